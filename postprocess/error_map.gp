# figure: where the errors of Hc and Hm by the mesh originate: film too thick in red, too thin in blue
# needs: /fields/error_map_Hc /fields/error_map_Hm map
figure = "error_map"
here = system(sprintf("dirname '%s'", ARG0))
wide = 180
load here."/result.gp"
load here."/window.gp"
# Two maps next to each other. The colours are proportional to the square root, each map relative
# to its own largest value.
half = (wide - m(edge)) / 2
high = (half - m(16)) * 2 * far / (right - left) + m(14 + top)
both = "error_map_Hc error_map_Hm"
load fields(both, matrix_of(300), "coarse")
load maps(both, 400)
stats $coarse_error_map_Hc matrix nonuniform using 3 nooutput prefix "C"
stats $coarse_error_map_Hm matrix nonuniform using 3 nooutput prefix "M"
size(low, high) = -low > high ? -low : high
of_Hc = size(C_min, C_max)
of_Hm = size(M_min, M_max)
shown(value, largest) = largest > 0 ? sgn(value) * (abs(value) / largest)**0.5 : 0
eval page
set multiplot
set xrange [left:right]
set yrange [bottom:bottom + 2 * far]
set xtics steps_of(right - left)
set ytics steps_of(2 * far)
set xlabel axis_along offset 0, 0.4
set palette defined (-1 blue, 0 "white", 1 red)
set cbrange [-1:1]
set cbtics ("small" -1, "0" 0, "large" 1)
unset key
unset colorbox
eval box(m(13), m(edge) + half, m(10), m(top + 4))
set ylabel axis_Y offset label_Y, 0
set label 1 "H_c" at graph 0.5, graph 1 offset 0, 0.6 center
plot $map_error_map_Hc matrix nonuniform using 1:2:(shown($3, of_Hc)) with image
unset label 100
eval box(half + m(8), m(edge), m(10), m(top + 4))
unset ylabel
set label 1 "H_m"
eval bar(m(10), m(top + 4))
plot $map_error_map_Hm matrix nonuniform using 1:2:(shown($3, of_Hm)) with image
unset multiplot
