# figure: accuracy against cost in a run in time: largest error over the run against seconds, tolerance and steps
# needs: time_study
#
# From a table of 'ehl study' of a deck with [transient]:
#   gnuplot -e "table='bump_study.csv'" postprocess/time_precision.gp
figure = "time_precision"
wide = 240.0
if (exists("table")) file = table
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

said(key) = system(sprintf("sed -n 's/^# %s: //p' '%s' | head -n 1", key, file))
if (said("reference error Hc") eq "") exit error file.": this is no table of 'ehl study' of a run in time"
# "Hc Hm P_max P_1 ...": these are passed to a shell, so only names are allowed.
quantities = system(sprintf("sed -n 's/^# reference error \\([A-Za-z0-9_]*\\): .*/\\1/p' '%s' | tr '\\n' ' '", file))
# In older tables, a deviation from the reference was called an error.
before = system(sprintf("grep -c '^rtol.*,deviation_' '%s'", file)) eq "0" ? "error_" : "deviation_"
array limits[words(quantities)]
do for [k = 1:words(quantities)] { limits[k] = real(said("reference error ".word(quantities, k))) }
label_of(name) = name eq "Hc" ? "H_c" : (name eq "Hm" ? "H_m" : (name eq "P_max" ? "P_{max}" : said("probe ".name[3:*])))
missing = system(sprintf("awk -F, '/^#/ {next} !at {for (k = 1; k <= NF; ++k) if ($k == \"status\") at = k; next} \
$at != \"complete\" {printf \"%%s%%s\", n++ ? \", \" : \"\", $1}' '%s'", file))
none = system(sprintf("grep -c ',complete,' '%s'", file)) eq "0"
if (none) exit error file.": no run of this study came to its end: there is nothing to draw"
if (title eq "") title = said("title")

set datafile separator comma
set datafile columnheaders
percent(error) = 100.0 * error
floor_of(error, least) = error > least ? error : least
complete(none) = stringcolumn("status") eq "complete"
colours = "#2166ac #b2182b #e69f00 #009e73 #777777 #cc79a7"
colour(k) = word(colours, (k - 1) % 6 + 1)
shapes = "7 9 5 13 11 15"
shape(k) = int(word(shapes, (k - 1) % 6 + 1))
lowest = 1e300
highest = 0.0
do for [k = 1:words(quantities)] {
  name = word(quantities, k)
  stats file using (complete(0) ? percent(floor_of(column(before.name), limits[k])) : NaN) nooutput prefix "E"
  lowest = E_min < lowest ? E_min : lowest
  highest = E_max > highest ? E_max : highest
}
stats file using (complete(0) ? column("seconds") : NaN) nooutput prefix "S"
stats file using (complete(0) ? column("rtol") : NaN) nooutput prefix "R"
stats file using (complete(0) ? column("steps") : NaN) nooutput prefix "N"

high = 105 * stretch
heading = ""
eval page
set multiplot title title noenhanced
set logscale xy
set format y "%g"
eval log_marks("y", lowest, highest)
set yrange [0.5 * lowest:2.0 * highest]
unset key
columns = "seconds rtol steps"
do for [panel = 1:3] {
  against = word(columns, panel)
  set lmargin at screen 0.065 + 0.32 * (panel - 1)
  set rmargin at screen 0.065 + 0.32 * (panel - 1) + 0.275
  set tmargin at screen 0.85
  set bmargin at screen 0.29
  set xtics auto
  if (panel != 2) { eval log_marks("x", panel == 1 ? S_min : N_min, panel == 1 ? S_max : N_max) }
  if (panel == 1) {set xrange [S_min / 1.4:S_max * 1.4]; set format x "%g"; set xlabel "seconds" offset 0, 0.6}
  if (panel == 2) {set xrange [R_max * 2:R_min / 2]; set format x "10^{%L}"; set xlabel "rtol" offset 0, 0.6}
  if (panel == 3) {set xrange [N_min / 1.4:N_max * 1.4]; set format x "%g"; set xlabel "steps" offset 0, 0.6}
  if (panel == 1) {set ylabel "largest error over the run [%]" offset 0.8, 0} else {unset ylabel}
  plot for [k = 1:words(quantities)] file using \
         (complete(0) ? column(against) : NaN):(percent(floor_of(column(before.word(quantities, k)), limits[k]))) \
         with linespoints pt shape(k) ps 1.0 lw 1.2 lc rgb colour(k), \
       for [k = 1:words(quantities)] percent(limits[k]) with lines dt 3 lw 0.8 lc rgb colour(k)
}

# The key of the curves, below the panels.
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
set tmargin at screen 0.16
set xrange [0:1]
set yrange [0:1]
set for [k = 1:words(quantities)] label k label_of(word(quantities, k)) at 0.07 + 0.93 * (k - 1) / words(quantities), 0.85 \
    point pt shape(k) ps 1.2 lc rgb colour(k) offset 1, 0
set label 20 "dotted: error of the reference, ".said("reference") at 0.06, 0.52 noenhanced font ",6.5"
set label 21 "seconds: ".said("times") at 0.06, 0.24 noenhanced font ",6.5"
set label 22 said("machine") at screen 0.5, 0.925 center noenhanced font ",6"
if (missing ne "") set label 23 "NOT COMPLETE and not drawn: rtol ".missing at 0.94, 0.24 right tc rgb red
plot NaN notitle
unset multiplot
