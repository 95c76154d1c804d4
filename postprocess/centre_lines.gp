# figure: pressure and film (dry: gap) along the line y = 0, and Hertz' pressure
# needs: /fields/P
figure = "centre_lines"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"

high = 60 * stretch
eval page
eval box(m(12), m(16), m(10), m(top + 4))
stats grid("P")." --along x --at y=0" using 1:2 nooutput prefix "P"
film = found("/fields/H") ne "" ? "H" : "gap"
stats grid(film)." --along x --at y=0" using (abs($1) < reach_x ? $2 : NaN) nooutput prefix "H"
stats grid(film)." --along x --at y=0" using (abs($1) < 1.4 * reach_x ? $2 : NaN) nooutput prefix "F"
left = -2.5 * reach_x > P_min_x ? -2.5 * reach_x : P_min_x
right = 1.5 * reach_x < P_max_x ? 1.5 * reach_x : P_max_x
set xlabel axis_X offset 0, 0.4
set ylabel axis_P textcolor rgb red offset 1.2, 0
set y2label axis_H textcolor rgb blue offset -1, 0
set ytics textcolor rgb red
set y2tics textcolor rgb blue
set xtics steps_of(right - left)
set xrange [left:right]
set yrange [0:1.12 * (P_max_y > p_h ? P_max_y : p_h)]
# The film has about a third of the height in the contact, and leaves at the top outside it.
set y2range [0:H_median > 0.02 * F_max ? 3.5 * H_median : F_max]
eval key_above
set samples 2001
plot Hertz(x) axes x1y1 with lines lw 0.8 dt (6, 4) lc rgb grey title "Hertz", \
     line("P", left, right) using 1:2 axes x1y1 with lines lw 1 lc rgb red title si ? "p" : "P", \
     line(film, left, right) using 1:2 axes x1y2 with lines lw 1 lc rgb blue title film eq "gap" ? "gap" : si ? "h" : "H"
