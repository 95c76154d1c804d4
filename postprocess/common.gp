# Shared by all figures: the variables of the command line, units, the page, fonts, colours.
#
#   file     result file (required)           output   picture (default: name of the figure in the working folder)
#   format   png, svg or pdf (default png)    ehl      the program (default build/release/ehl)
#   title    text above the figure            si       1: axes in um, nm, GPa (the contact is given in SI)
#   frame    number of a field in time (default: the last one); when: its time, in words
#   seconds  1: times in ms, 0 (default): in a/u_m
#   points   points of a map along x (default 500); a line has three times as many
#   mm       width of the picture in mm (default: that of the figure); pixels: the width of a PNG or SVG instead
if (!exists("file")) exit error "no result: gnuplot -e \"file='result.h5'\" postprocess/FIGURE.gp"
# Empty if the program could not find its own path (no /proc).
if (!exists("ehl")) ehl = ""
if (ehl eq "") ehl = "build/release/ehl"
if (!exists("format")) format = "png"
if (!exists("output")) output = figure.".".format
if (!exists("title")) title = ""
if (!exists("when")) when = ""
if (!exists("si")) si = 0
if (!exists("seconds")) seconds = 0
if (!exists("points")) points = 500
if (!exists("mm")) mm = 0
if (!exists("pixels")) pixels = 0
if (format ne "png" && format ne "svg" && format ne "pdf") exit error "format: png, svg or pdf, not ".format

# The page: `wide` must be set before this file is loaded, `high` after it, both in mm; then: eval page.
# Letters have 8 pt, or less if a figure is made narrower than it was designed for; line widths are in pt. `box` places
# a panel by its distances from the edges of the page in mm; m(x) is x mm, scaled with the letters.
if (!exists("wide")) wide = 90.0
small = mm > 0 && mm < wide ? (mm / wide)**0.5 : 1.0
stretch = mm > 0 ? mm / wide : 1.0
wide = wide * stretch
m(x) = small * x
dots = pixels > 0 ? pixels / wide * 25.4 : (format eq "svg" ? 96.0 : 300.0)
sized(mm) = int(mm * dots / 25.4 + 0.5)
terminal(none) = format eq "png" ? sprintf("pngcairo fontscale %g linewidth %g pointscale %g size %d, %d", small * dots / 96, \
        dots / 72, 0.5 * dots / 72, sized(wide), sized(high)) : \
    (format eq "svg" ? sprintf("svg fontscale %g linewidth %g size %d, %d", small * dots / 72, dots / 72, \
        sized(wide), sized(high)) : \
    sprintf("pdfcairo fontscale %g linewidth 2 pointscale 0.5 size %g cm, %g cm", 0.75 * small, wide / 10, high / 10))
# The mark stays if a figure with several panels removes its heading after the first panel.
headed = 'set label 99 mark at screen 0.5, 1 - m(3.4) / high center textcolor rgb red noenhanced; \
set label 100 heading at screen 0.5, 1 - m(mark eq "" ? 3.4 : 7.0) / high center noenhanced'
page = 'eval "set terminal ".terminal(0)." enhanced font \"DejaVu Sans,8\" background \"white\""; set output output; eval headed'
key_above = 'set key at graph 0.5, graph 1.01 center bottom horizontal samplen 2 width 2'
# The colour bar next to the last panel, which ends 20 mm from the right edge.
bar(bottom, top) = sprintf("set colorbox user origin screen %g, %g size screen %g, %g; set cblabel offset 0.6, 0", \
    1 - m(18) / wide, bottom / high, m(3) / wide, 1 - (bottom + top) / high)
