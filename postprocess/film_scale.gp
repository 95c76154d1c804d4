# Shared by the figures of films in time: one range of colours, or of an axis, for all times. The lines of the film
# within the contact are in $course_H, "time place film". Films that differ strongly, as those of widely separated
# bodies, get a logarithmic scale.
load blocks("/transient/frames/H", sprintf(" --along x --at y=0 --sample %d --window=%.9g:%.9g", \
    exists("samples") ? samples : 100, left, right), "course")
stats $course_H using (abs($2) <= 0.9 * reach_x ? $3 : NaN) nooutput prefix "F"
stats $course_H using 3 nooutput prefix "N"
far_apart = N_min > 0 && (F_max > 15 * F_median || F_median > 8 * F_min)
low = N_min < 0 ? N_min : F_min
highest = far_apart || F_max < 2 * abs(F_median) ? F_max : 2 * abs(F_median)
if (far_apart) { set logscale cb; set format cb "10^{%L}" }
set cbrange [low:highest]
