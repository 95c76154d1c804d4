# figure: the time steps: length, order, cycles
# needs: /transient
# on demand
figure = "transient_steps"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"
load here."/in_time.gp"

panels = 2
high = 36 * stretch * panels + m(top + 8)
eval page
set multiplot
eval panel(1)
unset key
set format x ""
set logscale y
set format y "10^{%T}"
set ylabel seconds ? "step [ms]" : "step [a/u_m]"
plot $table_transient using (T(column("time"))):(column("step") > 0 ? T(column("step")) : NaN) with lines lw 1 lc rgb blue
unset logscale y
set format "%g"
eval panel(2)
set xlabel axis_T offset 0, 0.4
set yrange [0:*]
set ylabel "cycles, order"
plot $table_transient using (T(column("time"))):"cycles" with points pt 7 ps 0.5 lc rgb red title "cycles", \
     $table_transient using (T(column("time"))):"order" with points pt 7 ps 0.3 lc rgb grey title "order"
unset multiplot
