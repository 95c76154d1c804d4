# figure: film thickness and its estimated error, level by level
# needs: /levels
# on demand
figure = "level_ladder"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"

load tables("levels")
set datafile columnheaders
stats $table_levels using "nx" nooutput prefix "N"
stats $table_levels using "Hm" nooutput prefix "M"
# In older files, the error of the mesh had another name.
bar = found("/levels/mesh_error_Hc") eq "" ? "error_" : "mesh_error_"
# A negative film has an infinite error.
load blocks("/levels/".bar."Hc", "", "all")
list = "$all_".bar."Hc"
estimates = 0
do for [k = 1:|@list|] { estimates = estimates + (strstrt(@list[k], "n") == 0) }  # neither nan nor inf
high = 80 * stretch + m(top)
half = (high - m(top + 19)) / 2
eval page
set multiplot
set logscale x 2
set xrange [N_min / 1.15:N_max * 1.15]
eval box(m(14), m(4), m(13) + half, m(top + 4))
eval key_above
set format x ""
set ylabel axis_H offset 0.5, 0
set yrange [below_zero(M_min):0 < *]
plot $table_levels using "nx":"Hc" with linespoints lw 1 pt 7 ps 1 lc rgb blue title "centre", \
     $table_levels using "nx":"Hm" with linespoints lw 1 pt 5 ps 1 lc rgb red title "minimum"
eval box(m(14), m(4), m(10), m(top + 6) + half)
unset key
unset label 100
set format x "%.0f"
set xlabel "cells along x" offset 0, 0.4
set logscale y
set format y "%g %%"
set ylabel "estimated error" offset 0.5, 0
# A single level has no estimate: this is printed, and the axis gets a range that gnuplot can draw.
set yrange [*:*]
if (estimates == 0) {
  set yrange [0.01:100]
  set label 1 (N_records > 1 ? "no estimate" : "no estimate: a single level") at graph 0.5, graph 0.5 center
}
plot $table_levels using "nx":(100 * abs(column(bar."Hc"))) with linespoints lw 1 pt 7 ps 1 lc rgb blue, \
     $table_levels using "nx":(100 * abs(column(bar."Hm"))) with linespoints lw 1 pt 5 ps 1 lc rgb red
unset multiplot
