# figure: order of accuracy: error against cells, one curve per method of the study
# needs: study
# on the page
figure = "error_against_cells"
wide = 190.0
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

said(key) = system(sprintf("sed -n 's/^# %s: //p' '%s' | head -n 1", key, file))
if (said("reference Hc") eq "") exit error file.": this is no table of 'ehl study'"
limit_Hc = 100.0 * real(said("reference error Hc"))
limit_Hm = 100.0 * real(said("reference error Hm"))
# The rows of each way, coarse to fine, with a blank line between two ways: "wedge,cells,error of Hc, of Hm".
# In older tables, a deviation from the reference was called an error.
rows = sprintf("awk -F, -v OFS=, '/^#/ {next} !(\"nx\" in at) {for (k = 1; k <= NF; ++k) {sub(/^error_/, \"deviation_\", $k); at[$k] = k}; next} \
$at[\"status\"] == \"converged\" || $at[\"status\"] == \"stopped\" {print $at[\"wedge\"], \
$at[\"cells\"], 100 * $at[\"deviation_Hc\"], 100 * $at[\"deviation_Hm\"], $at[\"evaluator\"], $at[\"cycles\"]}' '%s' | \
sort -t, -k1,1 -k5,5 -k6,6 -k2,2n", file)
wedges = system(rows." | awk -F, '!seen[$1]++ {printf \"%s \", $1}'")
of(w) = "< ".rows.sprintf(" | awk -F, '$1 == \"%s\" {if (way != \"\" && way != $5 $6) {print \"\"}; way = $5 $6; print}'", w)
colour(w) = w eq "upstream1" ? grey : (w eq "upstream2" ? blue : red)
if (title eq "") title = said("title")

set datafile separator comma
stats "< ".rows using 2 nooutput prefix "N"
stats "< ".rows using ($3 > 0 ? $3 : NaN) nooutput prefix "C"
stats "< ".rows using ($4 > 0 ? $4 : NaN) nooutput prefix "M"
high = 78 * stretch
heading = ""
eval page
set multiplot title title noenhanced
set logscale xy
set format "%g"
set xrange [N_min / 1.15:N_max * 1.15]
lowest = 0.5 * (C_min < M_min ? C_min : M_min)
highest = 2.0 * (C_max > M_max ? C_max : M_max)
set yrange [lowest:highest]
eval log_marks("y", lowest, highest)
set xtics (1)
do for [k = 0:20] { set xtics add (sprintf("%d", int(N_min * 2**k + 0.5)) N_min * 2**k) }
set xlabel "cells along x" offset 0, 0.3
set key at graph 0.98, graph 0.97 right top samplen 2
do for [panel = 1:2] {
  eval box(panel == 1 ? 16 * stretch : 108 * stretch, panel == 1 ? 98 * stretch : 6 * stretch, 13 * stretch, 11 * stretch)
  set title "(".(panel == 1 ? "a) central" : "b) minimum")." film; dotted: error of the reference" offset 0, -0.7
  set ylabel "error of ".(panel == 1 ? "H_c" : "H_m")." [%]" offset 0.5, 0
  limit = panel == 1 ? limit_Hc : limit_Hm
  plot for [w in wedges] of(w) using 2:(column(panel + 2)) with linespoints pt 7 ps 0.8 lw 0.8 lc rgb colour(w) title w, \
       limit with lines dt 3 lw 0.8 lc rgb "black" notitle
}
unset multiplot
