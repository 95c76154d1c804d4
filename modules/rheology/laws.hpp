#pragma once
// Viscosity and density of the lubricant as functions of pressure: small value types, evaluated on spans.
#include <span>
#include <variant>

#include "rheology/liquids.hpp"
#include "rheology/table.hpp"

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
using ViscosityLaw = std::variant<Isoviscous, Barus, Roelands, Doolittle, Yasutomi, TabulatedViscosity>;

/// Roelands' reference pressure [Pa].
inline constexpr double roelands_p0 = 1.96e8;
/// Roelands' exponent of a mineral oil of unknown viscosity.
inline constexpr double usual_z = 0.68;
/// Smallest and largest exponent that is accepted. Water, whose viscosity hardly rises with pressure, has less.
inline constexpr double least_z = 0.05, most_z = 1.5;
/// The pressure in Dowson and Higginson's density law [Pa].
inline constexpr double dowson_higginson_B = 5.9e8;

/// rho_bar = 1.
struct Incompressible {};
/// rho_bar = (5.9e8 + 1.34 p) / (5.9e8 + p), p in Pa. source: Dowson and Higginson (1966).
struct DowsonHigginson {
  double p_h_over_B;  ///< p_h / 5.9e8 Pa
};
using DensityLaw = std::variant<Incompressible, DowsonHigginson, Tait, Murnaghan, TabulatedDensity>;

/// Barus: alpha_bar = alpha p_h. in: alpha [1/Pa] >= 0, p_h [Pa] > 0.
Barus make_barus(double alpha, double p_h);
/// Roelands' law for P = p/p_h. in: alpha [1/Pa] > 0, p0 [Pa] > 0, z > 0 (0.45 to 0.7 for mineral oils), p_h [Pa] > 0.
/// limits: z = 1, or p0 -> infinity at z = 1, is Barus with alpha_bar = alpha p_h.
Roelands make_roelands(double alpha, double p0, double z, double p_h);
/// Exponent z that belongs to an ambient viscosity: alpha p0/z = ln(eta0) + 9.67.
/// in: alpha [1/Pa], p0 [Pa], eta0 [Pa s]. limits: eta0 > 6.3e-5 Pa s, Roelands' viscosity at -p0.
/// errors: InputError below that. source: Roelands (1966): all oils share the pole at -p0 and 6.3e-5 Pa s.
double roelands_z(double alpha, double p0, double eta0);
/// ln(eta0) + 9.67: ln of a viscosity [Pa s] over the viscosity at that pole.
double roelands_log_ratio(double eta0);
/// Dowson and Higginson's law for P = p/p_h. in: p_h [Pa] > 0.
DowsonHigginson make_dowson_higginson(double p_h);

/// This lubricant with the pressure scale p_h multiplied by `factor`. in: factor >= 0.
ViscosityLaw rescaled(const ViscosityLaw& law, double factor);
DensityLaw rescaled(const DensityLaw& law, double factor);

// All functions below: in P = p/p_h, any length; out of the same length, not overlapping P. Each value depends only on
// its own P, not on length or position. Slightly negative P continues the formula. Where 1 + p_h P/p0 <= 0 in Roelands'
// law, or a logarithm or power of another law has no value, the result is NaN.

/// fluidity = 1/eta_bar: never overflows; underflows to zero for ln(eta_bar) > 745. Exactly 1 at P = 0. error: below 4
/// units in the last place relative to the exponential of the rounded exponent; the rounding of the exponent adds up to
/// 4 |ln eta_bar| units.
void fluidity(const ViscosityLaw& law, std::span<const double> P, std::span<double> fluidity);
/// ln(eta_bar): finite where eta_bar overflows, accurate where ln(eta_bar) is small.
void log_viscosity(const ViscosityLaw& law, std::span<const double> P, std::span<double> log_eta);
/// ln(eta_bar) at one pressure.
double log_viscosity_at(const ViscosityLaw& law, double P);
/// d ln(eta_bar)/dP.
void log_viscosity_slope(const ViscosityLaw& law, std::span<const double> P, std::span<double> slope);

/// rho_bar(P). Exactly 1 at P = 0.
void density(const DensityLaw& law, std::span<const double> P, std::span<double> rho_bar);
/// d rho_bar/dP.
void density_slope(const DensityLaw& law, std::span<const double> P, std::span<double> drho_bar);

/// Fluidity and density in one loop over P, with the same bits as the two functions above.
void film_properties(const ViscosityLaw& viscosity, const DensityLaw& density, std::span<const double> P,
                     std::span<double> fluidity, std::span<double> rho_bar);
/// Fluidity, density and ln(eta_bar) in one loop.
void film_properties(const ViscosityLaw& viscosity, const DensityLaw& density, std::span<const double> P,
                     std::span<double> log_eta, std::span<double> fluidity, std::span<double> rho_bar);
/// Subtracts the shear thinning, ln(fluidity/fluidity of the oil), from ln(eta_bar). Where a fluidity is 0 nothing
/// changes.
void thin_log_viscosity(std::span<const double> oil_fluidity, std::span<const double> fluidity,
                        std::span<double> log_eta);

}  // namespace ehl::rheology
