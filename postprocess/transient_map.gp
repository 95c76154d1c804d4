# figure: film along the line y = 0 against time
# needs: /transient/frames/H
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
load here."/film_scale.gp"
high = 75 * stretch + m(top)
eval page
eval box(m(14), m(20), m(11), m(top))
set xrange [left:right]
set xtics steps_of(right - left)
set yrange [T(K_min):K_max > K_min ? T(K_max) : T(K_min) + 1]
set xtics offset 0, 0.5
set xlabel axis_along offset 0, 0.8
set ylabel axis_T offset -0.4, 0
set cblabel axis_H
if (!far_apart) { set cbtics steps_of(highest - low) }
eval bar(m(11), m(top))
eval "set palette ".film_colours
set view map
# The times need not be evenly spaced.
set pm3d map interpolate 1, 4
splot $course_H using 2:(T($1)):3 with pm3d notitle
