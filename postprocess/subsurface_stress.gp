# figure: von Mises' stress below the contact, in the section y = 0
# needs: /subsurface/section/sigma_mises /fields/P
figure = "subsurface_stress"
wide = 16
high = 15
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"
# half: half of what is shown along X;  d: step of the contour lines [p_h]
if (!exists("half")) half = 1.8
if (!exists("d")) d = 0.05

set contour base
unset surface
set cntrparam levels incremental d, d, 5
set table $contours
splot field("/subsurface/section/sigma_mises") using 1:2:3 with lines nosurface notitle
unset table
unset contour
set surface

S = number("/subsurface/largest_sigma_mises")
Sx = number("/subsurface/largest_sigma_mises_x")
Sy = number("/subsurface/largest_sigma_mises_y")
Sz = number("/subsurface/largest_sigma_mises_z")
shown(x) = abs(x) < 0.005 ? 0 : x  # not -0.00
stats field("/subsurface/section/sigma_mises") using 2:3 nooutput prefix "s"
stats field("/subsurface/section/sigma_mises") using 1 nooutput prefix "X"

set multiplot
set lmargin at screen 0.11
set rmargin at screen 0.86
set xrange [X_min > -half ? X_min : -half : X_max < half ? X_max : half]

# The pressure that makes the stress.
set tmargin at screen 0.94
set bmargin at screen 0.76
set ylabel "P = p/p_h" offset 0.5, 0
set yrange [0:*]
set format x ""
set ytics 0.5
set samples 2001
plot abs(x) < 1.002 ? sqrt(abs(x) < 1 ? 1 - x**2 : 0) : 1/0 with lines lw 1.2 dt 2 lc rgb grey title "Hertz", \
     centre_line("P") using 1:2 with lines lw 1.5 lc rgb red title "P"

# The stress, depth downwards.
unset title
set tmargin at screen 0.74
set bmargin at screen 0.10
set format x "%g"
set xlabel "X = x/a,  Y = 0"
set ylabel "Z = z/a"
set yrange [s_max_x:0]
set ytics auto
set palette defined (0 '#ffffff', 0.25 '#d1e5f0', 0.55 '#fddbc7', 0.8 '#d6604d', 1 '#67001f')
set cbrange [0:ceil(20 * s_max_y) / 20.0]
set cblabel "σ_{Mises}/p_h"
set colorbox user origin screen 0.885, screen 0.10 size screen 0.022, screen 0.64
unset grid
set view map
# A vector picture takes the cells as they are.
set pm3d corners2color mean
if (format eq "png") set pm3d interpolate 4,4
set border 4095 lw 0.8
set label 1 sprintf("largest: %.4f p_h at (%.2f, %.2f, %.2f) a", S, shown(Sx), shown(Sy), Sz) at graph 0.97, 0.05 right front
# Where the largest value of all lies off this section, its mark is open.
set label 2 "" at Sx, Sz point pt (abs(Sy) < 0.05 ? 7 : 6) ps 1.2 lc rgb "black" front
splot field("/subsurface/section/sigma_mises") using 1:2:3 with pm3d notitle, \
     $contours using 1:2:(0) with lines lw 0.6 lc rgb "#333333" nocontour notitle
unset multiplot
