# figure: a rough contact: pressure, film and the undeformed shape along y = 0, and the film over the contact
# needs: /fields/P /fields/H /fields/S map
figure = "roughness"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"
load here."/window.gp"
name = "H"
load here."/rough.gp"
