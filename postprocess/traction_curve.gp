# figure: the traction curve: friction and film against the slide-roll ratio
# needs: sweep motion.srr mu
#
# From a table of 'ehl sweep' of a deck with [friction] that varies motion.srr and, as it likes, one key more:
#   gnuplot -e "table='traction_eyring_sweep.csv'" postprocess/traction_curve.gp
figure = "traction_curve"
wide = 22
high = 10.5
if (exists("table")) file = table
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

other = system(sprintf("sed -n 's/^# vary: \\([^ ]*\\) = .*/\\1/p' '%s' | grep -v '^motion.srr$' | head -n 1", file))
values = other eq "" ? "all" : system(sprintf("sed -n 's/^# vary: %s = //p' '%s' | tr , ' '", other, file))
if (words(values) > 6) exit error file.": more than six curves: vary fewer values of ".other
if (title eq "") title = "Traction: ".system(sprintf("basename \"$(sed -n 's/^# deck: //p' '%s')\"", file))

set datafile separator comma
set datafile columnheaders
# Rows of other curves lie between those of one.
set datafile missing NaN
of(v) = stringcolumn("status") eq "converged" && (v eq "all" || stringcolumn(other) eq v)
srr(v) = of(v) ? abs(column("motion.srr")) : NaN
mu(v) = of(v) ? abs(column("mu")) : NaN
colours = "#2166ac #b2182b #1b7837 #762a83 #e08214 #333333"
name(k) = values eq "all" ? "" : other." = ".word(values, k)

# The thickest film of each curve, that of the least sliding.
array thickest[words(values)]
do for [k = 1:words(values)] {
  stats file using (of(word(values, k)) ? column("Hc") : NaN) nooutput prefix "H"
  thickest[k] = H_max
}
stats file using (srr("all") > 0 ? srr("all") : NaN):(mu("all") > 0 ? mu("all") : NaN) nooutput prefix "M"
set multiplot layout 1, 2 title title noenhanced
set title ""
set logscale x
set format x "10^{%T}"
set xlabel "slide-roll ratio (u_1 - u_2)/u_m"

# What a Newtonian oil of the same film would have: the slope of the first point.
set logscale y
set format y "10^{%T}"
set ylabel "friction coefficient μ"
set yrange [0.5 * M_min_y:3 * M_max_y]
set key bottom right reverse Left noenhanced
plot for [k = 1:words(values)] file using (srr(word(values, k))):(mu(word(values, k))) \
         with linespoints pt 7 ps 0.8 lw 1.4 lc rgb word(colours, k) title name(k), \
     M_min_y * x / M_min_x with lines lw 1 dt 2 lc rgb grey title "slope 1"

unset logscale y
set format y "%g"
set yrange [*:*]
set ylabel "central film H_c over its largest value"
set key bottom left reverse Left noenhanced
plot for [k = 1:words(values)] file using (srr(word(values, k))):(of(word(values, k)) ? column("Hc") / thickest[k] : NaN) \
         with linespoints pt 7 ps 0.8 lw 1.4 lc rgb word(colours, k) title name(k)
unset multiplot
