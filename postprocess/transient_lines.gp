# figure: film and pressure along the line y = 0 at six times, between which they change about equally
# needs: /transient/frames/H /transient/frames/P
# not on the page
figure = "transient_lines"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"
load here."/in_time.gp"
stats $table_transient using "Hc" nooutput prefix "C"
stats $table_transient using "Hm" nooutput prefix "M"
stats $table_transient using "P_max" nooutput prefix "P"
unset datafile columnheaders

# Six frames between which the course of films and pressure is about equally long: more of them where something happens.
# A hundredth of the course is time itself, so that a steady run has frames at equal distances.
shown = frames < 6 ? frames : 6
# Films that differ strongly count by their ratios, as on their axis.
ratios = M_min > 0 && C_max > 20 * M_min
relative(value, before, low, high) = alike(low, high) ? 0 : abs(value - before) / (high - low)
film(value, before, low, high) = ratios && !alike(low, high) ? abs(log(value / before)) / log(high / low) : relative(value, before, low, high)
number_in(row, k) = real(word($table_transient[row], k))
rows = |$table_transient|
array length[frames]
row = 3
so_far = 0
do for [k = 1:frames] {
  until = real($table_time[k])
  while (row <= rows && number_in(row, 1) <= until) {
    so_far = so_far + film(number_in(row, 2), number_in(row - 1, 2), C_min, C_max) \
        + film(number_in(row, 3), number_in(row - 1, 3), M_min, M_max) \
        + relative(number_in(row, 6), number_in(row - 1, 6), P_min, P_max) \
        + 0.01 * (number_in(row, 1) - number_in(row - 1, 1)) / (T_max - T_min)
    row = row + 1
  }
  length[k] = so_far
}
array picked[shown]
at = 1
do for [k = 1:shown] {
  goal = shown > 1 ? (k - 1.0) / (shown - 1) * length[frames] : 0
  # Frames that follow must remain for those that are still to be picked.
  while (at < frames - (shown - k) && length[at] < goal - 1e-12 * length[frames]) { at = at + 1 }
  picked[k] = at
  at = at + 1
}
frame(k) = picked[k + 1] - 1
left = -1.75 * reach_x
right = 1.4 * reach_x
steps = "0"
do for [k = 0:shown - 1] { steps = steps.sprintf(",%d", frame(k)) }
load blocks("/transient/frames/H /transient/frames/P", \
    sprintf(" --along x --at y=0 --sample 1000 --window=%.9g:%.9g --step %s", left, right, steps), "line")
curve(name, k, text) = sprintf("%s $line_%s_%d using 1:2:(%d) with lines lw 1 lc palette %s", \
    k > 0 ? "," : "plot", name, frame(k), k, text)
load here."/film_scale.gp"
panels = 2
high = 84 * stretch + m(top + 20)
top = top + 8  # the key of the curves has three rows
eval page
set multiplot
set xtics steps_along(left, right, wide - m(21))
set xrange [left:right]
set palette defined (0 "#f89540", 0.25 "#e16462", 0.5 "#b12a90", 0.75 "#6a00a8", 1 "#0d0887")
unset colorbox
set cbrange [0:shown > 1 ? shown - 1 : 1]
unset logscale cb
eval panel(1)
set format x ""
set ylabel axis_H offset 1, 0
if (far_apart) { set logscale y; set format y "10^{%L}"; set ylabel axis_H offset 0, 0; set yrange [low / 1.5:highest * 1.5] } else { set yrange [below_zero(low):1.4 * highest] }
films = ""
set key title axis_T
do for [k = 0:shown - 1] { films = films.curve("H", k, sprintf("title '%.4g'", time_of(frame(k)))) }
eval films
unset logscale y
set format y "% h"
eval panel(2)
unset key
set format x "%g"
set xlabel axis_X offset 0, 0.4
set ylabel axis_P offset 1, 0
set yrange [*:*]
tallest = 0
pressures = ""
do for [k = 0:shown - 1] {
  eval sprintf("stats $line_P_%d using 2 nooutput prefix 'P'", frame(k))
  tallest = greater(P_max, tallest)
  pressures = pressures.curve("P", k, "")
}
if (tallest > 0) { set yrange [0:*] } else { set yrange [0:1] }
eval pressures
unset multiplot
