#pragma once
// How the lubricant's viscosity and density depend on pressure: small value types, evaluated on spans.
#include <span>
#include <variant>

namespace ehl::rheology {

/// eta_bar = 1.
struct Isoviscous {};
/// eta_bar = exp(alpha_bar P).
struct Barus {
  double alpha_bar;
};
/// eta_bar = exp{(alpha p0/z) [(1 + p_h P/p0)^z - 1]}.
struct Roelands {
  double alpha_p0_over_z;  ///< alpha p0 / z
  double p_h_over_p0;      ///< p_h / p0
  double z;
};
using ViscosityLaw = std::variant<Isoviscous, Barus, Roelands>;

/// rho_bar = 1.
struct Incompressible {};
/// rho_bar = (5.9e8 + 1.34 p) / (5.9e8 + p), p in Pa.
struct DowsonHigginson {
  double p_h_over_B;  ///< p_h / 5.9e8 Pa
};
using DensityLaw = std::variant<Incompressible, DowsonHigginson>;

/// fluidity = 1/eta_bar: never overflows, and underflows to zero where alpha_bar P passes about 700.
/// in: P >= 0, any length. out: fluidity, same length. error: below 4 units in the last place relative
/// to the exact formula evaluated with the rounded exponent.
void fluidity(const ViscosityLaw& law, std::span<const double> P, std::span<double> fluidity);
/// d ln(eta_bar)/dP.
void log_viscosity_slope(const ViscosityLaw& law, std::span<const double> P, std::span<double> slope);
/// ln(eta_bar): finite where eta_bar itself overflows.
void log_viscosity(const ViscosityLaw& law, std::span<const double> P, std::span<double> log_eta);

/// rho_bar(P) and d rho_bar/dP.
void density(const DensityLaw& law, std::span<const double> P, std::span<double> rho_bar);
void density_slope(const DensityLaw& law, std::span<const double> P, std::span<double> drho_bar);

}  // namespace ehl::rheology
