# Shared by the figures that draw the rows of a sweep as curves. `ehl plot` prepares the variables: `data` has one block
# for each curve of each quantity, with rows "x y error formula_1 formula_2 formula_3"; curves, quantities and lost
# (cases without a solution) are numbers; the names are in curve_1, quantity_1, formula_1 and so on.
if (!exists("data")) exit error "the rows of a table are arranged by: ehl plot TABLE.csv"
name(kind, k) = value(sprintf("%s_%d", kind, k))
series = curves * quantities
curve_of(s) = (s - 1) % curves + 1
quantity_of(s) = (s - 1) / curves + 1
colour(s) = word(curve_colours, curve_of(s))
formulas = 0
do for [f = 1:3] { formulas = formulas + (name("formula", f) ne "") }
longest = 0
do for [k = 1:curves] { longest = strlen(name("curve", k)) > longest ? strlen(name("curve", k)) : longest }
do for [k = 1:quantities] { longest = quantities > 1 && strlen(name("quantity", k)) > longest ? strlen(name("quantity", k)) : longest }
do for [k = 1:3] { longest = strlen(name("formula", k)) > longest ? strlen(name("formula", k)) : longest }
# Ranges that include the formulas and the error bars.
low_of(a, b) = a < b ? a : b
high_of(a, b) = a > b ? a : b
stats data using 1 nooutput prefix "A"
stats data using 2 nooutput prefix "B"
stats data using (valid(3) && $2 - $3 > 0.2 * $2 ? $2 - $3 : $2) nooutput prefix "L"
x_min = A_min
x_max = A_max
y_min = L_min
y_max = B_max
do for [f = 1:3] { if (name("formula", f) ne "") {
  stats data using (column(3 + f)) nooutput prefix "F"
  y_min = low_of(y_min, F_min)
  y_max = high_of(y_max, F_max)
} }
# A range that can be drawn, for values that are all equal, zero or negative.
reaching(low, high) = high > 0 ? high : (low < 0 ? 0 : 1)
x_max = reaching(x_min, x_max)
y_max = reaching(y_min, y_max)
# An axis is logarithmic if its values span a factor of 4, unless --axes is given.
if (!exists("axes")) axes = ""
logarithmic(low, high) = axes eq "linear" || low <= 0 ? 0 : axes eq "log" || high >= 4 * low
step_along(which, low, high) = which eq "x" ? steps_along(low, high, wide - m(20)) : steps_of(high - low)
axis(which, low, high) = logarithmic(low, high) ? \
    sprintf("set logscale %s; set %srange [%g:%g]; ", which, which, low / 1.25, high * 1.25).log_marks(which, low, high) : \
    sprintf("set %stics %g; set %srange [%g:%g]", which, step_along(which, low < 0 ? low : 0, high), which, \
        low < 0 ? low - 0.05 * (high - low) : 0, high + 0.05 * (high - (low < 0 ? low : 0)))
# The number of letters in the longest tick label of such an axis, and the additional mm if it exceeds the n letters
# that a panel has space for.
decade_of(x) = 10.0**floor(log10(x))
longest_decade(d, last) = d > last ? 0 : greater(letters_in(10.0**d) - 1, longest_decade(d + 1, last))
longest_on(low, high) = logarithmic(low, high) ? \
    longest_decade(floor(log10(low / 1.25)) + (low / 1.25 > 5 * decade_of(low / 1.25)), floor(log10(high * 1.25))) : \
    longest_mark(low < 0 ? low : 0, high, steps_of(high - (low < 0 ? low : 0)))
beyond(letters, n) = letters > n ? mm_of(letters - n) : 0
