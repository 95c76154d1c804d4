# figure: a rough surface at rest in the contact: its shape, the film and the pressure along the centre line, and the film
# needs: /fields/P /fields/H /fields/S
figure = "roughness"
here = system(sprintf("dirname '%s'", ARG0))
wide = 24.0
load here."/common.gp"

Hc = number("Hc")
stats centre_line("P") using 1:2 nooutput prefix "P"
stats field("H") using (abs($1) < 1.5 && abs($2) < 1.5 ? 1 : 1/0):3 nooutput prefix "H"
left = -1.8 > P_min_x ? -1.8 : P_min_x
right = 1.3 < P_max_x ? 1.3 : P_max_x

set multiplot title title noenhanced
unset title
set lmargin at screen 0.08
set rmargin at screen 0.55
set xrange [left:right]
set samples 2001

set tmargin at screen 0.90
set bmargin at screen 0.52
set format x ""
set ylabel "P = p/p_h"
set yrange [0:1.15 * (P_max_y > 1 ? P_max_y : 1)]
set key center top horizontal
plot abs(x) < 1.002 ? sqrt(abs(x) < 1 ? 1 - x**2 : 0) : 1/0 with lines lw 1.5 dt 2 lc rgb grey title "Hertz", \
     centre_line("P") using 1:2 with lines lw 1.5 lc rgb red title "P"

set tmargin at screen 0.49
set bmargin at screen 0.11
set format x "%g"
set xlabel "X = x/a,  Y = 0"
set ylabel "H = hR/a^2"
set key vertical
set yrange [0:3.5 * Hc]
plot centre_line("S") using 1:(Hc + $2) with lines lw 1.2 dt 3 lc rgb grey title "H_c + S, undeformed", \
     centre_line("H") using 1:2 with lines lw 1.5 lc rgb blue title "H"

set lmargin at screen 0.63
set rmargin at screen 0.90
set tmargin at screen 0.79
set bmargin at screen 0.24
set xrange [left:right]
set yrange [-1.5:1.5]
set xlabel "X"
set ylabel "Y" offset 1
unset key
unset grid
eval "set palette ".film_colours
set cbrange [H_min_y:2 * Hc]
set cblabel "H"
set tics front
set size ratio -1
plot field("H") using 1:2:3 with image
unset multiplot
