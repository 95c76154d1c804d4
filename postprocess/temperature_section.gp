# figure: temperature and speed across the film, in the section y = 0
# needs: /thermal_section/T /thermal_section/u
figure = "temperature_section"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"

left = -1.8 * reach_x
load blocks("/grid/x", "", "axis")
stats $axis_x using 1 nooutput prefix "A"
right = A_max < 1.6 * reach_x ? A_max : 1.6 * reach_x
load blocks("/thermal_section/T /thermal_section/u", " --matrix", "section")
# Values outside the window are replaced by one within the range of the others.
stats $section_T matrix nonuniform using ($1 >= left && $1 <= right ? $3 : 0) nooutput prefix "T"
stats $section_u matrix nonuniform using ($1 >= left && $1 <= right ? $3 : 1) nooutput prefix "U"
panel = 34 * stretch
high = 2 * panel + m(21 + top)
eval page
set multiplot
unset key
set xrange [left:right]
set xtics steps_of(right - left)
set yrange [0:1]
set ytics 0.5
set ylabel "z/h, surface 2 to 1" offset 0.3, 0
set pm3d map interpolate 2, 8
eval box(m(16), m(20), m(17) + panel, m(top))
set format x ""
eval "set palette ".pressure_colours
set cbrange [T_min < 0 ? T_min : 0:T_max]
set cbtics steps_of(T_max)
set cblabel "T − T_{oil} [K]"
eval bar(m(17) + panel, m(top))
splot $section_T matrix nonuniform using 1:2:3 with pm3d
unset label 100
eval box(m(16), m(20), m(13), m(8 + top) + panel)
set format x "%g"
set xlabel axis_along offset 0, 0.4
eval "set palette ".film_colours
set cbrange [U_min:U_max]
set cbtics steps_of(U_max - U_min)
set cblabel "u/u_m"
eval bar(m(13), m(8 + top) + panel)
splot $section_u matrix nonuniform using 1:2:3 with pm3d
unset multiplot
