# figure: the map of loads: convergence factor, work and path over M and L, for each wedge
# needs: sweep contact.M contact.L
#
# From a table of 'ehl sweep' that varies contact.M, contact.L and, optionally, discretization.wedge:
#   gnuplot -e "table='stability_map.csv'" postprocess/stability_map.gp
figure = "stability_map"
wide = 190.0  # two columns of a journal
if (exists("table")) file = table
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

said(key) = system(sprintf("sed -n 's/^# %s//p' '%s' | paste -s -d , -", key, file))
varied(key) = system(sprintf("sed -n 's/^# vary: %s = //p' '%s' | tr , ' '", key, file))
Ms = varied("contact[.]M")
Ls = varied("contact[.]L")
wedges = varied("discretization[.]wedge")
if (Ms eq "" || Ls eq "") exit error file.": this is no table of 'ehl sweep' that varies contact.M and contact.L"
if (wedges eq "") wedges = "every"
if (words(wedges) > 2) exit error file.": more than two wedges"
if (title eq "") title = "Map of loads".(said("set: ") eq "" ? "" : ": ".said("set: "))

set datafile separator comma
set datafile columnheaders
# The values are evenly spaced on the axes, whatever their distance.
place(list, v, k) = k > words(list) ? NaN : (real(word(list, k)) == v ? k : place(list, v, k + 1))
X(wedge) = wedge eq "every" || stringcolumn("discretization.wedge") eq wedge ? place(Ms, column("contact.M"), 1) : NaN
Y(key) = place(Ls, column(key), 1)

is(status) = stringcolumn("status") eq status
X_if(status, wedge) = is(status) ? X(wedge) : NaN
mark(none) = is("not-converged") ? "×" : (is("refused") ? "–" : (is("failed") ? "!" : none))
# With fewer than two cycles there is no convergence factor.
known(name) = stringcolumn(name) ne "NaN"
shown(name, form) = is("converged") ? (known(name) ? sprintf(form, column(name)) : "n/a") : mark("")
ink(name, low, high) = known(name) && (column(name) < low || column(name) > high) ? 0xffffff : 0x222222
rgb_of(hex) = int("0x".substr(hex, 2, 7))
grey_not_converged = "#a0a0a0"
# A star marks a solution on a grid that does not resolve the contact.
star(none) = known("error_Hm") && column("error_Hm") > 0.1 ? "*" : none
# Direct: full multigrid from its first start.
kind(path) = path[1:6] eq "newton" ? 4 : (path eq "load-continuation" ? 3 : (path eq "full-multigrid" ? 1 : 2))
path_colours = "#7cc4ee #33b08b #f0b429 #d98cb3"
colour_of(path) = rgb_of(word(path_colours, kind(path)))

stats file using (is("converged") ? column("work_units") : NaN) nooutput prefix "W"
work_low = exists("W_min") ? nice(W_min) : 10
work_high = exists("W_max") && W_max > 10 * work_low ? W_max : 10 * work_low

left(k) = words(wedges) == 1 ? 0.075 : 0.075 + 0.42 * (k - 1)
right(k) = words(wedges) == 1 ? 0.9 : left(k) + 0.405
top(row) = 0.938 - 0.29 * (row - 1)
bottom(row) = top(row) - 0.236

high = 199 * stretch
heading = ""
eval page
set multiplot title title noenhanced
unset grid
unset key
set tics scale 0 nomirror
set xrange [0.5:words(Ms) + 0.5]
set yrange [0.5:words(Ls) + 0.5]
set xtics ("" 0) font ",7"  # small letters, so that four digits next to each other do not touch
do for [k = 1:words(Ms)] { set xtics add (word(Ms, k) k) }
set style fill solid 1.0 border rgb "white"

