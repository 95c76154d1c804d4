#include "case/thermal_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "rheology/temperature.hpp"
#include "rheology/thermal_keys.hpp"
#include "thermal/keys.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;

// Refuses what is not available for a contact with heat.
void check_possible(deck::Deck& deck, const Physics& physics, const steady::Scene& scene) {
  const char* caller = given(deck, "thermal", "T_oil")    ? "T_oil"
                       : given(deck, "thermal", "solid1") ? "solid1"
                                                          : "solid2";
  if (physics.language != Language::si)
    complain(deck, "thermal", caller,
             "needs speeds, load, radius and viscosity in SI: give load, radius_x and the elastic data, u_m and srr, "
             "eta0 and alpha");
  if (deck::word(deck, "multigrid", "polish") == "always")
    complain(deck, "multigrid", "polish",
             "always is available for isothermal contacts only, because film and temperature are solved by a "
             "fixed-point iteration: set polish = rescue");
  if (std::abs(physics.srr) > 2.0)
    complain(deck, "motion", given(deck, "motion", "u_m") ? "srr" : "u2",
             "one surface moves against the rolling direction: [thermal] needs -2 <= srr <= 2");
  if (scene.grid.line && std::abs(physics.srr) == 2.0) {
    const bool by_srr = given(deck, "motion", "srr");
    complain(deck, "motion",
             by_srr              ? "srr"
             : physics.srr > 0.0 ? "u2"
                                 : "u1",
             fmt::format("surface {} stands still, and in a line contact, which has no sides, its temperature would "
                         "rise without end: [thermal] needs both surfaces to move there, {}",
                         physics.srr > 0.0 ? 2 : 1, by_srr ? "-2 < srr < 2" : "u1 and u2 > 0"));
  }
}

thermal::Body body_of(const thermal::BodyInput& body, double u, double a, double k0, double T0) {
  const double T = body.T + rheology::zero_celsius;
  return {
      .Pe = std::max(0.0, u) * a * body.rho * body.c / body.k, .resistance = k0 / (body.k * a), .theta = (T - T0) / T0};
}

// beta = -d ln eta/dT at ambient pressure and T0.
double beta_of(const rheology::ThermalViscosity& law, double T0) {
  constexpr std::array<double, 1> zero{};
  std::array<double, 1> D{}, slope{};
  rheology::log_viscosity_change(law, zero, zero, zero, D, slope);
  return -slope[0] / T0;
}

}  // namespace

std::optional<HeatInput> thermal_input(deck::Deck& deck, const Physics& physics, const steady::Scene& scene,
                                       double limit) {
  if (!deck::called_for(deck, "thermal")) return std::nullopt;
  check_possible(deck, physics, scene);
  const rheology::WarmOil oil = rheology::read_warm_oil(deck);
  const thermal::Input heat = thermal::read(deck);
  if (!deck.errors.empty()) return std::nullopt;

  const contact::SiContact& contact = physics.si->contact;
  const contact::Hertz& hertz = physics.si->hertz;
  const double a = hertz.a, R = contact.radius, T0 = oil.constants.T0, u_m = 0.5 * contact.u_s;
  const double flow = u_m * a * a * a / (oil.k * R * R);
  HeatInput input{.T0 = T0, .k = oil.k, .power = oil.k * T0 * R / (scene.grid.line ? a : 1.0), .fields = heat.fields};
  const rheology::HeatLaw law = oil.follows_pressure
                                    ? rheology::HeatLaw{rheology::LarssonAndersson{T0, 1e-9 * physics.p_h}}
                                    : rheology::HeatLaw{rheology::ConstantHeat{}};
  input.setup = {.intervals = heat.intervals,
                 .lambda = scene.lambda,
                 .srr = physics.srr,
                 .stress_of_P = physics.p_h * a * a / (contact.eta0 * u_m * R),
                 .viscosity = scene.viscosity,
                 .thermal_viscosity = rheology::make_thermal_viscosity(scene.viscosity, oil.constants),
                 .thinning = scene.thinning,
                 .density = rheology::make_thermal_density(scene.density, T0, rheology::Expansion{oil.expansion}),
                 .heat = law,
                 .Br = contact.eta0 * u_m * u_m / (oil.k * T0),
                 .Pe = heat.convection ? oil.rho * oil.c * flow : 0.0,
                 .compression = heat.compression ? physics.p_h * flow / T0 : 0.0,
                 .limit = limit,
                 .body_1 = body_of(heat.body_1, physics.si->u1, a, oil.k * R, T0),
                 .body_2 = body_of(heat.body_2, physics.si->u2, a, oil.k * R, T0),
                 .lines = heat.lines};
  input.beta = beta_of(input.setup.thermal_viscosity, T0);
  return input;
}

}  // namespace ehl::program
