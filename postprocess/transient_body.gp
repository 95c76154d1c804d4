# figure: a body that moves: film and approach, the load that the film carries, the velocity
# needs: /transient/velocity
figure = "transient_body"
high = 18
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

set datafile columnheaders
stats table("transient") using "time" nooutput prefix "T"
set multiplot layout 3, 1 title title noenhanced
set title ""
set lmargin 11
set rmargin 4
set xrange [T_min:T_max > T_min ? T_max : T_min + 1]
set xzeroaxis lw 0.5 lc rgb grey
set key tmargin center horizontal samplen 3
set offsets 0, 0, graph 0.1, graph 0.05
set ylabel "H = hR/a^2"
stats table("transient") using "Hc" nooutput prefix "C"
# Bodies that come from afar would flatten the film to a line.
if (C_max > 20 * C_min) { set logscale y; set format y "%g"; unset offsets }
plot table("transient") using "time":"Hc" with lines lw 1.5 lc rgb blue title "H_c, centre", \
     table("transient") using "time":"Hm" with lines lw 1.5 lc rgb red title "H_m, minimum"
unset logscale y
set offsets 0, 0, graph 0.1, graph 0.05
set ylabel "load, P"
plot table("transient") using "time":"carried" with lines lw 1.5 lc rgb blue title "load that the film carries", \
     table("transient") using "time":"load" with lines lw 1 lc rgb grey title "load that acts", \
     table("transient") using "time":"P_max" with lines lw 1.5 lc rgb red title "P_{max}"
set xlabel "time [a/u_m]"
set ylabel "velocity [a u_m/R]"
plot table("transient") using "time":"velocity" with lines lw 1.5 lc rgb blue title "velocity of the body"
unset multiplot
