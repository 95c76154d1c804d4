# figure: film and pressure along the line y = 0 against time
# needs: /transient/frames/H /transient/frames/P
# not on the page
figure = "transient_map"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"
load here."/in_time.gp"
unset datafile columnheaders

left = -1.5 * reach_x
right = 1.25 * reach_x
samples = 300
load blocks("/transient/frames/P", sprintf(" --along x --at y=0 --sample %d --window=%.9g:%.9g", samples, left, right), "pressed")
stats $pressed_P using 3 nooutput prefix "P"
load here."/film_scale.gp"
panels = 2
high = 132 * stretch + m(top)
eval page
set multiplot
set xrange [left:right]
set xtics steps_along(left, right, wide - m(38)) offset 0, 0.5
set yrange [T(K_min):K_max > K_min ? T(K_max) : T(K_min) + 1]
set ylabel axis_T offset 0, 0
set view map
# The times need not be evenly spaced.
set pm3d map interpolate 1, 4
tall = (high - m(top + 16)) / panels
# The bottom and the top margin of a panel, in mm of the page.
below(panel) = m(11) + (panels - panel) * (tall + m(5))
above(panel) = m(top) + (panel - 1) * (tall + m(5))
do for [panel = 1:panels] {
  eval box(m(18), m(20), below(panel), above(panel))
  if (panel == panels) { set xlabel axis_along offset 0, 0.8; set format x "%g" } else { unset xlabel; set format x "" }
  set cblabel panel == 1 ? axis_H : axis_P
  eval bar(below(panel), above(panel))
  eval "set palette ".(panel == 1 ? film_colours : pressure_colours)
  if (panel == 2) { unset logscale cb; set format cb "%g"; set cbrange [0:P_max > 0 ? P_max : 1]; set cbtics steps_of(P_max > 0 ? P_max : 1) }
  if (panel == 1 && !far_apart) { set cbtics steps_of(highest - low) }
  if (panel == 1) { splot $course_H using 2:(T($1)):3 with pm3d notitle } else { splot $pressed_P using 2:(T($1)):3 with pm3d notitle }
  unset label 100
  unset label 99
}
unset multiplot
