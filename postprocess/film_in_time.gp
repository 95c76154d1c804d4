# Shared by transient_history and transient_body: the panel of the film.
set format x ""
set ylabel axis_H offset 1, 0
# Widely separated bodies would make the film appear as a flat line.
stats $table_transient using "Hc" nooutput prefix "C"
stats $table_transient using "Hm" nooutput prefix "M"
if (M_min > 0 && C_max > 20 * M_min) { set logscale y; set format y "10^{%L}"; set yrange [*:*]; set ylabel axis_H offset 0, 0 } else { set yrange [below_zero(M_min):0 < *] }
plot for [k = 1:bars] $table_transient using (T(column("time"))):(low_end("Hc")):(high_end("Hc")) @band blue notitle, \
     for [k = 1:bars] $table_transient using (T(column("time"))):(low_end("Hm")):(high_end("Hm")) @band red notitle, \
     $table_transient using (T(column("time"))):"Hc" with lines lw 1 lc rgb blue title "centre", \
     $table_transient using (T(column("time"))):"Hm" with lines lw 1 lc rgb red title "minimum", \
     for [k = 1:quasi] $table_transient using (T(column("time"))):(steady("Hc_quasi_steady")) with lines lw 1 dt (6, 3) lc rgb "#56b4e9" title quasi > 0 ? "quasi-steady" : "", \
     for [k = 1:quasi] $table_transient using (T(column("time"))):(steady("Hm_quasi_steady")) with lines lw 1 dt (6, 3) lc rgb "#e69f00" title quasi > 0 ? "its minimum" : "", \
     for [k = 1:probes] $table_transient using (T(column("time"))):(probes > 0 ? column(sprintf("H_%d", k)) : NaN) with lines lw 0.8 \
         lc rgb probe_colour(k) title probes > 0 ? place(k) : ""
unset logscale y
set format y "% h"
