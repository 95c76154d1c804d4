# figure: a moving body: film, load that the film carries, and the velocity of the body
# needs: /transient/velocity
figure = "transient_body"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"
load here."/in_time.gp"

probes = 0
panels = 3
top = top + more_rows
high = 36 * stretch * panels + m(top + 8)
eval page
set multiplot
eval panel(1)
load here."/film_in_time.gp"
eval panel(2)
set yrange [*:*]
stats $table_transient using "carried" nooutput prefix "C"
stats $table_transient using "load" nooutput prefix "L"
eval span(C_min < L_min ? C_min : L_min, C_max > L_max ? C_max : L_max)
set ylabel "relative load" offset 1, 0
plot $table_transient using (T(column("time"))):"carried" with lines lw 1 lc rgb blue title "carried", \
     $table_transient using (T(column("time"))):"load" with lines lw 0.8 dt (6, 3) lc rgb grey title "acting"
eval panel(3)
unset key
set xzeroaxis lw 0.5 lc rgb grey
set format x "%g"
set xlabel axis_T offset 0, 0.4
set yrange [*:*]
stats $table_transient using (column("velocity") * (si ? 1e3 : 1)) nooutput prefix "V"
eval span(V_min, V_max)
set ylabel si ? "velocity [mm/s]" : "velocity [a u_m/R]" offset 1, 0
plot $table_transient using (T(column("time"))):(column("velocity") * (si ? 1e3 : 1)) with lines lw 1 lc rgb blue
unset multiplot
