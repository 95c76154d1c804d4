# figure: residual and load error of every cycle, from the coarsest grid to the finest
# needs: /history
# on the page
figure = "convergence"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"

# The columns "level cycle residual load_error ..."; the cycles are numbered through all levels.
load tables("history")
set datafile columnheaders
set table $cycles
plot $table_history using 0:1:3:4 with table
unset table
unset datafile columnheaders
stats $cycles using 1:3 nooutput prefix "R"
stats $cycles using 1:4 nooutput prefix "L"
high = 60 * stretch
eval page
eval box(m(18), m(4), m(10), m(top + 4))
eval key_above
set logscale y
set format y "10^{%T}"
set xlabel "cycle, coarse to fine grids" offset 0, 0.4
set ylabel "residual, load error (relative)" offset -0.6, 0
set xrange [0.5:R_records + 0.5]
set xtics greater(1, int(steps_of(R_records)))
# Each level begins with a vertical line and its number.
level = -1
array begins[R_records]
k = 0
stats $cycles using (k = k + 1, begins[k] = $2 == level ? 0 : 1, level = $2, 0) nooutput prefix "B"
lowest = R_min_y < L_min_y ? R_min_y : L_min_y
array level_of[R_records]
k = 0
stats $cycles using (k = k + 1, level_of[k] = $2, 0) nooutput prefix "B"
do for [k = 1:R_records] {
  if (begins[k]) {
    set label 1000 + k sprintf("level %d", level_of[k]) at first k - 0.5, graph 0.04 left offset 0.4, 0 font ",6"
    if (k > 1) { set arrow 1000 + k from first k - 0.5, graph 0 to first k - 0.5, graph 1 nohead dt 3 lc rgb grey lw 0.6 }
  }
}
plot $cycles using ($1 + 1):($3 > 0 ? $3 : NaN) with linespoints lw 1 pt 7 ps 0.7 lc rgb blue title "residual", \
     $cycles using ($1 + 1):($4 > 0 ? $4 : NaN) with linespoints lw 1 dt (6, 3) pt 5 ps 0.6 lc rgb red title "load error"
