# Shared by the figures of a run in time: its times, its probes, and panels above each other.
load tables("/transient /transient/frames/time")
stats $table_time using 1 nooutput prefix "K"
frames = int(K_records)
time_of(k) = T(real($table_time[k + 1]))
set datafile columnheaders
stats $table_transient using "time" nooutput prefix "T"
# Columns P_1, H_1, ... ; the deck gives the place of each probe.
probes = 0
quasi = 0
bends = 0
heated = 0
bars = 0
do for [one in $table_transient[1]] {
  probes = probes + (one[1:2] eq "P_" && one[1:5] ne "P_max")
  quasi = quasi + (one eq "Hc_quasi_steady")
  bends = bends + (one eq "radius_x")
  heated = heated + (one eq "T_film_max")
  bars = bars + (one eq "error_Hc")
}
# The ends of the error bar of a column, which a table has only if the deck asks for it.
low_end(name) = bars ? column(name) - abs(column(name)) * column("error_".name) : NaN
high_end(name) = bars ? column(name) + abs(column(name)) * column("error_".name) : NaN
band = "with filledcurves fs transparent solid 0.2 noborder lc rgb"
# A column that a table has only with quasi-steady states.
steady(name) = quasi ? column(name) : NaN
places = probes > 0 ? system(read."deck | sed -n 's/^probe = //p' | tr ',' '\n' | sed 's/^ *//;s/ *$//;s/  */,/g' | paste -s -d ' '") : ""
place(k) = "(".word(places, k).") a"
probe_colour(k) = word("#e69f00 #009e73 #cc79a7 #56b4e9 #8c510a #444444", (k - 1) % 6 + 1)
set xrange [T(T_min):T_max > T_min ? T(T_max) : T(T_min) + 1]
# An axis for a quantity that may be constant: gnuplot warns of a range of zero length.
alike(low, high) = high - low <= 1e-9 * (abs(low) + abs(high))
# The margin keeps a curve away from the frame.
span(low, high) = alike(low, high) ? sprintf("set yrange [%g:%g]", low < 0 ? 2 * low : 0, high > 0 ? 2 * high : 1) : \
    sprintf("set yrange [%g:%g]", low - 0.05 * (high - low), high + 0.05 * (high - low))
# The oil enters from both sides in turn if the motion reverses.
stats $table_transient using "speed" nooutput prefix "S"
if (S_min < 0) { axis_along = axis_X.", motion ↔" } else { if (S_max == 0) { axis_along = axis_X } }
# The key of the film has as many rows as its entries need (more_rows: their height without the first); gnuplot makes all columns as wide as the longest one.
longest_entry = quasi > 0 ? 12 : 7
do for [k = 1:probes] { longest_entry = greater(longest_entry, strlen(place(k))) }
entries_in_row = int((wide - m(21)) / (mm_of(longest_entry) + m(11.2)))
more_rows = 4 * ((1 + 2 * quasi + probes) / (entries_in_row > 0 ? entries_in_row : 1))
# Panel k of `panels`, counted from the top, with space for labels with three decimals.
share = "(high - m(top + 9.5)) / panels"
panel(k) = box(m(17), m(4), high - m(top + 4) - k * @share + m(4.5), m(top + 4) + (k - 1) * @share).(k > 1 ? "; unset label 100; " : "; ").key_above
