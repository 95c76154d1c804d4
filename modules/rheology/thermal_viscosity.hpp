#pragma once
// Viscosity as a function of temperature at a given pressure, for the energy equation of the film.
//
// theta = (T - T0)/T0, T in kelvin, T0 the temperature of the isothermal law (laws.hpp). All laws are written as a
// change of that law,
//   ln eta_bar(P, theta) = ln eta_bar(P) + D(P, theta),
// with D exactly 0 at theta = 0, so that an isothermal film has the same bits.
#include <optional>
#include <span>
#include <variant>

#include "rheology/laws.hpp"
#include "rheology/temperature.hpp"

namespace ehl::rheology {

/// E(theta) = ln[eta(0, T)/eta(0, T0)] = -beta (T - T0).
struct Exponential {
  double beta;  ///< [1/K] > 0
};
/// E = A {[(T - 138)/(T0 - 138)]^-S0 - 1}, A = ln eta0 + 9.67: all oils approach one viscosity at high T.
/// source: Roelands 1966; Houpert 1985, who writes S0 = beta (T0 - 138)/A.
struct Houpert {
  double S0;  ///< > 0
  double A;   ///< > 0
};
/// E = B/(T - C) - B/(T0 - C). source: Vogel 1921, Fulcher, Tammann.
struct Vogel {
  double B;  ///< [K] > 0
  double C;  ///< [K], 0 <= C < T0
};
/// E = ln[nu(T) rho(T)/(nu(T0) rho(T0))] by ASTM D341 and the expansion of ASTM D1250 (temperature.hpp).
struct DataSheet {
  Walther walther;
  double density15;  ///< [kg/m^3]
};
/// Ambient viscosity as a function of temperature.
using AmbientViscosity = std::variant<Exponential, Houpert, Vogel, DataSheet>;

/// Volume as a function of temperature: V(0, T)/V(0, T0) = 1 + a_V (T - T0), K0(T) = K0 exp[-beta_K (T - T0)].
/// source: Bair 2007; Habchi 2018.
struct VolumeOfTemperature {
  double a_V;     ///< [1/K]
  double beta_K;  ///< [1/K]
};

/// Constants that a viscosity law needs to depend on temperature.
struct TemperatureConstants {
  double T0 = 0.0;                              ///< [K], of the isothermal law; above 138 for Houpert's law
  std::optional<AmbientViscosity> ambient{};    ///< for Barus and Roelands
  std::optional<VolumeOfTemperature> volume{};  ///< for Doolittle
  double occupied_expansion = 0.0;              ///< for Doolittle: R0 grows to R0 [1 + this (T - T0)] [1/K]
};

/// D = E(theta), independent of the pressure.
struct BarusOfT {
  double T0;
  AmbientViscosity ambient;
};
/// D = E(theta) (1 + p/p0)^z: ln(eta) + 9.67 is a function of T times one of p. source: Roelands 1966.
struct RoelandsOfT {
  double T0;
  AmbientViscosity ambient;
  double inverse_A;  ///< z/(alpha p0)
};
/// Doolittle's law with Tait's volume at T; occupied volume R0 [1 + e (T - T0)] in units of V(0, T0).
struct DoolittleOfT {
  double T0;
  Doolittle at_T0;
  VolumeOfTemperature volume;
  double occupied_expansion;
};
/// Yasutomi's law, which depends on T itself.
struct YasutomiOfT {
  double T0;
  Yasutomi at_T0;
};
using ThermalViscosity = std::variant<BarusOfT, RoelandsOfT, DoolittleOfT, YasutomiOfT>;

/// The law with temperature. errors: InputError if it has none: isoviscous, table, or constants missing.
ThermalViscosity make_thermal_viscosity(const ViscosityLaw& law, const TemperatureConstants& constants);
/// This lubricant with p_h multiplied by `factor`.
ThermalViscosity rescaled(const ThermalViscosity& law, double factor);

/// Houpert's law with the slope -d ln eta/dT = beta at T0. in: beta [1/K] > 0, eta0 [Pa s] > 6.3e-5, T0 [K] > 138.
Houpert make_houpert(double beta, double eta0, double T0);
/// ln[eta(0, T)/eta(0, T0)] at one temperature [K].
double log_ambient_change(const AmbientViscosity& ambient, double T0, double T);

/// D and dD/dtheta. in: P, log_eta = ln eta_bar(P) of the isothermal law at the same P, theta; out: same length, not
/// overlapping the input. limits: T above Houpert's 138 K and Vogel's C, NaN below. Beyond the glass transition
/// Doolittle and Yasutomi continue along the tangent in pressure at that temperature. error: a few units in the last
/// place of D if the oil is not a glass.
void log_viscosity_change(const ThermalViscosity& law, std::span<const double> P, std::span<const double> log_eta,
                          std::span<const double> theta, std::span<double> D, std::span<double> dD);

}  // namespace ehl::rheology
