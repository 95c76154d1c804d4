# figure: a rough contact without lubricant: pressure, gap and the undeformed shape along y = 0, and the pressure over it
# needs: /fields/P /fields/gap /fields/S map
figure = "dry_roughness"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"
load here."/window.gp"
name = "gap"
load here."/rough.gp"
