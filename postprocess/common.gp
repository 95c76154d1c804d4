# Shared by every figure: what may be given on the command line, the terminal, fonts and sizes.
#
#   file     result file (required)         output   picture (default: name of the figure in the working folder)
#   format   png, svg or pdf (default png)   ehl      the program (default build/release/ehl)
#   title    words above the figure (default: none)
if (!exists("file")) exit error "no result: gnuplot -e \"file='result.h5'\" postprocess/FIGURE.gp"
# Empty where the program could not find its own name (no /proc).
if (!exists("ehl")) ehl = ""
if (ehl eq "") ehl = "build/release/ehl"
if (!exists("format")) format = "png"
if (!exists("output")) output = figure.".".format
if (!exists("title")) title = ""

# wide and high are the figure's shape in centimetres.
if (!exists("wide")) wide = 16.0
if (!exists("high")) high = 12.0
if (format eq "png") set terminal pngcairo enhanced font "DejaVu Sans,17" linewidth 2 \
    size int(85 * wide), int(85 * high) background "white"
if (format eq "svg") set terminal svg enhanced font "DejaVu Sans,15" linewidth 1.3 \
    size int(55 * wide), int(55 * high) background "white"
if (format eq "pdf") set terminal pdfcairo enhanced font "DejaVu Sans,11" linewidth 1.5 \
    size wide cm, high cm background "white"
if (format ne "png" && format ne "svg" && format ne "pdf") exit error "format: png, svg or pdf, not ".format
set output output

set encoding utf8
set title title noenhanced
# Red and blue that stay apart for colour-blind eyes and in grey.
red = "#b2182b"
blue = "#2166ac"
grey = "#666666"
set style line 100 lc rgb "#cccccc" lw 0.5
set grid back ls 100
set border lw 0.8
set tics nomirror out

# What gnuplot reads: a field on the grid, its section along X at Y = 0, or a table with its column names.
field(name) = sprintf("< '%s' extract '%s' %s", ehl, file, name)
centre_line(name) = sprintf("< '%s' extract '%s' %s --along x --at y=0", ehl, file, name)
# The last line of the header names the columns; gnuplot wants it without the mark of a comment.
table(name) = sprintf("< '%s' extract '%s' %s | awk '/^#/ {header = $0; next} \
!seen {sub(/^# */, \"\", header); print header; seen = 1} {print}'", ehl, file, name)

# One number of the result.
number(name) = real(system(sprintf("'%s' extract '%s' %s | tail -n 1", ehl, file, name)))

# A vector picture of every node would have tens of megabytes: a step that leaves about `most` nodes each way.
step_for(nodes, most) = nodes > most ? int(ceil((nodes - 1.0) / (most - 1.0))) : 1
# 1, 2 or 5 times a power of ten, the nearest below.
nice(x) = (p = 10.0**floor(log10(x)), x / p >= 5 ? 5 * p : (x / p >= 2 ? 2 * p : p))
# Pressures from Hertz' pale to the spike's dark, films from dark (thin) to pale.
pressure_colours = "defined (0 '#f7fbff', 0.35 '#9ecae1', 0.7 '#3182bd', 0.9 '#08519c', 1 '#67001f')"
film_colours = "defined (0 '#67001f', 0.2 '#d6604d', 0.45 '#fddbc7', 0.6 '#d1e5f0', 1 '#2166ac')"

# An elliptic contact (a circular one has no kappa): how far it reaches along X and Y in a, and its outline along Y = 0.
optional(name, otherwise) = (found = system(sprintf("'%s' extract '%s' %s 2>/dev/null | tail -n 1", ehl, file, name)), \
    found eq "" ? otherwise : real(found))
kappa = optional("kappa", 1)
turn = optional("angle", 0) * pi / 180
reach_x = sqrt(cos(turn)**2 + (kappa * sin(turn))**2)
reach_y = sqrt(sin(turn)**2 + (kappa * cos(turn))**2)
outline_XX = cos(turn)**2 + (sin(turn) / kappa)**2
# What stays free around a contact shrinks with its shorter side.
margin = reach_x < reach_y ? reach_x : reach_y
