# figure: the von Mises stress below the contact, in the section y = 0
# needs: /subsurface/section/sigma_mises /fields/P
figure = "subsurface_stress"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"

name = "/subsurface/section/sigma_mises"
load blocks("/subsurface/section/x /subsurface/section/z", "", "axis")
stats $axis_x using 1 nooutput prefix "A"
stats $axis_z using 1 nooutput prefix "D"
left = A_min > -1.8 * a ? A_min : -1.8 * a
right = A_max < 1.8 * a ? A_max : 1.8 * a
bottom = 0
far = D_max / 2
load maps(name, points)
load lines("P", left, right)
stats $map_sigma_mises matrix nonuniform using 3 nooutput prefix "F"
stats $line_P using 2 nooutput prefix "P"
# Label and symbol of the global maximum; the symbol is open if the maximum lies outside this section.
where_to(axis) = number("/subsurface/largest_sigma_mises_".axis)
x = where_to("x")
y = where_to("y")
z = where_to("z")
note = sprintf(si ? "largest %.3f GPa at (%.0f, %.0f, %.0f) µm" : "largest %.4f p_h at (%.2f, %.2f, %.2f) a", \
    number("/subsurface/largest_sigma_mises"), x, abs(y) < 0.005 * a ? 0 : y, z)
y = abs(y) < 0.05 * a ? 0 : y
low = 0
highest = F_max
step = round_step(F_max / 5)
map = (wide - m(33)) * 2 * far / (right - left) + m(10)
high = map + 28 * stretch + m(top + 5)
load here."/contours.gp"

eval page
set multiplot
set xrange [left:right]
set xtics steps_of(right - left)
eval box(m(13), m(20), map + m(6), m(top + 4))
set format x ""
set ylabel axis_P offset 1, 0
set yrange [0:1.1 * (P_max > p_h ? P_max : p_h)]
set ytics steps_of(P_max)
set samples 4 * points + 1
eval key_above
plot Hertz(x) with lines lw 0.8 dt (6, 4) lc rgb grey title "Hertz", \
     $line_P using 1:2 with lines lw 1 lc rgb red title "pressure"

unset label 100
set label 1 note at graph 0.5, graph 1 offset 0, 0.6 center
set label 2 "" at where_to("x"), z point pt y == 0 ? 7 : 6 ps 1 lw 0.8 front
eval box(m(13), m(20), m(10), high - map)
eval bar(m(10), high - map)
set format x "%g"
set xlabel axis_X offset 0, 0.4
set ylabel axis_Z
set yrange [D_max:0]
set ytics steps_of(D_max) * (map < m(40) ? 2 : 1)
set cbtics steps_of(F_max)
eval "set palette ".pressure_colours
set cbrange [0:F_max]
set cblabel si ? "σ_{Mises} [GPa]" : "σ_{Mises}/p_h"
unset key
plot $map_sigma_mises matrix nonuniform using 1:2:3 with image, \
     $contours using 1:2 with lines lw 0.4 lc rgb "#333333", \
     $labels using 1:2:3 with labels boxed font ",6"
unset multiplot
