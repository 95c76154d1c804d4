# Shared by the maps of a contact: the window, and the height of the page.
edge = exists("edge") ? edge : 20  # mm right of the map, for a colour bar
load blocks("/grid/x /grid/y", "", "axis")
stats $axis_x using 1 nooutput prefix "X"
stats $axis_y using 1 nooutput prefix "Y"
inner(x, y) = x < y ? x : y
left = -inner(reach_x + 0.8 * margin, -X_min)
right = inner(reach_x + 0.5 * margin, X_max)
far = inner(reach_y + 0.6 * margin, Y_max)
bottom = -far
label_Y = far < 1000 ? 1 : 2.2  # space for four digits and a sign next to it
high = (wide - m(13 + edge)) * 2 * far / (right - left) + m(10 + top)
