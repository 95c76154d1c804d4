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
# An axis of what may be the same at all times: gnuplot warns of a range without a length.
alike(low, high) = high - low <= 1e-9 * (abs(low) + abs(high))
span(low, high) = alike(low, high) ? sprintf("set yrange [%g:%g]", low < 0 ? 2 * low : 0, high > 0 ? 2 * high : 1) : \
    "set yrange [*:*]"
# Panel k of `panels` from the top; beside it room for films of thousandths.
share = "(high - m(top + 9.5)) / panels"
panel(k) = box(m(17), m(4), high - m(top + 4) - k * @share + m(4.5), m(top + 4) + (k - 1) * @share).(k > 1 ? "; unset label 100; " : "; ").key_above
