#pragma once
// Where the laws of viscosity and density leave the pressures that they were made for.
#include <limits>
#include <string>
#include <vector>

#include "rheology/laws.hpp"

namespace ehl::rheology {

/// The highest pressure of a solution and what turns it into SI. NaN: not known.
struct Loading {
  double P_max = 0.0;                                      ///< p/p_h
  double p_h = std::numeric_limits<double>::quiet_NaN();   ///< [Pa]
  double eta0 = std::numeric_limits<double>::quiet_NaN();  ///< [Pa s]
};

/// The viscosity of a glass, by convention [Pa s]; an oil that has become one carries shear as a solid.
/// source: the usual definition of the glass transition of silicates and organic liquids, eta = 1e12 Pa s.
inline constexpr double glass_viscosity = 1e12;
/// ln(eta/eta0) of a glass where eta0 is not known: that of an oil of 0.1 Pa s.
inline constexpr double glass_log_viscosity = 30.0;
/// Pressure up to which the exponential of Barus follows measured viscosities [Pa], and its ln(eta/eta0) where p_h is
/// not known: that pressure with 20 1/GPa, a mineral oil. Above, measured curves bend away from it.
inline constexpr double barus_pressure = 0.5e9;
inline constexpr double barus_log_viscosity = 10.0;
/// Twice the highest pressure at which viscosities of lubricants were measured in number, 1.03 GPa [Pa]
/// source: ASME, Viscosity and Density of Over 40 Lubricating Fluids (1953), up to 150 000 psi.
inline constexpr double roelands_pressure = 2e9;
/// Where Dowson and Higginson's density, fitted to 0.4 GPa, has fallen 5 % behind Tait's equation with K0' = 11 and
/// K0 = 1.3 GPa, a typical oil near 25 C; it is 1 % behind at 0.4 GPa and 2 % at 1 GPa [Pa].
inline constexpr double dowson_higginson_pressure = 2e9;

/// What a user must know about a law at the highest pressure, each as one sentence with p_max, alpha_bar P and
/// ln(eta/eta0) there and the range it left; empty where the laws hold.
///   Barus: p_max above barus_pressure, or where p_h is not known ln(eta/eta0) above barus_log_viscosity.
///   Roelands: viscosity above that of a glass, or p_max above roelands_pressure.
///   Doolittle and Yasutomi: a glass, where the law is continued along its tangent.
///   Tables: p_max above their last pressure.
///   Dowson and Higginson: p_max above dowson_higginson_pressure.
/// limits: isoviscous, incompressible, Tait and Murnaghan have no range of pressure.
std::vector<std::string> out_of_range(const ViscosityLaw& viscosity, const DensityLaw& density, const Loading& loading);

}  // namespace ehl::rheology
