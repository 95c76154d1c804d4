# figure: film and pressure along the centre line at six times
# needs: /transient/frames/H /transient/frames/P
figure = "transient_lines"
high = 15
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

stats sprintf("< '%s' extract '%s' /transient/frames/time", ehl, file) using 1 nooutput prefix "T"
frames = int(T_records)
shown = frames < 6 ? frames : 6
frame(k) = shown > 1 ? int(floor((k * (frames - 1.0)) / (shown - 1) + 0.5)) : 0
time_of(k) = real(system(sprintf("'%s' extract '%s' /transient/frames/time | grep -v '#' | sed -n %dp", ehl, file, frame(k) + 1)))
line(name, k) = sprintf("< '%s' extract '%s' /transient/frames/%s --step %d --along x --at y=0", ehl, file, name, frame(k))
Hc = number("/summary/Hc")
set palette defined (0 blue, 0.5 "#9b5fa0", 1 red)
unset colorbox
set multiplot layout 2, 1 title title noenhanced
set title ""
set lmargin 10
set rmargin 3
set xrange [-1.75:1.4]
set key top right maxrows 3
set ylabel "H = hR/a^2"
set yrange [0:3 * Hc]
plot for [k = 0:shown - 1] line("H", k) using 1:2:(k) with lines lw 1.5 lc palette title sprintf("time %.3g", time_of(k))
set xlabel "X = x/a"
set ylabel "P = p/p_h"
set yrange [0:*]
plot for [k = 0:shown - 1] line("P", k) using 1:2:(k) with lines lw 1.5 lc palette notitle
unset multiplot
