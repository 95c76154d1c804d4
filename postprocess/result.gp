# Shared by the figures of a result: how its fields are read, their units, and the size of the contact.
load here."/common.gp"

# The program is started once for all single values: `known` has a line "path value unit meaning" for each dataset, and
# "[61x129]" instead of the value of an array.
read = sprintf("'%s' extract '%s'%s ", ehl, file, si ? " --si" : "")
known = "\n".system(read)
found(path) = (at = strstrt(known, "\n".path." "), at == 0 ? "" : word(known[at + 1:*], 2))
number(path) = real(found(path))
optional(path, otherwise) = found(path) eq "" ? otherwise : number(path)
size_of(list) = int(found(list)[2:strlen(found(list)) - 1])
# A number that did not converge must not look as if it had: every figure of such a result carries a mark.
complete = found("/summary/transient_completed") ne "0"
mark = found("/summary/converged") ne "1" ? "NOT CONVERGED" : complete ? "" : "NOT COMPLETE"
if (mark ne "") { top = heading eq "" ? 6.0 : top + 3.6 }
in_time = found("/transient/frames/time") ne ""
if (in_time && !exists("frame")) frame = size_of("/transient/frames/time") - 1
# Data blocks $PREFIX_NAME, which one start of the program makes for several names: `load lines("P H", left, right)` makes
# $line_P and $line_H, fields interpolated between their nodes. P and H are those of the frame that is shown.
blocks(names, options, prefix) = "< ".read.names.options." --gnuplot ".prefix
where(name) = in_time && (name eq "P" || name eq "H") ? "/transient/frames/".name : name
all_where(names) = words(names) < 2 ? where(names) : where(word(names, 1))." ".all_where(names[strlen(word(names, 1)) + 2:*])
fields(names, options, prefix) = blocks(all_where(names), \
    options.(strstrt(all_where(names), "/transient/") > 0 ? sprintf(" --step %d", frame) : ""), prefix)
lines(names, x0, x1) = \
    fields(names, sprintf(" --along x --at y=0 --sample %d --window=%.9g:%.9g", 3 * points, x0, x1), "line")
matrix_of(points) = \
    sprintf(" --matrix --sample %d --window=%.9g:%.9g,%.9g:%.9g", points, left, right, bottom, bottom + 2 * far)
maps(names, points) = fields(names, matrix_of(points), "map")
tables(names) = blocks(names, "", "table")

# The units, and the factors from the dimensionless quantities.
axis_X = si ? "x [µm]" : "X = x/a"
dry = found("/fields/H") eq ""
axis_along = axis_X.(dry ? "" : ", motion →")
axis_Y = si ? "y [µm]" : "Y = y/a"
axis_Z = si ? "z [µm]" : "Z = z/a"
axis_P = si ? "p [GPa]" : "P = p/p_h"
axis_H = si ? "h [nm]" : "H = hR/a^2"
a = si ? 1e6 * number("/scales/a") : 1.0
p_h = si ? 1e-9 * number("/scales/p_h") : 1.0
# Times are in ms or in a/u_m; the latter also for a contact in SI if its deck gives times in a/u_m.
u_m_time = si && !seconds ? 1e3 * optional("/scales/time", 1.0) : 1.0
T(t) = t / u_m_time
axis_T = seconds ? "t [ms]" : "T = t u_m/a"

# An elliptic contact (a circular one has no kappa): its half widths along x and y, and its outline along y = 0.
kappa = optional("/scales/kappa", 1)
turn = optional("/scales/angle", 0) * pi / 180
reach_x = a * sqrt(cos(turn)**2 + (kappa * sin(turn))**2)
reach_y = a * sqrt(sin(turn)**2 + (kappa * cos(turn))**2)
outline_XX = (cos(turn)**2 + (sin(turn) / kappa)**2) / a**2
Hertz(x) = p_h * sqrt(1 - outline_XX * x**2 > 0 ? 1 - outline_XX * x**2 : 0)
# The margin around a contact is proportional to its shorter side.
margin = reach_x < reach_y ? reach_x : reach_y
# The value of a field at the centre of the contact.
centre(name) = real(system(fields(name, \
    sprintf(" --along x --at y=0 --sample 3 --window=%g:%g", -0.01 * a, 0.01 * a), "centre")[3:*]." | sed -n '3s/.* //p'"))
