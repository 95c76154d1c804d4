#include "rheology/thermal_keys.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "deck/record.hpp"
#include "rheology/keys.hpp"
#include "rheology/laws.hpp"

namespace ehl::rheology {
namespace {

using Names = std::vector<std::string>;

const Names by_slope{"beta"}, by_second{"T_second", "eta_second"}, by_vogel{"vogel_B", "vogel_C"};
const Names of_volume{"volume_expansion", "modulus_decay", "occupied_expansion"};
// Density of a typical mineral oil, used if no key gives one [kg/m^3].
constexpr double usual_density = 870.0;

// A number for each of the names, or NaN.
std::vector<double> numbers(const deck::Part& part, const Names& names) {
  std::vector<double> list;
  for (const std::string& name : names) list.push_back(part.number(name));
  return list;
}

// Roelands: all oils meet at T = 138 K. S0 follows from the second viscosity.
Houpert through_second(const deck::Part& thermal, double T0, double eta0, double T, double eta) {
  constexpr double pole = 138.0;
  const double A = roelands_log_ratio(eta0);
  const double share = 1.0 + std::log(eta / eta0) / A;
  if (!((T - T0) * (eta - eta0) < 0.0))
    thermal.complain("eta_second",
                     "must be below the viscosity at T_oil if T_second is above T_oil, and above it if T_second is "
                     "below: an oil thins when it warms");
  else if (!(share > 0.0))
    thermal.complain("eta_second", "is too far from the viscosity at T_oil for Roelands' law: check both [Pa s]");
  return {-std::log(share) / std::log((T - pole) / (T0 - pole)), A};
}

// Ambient viscosity for Barus and Roelands, from the keys that the deck gives.
std::optional<AmbientViscosity> ambient_of(const deck::Part& thermal, bool roelands, double T0) {
  const deck::Part lubricant{thermal.deck, "lubricant"};
  const double eta0 = lubricant.number("eta0");
  const std::vector<double> slope = numbers(thermal, by_slope), second = numbers(thermal, by_second),
                            vogel = numbers(thermal, by_vogel);
  Names given;
  for (const Names* names : {&by_slope, &by_second, &by_vogel})
    for (const std::string& name : *names)
      if (thermal.given(name)) given.push_back(name);
  if (lubricant.has("kv40")) {
    thermal.refuse(given, "must not be given: kv40 and kv100 give the viscosity at every temperature; remove it");
    return DataSheet{make_walther(lubricant.number("kv40"), lubricant.number("kv100")), lubricant.number("density15")};
  }
  if (given.empty()) {
    thermal.complain("beta",
                     "is missing: the viscosity must fall with temperature. Give beta, or T_second and eta_second, or "
                     "vogel_B and vogel_C, or an oil by kv40 and kv100",
                     deck::Cause::missing);
    return std::nullopt;
  }
  const Names& used = thermal.given("beta") ? by_slope : thermal.given_of(by_second).empty() ? by_vogel : by_second;
  for (const std::string& name : given)
    if (std::ranges::find(used, name) == used.end())
      thermal.complain(name,
                       "is a second way to give the viscosity against temperature: keep beta, or T_second with "
                       "eta_second, or vogel_B with vogel_C");
  demand(thermal, used, "the viscosity against temperature");
  if (!thermal.deck.errors.empty()) return std::nullopt;
  if (&used == &by_slope) {
    if (roelands) return make_houpert(slope[0], eta0, T0);
    return Exponential{slope[0]};
  }
  if (&used == &by_second) return through_second(thermal, T0, eta0, second[0] + zero_celsius, second[1]);
  const double C = vogel[1] + zero_celsius;
  constexpr double least_distance = 5.0;  // [K]: closer to C the viscosity diverges
  if (!(T0 - C >= least_distance))
    thermal.complain("vogel_C", "must be at least 5 C below T_oil: at vogel_C Vogel's viscosity is infinite");
  return Vogel{vogel[0], C};
}

void read_viscosity(const deck::Part& thermal, WarmOil& oil) {
  const deck::Part lubricant{thermal.deck, "lubricant"};
  const std::string law = lubricant.word("viscosity");
  if (law == "isoviscous" || law == "table") {
    lubricant.complain("viscosity", law +
                                        " does not depend on temperature, but [thermal] needs a viscosity that falls "
                                        "when the oil warms: choose another law, or remove [thermal]");
    return;
  }
  const bool simple = law == "barus" || law == "roelands";
  if (simple)
    oil.constants.ambient = ambient_of(thermal, law == "roelands", oil.constants.T0);
  else
    for (const Names& names : {by_slope, by_second, by_vogel})
      thermal.refuse(names, "has no influence with viscosity = " + law + ": remove it", deck::Cause::idle);
  if (law != "doolittle") {
    thermal.refuse(of_volume, "has no influence with viscosity = " + law + ": remove it", deck::Cause::idle);
    return;
  }
  const bool known = lubricant.has("beta_K");
  if (known) settle(thermal, "modulus_decay", lubricant.word("beta_K"), "[lubricant] beta_K");
  demand(thermal, of_volume, "viscosity = doolittle with [thermal]");
  oil.constants.volume = {thermal.number("volume_expansion"), thermal.number("modulus_decay")};
  oil.constants.occupied_expansion = thermal.number("occupied_expansion");
}

std::vector<deck::Key> viscosity_keys() {
  using namespace deck::record;
  return {
      key("beta", unit("1/K"), Range{1e-4, 0.3}, example("0.04"),
          "Temperature coefficient -d ln(eta)/dT at ambient pressure and T_oil, for barus (exponential) and "
          "roelands (S0 of Roelands and Houpert). T_second and eta_second, or vogel_B and vogel_C, may be given "
          "instead. kv40 with kv100, doolittle and yasutomi have their own."),
      key("T_second", unit("C"), Range{coldest_oil, hottest_oil}, example("100"),
          "Second temperature, other than T_oil, at which the viscosity is eta_second."),
      key("eta_second", unit("Pa s"), up_to(1e6), example("0.007"), "Viscosity at ambient pressure and T_second."),
      key("vogel_B", unit("K"), Range{1.0, 1e4}, example("900"), "Constant B of Vogel's law eta = A exp[B/(T - C)]."),
      key("vogel_C", unit("C"), Range{-273.15, -40.0}, example("-110"),
          "Constant C of Vogel's law, at which the viscosity is infinite, in degrees Celsius."),
      key("volume_expansion", unit("1/K"), Range{1e-5, 1e-2}, example("8.4e-4"),
          "For viscosity = doolittle: relative growth of the volume V0 per kelvin."),
      key("modulus_decay", unit("1/K"), Range{1e-5, 0.1}, example("6.332e-3"),
          "For viscosity = doolittle: decay of the bulk modulus, K0 proportional to exp(-modulus_decay T). It "
          "equals [lubricant] beta_K if that is given."),
      key("occupied_expansion", unit("1/K"), Range{-1e-2, 1e-2}, example("-7.3e-4"),
          "For viscosity = doolittle: relative growth of the occupied volume R0 per kelvin."),
  };
}

deck::Records<WarmOil> property_records() {
  using namespace deck::record;
  return {
      key("k", &WarmOil::k, unit("W/(m K)"), Range{0.01, 10.0}, by_default("0.14"),
          "Thermal conductivity of the oil at ambient pressure.", remedy("oils have 0.11 to 0.17 W/(m K)"),
          source("paraffinic mineral oil: Larsson and Andersson 2000, 0.137")),
      key("c", &WarmOil::c, unit("J/(kg K)"), Range{200.0, 1e4}, by_default("2000"),
          "Specific heat capacity of the oil at ambient pressure.", remedy("oils have 1700 to 2400 J/(kg K)"),
          source("the same oil: rho c = 1.71e6 J/(m^3 K)")),
      key("rho", &WarmOil::rho, unit("kg/m^3"), Range{500.0, 3000.0}, example("870"),
          otherwise("from density15 if that is given, else 870"),
          "Density of the oil at ambient pressure and T_oil, for the heat that it carries.",
          remedy("oils have 800 to 1000 kg/m^3")),
      key("properties", &WarmOil::follows_pressure, {{"larsson-andersson", true}, {"constant", false}}, own_default,
          "How k and rho c depend on pressure. larsson-andersson: they grow as those of a mineral oil, at 1 GPa to 2.1 "
          "times k and 1.3 times rho c. constant: they do not.",
          source("Larsson and Andersson, Proc. IMechE J 214, 2000")),
      key("expansion", &WarmOil::expansion, unit("1/K"), Range{0.0, 5e-3}, by_default("6.5e-4"),
          "Thermal expansion coefficient of the oil, -d ln(rho)/dT.",
          source("mineral oils, 6.3e-4 to 7.5e-4: ASTM D1250")),
  };
}

}  // namespace

std::vector<deck::Key> warm_oil_keys() {
  using namespace deck::record;
  const deck::Key T_oil = key("T_oil", unit("C"), Range{coldest_oil, hottest_oil}, example("40"),
                              otherwise("[lubricant] temperature, if that is given"),
                              "Temperature of the oil that enters the contact. eta0, alpha and the other "
                              "constants of the oil are values at this temperature.",
                              remedy("is it in kelvin or in degrees Fahrenheit?"));
  return deck::together({deck::in_section("thermal", deck::together({std::vector<deck::Key>{T_oil}, viscosity_keys()})),
                         deck::keys_of("thermal", property_records())});
}

WarmOil read_warm_oil(deck::Deck& deck) {
  const deck::Part thermal{deck, "thermal"}, lubricant{deck, "lubricant"};
  WarmOil oil;
  if (lubricant.has("temperature"))
    settle(thermal, "T_oil", deck::shortest(lubricant.number("temperature")), "[lubricant] temperature");
  else
    demand(thermal, {"T_oil"}, "[thermal]");
  oil.constants.T0 = thermal.number("T_oil") + zero_celsius;
  if (lubricant.has("density15"))
    thermal.fill("rho", oil_density(lubricant.number("density15"), thermal.number("T_oil")), "density15 at T_oil");
  thermal.fill("rho", usual_density, "typical of mineral oils");
  read_viscosity(thermal, oil);
  deck::read(thermal, property_records(), oil);
  return oil;
}

}  // namespace ehl::rheology
