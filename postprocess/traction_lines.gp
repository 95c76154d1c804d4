# figure: shear stress on both surfaces, pressure and film at one time, along y = 0
# needs: /transient/frames/tau1 /transient/frames/tau2 /transient/frames/P /transient/frames/H
# not on the page
figure = "traction_lines"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"

high = 96 * stretch
half = (high - m(top + 20)) / 2
left = -2.5 * reach_x
right = 1.5 * reach_x
load blocks("/transient/frames/tau1 /transient/frames/tau2 /transient/frames/P /transient/frames/H", \
    sprintf(" --step %d --along x --at y=0 --sample %d --window=%g:%g", frame, 3 * points, left, right), "line")
eval page
set multiplot
set xrange [left:right]
set xtics steps_of(right - left)
eval box(m(17), m(16), m(16) + half, m(top + 4))
set format x ""
stats $line_tau1 using 2 nooutput prefix "A"
stats $line_tau2 using 2 nooutput prefix "B"
set ylabel si ? "shear stress [MPa]" : "shear stress/p_h" offset 1, 0
MPa = si ? 1e3 : 1
set ytics steps_of(MPa * (greater(A_max, B_max) - (A_min < B_min ? A_min : B_min)))
set xzeroaxis lw 0.5 lc rgb grey
eval key_above
plot $line_tau1 using 1:(MPa * $2) with lines lw 1 lc rgb blue title "surface 1", \
     $line_tau2 using 1:(MPa * $2) with lines lw 1 dt (6, 3) lc rgb green title "surface 2"
unset label 100
unset xzeroaxis
eval box(m(17), m(16), m(10), high - m(10) - half)
set format x "%g"
set xlabel axis_along offset 0, 0.4
set ylabel axis_P offset 1, 0
stats $line_P using 2 nooutput prefix "P"
stats $line_H using (abs($1) <= reach_x ? $2 : NaN) nooutput prefix "H"
set yrange [0:1.1 * greater(P_max, p_h)]
set ytics steps_of(P_max) nomirror
set y2label axis_H
set y2range [0:3 * H_max]
set y2tics steps_of(3 * H_max)
plot $line_P using 1:2 with lines lw 1 lc rgb red title "pressure", \
     $line_H using 1:2 axes x1y2 with lines lw 1 lc rgb blue title "film"
unset multiplot
