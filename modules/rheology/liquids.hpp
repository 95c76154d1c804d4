#pragma once
// Physical laws of liquids: density from an equation of state; viscosity from the free volume or from the distance to
// the glass transition. Evaluated through laws.hpp.
#include <span>

namespace ehl::rheology {

/// v = 1 - ln[1 + (1 + K0') p/K0]/(1 + K0'), rho_bar = 1/v. source: Tait, in the form of Bair (High Pressure Rheology
/// for Quantitative Elastohydrodynamics, 2007).
struct Tait {
  double K0_prime;     ///< pressure derivative of the bulk modulus at ambient pressure
  double p_h_over_K0;  ///< p_h over the bulk modulus at ambient pressure
};

/// rho_bar = (1 + K0' p/K0)^(1/K0'): the bulk modulus grows linearly with the pressure. source: Murnaghan (1944).
struct Murnaghan {
  double K0_prime;
  double p_h_over_K0;
};

/// ln eta_bar = B R0 [1/(v - R0) - 1/(1 - R0)], v Tait's relative volume: viscosity from the free volume. Above the
/// pressure at which the oil is a glass (1e12 Pa s) the law continues along its tangent, because v = R0 is a pole.
/// source: Doolittle (1951); with Tait's volume Cook et al. (1994).
struct Doolittle {
  double B;
  double R0;           ///< occupied volume over the volume at ambient pressure, at the temperature of the contact
  double K0_prime;     ///< of Tait's equation
  double p_h_over_K0;  ///< of Tait's equation
  double u_glass;      ///< p/K0 at which the oil becomes a glass
  double log_glass;    ///< ln eta_bar there
  double slope_glass;  ///< d ln eta_bar/d(p/K0) there
};

/// ln(eta/eta_g) = -ln(10) C1 x/(C2 + x), x = (T - Tg) F, Tg = Tg0 + A1 ln(1 + A2 p), F = (1 + b1 p)^b2: viscosity from
/// the distance to the glass transition (Williams, Landel, Ferry). Beyond the transition, x < 0, the law continues
/// along its tangent. source: Yasutomi, Bair and Winer (1984); F of Bair, Mary, Bouscharain and Vergne (2013).
struct Yasutomi {
  double x0;           ///< T - Tg0 [K]
  double A1;           ///< [K]
  double A2;           ///< [1/Pa]
  double b1;           ///< [1/Pa]
  double b2;           ///< -
  double C1;           ///< -
  double C2;           ///< [K]
  double p_h;          ///< [Pa]
  double p_glass;      ///< pressure of the glass transition [Pa]
  double log_glass;    ///< ln eta_bar there
  double slope_glass;  ///< d ln eta_bar/dp there [1/Pa]
};

/// Tait's equation for P = p/p_h. in: K0 [Pa] > 0, K0_prime > 0, p_h [Pa] >= 0.
Tait make_tait(double K0, double K0_prime, double p_h);
/// Murnaghan's equation for P = p/p_h. in: as for make_tait().
Murnaghan make_murnaghan(double K0, double K0_prime, double p_h);

/// Constants of Doolittle's law.
struct DoolittleConstants {
  double B = 0.0;         ///< > 0
  double R0 = 0.0;        ///< 0 < R0 < 1
  double K0 = 0.0;        ///< of Tait's equation [Pa] > 0
  double K0_prime = 0.0;  ///< of Tait's equation > 0
  double eta0 = 0.0;      ///< viscosity at ambient pressure, only for the pressure of the glass [Pa s], 0 < eta0 < 1e12
};
/// Doolittle's law for P = p/p_h. in: p_h [Pa] >= 0.
Doolittle make_doolittle(const DoolittleConstants& constants, double p_h);

/// Constants of Yasutomi's law.
struct YasutomiConstants {
  double T = 0.0;      ///< temperature of the contact [C] > Tg0
  double Tg0 = 0.0;    ///< glass transition at ambient pressure [C]
  double A1 = 0.0;     ///< [K] > 0
  double A2 = 0.0;     ///< [1/Pa] > 0
  double b1 = 0.0;     ///< [1/Pa] >= 0
  double b2 = 0.0;     ///< <= 0
  double C1 = 0.0;     ///< > 0
  double C2 = 0.0;     ///< [K] > 0
  double eta_g = 0.0;  ///< viscosity at the glass transition [Pa s] > 0
};
/// Yasutomi's law for P = p/p_h. in: p_h [Pa] >= 0.
Yasutomi make_yasutomi(const YasutomiConstants& constants, double p_h);
/// Viscosity at ambient pressure by that law [Pa s].
double yasutomi_eta0(const YasutomiConstants& constants);

// Functions that laws.hpp visits. in: P; out: same length, not overlapping.
void log_eta(const Doolittle& law, std::span<const double> P, std::span<double> out);
void log_eta(const Yasutomi& law, std::span<const double> P, std::span<double> out);
void log_eta_slope(const Doolittle& law, std::span<const double> P, std::span<double> out);
void log_eta_slope(const Yasutomi& law, std::span<const double> P, std::span<double> out);
void rho(const Tait& law, std::span<const double> P, std::span<double> out);
void rho(const Murnaghan& law, std::span<const double> P, std::span<double> out);
void rho_slope(const Tait& law, std::span<const double> P, std::span<double> out);
void rho_slope(const Murnaghan& law, std::span<const double> P, std::span<double> out);

}  // namespace ehl::rheology
