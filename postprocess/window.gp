# Shared by the maps of a contact: the window, and a page as high as it needs.
left = -reach_x - 0.8 * margin
right = reach_x + 0.5 * margin
far = reach_y + 0.6 * margin
bottom = -far
high = (wide - m(33)) * 2 * far / (right - left) + m(10 + top)
