# figure: time against the number of nodes (the paper's figure 5)
# needs: /levels
# on demand
figure = "time_against_nodes"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"

high = 62 * stretch + m(top)
eval page
eval box(m(14), m(4), m(10), m(top))
load tables("levels")
set datafile columnheaders
nodes(nx, ny) = (nx + 1.0) * (ny + 1.0)
# Full multigrid reaches a level after all coarser levels: the time of a solution on a level is the sum so far.
sum = 0.0
running(s) = (sum = sum + s, sum)
set table $times
plot $table_levels using (nodes(column("nx"), column("ny"))):(running(column("seconds"))) with table
unset table
unset datafile columnheaders
stats $times using 1 nooutput prefix "N"
stats $times using 2 nooutput prefix "T"
# Both lines pass through the finest level; the coarsest level is converged fully and costs more than its share.
n0 = N_max
t0 = T_max

set logscale xy
set xlabel "nodes n" offset 0, 0.4
set ylabel "seconds to a solution"
set format x "10^{%L}"
set format y "10^{%L}"
set key top left
set xrange [N_min / 2:N_max * 2]
set yrange [T_min / 5:T_max * 3]
set samples 50
plot t0 * x / n0 with lines lw 0.8 dt (6, 4) lc rgb grey title "O(n)", \
     t0 * (x / n0)**2 with lines lw 0.8 dt (1, 2) lc rgb grey title "O(n^2)", \
     $times using 1:2 with linespoints lw 1 pt 7 ps 1 lc rgb blue title "full multigrid, measured"
