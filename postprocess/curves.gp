# figure: a quantity against a varied key, such as film against speed, with error bars and published formulas
# needs: sweep curves
# curves
figure = "curves"
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"
load here."/series.gp"

# The key of the curves is below the axis, in as many columns as the texts permit.
entries = (curves > 1 ? curves : 0) + (quantities > 1 ? quantities : 0) + formulas
columns = longest > 30 ? 1 : (longest > 16 ? 2 : 3)
rows = (entries + columns - 1) / columns
below = m(10 + 3.7 * rows + (lost > 0 ? 4 : 0))
high = 62 * stretch + below + m(top)
eval page
# Space for the tick labels: their full width next to the axis, half of the last one below it.
left = m(14) + beyond(longest_on(y_min, y_max), 4)
right = roughness > 0 ? m(14) + beyond(longest_on(y_min / roughness, y_max / roughness), 4) : \
    greater(m(4), m(0.4) + mm_of(longest_on(x_min, x_max)) / 2)
eval box(left, right, below, m(top))
set key at screen 0.5, screen m(lost > 0 ? 5 : 1) / high center bottom vertical maxrows (rows > 0 ? rows : 1) samplen 2.5 Left reverse
if (lost > 0) { set label 1 sprintf("%d of %d cases have no converged solution and are not drawn", lost, rows_of_table) at screen 0.5, screen m(3) / high center }
eval axis("x", x_min, x_max)
eval axis("y", y_min, y_max)
set xlabel x_words offset 0, 0.4
set ylabel y_words offset 0.5, 0
if (roughness > 0) {
  set ytics nomirror
  set y2tics
  eval axis("y2", y_min / roughness, y_max / roughness)
  set y2label lambda_words offset -0.5, 0
}
# The second quantity has open symbols.
plot for [s = 1:series] for [f = 1:3] data index s - 1 using 1:(column(3 + f)) with lines lw 0.7 dt 1 + f lc rgb (curves > 1 ? colour(s) : grey) notitle, \
     for [s = 1:series] data index s - 1 using 1:2:(valid(3) ? $3 : 0) with yerrorbars lw 0.8 pt (quantity_of(s) == 1 ? 7 : 6) ps 0.9 lc rgb colour(s) notitle, \
     for [s = 1:series] data index s - 1 using 1:2 with lines lw 0.9 lc rgb colour(s) notitle, \
     for [k = 1:curves] NaN with lines lw 1.2 lc rgb colour(k) title curves > 1 ? name("curve", k) : "", \
     for [q = 1:quantities] NaN with points pt (q == 1 ? 7 : 6) ps 0.9 lc rgb "black" title quantities > 1 ? name("quantity", q) : "", \
     for [f = 1:3] NaN with lines lw 0.7 dt 1 + f lc rgb grey title name("formula", f)
