# figure: the traction map: friction over the slide-roll ratio and the mean speed
# needs: sweep motion.srr motion.u_m mu
#
# From a table of 'ehl sweep' that varies motion.srr and motion.u_m.
figure = "traction_map"
here = system(sprintf("dirname '%s'", ARG0))
load here."/common.gp"

varied(key) = system(sprintf("sed -n 's/^# vary: %s = //p' '%s'", key, file))
if (varied("motion[.]srr") eq "" || varied("motion[.]u_m") eq "") exit error file.": varies not both motion.srr and motion.u_m"
# Rows "u_m srr mu" of converged cases, one scan per speed.
$map << EOD
EOD
rows = "< awk -F, '/^#/ {next} !n {for (k = 1; k <= NF; ++k) c[$k] = k; n = 1; next} \
  $c[\"status\"] == \"converged\" {print $c[\"motion.u_m\"], $c[\"motion.srr\"], $c[\"mu\"]}' '".file."' | sort -g -k1,1 -k2,2 | \
  awk 'NR > 1 && $1 != u {print \"\"} {u = $1; print}'"
stats rows using 1:3 nooutput prefix "M"
stats rows using 2 nooutput prefix "S"
high = 66 * stretch + m(15 + top)
eval page
eval box(m(14), m(20), m(13), m(top))
unset key
set logscale y
set xrange [100 * S_min:100 * S_max]
set yrange [M_min_x:M_max_x]
set xtics steps_of(100 * (S_max - S_min))
eval log_marks("y", M_min_x, M_max_x)
set xlabel "slide-roll ratio |u_1 - u_2|/u_m [%]" offset 0, 0.4
set ylabel "mean speed u_m [m/s]" offset 0.5, 0
set cblabel "friction coefficient μ"
eval "set palette ".pressure_colours
set cbrange [0:M_max_y]
set cbtics steps_of(M_max_y)
eval bar(m(13), m(top))
step = round_step(M_max_y / 6)
set contour base
set cntrlabel onecolor
set cntrparam levels incremental step, step, M_max_y
set pm3d map interpolate 8, 8
splot rows using (100 * $2):1:3 with pm3d nocontour, \
      rows using (100 * $2):1:3 with lines nosurface lw 0.5 lc rgb "#333333", \
      rows using (100 * $2):1:3 with points nocontour pt 7 ps 0.25 lc rgb "#555555"
