#pragma once
// Pressure ranges of the viscosity and density laws.

#include "core/constants.hpp"
#include "core/warning.hpp"
#include "rheology/laws.hpp"

namespace ehl::rheology {

/// Highest pressure of a solution and its scales; NaN: not known.
struct Loading {
  double P_max = 0.0;           ///< p/p_h
  double p_h = core::unknown;   ///< [Pa]
  double eta0 = core::unknown;  ///< [Pa s]
};

/// Viscosity of a glass by convention [Pa s]; such an oil carries shear like a solid.
/// source: the usual definition of the glass transition of silicates and organic liquids, eta = 1e12 Pa s.
inline constexpr double glass_viscosity = 1e12;
/// ln(eta/eta0) of a glass for an unknown eta0: value for an oil of 0.1 Pa s.
inline constexpr double glass_log_viscosity = 30.0;
/// Pressure up to which the exponential of Barus follows measured viscosities [Pa], and its ln(eta/eta0) for an unknown
/// p_h: that pressure with 20 1/GPa, a mineral oil. Measured viscosities rise more slowly above.
inline constexpr double barus_pressure = 0.5e9;
inline constexpr double barus_log_viscosity = 10.0;
/// Twice the highest pressure of extensive viscosity measurements on lubricants, 1.03 GPa [Pa].
/// source: ASME, Viscosity and Density of Over 40 Lubricating Fluids (1953), up to 150 000 psi.
inline constexpr double roelands_pressure = 2e9;
/// Pressure at which Dowson and Higginson's density, fitted up to 0.4 GPa, is 5 % below Tait's equation with K0' = 11
/// and K0 = 1.3 GPa, a typical oil near 25 C [Pa].
inline constexpr double dowson_higginson_pressure = 2e9;

/// Warnings about a law at the highest pressure, each one sentence with p_max, alpha_bar P, ln(eta/eta0) and the range;
/// empty if all laws are within their ranges:
///   Barus: p_max above barus_pressure; for an unknown p_h, ln(eta/eta0) above barus_log_viscosity. It
///     recommends Roelands' law, or a table of measured viscosities for a liquid that this law does not describe.
///   Roelands: viscosity above that of a glass, or p_max above roelands_pressure.
///   Doolittle and Yasutomi: a glass, for which the law is continued along its tangent.
///   Tables: p_max above the last pressure.
///   Dowson and Higginson: p_max above dowson_higginson_pressure.
/// limits: isoviscous, incompressible, Tait and Murnaghan have no pressure range.
core::Warnings out_of_range(const ViscosityLaw& viscosity, const DensityLaw& density, const Loading& loading);

}  // namespace ehl::rheology
