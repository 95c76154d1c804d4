# figure: film, pressure, load and speed against time
# needs: /transient
figure = "transient_history"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"
load here."/in_time.gp"

stats $table_transient using "load" nooutput prefix "L"
stats $table_transient using "speed" nooutput prefix "S"
driven = L_min < L_max || S_min < S_max || bends
highest_drive = greater(L_max, S_max)
if (bends) { stats $table_transient using "radius_x" nooutput prefix "R"; highest_drive = greater(highest_drive, R_max) }
panels = 2 + driven
top = top + more_rows
high = 36 * stretch * panels + m(top + 8)
eval page
set multiplot
eval panel(1)
load here."/film_in_time.gp"
eval panel(2)
set ylabel axis_P offset 1, 0
set yrange [*:*]
stats $table_transient using "P_max" nooutput prefix "P"
if (P_max > 0) { set yrange [0:1.05 * P_max] } else { set yrange [0:1] }
set format x panels == 2 ? "%g" : ""
if (panels == 2) { set xlabel axis_T offset 0, 0.4 }
plot for [k = 1:bars] $table_transient using (T(column("time"))):(low_end("P_max")):(high_end("P_max")) @band red notitle, \
     $table_transient using (T(column("time"))):"P_max" with lines lw 1 lc rgb red title "maximum", \
     for [k = 1:quasi] $table_transient using (T(column("time"))):(steady("P_max_quasi_steady")) with lines lw 1 dt (6, 3) lc rgb "#e69f00" notitle, \
     for [k = 1:probes] $table_transient using (T(column("time"))):(probes > 0 ? column(sprintf("P_%d", k)) : NaN) with lines lw 0.8 \
         lc rgb probe_colour(k) notitle
if (driven) {
  eval panel(3)
  set format x "%g"
  set xlabel axis_T offset 0, 0.4
  set ylabel bends ? "F/F_0, R/R_0, u/u_m" : "F/F_0, u/u_m"
  eval span(S_min < 0 ? S_min : 0, highest_drive)
  if (S_min < 0) { set xzeroaxis }
  plot $table_transient using (T(column("time"))):"load" with lines lw 1 lc rgb blue title "load", \
       for [k = 1:bends] $table_transient using (T(column("time"))):(bends ? column("radius_x") : NaN) with lines lw 1 dt (2, 2) lc rgb red title bends > 0 ? "radius" : "", \
       $table_transient using (T(column("time"))):"speed" with lines lw 1 dt (6, 3) lc rgb green title "speed"
}
unset multiplot
