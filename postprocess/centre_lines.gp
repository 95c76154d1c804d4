# figure: pressure and film along the centre line
# needs: /fields/P /fields/H
figure = "centre_lines"
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

Hc = number("Hc")
stats centre_line("P") using 1:2 nooutput prefix "P"

set xlabel "X = x/a,  Y = 0"
set ylabel "P = p/p_h" textcolor rgb red
set y2label "H = hR/a^2" textcolor rgb blue
set ytics textcolor rgb red
set y2tics textcolor rgb blue
set xrange [-2.5 * reach_x > P_min_x ? -2.5 * reach_x : P_min_x : 1.5 * reach_x < P_max_x ? 1.5 * reach_x : P_max_x]
set yrange [0:1.15 * (P_max_y > 1 ? P_max_y : 1)]
# The film has a third of the height in the contact, and leaves at the top outside it.
set y2range [0:4 * Hc]
set key top right
set samples 2001
edge = 1 / sqrt(outline_XX)
plot abs(x) < 1.002 * edge ? sqrt(abs(x) < edge ? 1 - outline_XX * x**2 : 0) : 1/0 axes x1y1 with lines lw 1.5 dt 2 lc rgb grey title "Hertz", \
     centre_line("P") using 1:2 axes x1y1 with lines lw 1.5 lc rgb red title "P", \
     centre_line("H") using 1:2 axes x1y2 with lines lw 1.5 lc rgb blue title "H"
