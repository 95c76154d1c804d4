# figure: film thickness over the contact, with labelled lines of equal film
# needs: /fields/H map
figure = "film_contours"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"

name = "H"
quantity = axis_H
colours = film_colours
load here."/map.gp"
