# figure: the film over the contact as an optical interferogram
# needs: /fields/H map
figure = "interferogram"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"
edge = 4
load here."/window.gp"

# Nanometres of what H is read in. A dimensionless case has no colours of its own: shown as if h_c were 250 nm.
film_nm = si ? 1.0 : 250.0 / abs(centre("H"))
# Beyond the fringes of a lamp a laser shows them: one colour.
laser = film_nm * centre("H") > 1800
note = si ? sprintf("h_c = %.0f nm%s", centre("H"), laser ? ", in light of 630 nm" : "") : \
    sprintf("colours as if h_c = %.0f nm", film_nm * centre("H"))
if (number("/summary/Hm") < 0) { note = note.", red: below zero" }
# Two beams, reflected at the coated glass and at the steel, path 2 n h with n = 1.5; the contrast fades as the light of
# a lamp loses its coherence. Dark where the film is thin.
visibility(h) = laser ? 1 : exp(-(h / 900.0)**2)
# A film below zero has no fringes: light would show it as one above.
shade(h, wavelength) = h < 0 ? (wavelength < 630 ? 30 : 178) : laser && wavelength < 630 ? 0 : \
    int(127.5 * (1 - visibility(h) * cos(4 * pi * 1.5 * h / wavelength)))

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
# Oil ends where it no longer fills the gap.
starved = found("/fields/theta") ne ""
if (starved) {
  set contour base
  unset surface
  set cntrparam levels discrete 0.95
  set table $edge_of_oil
  splot field("theta", 350) matrix nonuniform using 1:2:3 with lines nosurface
  unset table
  unset contour
  set surface
}
if (!starved) { set print $edge_of_oil; print "NaN NaN NaN"; set print }
plot field("H", 700) matrix nonuniform using 1:2:(shade(film_nm * $3, 630.0)):(shade(film_nm * $3, 540.0)): \
    (shade(film_nm * $3, 460.0)) with rgbimage notitle, \
    $edge_of_oil using 1:2 with lines lw 0.8 lc rgb "white" notitle
