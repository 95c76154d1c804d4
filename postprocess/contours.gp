# Shared by the maps: $contours of a field in steps from lowest to highest, and in $labels one place for each level:
# where the field is flattest and no other label is near.
set contour base
unset surface
set cntrparam levels incremental step * ceil(low / step + 1e-9), step, highest
set table $contours
# A path ends with the name of its block.
last_of(path) = (slash = strstrt(path, "/"), slash == 0 ? path : last_of(path[slash + 1:*]))
load fields(name, matrix_of(points / 2), "half")
half_of_name = "$half_".last_of(name)
splot @half_of_name matrix nonuniform using 1:2:3 with lines nosurface
unset table
unset contour

coarse = 40
# The number of rows is proportional to the length of the contact.
load fields(name, matrix_of(coarse), "coarse")
coarse_of_name = "$coarse_".last_of(name)
stats @coarse_of_name matrix nonuniform using 3 nooutput prefix "G"
array flat[G_records]
k = 0
stats @coarse_of_name matrix nonuniform using (k = k + 1, flat[k] = $3, 0) nooutput prefix "G"
rows = k / coarse
within(k, n) = k < 0 ? 0 : (k >= n ? n - 1 : k)
node(i, j) = flat[1 + within(j, rows) * coarse + within(i, coarse)]
slope(i, j) = abs(node(i + 1, j) - node(i - 1, j)) + abs(node(i, j + 1) - node(i, j - 1))
at_i(x) = int((x - left) / (right - left) * (coarse - 1) + 0.5)
at_j(y) = int((y - bottom) / (right - left) * (coarse - 1) + 0.5)
# A label is 8 mm wide: other labels and the edge must be 9 mm away.
near = m(9) * (right - left) / (wide - m(33))
on_edge(x, y) = x - left < near / 2 || right - x < near / 2 || y - bottom < near / 4 || 2 * far + bottom - y < near / 4
crowded(x, y, n) = n < 1 ? 0 : ((x - X[n])**2 + 2 * (y - Y[n])**2 < near**2 ? 1 : crowded(x, y, n - 1))
score(x, y) = on_edge(x, y) || crowded(x, y, labels) ? 1e9 : slope(at_i(x), at_j(y))
array X[40]
array Y[40]
array Z[40]
labels = 0
levels = 0
stats $contours using (levels = column(-2) + 1, $3) nooutput prefix "C"
do for [level = 0:levels - 1] {
  best = 1e8
  stats $contours index level using (s = score($1, $2), s < best ? (best = s, best_x = $1, best_y = $2, best_z = $3) : 0) nooutput prefix "G"
  if (best < 1e8 && labels < 40) { labels = labels + 1; X[labels] = best_x; Y[labels] = best_y; Z[labels] = best_z }
}
set print $labels
if (labels == 0) { print "NaN NaN NaN" }
do for [k = 1:labels] { print sprintf("%g %g %g", X[k], Y[k], Z[k]) }
set print
