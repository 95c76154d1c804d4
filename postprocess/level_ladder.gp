# figure: film thickness and its error, level by level
# needs: /levels
figure = "level_ladder"
high = 15
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

set datafile columnheaders
stats table("levels") using "nx" nooutput prefix "N"
set multiplot layout 2, 1 title title noenhanced
set title ""
set logscale x 2
set xrange [N_min / 1.15:N_max * 1.15]
set xlabel "cells along X"
set format x "%.0f"
set key bottom right
set ylabel "H = hR/a^2"
set lmargin 11
set offsets 0, 0, graph 0.08, graph 0.08
plot table("levels") using "nx":"Hc" with linespoints lw 1.5 pt 7 ps 1.2 lc rgb blue title "H_c, centre", \
     table("levels") using "nx":"Hm" with linespoints lw 1.5 pt 5 ps 1.2 lc rgb red title "H_m, minimum"
unset offsets
set logscale y
set format y "%g %%"
set ylabel "estimated error"
# A single level has no estimate: say so, and give the axis a range that gnuplot can draw.
estimates = 0
stats table("levels") using (estimates = estimates + (column("error_Hc") > 0 ? 1 : 0), 1) nooutput prefix "E"
if (estimates == 0) {
  set yrange [0.01:100]
  set label 1 "no estimate: a single level" at graph 0.5, graph 0.5 center
}
set key top right
plot table("levels") using "nx":(100 * abs(column("error_Hc"))) with linespoints lw 1.5 pt 7 ps 1.2 lc rgb blue \
         title "error of H_c", \
     table("levels") using "nx":(100 * abs(column("error_Hm"))) with linespoints lw 1.5 pt 5 ps 1.2 lc rgb red \
         title "error of H_m"
unset multiplot
