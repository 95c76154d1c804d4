# figure: pressure over the contact, with labelled lines of equal pressure
# needs: /fields/P pressure map
figure = "pressure_contours"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"

name = "P"
quantity = axis_P
colours = pressure_colours
load here."/map.gp"
