# figure: film, pressure, load and speed against time, and the steps that were taken
# needs: /transient
figure = "transient_history"
high = 18
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

set datafile columnheaders
stats table("transient") using "time" nooutput prefix "T"
# The points that the run looked at, columns P_1, H_1, ...; where each is stands in the deck.
probes = int(system(sprintf("'%s' extract '%s' transient | sed '/^#/!d' | tr ' ' '\n' | grep -c '^P_[0-9]'", ehl, file)))
where(k) = system(sprintf("'%s' extract '%s' deck | sed -n 's/^probe = //p' | cut -d, -f%d | xargs", ehl, file, k))
probe_colours = "#e69f00 #009e73 #cc79a7 #56b4e9 #8c510a #444444"
probe_colour(k) = word(probe_colours, (k - 1) % 6 + 1)
set multiplot layout 3, 1 title title noenhanced
set title ""
set lmargin 11
set rmargin 9
set xrange [T_min:T_max > T_min ? T_max : T_min + 1]
set key tmargin center horizontal samplen 3
set offsets 0, 0, graph 0.1, graph 0.05
set ylabel "H = hR/a^2"
plot table("transient") using "time":"Hc" with lines lw 1.5 lc rgb blue title "H_c, centre", \
     table("transient") using "time":"Hm" with lines lw 1.5 lc rgb red title "H_m, minimum", \
     for [k = 1:probes] table("transient") using "time":(probes > 0 ? column(sprintf("H_%d", k)) : 1/0) with lines lw 1 lc rgb probe_colour(k) \
         title sprintf("H at (%s)", where(k))
set ylabel "P = p/p_h"
set y2label "load, speed over the start"
set ytics nomirror
set y2tics
stats table("transient") using "load" nooutput prefix "L"
stats table("transient") using "speed" nooutput prefix "S"
highest = L_max > S_max ? L_max : S_max
set y2range [0:highest > 0 ? 1.15 * highest : 1]
plot table("transient") using "time":"P_max" with lines lw 1.5 lc rgb red title "P_{max}", \
     for [k = 1:probes] table("transient") using "time":(probes > 0 ? column(sprintf("P_%d", k)) : 1/0) with lines lw 1 lc rgb probe_colour(k) \
         title sprintf("P at (%s)", where(k)), \
     table("transient") using "time":"load" axes x1y2 with lines lw 1 lc rgb grey title "load (right)", \
     table("transient") using "time":"speed" axes x1y2 with lines lw 1 dt 2 lc rgb grey title "speed (right)"
set xlabel "time [a/u_m]"
set ylabel "step [a/u_m]"
set y2label "cycles, order"
set y2range [0:*]
set logscale y
set format y "10^{%T}"
unset offsets
# A run that ended at once took no steps.
if (T_max > T_min) plot table("transient") using "time":(column("step") > 0 ? column("step") : 1/0) with lines lw 1.5 lc rgb blue \
         title "length of the step", \
     table("transient") using "time":"cycles" axes x1y2 with points pt 7 ps 0.25 lc rgb red title "cycles (right)", \
     table("transient") using "time":"order" axes x1y2 with points pt 7 ps 0.15 lc rgb grey title "order (right)"
unset multiplot