box(left, right, bottom, top) = sprintf("set lmargin at screen %g; set rmargin at screen %g; \
set bmargin at screen %g; set tmargin at screen %g", left / wide, 1 - right / wide, bottom / high, 1 - top / high)
# The heading, broken into lines that fit; top: its height in mm.
gap_before(text, n) = n < 1 ? 0 : (text[n:n] eq " " ? n : gap_before(text, n - 1))
wrapped(text, n) = strlen(text) <= n ? text : (at = gap_before(text, n), at < 1 ? text : \
    text[1:at - 1]."\n".wrapped(text[at + 1:*], n))
lines_of(text, n) = strlen(text) <= n ? 1 : (at = gap_before(text, n), at < 1 ? 1 : 1 + lines_of(text[at + 1:*], n))
letters = int(wide / m(1.6))
heading = title.(title ne "" && when ne "" ? ", " : "").when
top = heading eq "" ? 3.0 : 2.6 + 3.4 * lines_of(heading, letters)
heading = wrapped(heading, letters)
# The problem that result.gp finds in a result, in red above the heading.
mark = ""

set encoding utf8
# Red and blue that differ for colour-blind readers and in grey.
red = "#b2182b"
blue = "#2166ac"
green = "#1b7837"
grey = "#666666"
curve_colours = "#2166ac #b2182b #1b7837 #762a83 #e08214 #35978f #8c510a #c51b7d #444444 #80b1d3 #fb8072 #b3de69"
# Colours for one-signed quantities: pale to dark for pressures and stresses, dark (thin) to pale for films.
pressure_colours = "defined (0 '#ffffff', 0.25 '#fdd49e', 0.5 '#fc8d59', 0.8 '#b30000', 1 '#4d0000')"
film_colours = "defined (0 '#081d58', 0.25 '#225ea8', 0.5 '#41b6c4', 0.75 '#c7e9b4', 1 '#ffffe5')"
set border lw 0.5
set tics nomirror out scale 0.5
set key samplen 2.5 spacing 1.05
set style textbox opaque noborder margins 0.3, 0.3

# The largest number of the form 1, 2 or 5 times a power of ten that does not exceed x.
nice(x) = x <= 0 ? 1 : (p = 10.0**floor(log10(x)), x / p >= 5 ? 5 * p : (x / p >= 2 ? 2 * p : p))

# The nearest number of this form.
round_step(x) = x / nice(x) > (nice(x) / 10**floor(log10(nice(x)) + 1e-9) == 2 ? 1.6 : 1.45) ? nice(2.5 * x) : nice(x)
# The step between the tick marks of an axis, for three to seven of them.
steps_of(range) = nice(range / 3.5)
# The step along x: larger if the labels would touch, on an axis of the given length in mm.
mm_of(letters) = m(1.8 * letters)
letters_of_text(text) = strlen(text) + (strstrt(text, "e") > 0 ? 2 : 0)  # a power of ten is wider
letters_in(x) = letters_of_text(sprintf("% g", x))  # gnuplot leaves a blank for the sign
greater(a, b) = a > b ? a : b
longest_step(step, k, last) = k > last ? 0 : greater(letters_in(k * step), longest_step(step, k + 1, last))
longest_mark(low, high, step) = longest_step(step, ceil(low / step), floor(high / step))
fitting(low, high, mm, step) = (mm_of(longest_mark(low, high, step)) + m(1)) * (high - low) > mm * step ? \
    nice(2.51 * step) : step
steps_along(low, high, mm) = fitting(low, high, mm, steps_of(high - low))
# The lower end of an axis of films. A negative film is no valid result and must be visible: cut off at zero, the
# rest would look like one.
below_zero(least) = least < 0 ? 1.1 * least : 0
# Tick marks at 1, 2 and 5 of every decade; for many decades at 1 only.
marks = "%g"
log_marks(which, low, high) = sprintf('set %stics (1); do for [d = %d:%d] { do for [k in "%s"] { \
set %stics add (sprintf(marks, k * 10.0**d) k * 10.0**d) } }', which, floor(log10(low)) - 1, ceil(log10(high)) + 1, \
high < 300 * low ? "1 2 5" : "1", which)
