# Shared by film_contours and pressure_contours: a field over the contact in colours, with labelled contour lines.
load here."/window.gp"
load maps(name, points)
map = "$map_".name
stats @map matrix nonuniform using 3 nooutput prefix "F"
low = name eq "P" ? 0 : F_min
# Outside the contact the film grows without bound; films thicker than this are pale.
if (exists("most")) { highest = most } else {
  thick = name eq "P" ? F_max : 1.7 * abs(centre(name))
  highest = F_max < thick ? F_max : thick
}
flat_field = !(highest > low)
if (flat_field) { highest = low + 1; top = top + 4; high = high + m(4) } else { step = round_step((highest - low) / 5); load here."/contours.gp" }

eval page
eval box(m(13), m(20), m(10), m(top))
set xrange [left:right]
set yrange [bottom:bottom + 2 * far]
set xtics steps_of(right - left)
set ytics steps_of(2 * far)
set xlabel axis_along offset 0, 0.4
set ylabel axis_Y offset label_Y, 0
set cblabel quantity
eval "set palette ".colours
set cbrange [low:highest]
set cbtics steps_of(highest - low)
eval bar(m(10), m(top))
unset key
if (flat_field) {
  set label 1 "the same everywhere" at graph 0.5, graph 1 offset 0, 0.6 center
  load maps(name, 50)
  plot @map matrix nonuniform using 1:2:3 with image
} else {
  plot @map matrix nonuniform using 1:2:3 with image, \
       $contours using 1:2 with lines lw 0.4 lc rgb "#333333", \
       $labels using 1:2:3 with labels boxed font ",6"
}
