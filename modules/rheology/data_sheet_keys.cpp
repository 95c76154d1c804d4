// Keys of a data sheet: kinematic viscosities, density, alpha*; and the temperature of the contact.
#include <fmt/format.h>

#include <cmath>

#include "deck/record.hpp"
#include "rheology/keys.hpp"
#include "rheology/pressure_coefficient.hpp"
#include "rheology/temperature.hpp"

namespace ehl::rheology {
namespace {

using Names = std::vector<std::string>;

const Names of_data_sheet{"kv40", "kv100", "density15"};

// [Pa s]
double viscosity_at(const deck::Part& lubricant, double T, AmbientOil& ambient) {
  const Walther law = make_walther(lubricant.number("kv40"), lubricant.number("kv100"));
  ambient = {T, kinematic_viscosity(law, T), oil_density(lubricant.number("density15"), T)};
  constexpr double square_millimetre = 1e-6;  // [m^2]
  return square_millimetre * ambient.nu * ambient.rho;
}

void check_oil_temperature(const deck::Part& lubricant, const std::string& name) {
  const double T = lubricant.number(name);
  if (T < coldest_oil || T > hottest_oil)
    lubricant.complain(name, fmt::format("must be from {:g} to {:g} C, the range in which kv40 and kv100 describe an "
                                         "oil. Is it in kelvin or in degrees Fahrenheit?",
                                         coldest_oil, hottest_oil));
}

// Refuses alpha_star and alpha_temperature where they are not allowed.
void check_alpha_star(const deck::Part& lubricant, const Oil& oil) {
  const Names both{"alpha_star", "alpha_temperature"};
  if (lubricant.given("alpha"))
    lubricant.refuse(both, "alpha is given as well: keep one of them");
  else if (oil.viscosity != "barus" && oil.viscosity != "roelands")
    lubricant.refuse(both,
                     "has no influence with viscosity = " + oil.viscosity +
                         (oil.viscosity == "isoviscous" ? ": remove it" : ": the law has its own alpha*; remove it"),
                     deck::Cause::idle);
}

// Roelands' law from alpha* at `T_alpha`, where the viscosity is eta_alpha. z does not depend on the temperature.
void set_roelands(const deck::Part& lubricant, double alpha_star, double eta_alpha, bool same_temperature, Oil& oil) {
  const deck::Key& key = lubricant.key("z");
  const double z = roelands_z_of(alpha_star, oil.p0, eta_alpha);
  if (std::isnan(z)) {
    lubricant.complain(
        "alpha_star",
        fmt::format(
            "with eta0 = {:.4g} Pa s no z that is {} gives this value: check alpha_star [1/Pa] and the viscosity",
            eta_alpha, deck::allowed(key)));
    return;
  }
  settle(lubricant, "z", deck::shortest(z), "from alpha_star and the viscosity");
  deck::mark_following(lubricant.deck, lubricant.section, "z");
  oil.z = z;
  oil.roelands_alpha = z * roelands_log_ratio(oil.eta0) / oil.p0;
  constexpr double pascal = 1.0;
  if (!same_temperature)
    oil.alpha = pressure_coefficients(make_roelands(oil.roelands_alpha, oil.p0, z, pascal)).alpha_star;
}

}  // namespace

std::vector<deck::Key> data_sheet_keys() {
  using namespace deck::record;
  return {
      key("temperature", unit("C"), Range{-273.15, 1000.0, true, false}, example("40"),
          otherwise("40 for an oil by name whose viscosities at 40 and 100 C are known"),
          "Temperature of oil and bodies. It is required with kv40 and kv100, with K00 and beta_K, and with viscosity "
          "= yasutomi, where it must lie above the glass transition Tg0. All other constants are values at the "
          "temperature of the contact."),
      key("kv40", unit("mm^2/s"), Range{least_kinematic_viscosity, 1e5}, example("68"),
          "Kinematic viscosity at 40 C. kv40, kv100, density15 and temperature replace eta0: the viscosity at the "
          "temperature follows from ASTM D341 (Walther).",
          remedy("in mm^2/s = cSt, as in data sheets"), source("ASTM D341")),
      key("kv100", unit("mm^2/s"), Range{least_kinematic_viscosity, 1e5}, example("8.5"),
          "Kinematic viscosity at 100 C. It must be below kv40.", remedy("in mm^2/s = cSt, as in data sheets"),
          source("ASTM D341")),
      key("density15", unit("kg/m^3"), Range{500.0, 3000.0}, example("880"),
          "Density at 15 C. The density at the temperature follows with the thermal expansion of lubricating oils, "
          "0.6278/density15 per kelvin.",
          remedy("oils have 800 to 1000 kg/m^3"), source("ASTM D1250, table 54D")),
      key("alpha_star", unit("1/Pa"), Range{1e-12, 1e-6}, example("18e-9"),
          "Pressure coefficient alpha*, defined by 1/alpha* = int eta0/eta dp, instead of alpha, for viscosity = barus "
          "and roelands. Roelands' z (without eta0: the slope) is chosen so that alpha* is met. Groups and film "
          "formulas use alpha* as alpha. alpha is the slope of the law at ambient pressure, 5 to 25 % larger.",
          remedy("mineral oils have 1e-8 to 3e-8"), source("Blok 1963; Bair, Liu and Wang 2006")),
      key("alpha_temperature", unit("C"), Range{-273.15, 1000.0, true, false}, example("40"), otherwise("temperature"),
          "Temperature at which the oil has alpha_star, with kv40, kv100 and viscosity = roelands. z is the same at "
          "every temperature.",
          source("Roelands 1966")),
  };
}

std::optional<AmbientOil> read_ambient(const deck::Part& lubricant) {
  const std::string viscosity = lubricant.word("viscosity");
  const bool brings_eta0 = viscosity == "yasutomi" || viscosity == "table";
  if (brings_eta0)
    lubricant.refuse(of_data_sheet,
                     "has no influence with viscosity = " + viscosity + ", which has its own constants: remove it",
                     deck::Cause::idle);
  bool any = false;
  for (const std::string& name : of_data_sheet) any = any || (lubricant.has(name) && !brings_eta0);
  if (!any && !lubricant.given("fluid") && viscosity != "yasutomi" && lubricant.given_of({"K00", "beta_K"}).empty())
    lubricant.refuse({"temperature"},
                     "has no influence: the constants are values at the temperature of the contact. Remove it, or give "
                     "kv40, kv100 and density15 instead of eta0, or K00 and beta_K instead of K0",
                     deck::Cause::idle);
  if (!any) return std::nullopt;
  demand(lubricant, {"kv40", "kv100", "density15", "temperature"}, "an oil by its viscosities at two temperatures");
  if (lubricant.number("kv40") <= lubricant.number("kv100"))
    lubricant.complain("kv100", "must be below kv40: an oil thins when it warms");
  check_oil_temperature(lubricant, "temperature");
  if (!lubricant.deck.errors.empty()) return std::nullopt;
  AmbientOil ambient;
  const double eta0 = viscosity_at(lubricant, lubricant.number("temperature"), ambient);
  settle_at_temperature(lubricant, "eta0", eta0, "kv40, kv100 and density15");
  return ambient;
}

void read_alpha_star(const deck::Part& lubricant, Oil& oil) {
  if (!lubricant.has("alpha_star")) {
    lubricant.refuse({"alpha_temperature"}, "has no influence: it is used only with alpha_star; remove it",
                     deck::Cause::idle);
    return;
  }
  check_alpha_star(lubricant, oil);
  const bool roelands = oil.viscosity == "roelands";
  if (!oil.ambient || !roelands)
    lubricant.refuse({"alpha_temperature"},
                     "has no influence: it is used only with kv40, kv100 and viscosity = roelands; remove it",
                     deck::Cause::idle);
  else if (!lubricant.has("alpha_temperature"))
    lubricant.choose("alpha_temperature", oil.ambient->T, "the temperature of the contact");
  check_oil_temperature(lubricant, "alpha_temperature");
  const double alpha_star = lubricant.number("alpha_star");
  if (!lubricant.deck.errors.empty()) return;
  oil.alpha = alpha_star;
  if (!roelands) return;
  if (std::isnan(oil.eta0)) {
    lubricant.fill("z", usual_z, "typical of mineral oils; with eta0 it would be computed");
    oil.z = lubricant.number("z");
    oil.roelands_alpha = roelands_alpha_of(alpha_star, oil.p0, oil.z);
    return;
  }
  double eta_alpha = oil.eta0;
  const double T_alpha = lubricant.number("alpha_temperature");
  const bool same_temperature = !oil.ambient || T_alpha == oil.ambient->T;
  AmbientOil there;
  if (!same_temperature) eta_alpha = viscosity_at(lubricant, T_alpha, there);
  set_roelands(lubricant, alpha_star, eta_alpha, same_temperature, oil);
}

}  // namespace ehl::rheology
