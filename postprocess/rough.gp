# Shared by roughness and dry_roughness: two panels along y = 0 above a map.
map = high - m(top)
panel = 33 * stretch
high = map + 2 * panel + m(top + 8)
eval page
load lines("P S ".name, left, right)
stats $line_P using 2 nooutput prefix "P"
stats $line_S using (abs($1) < reach_x ? $2 : NaN) nooutput prefix "S"
line = "$line_".name
stats @line using (abs($1) < 0.9 * reach_x ? $2 : NaN) nooutput prefix "H"
stats @line using 2 nooutput prefix "L"
shown = name eq "H" ? "H" : "P"
load fields(shown, matrix_of(300), "coarse")
load maps(shown, points)
coarse = "$coarse_".shown
map_of_shown = "$map_".shown
stats @coarse matrix nonuniform using 3 nooutput prefix "F"
wet = name eq "H" ? centre(name) : 0
shape(s) = wet + s - S_min
set multiplot
set xrange [left:right]
set samples 4 * points + 1

eval box(m(13), m(20), map + panel + m(4), m(top + 4))
unset label 1
set format x ""
set ylabel axis_P offset 1, 0
set ytics steps_of(P_max)
set xtics steps_of(right - left)
set yrange [0:1.1 * (P_max > p_h ? P_max : p_h)]
eval key_above
plot Hertz(x) with lines lw 0.8 dt (6, 4) lc rgb grey title "Hertz", \
     $line_P using 1:2 with lines lw 1 lc rgb red title "pressure"

unset label 100
eval box(m(13), m(20), map, m(top + 8) + panel)
set format x "%g"
set ylabel axis_H
set ytics steps_of(H_max > wet + S_max - S_min ? H_max : wet + S_max - S_min)
tallest = 1.15 * (H_max > wet + S_max - S_min ? H_max : wet + S_max - S_min)
# A gap of zero would be hidden by the axis, so the axis begins slightly below zero.
set yrange [-greater(dry ? 0.03 * tallest : 0, -below_zero(L_min)):tallest]
plot @line using 1:2 with lines lw 1 lc rgb blue title name eq "H" ? "film" : "gap", \
     $line_S using 1:(shape($2)) with lines lw 0.8 dt (1, 2) lc rgb grey title "undeformed"

unset key
eval box(m(13), m(20), m(10), high - map + m(6))
eval bar(m(10), high - map + m(6))
bar_top = name eq "H" && F_max > 2 * abs(wet) ? 2 * abs(wet) : F_max
set yrange [bottom:bottom + 2 * far]
set xlabel axis_along offset 0, 0.4
set ylabel axis_Y
set ytics steps_of(2 * far)
eval "set palette ".(name eq "H" ? film_colours : pressure_colours)
set cbrange [name eq "H" ? F_min : 0:bar_top]
set cbtics steps_of(bar_top - (name eq "H" ? F_min : 0))
set cblabel name eq "H" ? axis_H : axis_P
plot @map_of_shown matrix nonuniform using 1:2:3 with image
unset multiplot
