# figure: the film over the contact as an optical interferogram
# needs: /fields/H map
# not on the page
figure = "interferogram"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"
edge = 4
load here."/window.gp"

# The film in nanometres. Dimensionless results are drawn assuming h_c = 250 nm.
middle = centre("H")
film_nm = si ? 1.0 : 250.0 / abs(middle)
# Films too thick for the fringes of a lamp are shown as with a laser, in one colour.
laser = film_nm * middle > 1800
note = si ? sprintf("h_c = %.0f nm%s", middle, laser ? ", in light of 630 nm" : "") : \
    sprintf("colours as if h_c = %.0f nm", film_nm * middle)
if (number("/summary/Hm") < 0) { note = note.", red: below zero" }
# Two beams, reflected at the coated glass and at the steel, with a path difference of 2 n h, n = 1.5. The contrast
# decreases with the film because of the limited coherence of the lamp. Thin films are dark.
visibility(h) = laser ? 1 : exp(-(h / 900.0)**2)
shade(h, wavelength) = laser && wavelength < 630 ? 0 : \
    int(127.5 * (1 - visibility(h) * cos(4 * pi * 1.5 * h / wavelength)))
colour(h) = sprintf("'#%02x%02x%02x'", shade(h, 630.0), shade(h, 540.0), shade(h, 460.0))

load maps("H", 700)
most = 2700.0  # nm, from where on a lamp shows no fringes
if (laser) { stats $map_H matrix nonuniform using 3 nooutput; most = film_nm * STATS_max }

high = high + m(5)
eval page
eval box(m(13), m(edge), m(10), m(top + 5))
set label 1 note at graph 0.5, graph 1 offset 0, 0.6 center
set xrange [left:right]
set yrange [bottom:bottom + 2 * far]
set xtics steps_of(right - left)
set ytics steps_of(2 * far)
set xlabel axis_along offset 0, 0.4
set ylabel axis_Y offset label_Y, 0
# The edge of the oil is where the gap is no longer full.
starved = found("/fields/theta") ne ""
if (starved) {
  set contour base
  unset surface
  set cntrparam levels discrete 0.95
  set table $edge_of_oil
  load fields("theta", matrix_of(350), "edge")
  splot $edge_theta matrix nonuniform using 1:2:3 with lines nosurface
  unset table
  unset contour
  set surface
}
if (!starved) { set print $edge_of_oil; print "NaN NaN NaN"; set print }
# The palette of the film. A negative film gets no fringes: they would show it as a positive one.
colours = 2000
step = most / colours
palette_of_film = "-1 '#b21e1e', 0 '#b21e1e'"
do for [k = 0:colours] { palette_of_film = palette_of_film.sprintf(", %d %s", k, colour(k * step)) }
eval "set palette defined (".palette_of_film.")"
unset colorbox
set cbrange [-step / film_nm:most / film_nm]
plot $map_H matrix nonuniform using 1:2:3 with image notitle, \
    $edge_of_oil using 1:2 with lines lw 0.8 lc rgb "white" notitle
