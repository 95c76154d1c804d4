# figure: film over the contact in time, an animated GIF
# needs: /transient/frames/H map
# movie
# With frames_in='FOLDER', every frame is also saved as a PNG in that folder: 0000.png and so on.
figure = "transient_movie"
here = system(sprintf("dirname '%s'", ARG0))
gif = exists("output") ? output : figure.".gif"
format = "png"
output = "/dev/null"
when = ""
load here."/result.gp"
load here."/in_time.gp"
load here."/window.gp"
unset datafile columnheaders

load here."/film_scale.gp"
top = top + 5
high = high + m(5)
set xrange [left:right]
set yrange [bottom:bottom + 2 * far]
set xtics steps_of(right - left)
set ytics steps_of(2 * far)
set xlabel axis_along offset 0, 0.4
set ylabel axis_Y offset 1, 0
set cblabel axis_H
eval "set palette ".film_colours
eval box(m(13), m(20), m(10), m(top))
eval bar(m(10), m(top))
size = pixels > 0 ? pixels : 640
array named[2] = ["gif", "png"]
do for [pass = 1:(exists("frames_in") ? 2 : 1)] {
  if (named[pass] eq "gif") {
    set terminal gif animate delay 8 loop 0 enhanced font "DejaVu Sans,8" fontscale size / 340.0 \
        size size, int(size * high / wide) background "#ffffff"
    set output gif
  }
  do for [k = 0:frames - 1] {
    if (named[pass] eq "png") {
      set terminal pngcairo enhanced font "DejaVu Sans,8" fontscale size / 340.0 size size, int(size * high / wide) \
          background "white"
      set output sprintf("%s/%04d.png", frames_in, k)
    }
    eval headed
    set label 101 sprintf("%s = %.3g", axis_T, time_of(k)) at graph 0.5, graph 1 offset 0, 0.6 center
    frame = k
    load maps("H", 300)
    plot $map_H matrix nonuniform using 1:2:3 with image notitle
  }
  set output
}
