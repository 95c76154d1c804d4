# figure: the film as an optical interferogram
# needs: /fields/H
figure = "interferogram"
wide = 14
high = 14
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

Hc = number("Hc")
# Nanometres of one unit of H. A dimensionless case has no colours of its own: shown as if h_c were 250 nm.
scale_note = exists("film_nm") ? sprintf("h_c = %.0f nm", film_nm * Hc) : "colours as if h_c = 250 nm"
if (!exists("film_nm")) film_nm = 250.0 / Hc

# Two beams, reflected at the coated glass and at the steel, path 2 n h with n = 1.5; the contrast fades as the
# light of a lamp loses its coherence. Dark where the film is thin.
visibility(h) = exp(-(h / 900.0)**2)
intensity(h, wavelength) = 0.5 * (1 - visibility(h) * cos(4 * pi * 1.5 * h / wavelength))
shade(h, wavelength) = int(255 * intensity(h, wavelength))

set size ratio -1
set xrange [-reach_x - 0.8 * margin:reach_x + 0.4 * margin]
set yrange [-reach_y - 0.6 * margin:reach_y + 0.6 * margin]
set xlabel "X = x/a"
set ylabel "Y = y/a"
unset grid
set label 1 scale_note."\nentrainment →" at graph 0.03, 0.95 left front textcolor rgb "white"
plot field("H") using 1:2:(shade(film_nm * $3, 630.0)):(shade(film_nm * $3, 540.0)):(shade(film_nm * $3, 460.0)) \
    with rgbimage notitle
