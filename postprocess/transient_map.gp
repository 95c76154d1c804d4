# figure: film along the centre line against time
# needs: /transient/frames/H
figure = "transient_map"
high = 12
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

map = sprintf("< '%s' extract '%s' /transient/frames/H --along x --at y=0", ehl, file)
Hc = number("/summary/Hc")
set lmargin 9
set rmargin 16
set xlabel "X = x/a"
set ylabel "time [a/u_m]"
set cblabel "H/H_c"
set xrange [-1.5:1.25]
set autoscale yfix
set palette @film_colours
# The film in the contact, down to its thinnest; the inlet is thicker than any colour tells.
stats map using (abs($2) <= 1 ? $3 / Hc : NaN) nooutput prefix "H"
set cbrange [H_min < 0.6 ? 0.1 * floor(10 * H_min) : 0.6:1.6]
set cbtics 0.2
unset grid
set tics out
set view map
set pm3d map interpolate 1,1
splot map using 2:1:($3 / Hc) with pm3d notitle
