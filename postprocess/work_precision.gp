# figure: accuracy against cost: error against seconds, one front per wedge, with the seconds to 1, 0.1 and 0.01 %
# needs: study
#
# From a table of 'ehl study':
#   gnuplot -e "table='venner1992_M50_L10_study.csv'" postprocess/work_precision.gp
figure = "work_precision"
wide = 190.0  # two columns of a journal
if (exists("table")) file = table
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

said(key) = system(sprintf("sed -n 's/^# %s: //p' '%s' | head -n 1", key, file))
if (said("reference Hc") eq "") exit error file.": this is no table of 'ehl study'"
# In older tables, a deviation from the reference was called an error. The rows with a film to judge, as
# "wedge,seconds,error of Hc, of Hm, nodes"; errors are in per cent, and not below that of the reference.
limit(name) = 100.0 * real(said("reference error ".name))
rows = sprintf("awk -F, -v OFS=, '/^#/ {next} !(\"nx\" in at) {for (k = 1; k <= NF; ++k) {sub(/^error_/, \"deviation_\", $k); at[$k] = k}; next} \
function low(e, least) {return e > least ? e : least} $at[\"status\"] == \"converged\" || $at[\"status\"] == \"stopped\" \
{print $at[\"wedge\"], $at[\"seconds\"], low(100 * $at[\"deviation_Hc\"], %.9g), low(100 * $at[\"deviation_Hm\"], %.9g), \
($at[\"nx\"] + 1) * ($at[\"ny\"] + 1)}' '%s'", limit("Hc"), limit("Hm"), file)
wedges = system(rows." | awk -F, '!seen[$1]++ {printf \"%s \", $1}'")
of(w) = "< ".rows." | awk -F, '$1 == \"".w."\"'"
# The Pareto front: points without a cheaper point of the same accuracy. Columns: seconds, error, nodes.
# column: 3 for Hc, 4 for Hm.
front(w, column) = rows.sprintf(" | awk -F, '$1 == \"%s\"' | sort -t, -g -k2 | awk -F, -v OFS=, \
'NR == 1 || $%d < e {e = $%d; print $2, e, $5}'", w, column, column)
# The seconds after which the front has an error of e %; empty if it does not reach this error.
seconds_to(w, column, e) = system(front(w, column).sprintf(" | awk -F, '$2 <= %g {print $1; exit}'", e))
if (title eq "") title = said("title")

set datafile separator comma
stats "< ".rows using 2 nooutput prefix "S"
stats "< ".rows using 3 nooutput prefix "C"
stats "< ".rows using 4 nooutput prefix "M"
lowest = 0.5 * (C_min < M_min ? C_min : M_min)
highest = 2.0 * (C_max > M_max ? C_max : M_max)
colour(w) = w eq "upstream1" ? grey : (w eq "upstream2" ? blue : red)
shape(w) = w eq "upstream1" ? 4 : (w eq "upstream2" ? 6 : 7)

high = 88 * stretch
heading = ""
eval page
set multiplot title title noenhanced
set logscale xy
set xrange [S_min / 1.5:S_max * 2.5]
set yrange [lowest:highest]
eval log_marks("x", S_min, S_max)
eval log_marks("y", lowest, highest)
set grid ytics lc rgb "#dddddd"
set xlabel "seconds" offset 0, 0.3
set key at graph 0.98, graph 0.97 right top samplen 2
set label 25 "seconds: ".said("times")."; ".said("machine") at screen 0.5, 1 - m(8) / high center noenhanced font ",6"
set label 26 "small: every method of the study; line: nothing cheaper is as accurate; numbers: seconds to 1, 0.1, 0.01 %; \
grey: below the error of the reference" at screen 0.5, m(3) / high center font ",6"
do for [panel = 1:2] {
  name = panel == 1 ? "Hc" : "Hm"
  eval box(panel == 1 ? 16 * stretch : 108 * stretch, panel == 1 ? 98 * stretch : 6 * stretch, 15 * stretch, 15 * stretch)
  set title "(".(panel == 1 ? "a) central" : "b) minimum")." film" offset 0, -0.7
  set ylabel "error of ".(panel == 1 ? "H_c" : "H_m")." [%]" offset 0.5, 0
  set object 1 rectangle from graph 0, first lowest to graph 1, first limit(name) behind fillstyle solid noborder \
      fillcolor rgb "#ececec"
  do for [k = 1:words(wedges)] { do for [d = 1:3] {
    unset label 10 * k + d + 200
    at = seconds_to(word(wedges, k), panel + 2, 10.0**(1 - d))
    if (at ne "") {
      last = k == words(wedges)  # the last label is below its line, the others above
      set label 10 * k + d + 200 sprintf("%.2g s", real(at)) at first real(at), first 10.0**(1 - d) left \
          offset (last ? -5.5 : 0.4), (last ? -0.5 : 0.5) tc rgb colour(word(wedges, k)) font ",7"
    }
  } }
  plot for [w in wedges] of(w) using 2:(column(panel + 2)) with points pt shape(w) ps 0.5 lw 0.4 lc rgb colour(w) notitle, \
       for [w in wedges] "< ".front(w, panel + 2) using 1:2 with steps lc rgb colour(w) lw 1.4 notitle, \
       for [w in wedges] "< ".front(w, panel + 2) using 1:2 with points pt shape(w) ps 1.6 lw 1 lc rgb colour(w) title w
}
unset multiplot
