# Shared by the figures of films in time: a range of colours or of an axis for all times. Lines of the film within the
# contact are in `map`, "time place film". Films that differ by much, of bodies that come from afar, on logarithms.
stats map using (abs($2) <= 0.9 * reach_x ? $3 : NaN) nooutput prefix "F"
far_apart = F_max > 15 * F_median || F_median > 8 * F_min
low = F_min
highest = far_apart ? F_max : (F_max < 2 * F_median ? F_max : 2 * F_median)
if (far_apart) { set logscale cb; set format cb "10^{%L}" }
set cbrange [low:highest]
