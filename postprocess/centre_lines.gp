# figure: pressure and film (dry contact: gap) along the line y = 0, and the Hertz pressure
# needs: /fields/P
figure = "centre_lines"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"

high = 60 * stretch
eval page
film = dry ? "gap" : "H"
load fields("P ".film, " --along x --at y=0", "node")
stats $node_P using 1:2 nooutput prefix "P"
node = "$node_".film
stats @node using (abs($1) < reach_x ? $2 : NaN) nooutput prefix "H"
stats @node using (abs($1) < 1.4 * reach_x ? $2 : NaN) nooutput prefix "F"
left = -2.5 * reach_x > P_min_x ? -2.5 * reach_x : P_min_x
right = 1.5 * reach_x < P_max_x ? 1.5 * reach_x : P_max_x
set xlabel axis_X offset 0, 0.4
set ylabel axis_P textcolor rgb red offset 1.2, 0
set ytics textcolor rgb red
set y2tics textcolor rgb blue
set xtics steps_of(right - left)
set xrange [left:right]
P_top = 1.12 * (P_max_y > p_h ? P_max_y : p_h)
# Inside the contact, the film takes about a third of the height; outside, it leaves the panel at the top.
film_top = H_median > 0.02 * F_max ? 3.5 * H_median : F_max
# A gap of zero would be hidden by the axis, so the axis begins slightly below zero. Both zeros are at the same height.
load lines("P ".film, left, right)
between = "$line_".film
stats @between using 2 nooutput prefix "L"
under = greater(dry ? 0.03 : 0, -below_zero(L_min) / film_top)
set yrange [-under * P_top:P_top]
set y2range [-under * film_top:film_top]
set ytics 0, steps_of(P_top)
set y2tics steps_of(film_top)
eval box(m(13), m(film_top < 1e4 ? 16 : 18), m(10), m(top + 4))
set y2label axis_H textcolor rgb blue offset film_top < 1e4 ? -1 : -0.6, 0
eval key_above."; set key width 0"  # short labels, in one row
set samples 4 * points + 1
plot Hertz(x) axes x1y1 with lines lw 0.8 dt (6, 4) lc rgb grey title "Hertz", \
     $line_P using 1:2 axes x1y1 with lines lw 1 lc rgb red title si ? "p" : "P", \
     @between using 1:2 axes x1y2 with lines lw 1 lc rgb blue title film eq "gap" ? "gap" : si ? "h" : "H"
