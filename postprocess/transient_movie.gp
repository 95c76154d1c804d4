# figure: film over the contact as time goes on, an animated GIF
# needs: /transient/frames/H
# movie
# With frames_in='FOLDER' every frame is a PNG there, too: 0000.png and on.
figure = "transient_movie"
here = system(sprintf("dirname '%s'", ARG0))
gif = exists("output") ? output : figure.".gif"
format = "png"
output = "/dev/null"
load here."/common.gp"
set output

times = sprintf("< '%s' extract '%s' /transient/frames/time", ehl, file)
stats times using 1 nooutput prefix "T"
last = int(T_records) - 1
time_of(k) = system(sprintf("'%s' extract '%s' /transient/frames/time | grep -v '#' | sed -n %dp", ehl, file, k + 1))
film(k) = sprintf("< '%s' extract '%s' /transient/frames/H --step %d --matrix", ehl, file, k)
Hc = number("/summary/Hc")
set size ratio -1
set xrange [-1.5:1.5]
set yrange [-1.5:1.5]
set xlabel "X = x/a"
set ylabel "Y = y/a"
set cblabel "H/H_c"
set cbrange [0.4:1.8]
eval "set palette ".film_colours
unset grid
array named[2] = ["gif", "png"]
do for [pass = 1:(exists("frames_in") ? 2 : 1)] {
  if (named[pass] eq "gif") {
    set terminal gif animate delay 8 loop 0 enhanced font "DejaVu Sans,13" size 640, 560 background "#ffffff"
    set output gif
  }
  do for [k = 0:last] {
    if (named[pass] eq "png") {
      set terminal pngcairo enhanced font "DejaVu Sans,13" size 640, 560 background "white"
      set output sprintf("%s/%04d.png", frames_in, k)
    }
    set title sprintf("%s\ntime %.3g a/u_m", title, real(time_of(k))) noenhanced
    plot film(k) matrix nonuniform using 1:2:($3 / Hc) with image notitle
  }
  set output
}
