# figure: the starved film relative to the flooded film against the supply, with Chevalier's formula for point contacts
# needs: sweep supply_ratio starvation_factor
#
# From a table of 'ehl sweep' over a key of [supply].
figure = "film_against_supply"
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

set datafile separator comma
set datafile columnheaders
r(none) = stringcolumn("status") eq "converged" ? column("supply_ratio") : NaN
stats file using (r(0)) nooutput prefix "R"
if (!exists("R_min")) exit error file.": no case has a converged solution"
stats file using (r(0) > 0 ? column("starvation_factor") : NaN) nooutput prefix "F"
x_min = R_min / 1.3
x_max = R_max * 1.3
y_min = F_min / 1.3
y_max = 1.3 > F_max * 1.1 ? 1.3 : F_max * 1.1
high = 76 * stretch + m(top)
eval page
eval box(m(14), m(4), m(10), m(top))
set logscale xy
set xrange [x_min:x_max]
set yrange [y_min:y_max]
eval log_marks("x", x_min, x_max)
eval log_marks("y", y_min, y_max)
set xlabel "supply over the flooded film, r" offset 0, 0.4
set ylabel "film over the flooded film" offset 0.5, 0
set key at graph 0.97, graph 0.03 right bottom vertical
set samples 400
by_supply(x, gamma) = x / (1 + x**gamma)**(1.0 / gamma)
plot x < 1 ? x : 1 with lines lw 0.6 lc rgb grey notitle, \
     by_supply(x, 2) with lines lw 0.8 dt 3 lc rgb grey title "γ = 2", \
     by_supply(x, 3) with lines lw 0.8 dt 1 lc rgb "black" title "γ = 3 (Chevalier, point contacts)", \
     by_supply(x, 5) with lines lw 0.8 dt 2 lc rgb grey title "γ = 5", \
     file using (r(0)):"starvation_factor" with points pt 7 ps 0.9 lc rgb blue title "computed"
