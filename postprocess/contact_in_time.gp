# figure: the contact at one time: film and pressure, their lines y = 0, and the course of both
# needs: /transient/frames/P /transient/frames/H
# on the page
# shown_frames="0 5 10": the numbers of several frames; an SVG then holds as many pictures, one after another, with the
# same axes.
figure = "contact_in_time"
wide = 190.0
here = system(sprintf("dirname '%s'", ARG0))
when = ""
load here."/result.gp"
load here."/in_time.gp"
if (!exists("shown_frames")) shown_frames = sprintf("%d", frame)
unset datafile columnheaders
plane = size_of("/grid/y") > 1 && found("/roller/y") eq ""
if (plane) { load here."/window.gp" } else { left = -1.8 * reach_x; right = 1.4 * reach_x }

# All frames share their axes: the film by film_scale.gp, the pressure by the highest of the course.
load here."/film_scale.gp"
set datafile columnheaders
stats $table_transient using "P_max" nooutput prefix "P"
tallest = P_max > 0 ? 1.05 * P_max : 1
stats $table_transient using "Hc" nooutput prefix "C"
stats $table_transient using "Hm" nooutput prefix "M"
unset datafile columnheaders
begin = T(T_min)
end = T_max > T_min ? T(T_max) : begin + 1
# All frames that are shown are read at once, and that of the start: $line_H_0, $map_P_12.
steps = " --step 0"
do for [shown in shown_frames] { steps = steps.",".shown }
both = "/transient/frames/H /transient/frames/P"
load blocks(both, sprintf(" --along x --at y=0 --sample %d --window=%.9g:%.9g", points, left, right).steps, "line")
if (plane) { load blocks(both, matrix_of(points / 2).steps, "map") }

# A map has the shape of its window, within limits.
tall = plane ? (wide - m(131)) * 2 * far / (right - left) : 0
tall = tall < m(15) ? m(15) : tall > m(90) ? m(90) : tall
high = plane ? m(80 + top) + tall : m(70 + top)
course = "eval box(panel == 1 ? m(17) : m(112), panel == 1 ? m(114) : m(19), m(9), high - m(29)); unset title; unset colorbox"
lines = "eval box(panel == 1 ? m(17) : m(112), panel == 1 ? m(114) : m(19), m(40), high - m(69))"
maps = "eval box(panel == 1 ? m(17) : m(112), panel == 1 ? m(114) : m(19), m(78), m(top + 2))"
eval page
do for [shown in shown_frames] {
  now = time_of(int(shown))
  set multiplot
  do for [panel = 1:2] {
    name = panel == 1 ? "H" : "P"
    unset key
    set format "%g"
    unset logscale
    unset arrow
    set xrange [left:right]
    set xtics steps_of(right - left)
    if (plane) {
      @maps
      set yrange [bottom:bottom + 2 * far]
      set ytics steps_of(2 * far)
      unset xlabel
      set ylabel axis_Y offset 1, 0
      set cblabel panel == 1 ? axis_H : axis_P offset 1.6, 0
      eval "set palette ".(panel == 1 ? film_colours : pressure_colours)
      set cbrange [panel == 1 ? (M_min > 0 ? inner(low, M_min) : low) : 0:panel == 1 ? highest : tallest]
      if (panel == 1 && far_apart) { set logscale cb; set format cb "10^{%L}" } else { unset logscale cb; set format cb "%g" }
      set colorbox user origin screen (wide - (panel == 1 ? m(113) : m(18))) / wide, m(78) / high size screen m(2.5) / wide, tall / high
      eval sprintf("plot $map_%s_%s matrix nonuniform using 1:2:3 with image", name, shown)
      unset colorbox
    }
    @lines
    set xlabel axis_along offset 0, 0.4
    set ylabel panel == 1 ? axis_H : axis_P offset -0.4, 0
    set ytics auto
    set yrange [panel == 1 ? below_zero(low) : 0:panel == 1 ? 1.2 * highest : tallest]
    if (panel == 1 && far_apart) { set logscale y; set format y "10^{%L}"; set yrange [low / 1.5:1.5 * highest] }
    eval sprintf("plot $line_%s_0 using 1:2 with lines lw 0.8 dt (4, 3) lc rgb '#aaaaaa', \
        $line_%s_%s using 1:2 with lines lw 1 lc rgb '%s'", name, name, shown, panel == 1 ? blue : red)
    @course
    set xlabel axis_T offset 0, 0.4
    set xrange [begin:end]
    set xtics auto
    set arrow 1 from first now, graph 0 to first now, graph 1 nohead front lw 0.8 dt 2 lc rgb "#444444"
    top_of_course = panel == 1 ? 1.05 * greater(C_max, M_max) : tallest
    set yrange [panel == 1 ? below_zero(M_min) : 0:top_of_course]
    set ytics steps_of(top_of_course)
    if (panel == 1 && M_min > 0 && C_max > 20 * M_min) { set logscale y; set format y "10^{%L}"; set ytics auto; set yrange [0.8 * M_min:1.2 * C_max] }
    if (panel == 1) {
      set key bottom right
      plot $table_transient every ::1 using (T($1)):2 with lines lw 1 lc rgb blue title "centre", \
           $table_transient every ::1 using (T($1)):3 with lines lw 1 lc rgb red title "minimum"
    } else {
      plot $table_transient every ::1 using (T($1)):6 with lines lw 1 lc rgb red
    }
  }
  unset multiplot
}
