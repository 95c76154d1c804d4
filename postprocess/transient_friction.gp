# figure: friction in time: coefficients of sliding and rolling, power, temperatures, film, load and speeds
# needs: /transient/mu
figure = "transient_friction"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"
load here."/in_time.gp"

probes = 0
quasi = 0
panels = 5 + heated
high = 27 * stretch * panels + m(top + 8)
# Before any panel sets a range, which `stats` would obey.
stats $table_transient using "mu" nooutput prefix "U"
stats $table_transient using "mu_rolling" nooutput prefix "R"
stats $table_transient using "friction_power" nooutput prefix "W"
stats $table_transient using "load" nooutput prefix "L"
stats $table_transient using "slide_roll_ratio" nooutput prefix "S"
eval page
set multiplot
eval panel(1)
set format x ""
set ylabel "μ" offset 1, 0
eval span(U_min, U_max)
few(low, high) = alike(low, high) ? "set ytics auto" : sprintf("set ytics %g", 2 * round_step((high - low) / 5))
eval few(U_min, U_max)
plot for [k = 1:bars] $table_transient using (T(column("time"))):(low_end("mu")):(high_end("mu")) @band blue notitle, \
     $table_transient using (T(column("time"))):"mu" with lines lw 1 lc rgb blue title "sliding"
eval panel(2)
set ylabel "μ_{rolling}" offset 1, 0
set format y "%g"
eval span(R_min, R_max)
eval few(R_min, R_max)
plot $table_transient using (T(column("time"))):"mu_rolling" with lines lw 1 lc rgb green title "rolling"
eval panel(3)
set format y "% h"
set ylabel si ? "power [W".(size_of("/grid/y") > 1 ? "]" : "/m]") : "power [F_0 u_m]" offset 1, 0
eval span(W_min, W_max)
eval few(W_min, W_max)
plot $table_transient using (T(column("time"))):"friction_power" with lines lw 1 lc rgb red title "of the motion against the film"
eval panel(4)
set yrange [*:*]
set ytics auto
load here."/film_in_time.gp"
if (heated) {
  eval panel(5)
  set ylabel "T - T_{oil} [K]" offset 1, 0
  set yrange [0:*]
  plot $table_transient using (T(column("time"))):(heated ? column("T_film_max") : NaN) with lines lw 1 lc rgb red title "film", \
       $table_transient using (T(column("time"))):(heated ? column("T1_max") : NaN) with lines lw 1 dt (6, 3) lc rgb blue title "body 1", \
       $table_transient using (T(column("time"))):(heated ? column("T2_max") : NaN) with lines lw 1 dt (2, 2) lc rgb green title "body 2"
}
eval panel(panels)
set format x "%g"
set xlabel axis_T offset 0, 0.4
set ylabel "F/F_0, u/u_m, slip" offset 1, 0
set yrange [*:*]
eval span(L_min < S_min ? L_min : S_min, L_max > S_max ? L_max : S_max)
plot $table_transient using (T(column("time"))):"load" with lines lw 1 lc rgb blue title "load", \
     $table_transient using (T(column("time"))):"speed" with lines lw 1 dt (6, 3) lc rgb green title "speed", \
     $table_transient using (T(column("time"))):"slide_roll_ratio" with lines lw 1 dt (2, 2) lc rgb red title "slip"
unset multiplot
