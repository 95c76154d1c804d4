# figure: film and oil on a track against the number of passes, with the closed form for thin layers; the track
# needs: /passes /tracks
figure = "film_against_passes"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"

load tables("passes tracks /passes/thin_layers")
set datafile columnheaders
unset tics
stats $table_passes using "pass" nooutput prefix "N"
stats $table_passes using "left" nooutput prefix "L"
stats $table_passes using "Hm" nooutput prefix "M"
stats $table_passes using "Hc" nooutput prefix "C"
set tics
panel = 52 * stretch
high = 2 * panel + m(top + 38)
eval page
set multiplot
below = panel + m(24)
eval box(m(14), m(4), below, m(top + 7))
# Unless there are few passes, the axes are logarithmic: the closed form decreases as n^-1/2.
n_min = 0.9
n_max = 1.15 * N_max
set xrange [n_min:n_max]
eval "set logscale x; ".log_marks("x", 1, N_max)
low = 0.85 * M_min
highest = 1.15 * (L_max > C_max ? L_max : C_max)
# A negative film has no logarithm.
set yrange [low > 0 ? low : below_zero(M_min):highest]
if (low > 0) { eval "set logscale y; ".log_marks("y", low, highest) }
set xlabel "passes n" offset 0, 0.4
set ylabel axis_H offset 0.5, 0
eval key_above
formula = 0
do for [k = 1:|$table_thin_layers|] { formula = formula || $table_thin_layers[k] ne "nan" }
plot $table_passes using "pass":"left" with points pt 7 ps 0.8 lc rgb blue title "oil left, y = 0", \
     $table_passes using "pass":(formula ? column("thin_layers") : NaN) with lines lw 0.9 dt 2 lc rgb blue title formula ? "thin layers" : "", \
     $table_passes using "pass":"Hc" with points pt 6 ps 0.8 lc rgb red title "centre", \
     $table_passes using "pass":"Hm" with points pt 4 ps 0.8 lc rgb green title "minimum"

# The track after 1, 2, 5, 10, 20 .. passes, and after the last.
unset label 100
unset logscale
unset key
eval box(m(14), m(4), m(10), panel + m(top + 26))
reset_far = 1.6 * reach_y
set xrange [-reset_far:reset_far]
set yrange [0:*]
set xtics steps_of(2 * reset_far)
set ytics auto
set xlabel axis_Y offset 0, 0.4
set ylabel (si ? "oil left [nm]" : "oil left [a^2/R]") offset 0.5, 0
decade(n) = 10**floor(log10(n) + 1e-9)
marked(n) = n == N_max || n == decade(n) || n == 2 * decade(n) || n == 5 * decade(n)
list = ""
do for [n = 1:int(N_max)] { if (marked(n)) { list = list." ".n } }
shade(k) = int(200 * (1 - k / (words(list) + 0.0)))
ink(k) = shade(k) * 65536 + shade(k) * 256 + 255 * (k < words(list))
set key at graph 0.5, graph 1.01 center bottom horizontal samplen 1.5 maxrows 2
plot for [k = 1:words(list)] $table_tracks using "y":(column("pass") == real(word(list, k)) ? column("layer") : NaN) \
    with lines lw (k == words(list) ? 1.4 : 0.9) lc rgb ink(k) title word(list, k)
unset multiplot
