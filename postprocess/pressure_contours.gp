# figure: lines of equal pressure (the paper's figure 3)
# needs: /fields/P
figure = "pressure_contours"
wide = 14.5
high = 14
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"
if (!exists("dP")) dP = 0.04

set contour base
unset surface
set cntrparam levels incremental dP, dP, 10
set table $contours
splot field("P") using 1:2:3 with lines nosurface notitle
unset table
unset contour

set size ratio -1
set xrange [-reach_x - 0.8 * margin:reach_x + 0.4 * margin]
set yrange [-reach_y - 0.6 * margin:reach_y + 0.6 * margin]
set xlabel "X = x/a"
set ylabel "Y = y/a"
eval "set palette ".pressure_colours
set cbrange [-0.3:1.1]
unset colorbox
set label 1 sprintf("ΔP = %g", dP) at screen 0.97, 0.97 right
plot $contours using 1:2:3 with lines lw 0.7 lc palette notitle
