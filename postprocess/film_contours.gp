# figure: lines of equal film thickness (the paper's figure 4)
# needs: /fields/H
figure = "film_contours"
wide = 14.5
high = 14
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

stats field("H") using 3 nooutput prefix "S"
Hc = number("Hc")
# The paper's 0.0025 where its load is near (Hc about 0.25), about 80 lines up to Hc elsewhere.
if (!exists("dH")) dH = Hc > 0.1 && Hc < 0.5 ? 0.0025 : nice(Hc / 80)
top = 1.6 * Hc
first = dH * ceil(S_min / dH)

set contour base
unset surface
set cntrparam levels incremental first, dH, top
set table $contours
splot field("H") using 1:2:3 with lines nosurface notitle
unset table
unset contour

set size ratio -1
set xrange [-reach_x - 0.8 * margin:reach_x + 0.4 * margin]
set yrange [-reach_y - 0.6 * margin:reach_y + 0.6 * margin]
set xlabel "X = x/a"
set ylabel "Y = y/a"
eval "set palette ".film_colours
set cbrange [S_min:top]
set colorbox
set cblabel "H = hR/a^2"
set label 1 sprintf("ΔH = %g", dH) at screen 0.97, 0.97 right
plot $contours using 1:2:3 with lines lw 0.7 lc palette notitle
