# figure: where the gap is full of oil and where it is not: the meniscus and the cavity behind the contact
# needs: /fields/theta map
figure = "content_map"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"

name = "theta"
most = 0.999  # a line along the edge of the oil would follow the cells
quantity = "share of the gap that oil fills"
colours = film_colours
load here."/map.gp"
