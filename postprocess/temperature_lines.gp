# figure: temperatures along y = 0 above that of the oil: maximum and middle of the film, both surfaces; pressure
# needs: /fields/T_mid /fields/T_max /fields/T1 /fields/T2
figure = "temperature_lines"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"

left = -2.5 * reach_x
load blocks("/grid/x", "", "axis")
stats $axis_x using 1 nooutput prefix "A"
right = A_max < 1.6 * reach_x ? A_max : 1.6 * reach_x
load lines("T_max T_mid T1 T2 P", left, right)
stats $line_T_max using 2 nooutput prefix "T"
stats $line_P using 2 nooutput prefix "P"
high = 62 * stretch + m(22 + top)
eval page
eval box(m(13), m(14), m(22), m(top))
set key at screen 0.5, screen m(1) / high center bottom vertical maxrows 3 samplen 2.5 Left reverse
set xrange [left:right]
set xtics steps_of(right - left)
set yrange [0:1.08 * T_max]
set ytics steps_of(T_max) nomirror
set y2range [0:1.08 * (P_max > p_h ? P_max : p_h)]
set y2tics steps_of(P_max)
set xlabel axis_along offset 0, 0.4
set ylabel "T − T_{oil} [K]" offset 0.5, 0
set y2label axis_P offset -0.5, 0
plot $line_T_max using 1:2 with lines lw 1.4 lc rgb red title "film, hottest", \
     $line_T_mid using 1:2 with lines lw 1 dt (6, 3) lc rgb red title "film, middle", \
     $line_T1 using 1:2 with lines lw 1 lc rgb blue title "surface 1", \
     $line_T2 using 1:2 with lines lw 1 lc rgb green title "surface 2", \
     $line_P using 1:2 axes x1y2 with lines lw 0.8 lc rgb grey title "pressure"
