# figure: heat in time: film, highest temperatures, heat made and led away, load and speed
# needs: /transient/T_film_max
figure = "transient_heat"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"
load here."/in_time.gp"

probes = 0
# Before any panel sets a range, which `stats` would obey.
stats $table_transient using "load" nooutput prefix "L"
stats $table_transient using "speed" nooutput prefix "S"
driven = L_min < L_max || S_min < S_max
panels = 3 + driven
top = top + more_rows
high = 30 * stretch * panels + m(top + 8)
eval page
set multiplot
eval panel(1)
load here."/film_in_time.gp"
eval panel(2)
set ylabel "T - T_{oil} [K]" offset 1, 0
set yrange [0:*]
plot $table_transient using (T(column("time"))):"T_film_max" with lines lw 1 lc rgb red title "film", \
     $table_transient using (T(column("time"))):"T1_max" with lines lw 1 dt (6, 3) lc rgb blue title "body 1", \
     $table_transient using (T(column("time"))):"T2_max" with lines lw 1 dt (2, 2) lc rgb green title "body 2"
eval panel(3)
set ylabel "heat [W".(size_of("/grid/y") > 1 ? "]" : "/m]") offset 1, 0
set format x driven ? "" : "%g"
if (!driven) { set xlabel axis_T offset 0, 0.4 }
plot $table_transient using (T(column("time"))):"heat_made" with lines lw 1 lc rgb red title "made", \
     $table_transient using (T(column("time"))):"heat_1" with lines lw 1 dt (6, 3) lc rgb blue title "body 1", \
     $table_transient using (T(column("time"))):"heat_2" with lines lw 1 dt (2, 2) lc rgb green title "body 2"
if (driven) {
  eval panel(4)
  set format x "%g"
  set xlabel axis_T offset 0, 0.4
  set ylabel "F/F_0, u/u_m" offset 1, 0
  eval span(L_min < S_min ? L_min : S_min, L_max > S_max ? L_max : S_max)
  plot $table_transient using (T(column("time"))):"load" with lines lw 1 lc rgb blue title "load", \
       $table_transient using (T(column("time"))):"speed" with lines lw 1 dt (6, 3) lc rgb green title "speed"
}
unset multiplot
