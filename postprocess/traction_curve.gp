# figure: the traction curve: friction and film against the slide-roll ratio in per cent
# needs: sweep motion.srr mu
# curves
figure = "traction_curve"
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"
load here."/series.gp"

# Series 1 to `curves` are friction, the others films. --axes log shows small slide-roll ratios.
stats data index 0:curves - 1 using (abs($1)):(abs($2)) nooutput prefix "M"
stats data index curves:series - 1 using 2 nooutput prefix "H"
percent(x) = 100 * abs(x)
# Measured points, "srr mu standard_error", given by ehl plot --measured.
with_points = exists("measured")
$none << EOD
NaN NaN NaN
EOD
if (!with_points) { measured = "$none" } else {
  stats measured using (abs($1)):(abs($2)) nooutput prefix "E"
  M_min_x = E_min_x < M_min_x ? E_min_x : M_min_x
  M_max_x = E_max_x > M_max_x ? E_max_x : M_max_x
  M_min_y = E_min_y < M_min_y ? E_min_y : M_min_y
  M_max_y = E_max_y > M_max_y ? E_max_y : M_max_y
}
entries = (curves > 1 ? curves : 0) + with_points
rows = entries > 0 ? (longest > 16 ? (entries + 1) / 2 : (entries + 2) / 3) : 0
below = m(10 + 3.7 * rows)
panel = 45 * stretch
high = 2 * panel + below + m(top + 2)
eval page
set multiplot
set key at screen 0.5, screen m(1) / high center bottom vertical maxrows (rows > 0 ? rows : 1) samplen 2.5 Left reverse
left = greater(m(16), m(14) + beyond(longest_on(0, H_max), 4))
eval box(left, m(4), below + panel + m(2), m(top))
eval axis("y", M_min_y, M_max_y)
marks = ""
eval axis("x", percent(M_min_x), percent(M_max_x))
set format x ""
set ylabel "friction coefficient μ" offset 0.5, 0
plot for [k = 1:curves] data index k - 1 using (percent($1)):(abs($2)) with linespoints pt 7 ps 0.8 lw 0.9 lc rgb colour(k) \
    title curves > 1 ? name("curve", k) : "", \
    measured using (percent($1)):(abs($2)):3 with yerrorbars pt 6 ps 1.1 lw 0.9 lc rgb "black" title with_points ? "measured" : ""

unset label 100
unset key
eval box(left, m(4), below, m(top + 2) + panel)
set format x "%g"
marks = "%g"
eval axis("x", percent(M_min_x), percent(M_max_x))
set xlabel "slide-roll ratio |u_1 - u_2|/u_m [%]" offset 0, 0.4
unset logscale y
set ytics auto
eval axis("y", 0, H_max)
set ylabel axis_2 offset 0.5, 0
plot for [k = 1:curves] data index curves + k - 1 using (percent($1)):2 with linespoints pt 7 ps 0.8 lw 0.9 lc rgb colour(k)
unset multiplot
