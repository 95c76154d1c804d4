#pragma once
// Viscosity and density at ambient pressure and a given temperature, from the numbers of a data sheet.

namespace ehl::rheology {

/// lg lg Z = A - B lg T with Z = nu + 0.7 + exp(-1.47 - 1.84 nu - 0.51 nu^2), nu in mm^2/s, T in kelvin: kinematic
/// viscosity through two measured values. source: Walther 1931; ASTM D341.
struct Walther {
  double A;
  double B;
};

inline constexpr double zero_celsius = 273.15;  ///< [K]

/// Lower end of the range of ASTM D341 [mm^2/s].
inline constexpr double least_kinematic_viscosity = 0.21;
/// Temperatures at which a lubricating oil is a liquid described by two viscosities [C]: below, wax or a glass forms;
/// above, it evaporates and cracks.
inline constexpr double coldest_oil = -40.0, hottest_oil = 200.0;

/// in: kinematic viscosities at 40 and 100 C [mm^2/s], kv40 > kv100 >= least_kinematic_viscosity.
Walther make_walther(double kv40, double kv100);
/// Kinematic viscosity [mm^2/s] at T [C]; reproduces kv40 and kv100 to rounding.
double kinematic_viscosity(const Walther& law, double T);

/// Density of a lubricating oil [kg/m^3] at T [C] from that at 15 C [kg/m^3]:
///   rho15 exp[-a dT (1 + 0.8 a dT)],   a = 0.6278/rho15 per kelvin.
/// limits: petroleum oils; for synthetic ones within 1 % up to 150 C.
/// source: ASTM D1250 (API MPMS 11.1, table 54D, 1980).
double oil_density(double density15, double T);

}  // namespace ehl::rheology
