# figure: load per length, maximum pressure and film along a roller, with and without oil
# needs: /roller /roller_dry
figure = "roller"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"

load tables("roller roller_dry")
set datafile columnheaders
unset tics
stats $table_roller using "y" nooutput prefix "Y"
stats $table_roller using "P_max" nooutput prefix "P"
stats $table_roller_dry using "P_max" nooutput prefix "D"
stats $table_roller using "H_min" nooutput prefix "L"
stats $table_roller using "H_c" nooutput prefix "H"
set tics
panel = 50 * stretch
high = 2 * panel + m(top + 49)
eval page
set multiplot
eval box(m(16), m(14), panel + m(24), m(top + 16))
# A film that becomes negative does so at the ends, where the frame would hide it.
beside = L_min < 0 ? 0.02 * (Y_max - Y_min) : 0
set xrange [Y_min - beside:Y_max + beside]
set xtics steps_along(Y_min, Y_max, wide - m(30)) format ""
set yrange [0:1.1 * (P_max > D_max ? P_max : D_max)]
set ylabel axis_P offset 0.5, 0
set y2range [0:*]
set y2tics auto
set ytics nomirror
set y2label "load per length over the mean"
eval key_above
plot $table_roller using "y":"P_max" with lines lw 1.4 lc rgb red title "highest pressure", \
     $table_roller_dry using "y":"P_max" with lines lw 0.9 dt 2 lc rgb red title "dry", \
     $table_roller using "y":"load" axes x1y2 with lines lw 1.0 lc rgb grey title "load"

# The gap grows without bound where the profile falls; the axis ends at twice the film in the middle.
unset label 100
unset y2tics
unset y2label
eval box(m(16), m(14), m(10), panel + m(top + 37))
set xtics format "%g"
set xlabel axis_Y offset 0, 0.4
set ylabel axis_H offset 0.5, 0
middle = real(system(sprintf("%s H --along y --at x=0 | sed '/^#/d' | awk '{line[NR] = $2} END {print line[int((NR + 1) / 2)]}'", read)))
set yrange [below_zero(L_min):middle > 0 ? 2 * middle : H_max > 0 ? H_max : 1]
if (L_min < 0) { set xzeroaxis lw 0.5 lc rgb grey }
plot $table_roller using "y":"H_c" with lines lw 1.4 lc rgb blue title "film at x = 0", \
     $table_roller using "y":"H_min" with lines lw 1.0 lc rgb green title "least film"
unset multiplot
