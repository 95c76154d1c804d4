# figure: the temperature in the middle of the film above that of the oil
# needs: /fields/T_mid map
figure = "temperature_map"
here = system(sprintf("dirname '%s'", ARG0))
load here."/result.gp"

name = "T_mid"
most = number("/summary/T_film_max")
quantity = "T − T_{oil} in the middle of the film [K]"
colours = pressure_colours
load here."/map.gp"
