# figure: what accuracy costs: error against seconds and work for every way of a study, with the Pareto front
# needs: study
#
# From a table of 'ehl study':
#   gnuplot -e "table='venner1992_M50_L10_study.csv'" postprocess/work_precision.gp
figure = "work_precision"
wide = 190.0  # a journal's two columns
if (exists("table")) file = table
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

said(key) = system(sprintf("sed -n 's/^# %s: //p' '%s' | head -n 1", key, file))
# The different words of a column, in the order in which they come.
words_of(name) = system(sprintf("awk -F, -v name=%s '/^#/ {next} !at {for (k = 1; k <= NF; ++k) if ($k == name) at = k; next} \
!seen[$at]++ {printf \"%%s \", $at}' '%s'", name, file))
if (said("reference Hc") eq "") exit error file.": this is no table of 'ehl study'"
wedges = words_of("wedge")
evaluators = words_of("evaluator")
cycles = words_of("cycles")
# Seconds and error of the points on a Pareto front, in the order of the seconds.
front_of(name) = sprintf("< awk -F, '/^#/ {next} !(\"nx\" in at) {for (k = 1; k <= NF; ++k) at[$k] = k; next} \
$at[\"front_%s\"] == 1 {print $at[\"seconds\"] \",\" $at[\"error_%s\"]}' '%s' | sort -g | sed '1i s,e'", name, name, file)
limit(name) = real(said("reference error ".name))
if (title eq "") title = said("title")

set datafile separator comma
set datafile columnheaders
is(name, word) = stringcolumn(name) eq word
# Only what has a film that can be looked at.
has_film(none) = is("status", "converged") || is("status", "stopped")
chosen(w, e, c) = has_film(0) && is("wedge", w) && is("evaluator", e) && is("cycles", c)
nodes(none) = (column("nx") + 1.0) * (column("ny") + 1.0)
cost(panel) = panel == 1 ? column("seconds") : column("work_units") * nodes(0)
floor_of(error, least) = error > least ? error : least
percent(error) = 100.0 * error

# Colour: the evaluator. Shape: the cycles. Open: first order; filled: second order.
colour(e) = e eq "mlmi4" ? "#e69f00" : (e eq "mlmi6" ? "#d55e00" : (e eq "mlmi8" ? "#b2182b" : (e eq "fft" ? "#2166ac" : "#777777")))
open_shapes = "8 10 4 6 12 14"
filled_shapes = "9 11 5 7 13 15"
shape(w, k) = int(word(w eq "upstream1" ? open_shapes : filled_shapes, (k - 1) % 6 + 1))

stats file using (has_film(0) ? percent(floor_of(column("error_Hc"), limit("Hc"))) : NaN) nooutput prefix "C"
stats file using (has_film(0) ? percent(floor_of(column("error_Hm"), limit("Hm"))) : NaN) nooutput prefix "M"
stats file using (has_film(0) ? cost(1) : NaN) nooutput prefix "S"
stats file using (has_film(0) ? cost(2) : NaN) nooutput prefix "W"
lowest = 0.5 * (C_min < M_min ? C_min : M_min)
highest = 2.0 * (C_max > M_max ? C_max : M_max)

high = 164 * stretch
heading = ""
eval page
set multiplot title title noenhanced
set logscale xy
set format y "%g"
set yrange [lowest:highest]
unset key
left(panel) = panel == 1 ? 0.075 : 0.56
top(row) = row == 1 ? 0.925 : 0.52
height = 0.31

do for [row = 1:2] {
  name = row == 1 ? "Hc" : "Hm"
  error = "error_".name
  least = limit(name)
  do for [panel = 1:2] {
    set lmargin at screen left(panel)
    set rmargin at screen left(panel) + 0.42
    set tmargin at screen top(row)
    set bmargin at screen top(row) - height
    letter = substr("abcd", 2 * row + panel - 2, 2 * row + panel - 2)
    set xrange [(panel == 1 ? S_min : W_min) / 1.5:(panel == 1 ? S_max : W_max) * 1.5]
    set format x (panel == 1 ? "%g" : "10^{%L}")
    set title "(".letter.") ".(row == 1 ? "central film" : "minimum film") offset 0, -0.7
    set xlabel (panel == 1 ? "seconds" : "work: evaluated nodes") offset 0, 0.6
    set ylabel "error of ".(row == 1 ? "H_c" : "H_m")." [%]" offset 0, 0
    unset object
    set object 1 rectangle from graph 0, first lowest to graph 1, first percent(least) behind fillstyle solid noborder \
        fillcolor rgb "#ececec"
    eval log_marks("y", lowest, highest)
    if (panel == 1) { eval log_marks("x", S_min, S_max) } else { set xtics auto }
    plot for [w in wedges] for [e in evaluators] for [k = 1:words(cycles)] file \
             using (chosen(w, e, word(cycles, k)) ? cost(panel) : NaN):(percent(floor_of(column(error), least))) \
             with points pt shape(w, k) ps 1.3 lw 0.6 lc rgb colour(e), \
         front_of(name) using (panel == 1 ? $1 : NaN):(percent(floor_of($2, least))) with steps lc rgb "black" lw 1.3, \
         front_of(name) using (panel == 1 ? $1 : NaN):(percent(floor_of($2, least))) with points pt 6 ps 2.4 lc rgb "black"
  }
}

# The key below the panels.
unset object
unset title
unset xlabel
unset ylabel
unset tics
unset border
unset grid
unset logscale
set format
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 0.15
set xrange [0:1]
set yrange [0:1]
set for [k = 1:words(evaluators)] label k word(evaluators, k) at 0.1 + 0.1 * (k - 1), 0.75 point pt 7 ps 1.2 \
    lc rgb colour(word(evaluators, k)) offset 1, 0
set for [k = 1:words(cycles)] label 10 + k word(cycles, k) at 0.1 + 0.1 * (k - 1), 0.48 point pt shape("upstream2", k) \
    ps 1.2 lc rgb "#333333" offset 1, 0
set label 20 "film by" at 0.02, 0.75
set label 21 "cycles" at 0.02, 0.48
set label 22 "open: upstream1, filled: upstream2" at 0.64, 0.75
set label 23 "line and rings: nothing cheaper is as accurate" at 0.64, 0.48
set label 24 "grey: below the error of the reference, ".said("reference cells")." cells extrapolated" at 0.02, 0.2
set label 25 "seconds: ".said("times")."; ".said("machine") at screen 0.5, 0.962 center noenhanced font ",6"
plot NaN notitle
unset multiplot
