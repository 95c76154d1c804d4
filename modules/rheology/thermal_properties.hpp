#pragma once
// Density, conductivity and heat capacity of the oil as functions of pressure and temperature, for the energy equation.
// theta = (T - T0)/T0 as in thermal_viscosity.hpp.
#include <span>
#include <variant>

#include "rheology/laws.hpp"
#include "rheology/thermal_viscosity.hpp"

namespace ehl::rheology {

/// rho(P, theta) = rho(P) exp[-e(P) (T - T0)], e = e0 exp(-P decay): the expansion coefficient e falls with pressure.
/// decay = 0: constant. source: Larsson and Andersson 2000 for the decay.
struct Expansion {
  double e0;           ///< [1/K] >= 0
  double decay = 0.0;  ///< per p_h, >= 0
};
/// Tait's or Murnaghan's equation with VolumeOfTemperature.
struct EquationOfState {
  VolumeOfTemperature volume;
};
/// A density law with temperature.
struct ThermalDensity {
  double T0;         ///< [K]
  DensityLaw at_T0;  ///< the isothermal law
  std::variant<Expansion, EquationOfState> expansion;
};

/// errors: InputError if an equation of state is required but the law has none with temperature.
ThermalDensity make_thermal_density(const DensityLaw& law, double T0,
                                    std::variant<Expansion, EquationOfState> expansion);
/// This law with p_h multiplied by `factor`.
ThermalDensity rescaled(const ThermalDensity& law, double factor);

/// ratio = rho(P, theta)/rho(P, 0), exactly 1 at theta = 0; expansion = -d ln rho/dtheta = e T0.
void density_change(const ThermalDensity& law, std::span<const double> P, std::span<const double> theta,
                    std::span<double> ratio, std::span<double> expansion);

/// Constant k and rho c.
struct ConstantHeat {};
/// k/k0 = 1 + 1.72 p/(1 + 0.54 p), rho c/(rho c)_0 = [1 + 0.47 p/(1 + 0.81 p)][1 + b (T - T0)],
/// b = 9.3e-4 (1 + 1.4 p - 0.51 p^2), p in GPa: a paraffinic mineral oil, k0 = 0.137 W/(m K), rho c = 1.71e6 J/(m^3 K);
/// the factors are taken for the oil's own k0 and (rho c)_0. source: Larsson and Andersson, Proc. IMechE J 214, 2000.
/// limits: measured to 1.1 GPa.
struct LarssonAndersson {
  double T0;  ///< [K]
  double p_h_in_GPa;
};
using HeatLaw = std::variant<ConstantHeat, LarssonAndersson>;
/// This law with p_h multiplied by `factor`.
HeatLaw rescaled(const HeatLaw& law, double factor);

/// k/k0, independent of the temperature.
void conductivity(const HeatLaw& law, std::span<const double> P, std::span<double> k_bar);
/// rho c/(rho c)_0.
void heat_capacity(const HeatLaw& law, std::span<const double> P, std::span<const double> theta,
                   std::span<double> rho_c_bar);

}  // namespace ehl::rheology
