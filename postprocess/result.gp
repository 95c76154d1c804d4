# Shared by the figures of a result: how its fields are read, their units, and the size of the contact.
load here."/common.gp"

# The input of gnuplot: a field, a part of it interpolated between its nodes, a line of it, or
# a table with column names.
read = sprintf("'%s' extract '%s'%s ", ehl, file, si ? " --si" : "")
found(what) = system(read.what." 2>/dev/null | tail -n 1")
number(name) = real(found(name))
optional(name, otherwise) = (said = found(name), said eq "" ? otherwise : real(said))
# A number that did not converge must not look as if it had: every figure of such a result carries a mark.
complete = found("/summary/transient_completed") ne "0"
mark = found("/summary/converged") ne "1" ? "NOT CONVERGED" : complete ? "" : "NOT COMPLETE"
if (mark ne "") { top = heading eq "" ? 6.0 : top + 3.6 }
in_time = found("/transient/frames/time") ne ""
if (in_time && !exists("frame")) frame = int(system(read."/transient/frames/time | sed '/^#/d' | wc -l")) - 1
of_frame(name, k) = sprintf("/transient/frames/%s --step %d", name, k)
# A plain name refers to the field of the frame that is shown.
where(name) = in_time && (name eq "P" || name eq "H") ? of_frame(name, frame) : name
field(name, points) = sprintf("< %s%s --matrix --sample %d --window=%.9g:%.9g,%.9g:%.9g", \
    read, where(name), points, left, right, bottom, bottom + 2 * far)
line(name, x0, x1) = sprintf("< %s%s --along x --at y=0 --sample %d --window=%.9g:%.9g", \
    read, where(name), 3 * points, x0, x1)
grid(name) = "< ".read.where(name)
# The last line of the heading names the columns; gnuplot needs it without the comment sign.
table(name) = "< ".read.name." | awk '/^#/ {header = $0; next} !seen {sub(/^# */, \"\", header); print header; seen = 1} {print}'"

# The units, and the factors from the dimensionless quantities.
axis_X = si ? "x [µm]" : "X = x/a"
dry = found("/fields/H") eq ""
axis_along = axis_X.(dry ? "" : ", motion →")
axis_Y = si ? "y [µm]" : "Y = y/a"
axis_Z = si ? "z [µm]" : "Z = z/a"
axis_P = si ? "p [GPa]" : "P = p/p_h"
axis_H = si ? "h [nm]" : "H = hR/a^2"
a = si ? 1e6 * real(system(sprintf("'%s' extract '%s' /scales/a | tail -n 1", ehl, file))) : 1.0
p_h = si ? 1e-9 * real(system(sprintf("'%s' extract '%s' /scales/p_h | tail -n 1", ehl, file))) : 1.0
# Times are in ms or in a/u_m; the latter also for a contact in SI if its deck gives times in a/u_m.
u_m_time = si && !seconds ? 1e3 * optional("/scales/time", 1.0) : 1.0
T(t) = t / u_m_time
axis_T = seconds ? "t [ms]" : "T = t u_m/a"

# An elliptic contact (a circular one has no kappa): its half widths along x and y, and its outline along y = 0.
kappa = optional("kappa", 1)
turn = optional("angle", 0) * pi / 180
reach_x = a * sqrt(cos(turn)**2 + (kappa * sin(turn))**2)
reach_y = a * sqrt(sin(turn)**2 + (kappa * cos(turn))**2)
outline_XX = (cos(turn)**2 + (sin(turn) / kappa)**2) / a**2
Hertz(x) = p_h * sqrt(1 - outline_XX * x**2 > 0 ? 1 - outline_XX * x**2 : 0)
# The margin around a contact is proportional to its shorter side.
margin = reach_x < reach_y ? reach_x : reach_y
# The value of a field at the centre of the contact.
centre(name) = real(system(sprintf("%s%s --along x --at y=0 --sample 3 --window=%g:%g | tail -n 2 | head -n 1 | cut -d ' ' -f 2", \
    read, where(name), -0.01 * a, 0.01 * a)))
