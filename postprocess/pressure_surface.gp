# figure: the pressure as a surface (the paper's figure 1)
# needs: /fields/P
figure = "pressure_surface"
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

stats field("P") using 1:3 nooutput prefix "S"
step = step_for(sqrt(S_records), format eq "png" ? 257 : 129)

# Shaded by the slope, as seen from downstream: the spike stands in front.
set pm3d depthorder lighting primary 0.55 specular 0.15 noborder
# Viewers leave hair lines between the patches of a PDF unless each is outlined in its own colour.
if (format eq "pdf") set pm3d border retrace lw 0.4
unset colorbox
unset grid
eval "set palette ".pressure_colours
set view 52, 128, 1.08, 1.1
# The box hangs low in its canvas and leaves the title far above.
set origin 0, 0.07
set title offset 0, -3
set xyplane 0
set ticslevel 0
set xlabel "X = x/a" offset 0, -0.5
set ylabel "Y = y/a" offset 0, -0.5
set label 1 "P = p/p_h" at graph 1, graph 0, graph 1.08 center
set xrange [-reach_x - margin:reach_x + 0.5 * margin]
set yrange [-reach_y - 0.6 * margin:reach_y + 0.6 * margin]
set zrange [0:*]
set cbrange [0:S_max_y]
splot field("P") using 1:2:3 every step:step with pm3d notitle
