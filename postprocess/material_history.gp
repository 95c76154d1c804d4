# figure: the stresses that the material of both bodies has met, over the place in the body and the depth, at y = 0
# needs: /history_1/section_most_sigma_mises /history_2/section_most_sigma_mises
figure = "material_history"
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"

path(body, name) = sprintf("/history_%d/section_%s", body, name)
section(body, name) = "< ".read.path(body, name)." --matrix"
name(k) = k == 1 ? "most_sigma_mises" : "range_tau_xz"
of_what(k) = k == 1 ? "largest σ_{Mises}" : "range of τ_{xz}"
panels = 4
high = 36 * stretch * panels + m(top + 8)
eval page
set multiplot
unset key
set pm3d map interpolate 2, 2
share = (high - m(top + 12)) / panels
stats "< ".read.path(1, name(1))." --along z --at x=0" using 1 nooutput prefix "D"
eval "set palette ".pressure_colours
do for [k = 1:2] {
  set xrange [*:*]
  set yrange [*:*]
  stats section(1, name(k)) matrix nonuniform using 3 nooutput prefix "A"
  stats section(2, name(k)) matrix nonuniform using 3 nooutput prefix "B"
  do for [body = 1:2] {
    row = 2 * (k - 1) + body
    eval box(m(18), m(24), m(12) + (panels - row) * share, m(top) + (row - 1) * share + m(11))
    set xrange [*:*]
    set yrange [*:*]
    stats "< ".read.path(body, name(k))." --along x" using 1 nooutput prefix "X"
    set xrange [X_min:X_max]
    set xtics steps_along(X_min, X_max, wide - m(42))
    set yrange [D_max:0]
    set ytics steps_of(D_max) * 2
    set ylabel axis_Z offset -0.5, 0
    set title sprintf("body %d: %s", body, of_what(k)) offset 0, -0.7
    if (row == panels) { set xlabel (si ? "x [µm]" : "x/a")." in the body, motion →" offset 0, 0.4 }
    set cbrange [0:greater(A_max, B_max)]
    set cbtics steps_of(greater(A_max, B_max))
    set cblabel si ? "[GPa]" : "[p_h]"
    eval bar(m(12) + (panels - row) * share, m(top) + (row - 1) * share + m(11))
    splot section(body, name(k)) matrix nonuniform using 1:2:3 with pm3d
    unset label 100
  }
}
unset multiplot
