# Shared by the figures of a run in time: its times, the points that it looked at, panels below each other.
stats "< ".read."transient/time" using 1 nooutput prefix "T"
stats "< ".read."/transient/frames/time" using 1 nooutput prefix "K"
frames = int(K_records)
time_of(k) = T(real(system(sprintf("%s /transient/frames/time | sed '/^#/d' | sed -n %dp", read, k + 1))))
set datafile columnheaders
# Columns P_1, H_1, ... ; where each point is stands in the deck.
probes = int(system(sprintf("%s transient | sed '/^#/!d' | tr ' ' '\n' | grep -c '^P_[0-9]'", read)))
place(k) = "at (".system(sprintf("%s deck | sed -n 's/^probe = //p' | cut -d, -f%d | xargs | tr ' ' ','", read, k)).") a"
probe_colour(k) = word("#e69f00 #009e73 #cc79a7 #56b4e9 #8c510a #444444", (k - 1) % 6 + 1)
set xrange [T(T_min):T_max > T_min ? T(T_max) : T(T_min) + 1]
# Panel k of `panels` from the top.
panel(k) = box(m(14), m(4), high - m(top + 4) - k * (high - m(top + 14)) / panels + m(4.5), \
    m(top + 4) + (k - 1) * (high - m(top + 14)) / panels).(k > 1 ? "; unset label 100; " : "; ").key_above
