# figure: a rough contact without lubricant: what the surfaces carry, gap and pressure along the centre line, and the pressure
# needs: /fields/P /fields/gap /fields/S
figure = "dry_roughness"
here = system(sprintf("dirname '%s'", ARG0))
wide = 24.0
load here."/common.gp"

stats centre_line("P") using 1:2 nooutput prefix "P"
stats centre_line("S") using (abs($1) < 1 ? $1 : 1/0):2 nooutput prefix "S"
left = -1.3 > P_min_x ? -1.3 : P_min_x
right = 1.3 < P_max_x ? 1.3 : P_max_x
deep = S_max_y - S_min_y

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
set yrange [0:1.25 * (P_max_y > 1 ? P_max_y : 1)]
set key center top horizontal
plot abs(x) < 1.002 ? sqrt(abs(x) < 1 ? 1 - x**2 : 0) : 1/0 with lines lw 1.5 dt 2 lc rgb grey title "Hertz", \
     centre_line("P") using 1:2 with lines lw 1.5 lc rgb red title "P"

set tmargin at screen 0.49
set bmargin at screen 0.11
set format x "%g"
set xlabel "X = x/a,  Y = 0"
set ylabel "hR/a^2"
set yrange [S_min_y - 0.1 * deep:S_max_y + deep]
plot centre_line("S") using 1:2 with lines lw 1.2 dt 3 lc rgb grey title "S, undeformed", \
     centre_line("gap") using 1:2 with lines lw 1.5 lc rgb blue title "gap"

set lmargin at screen 0.63
set rmargin at screen 0.90
set tmargin at screen 0.79
set bmargin at screen 0.24
set xrange [left:right]
set yrange [left:right]
set xlabel "X"
set ylabel "Y" offset 1
unset key
unset grid
eval "set palette ".pressure_colours
set cbrange [0:*]
set cblabel "P"
set tics front
set size ratio -1
plot field("P") using 1:2:3 with image
unset multiplot
