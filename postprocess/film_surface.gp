# figure: the film as a surface, upside down (the paper's figure 2)
# needs: /fields/H
figure = "film_surface"
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

stats field("H") using 1:3 nooutput prefix "S"
step = step_for(sqrt(S_records), format eq "png" ? 257 : 129)
Hc = number("Hc")
# Films thicker than this lie outside the contact and would hide it.
top = 2.5 * Hc

# Thin is up: the flat film of the contact is a plateau, and the horseshoe of the smallest film its rim.
set pm3d depthorder lighting primary 0.55 specular 0.15 noborder
# Viewers leave hair lines between the patches of a PDF unless each is outlined in its own colour.
if (format eq "pdf") set pm3d border retrace lw 0.4
unset colorbox
unset grid
eval "set palette ".film_colours
set cbrange [S_min_y:top]
set view 52, 128, 1.08, 1.1
# The box hangs low in its canvas and leaves the title far above.
set origin 0, 0.07
set title offset 0, -3
set xyplane at top
set xlabel "X = x/a" offset 0, -0.5
set ylabel "Y = y/a" offset 0, -0.5
set label 1 "H = hR/a^2" at graph 1, graph 0, graph 1.08 center
set xrange [-reach_x - margin:reach_x + 0.5 * margin]
set yrange [-reach_y - 0.6 * margin:reach_y + 0.6 * margin]
set zrange [top:0]
splot field("H") using 1:2:($3 < top ? $3 : top) every step:step with pm3d notitle
