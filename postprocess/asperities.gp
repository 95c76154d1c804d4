# figure: asperities of a map: pressure and share of the area in contact, and flow factors, against the gap
# needs: asperities
#
# From a table of 'ehl asperities':
#   gnuplot -e "table='map_asperities.csv'" postprocess/asperities.gp
figure = "asperities"
wide = 190.0
if (exists("table")) file = table
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

said(key) = system(sprintf("sed -n 's/^# %s: //p' '%s' | head -n 1", key, file))
Sq = real(said("Sq"))
if (Sq <= 0) exit error file.": this is no table of 'ehl asperities'"
gamma = said("gamma")
if (system(sprintf("grep -c '^# NOT CONVERGED' '%s'", file)) ne "0") mark = "NOT CONVERGED: see the table"

set datafile separator comma
set datafile columnheaders
# Columns that a table may lack are drawn if its heading has them.
has(name) = system(sprintf("grep -v '^#' '%s' | head -n 1 | grep -c '%s \\['", file, name)) ne "0"
unit(name) = name eq "pressure" || name eq "pressure_gw" ? "Pa" : (name eq "gap" || name eq "error_gap" ? "m" : "-")
heading_of(name) = name." [".unit(name)."]"
cell(name) = column(heading_of(name))
l(none) = cell("gap") / Sq
touches(none) = cell("pressure") > 0
stats file using (l(0)) nooutput prefix "L"
stats file using (touches(0) ? 1e-6 * cell("pressure") : NaN) nooutput prefix "P"

stats file using (touches(0) ? l(0) : NaN) nooutput prefix "T"
stats file using (touches(0) ? 100 * cell("area") : NaN) nooutput prefix "A"
stats file using (cell("phi_x") > cell("phi_y") ? cell("phi_x") : cell("phi_y")) nooutput prefix "F"

high = 76 * stretch
heading = title
eval page
set multiplot
set xrange [0:L_max * 1.03]
set xlabel "gap over Sq = ".(Sq < 1e-6 ? sprintf("%.3g nm", 1e9 * Sq) : sprintf("%.3g µm", 1e6 * Sq)) offset 0, 0.4
set grid lw 0.3 lc rgb "#dddddd"

# Pressure and area, where the surfaces touch.
set xrange [0:T_max * 1.05]
eval box(m(17), 0.5 * wide + m(11), m(21), m(6))
set logscale y
set logscale y2
set format y "%g"
set format y2 "%g"
set yrange [P_min / 2:P_max * 2]
set y2range [A_min / 2:A_max * 2 > 100 ? 100 : A_max * 2]
eval log_marks("y", P_min, P_max)
eval log_marks("y2", A_min, A_max)
set format y "%g"
set ytics nomirror
set y2tics nomirror
set ylabel "mean pressure [MPa]" offset 0.8, 0
set y2label "area in contact [%]" offset -0.8, 0
set key at graph 0.5, screen m(1) / high center bottom horizontal maxrows 2 samplen 2.5 width 1 font ",7.5"
gw = has("pressure_gw")
plot file using (touches(0) ? l(0) : NaN):(1e-6 * cell("pressure")) with linespoints pt 7 ps 0.8 lw 1.2 lc rgb red title "pressure", \
     gw ? file : "+" using (gw && touches(0) ? l(0) : NaN):(gw ? 1e-6 * cell("pressure_gw") : NaN) with lines dt 2 lw 0.9 lc rgb red title gw ? "Greenwood, Williamson" : "", \
     file using (touches(0) ? l(0) : NaN):(100 * cell("area")) axes x1y2 with linespoints pt 5 ps 0.7 lw 1.2 lc rgb grey title "area"

# Flow factors.
unset logscale
unset y2tics
unset y2label
set ytics auto mirror
set xrange [0:L_max * 1.03]
eval box(0.5 * wide + m(15), m(4), m(21), m(6))
set yrange [0:F_max > 1 ? F_max * 1.05 : 1.02]
set ylabel "flow factor" offset 0.8, 0
pc = has("phi_x_pc")
ex = has("error_phi_x")
plot file using (l(0)):(cell("phi_x")):(ex ? cell("error_phi_x") : 0) with yerrorbars pt 7 ps 0.8 lw 0.8 lc rgb blue notitle, \
     file using (l(0)):(cell("phi_x")) with linespoints pt 7 ps 0.8 lw 1.2 lc rgb blue title "along x", \
     file using (l(0)):(cell("phi_y")):(ex ? cell("error_phi_y") : 0) with yerrorbars pt 5 ps 0.7 lw 0.8 lc rgb green notitle, \
     file using (l(0)):(cell("phi_y")) with linespoints pt 5 ps 0.7 lw 1.2 lc rgb green title "along y", \
     file using (l(0)):(pc ? cell("phi_x_pc") : NaN) with lines dt 2 lw 0.9 lc rgb blue title pc ? "Patir, Cheng, gamma ".sprintf("%.2g", real(gamma)) : "", \
     file using (l(0)):(pc ? cell("phi_y_pc") : NaN) with lines dt 2 lw 0.9 lc rgb green notitle
unset multiplot
