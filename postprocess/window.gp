# Shared by the maps of a contact: the window, and the height of the page.
edge = exists("edge") ? edge : 20  # mm right of the map, for a colour bar
end_of(axis, line) = real(system(sprintf("%s/grid/%s | sed '/^#/d' | sed -n '%sp'", read, axis, line)))
inner(x, y) = x < y ? x : y
left = -inner(reach_x + 0.8 * margin, -end_of("x", "1"))
right = inner(reach_x + 0.5 * margin, end_of("x", "$"))
far = inner(reach_y + 0.6 * margin, end_of("y", "$"))
bottom = -far
label_Y = far < 1000 ? 1 : 2.2  # space for four digits and a sign next to it
high = (wide - m(13 + edge)) * 2 * far / (right - left) + m(10 + top)