do for [row = 1:3] {
  do for [k = 1:words(wedges)] {
    wedge = word(wedges, k)
    set lmargin at screen left(k)
    set rmargin at screen right(k)
    set tmargin at screen top(row)
    set bmargin at screen bottom(row)
    name = row == 1 ? "convergence factor per cycle" : (row == 2 ? "work units on the finest grid" : "path, and cells along x")
    letter = substr("abcdef", (row - 1) * words(wedges) + k, (row - 1) * words(wedges) + k)
    set title "(".letter.") ".name.(wedge eq "every" ? "" : ", wedge ".wedge) offset 0, -0.6 noenhanced
    set xlabel (row == 3 ? "Moes' load parameter M" : "") offset 0, 0.3
    set ylabel (k == 1 ? "Moes' material parameter L" : "") offset 0.5, 0
    set ytics ("" 0)
    do for [j = 1:words(Ls)] { set ytics add ((k == 1 ? word(Ls, j) : "") j) }
    unset colorbox
    if (row < 3 && k == words(wedges)) {
      set colorbox user origin right(k) + 0.012, bottom(row) size 0.016, top(row) - bottom(row)
    }
    if (row == 1) {
      # White is 0.2, the desired convergence factor.
      set palette defined (0 '#2166ac', 0.1 '#92c5de', 0.2 '#f7f7f7', 0.5 '#f4a582', 0.8 '#b2182b', 1 '#67001f')
      set cbrange [0:1]
      set cbtics (0, 0.1, 0.2, 0.5, 1)
      plot file using (X_if("not-converged", wedge)):(Y("contact.L")):(0.5):(0.5) with boxxyerror lc rgb grey_not_converged, \
           file using (X_if("converged", wedge)):(Y("contact.L")):(0.5):(0.5) with boxxyerror lc rgb "#eeeeee", \
           file using (known("cycle_factor") ? X_if("converged", wedge) : NaN):(Y("contact.L")):(0.5):(0.5):"cycle_factor" with boxxyerror lc palette, \
           file using (X(wedge)):(Y("contact.L")):(shown("cycle_factor", "%.2f")):(ink("cycle_factor", 0.05, 0.65)) \
               with labels textcolor rgb variable font ",6.5"
    }
    if (row == 2) {
      set palette defined (0 '#f2f0f7', 0.4 '#bcbddc', 0.7 '#807dba', 1 '#3f007d')
      set logscale cb
      set cbrange [work_low:work_high]
      set cbtics (5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000)
      plot file using (X_if("not-converged", wedge)):(Y("contact.L")):(0.5):(0.5) with boxxyerror lc rgb grey_not_converged, \
           file using (X_if("converged", wedge)):(Y("contact.L")):(0.5):(0.5):"work_units" with boxxyerror lc palette, \
           file using (X(wedge)):(Y("contact.L")):(shown("work_units", "%.0f")) \
               :(ink("work_units", 0, work_low * (work_high / work_low)**0.6)) with labels textcolor rgb variable font ",6.5"
    }
    if (row == 3) {
      if (k == words(wedges)) {
        names = "direct|later start|load continuation|Newton|× not converged|– refused, ! failed"
        do for [j = 1:6] {
          at = real(word("0.075 0.185 0.3 0.46 0.565 0.735", j))
          entry = system(sprintf("echo '%s' | cut -d '|' -f %d", names, j))
          set object j rectangle from screen at, 0.028 to screen at + 0.02, 0.043 front fillstyle solid border rgb "#666666" \
              fillcolor rgb (j < 5 ? word(path_colours, j) : (j == 5 ? grey_not_converged : "#ffffff"))
          set label j entry at screen at + 0.026, 0.0355 left front
        }
        set label 7 "* estimated discretization error of H_m above 10 %: the grid is too coarse for the contact" \
            at screen 0.075, 0.012 left front
      }
      plot file using (X_if("not-converged", wedge)):(Y("contact.L")):(0.5):(0.5) with boxxyerror lc rgb grey_not_converged, \
           file using (X_if("converged", wedge)):(Y("contact.L")):(0.5):(0.5):(colour_of(stringcolumn("path"))) \
               with boxxyerror lc rgb variable, \
           file using (X(wedge)):(Y("contact.L")):(mark(stringcolumn("nx").star(""))) with labels textcolor rgb "#222222" font ",6.5"
    }
  }
}
unset multiplot
