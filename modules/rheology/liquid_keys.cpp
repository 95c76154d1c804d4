// The keys of [lubricant] that belong to single laws.
#include <cmath>

#include "deck/file.hpp"
#include "deck/text.hpp"
#include "rheology/fluid_table.hpp"
#include "rheology/keys.hpp"
#include "rheology/pressure_coefficient.hpp"
#include "rheology/temperature.hpp"

namespace ehl::rheology {
namespace {

using deck::Key;
using deck::Type;

Key constant(const char* name, const char* unit, deck::Range range, const char* meaning, const char* example) {
  return {.name = name, .unit = unit, .range = range, .meaning = meaning, .example = example};
}

using Names = std::vector<std::string>;

const Names bulk_modulus{"K0", "K0_prime"}, bulk_modulus_of_T{"K00", "beta_K"};
const Names doolittle{"eta0", "doolittle_B", "doolittle_R0", "K0", "K0_prime"};
const Names yasutomi{"temperature", "Tg0", "A1", "A2", "b1", "b2", "C1", "C2", "eta_g"};

// K0 from its value and decay with temperature, if given so. source: Habchi, Finite Element Modeling of
// Elastohydrodynamic Lubrication Problems, 2018.
void read_bulk_modulus(const deck::Part& lubricant) {
  const double K00 = lubricant.number("K00"), beta_K = lubricant.number("beta_K");
  if (lubricant.given_of(bulk_modulus_of_T).empty()) return;
  demand(lubricant, {"K00", "beta_K", "temperature"}, "the bulk modulus at a temperature");
  if (!lubricant.deck.errors.empty()) return;
  const double T = lubricant.number("temperature") + zero_celsius;
  settle_at_temperature(lubricant, "K0", K00 * std::exp(-beta_K * T), "K00 and beta_K");
}

// Reports constants that a law needs and that no law uses.
void check_constants(const deck::Part& lubricant, const std::string& viscosity, const std::string& density) {
  if (viscosity == "doolittle") demand(lubricant, doolittle, "viscosity = doolittle");
  if (viscosity == "yasutomi") demand(lubricant, yasutomi, "viscosity = yasutomi");
  const bool tait = density == "tait" || density == "murnaghan";
  if (tait) demand(lubricant, bulk_modulus, "density = " + density);
  const bool tabulated = viscosity == "table" || density == "table";
  if (tabulated) demand(lubricant, {"table"}, viscosity == "table" ? "viscosity = table" : "density = table");
  const std::string laws = "has no influence with viscosity = " + viscosity + " and density = " + density;
  if (!tait && viscosity != "doolittle")
    for (const Names& names : {bulk_modulus, bulk_modulus_of_T})
      lubricant.refuse(names, laws + ": remove it, or set density = tait or murnaghan", deck::Cause::idle);
  if (!tabulated)
    lubricant.refuse({"table"}, laws + ": remove it, or set viscosity = table or density = table", deck::Cause::idle);
  const double Tg0 = lubricant.number("Tg0");
  if (viscosity == "yasutomi" && lubricant.number("temperature") <= Tg0)
    lubricant.complain("temperature", "must be above the glass transition at ambient pressure, Tg0 = " +
                                          deck::shortest(Tg0) + " C: below it the oil is not a liquid");
}

void add_table(const deck::Part& lubricant, bool viscosity, bool density, Liquid& liquid) {
  const ReadTable read = read_fluid_table(deck::found_beside(lubricant.deck, lubricant.section, "table"), density);
  if (const auto* wrong = std::get_if<std::string>(&read)) {
    lubricant.complain("table", *wrong);
    return;
  }
  const FluidTable& table = std::get<FluidTable>(read);
  liquid.table_end = table.p.back();
  if (density) liquid.density = make_tabulated_density(table.p, table.rho, 1.0);
  if (!viscosity) return;
  liquid.viscosity = make_tabulated_viscosity(table.p, table.eta, 1.0);
  settle(lubricant, "eta0", deck::shortest(table.eta.front()), "the first row of the table");
}

YasutomiConstants read_yasutomi(const deck::Part& lubricant) {
  const auto number = [&](const char* name) { return lubricant.number(name); };
  return {.T = number("temperature"),
          .Tg0 = number("Tg0"),
          .A1 = number("A1"),
          .A2 = number("A2"),
          .b1 = number("b1"),
          .b2 = number("b2"),
          .C1 = number("C1"),
          .C2 = number("C2"),
          .eta_g = number("eta_g")};
}

}  // namespace

std::vector<Key> liquid_keys() {
  const deck::Range positive{0.0, 1e12, true, false};
  return deck::together(
      {{constant("K0", "Pa", {1e7, 1e12},
                 "Bulk modulus at ambient pressure and at the temperature of the contact. Required for density = tait "
                 "and murnaghan and for viscosity = doolittle.",
                 "1.192e9"),
        constant("K00", "Pa", {1e8, 1e14},
                 "Factor of the bulk modulus against temperature: K0 = K00 exp(-beta_K T), T in kelvin. K00, beta_K "
                 "and temperature replace K0.",
                 "8.658e9"),
        constant("beta_K", "1/K", {1e-5, 0.1},
                 "Decay of the bulk modulus with temperature, see K00. Required with K00.", "6.332e-3"),
        constant("K0_prime", "", {1.0, 50.0},
                 "Derivative K0' of the bulk modulus with respect to pressure. Required with K0.", "11.74")},
       deck::only_with(
           {.name = "viscosity", .words = {"doolittle"}},
           {constant("doolittle_B", "", {0.0, 1e3, true, false}, "Doolittle's factor B.", "4.71"),
            constant("doolittle_R0", "", {0.0, 1.0, true, true},
                     "Occupied volume R0 over the volume at ambient pressure, at the temperature of the contact.",
                     "0.6568")}),
       deck::only_with(
           {.name = "viscosity", .words = {"yasutomi"}},
           {constant("Tg0", "C", {-273.15, 1000.0, true, false},
                     "Glass transition temperature at ambient pressure, Tg = Tg0 + A1 ln(1 + A2 p).", "-83.2"),
            constant("A1", "K", positive, "Constant of the glass transition, Tg = Tg0 + A1 ln(1 + A2 p).", "188.95"),
            constant("A2", "1/Pa", {0.0, 1e-6, true, false},
                     "Constant of the glass transition, Tg = Tg0 + A1 ln(1 + A2 p).", "0.719e-9"),
            constant("b1", "1/Pa", {0.0, 1e-6}, "Constant of F = (1 + b1 p)^b2.", "8.2e-9"),
            constant("b2", "", {-10.0, 0.0}, "Constant of F = (1 + b1 p)^b2.", "-0.53"),
            constant("C1", "", {0.0, 100.0, true, false},
                     "First constant of the equation of Williams, Landel and Ferry.", "16.09"),
            constant("C2", "K", {0.0, 1e3, true, false},
                     "Second constant of the equation of Williams, Landel and Ferry.", "17.38"),
            constant("eta_g", "Pa s", {1e3, 1e15}, "Viscosity at the glass transition.", "1e12")}),
       {{.name = "table",
         .type = Type::text,
         .meaning = "CSV file with the columns p [Pa], rising from 0, eta [Pa s] and rho [kg/m^3]; a heading may give "
                    "another order and other units, such as p [MPa], eta [mPa s]. For viscosity = table, density = "
                    "table, or both. It needs at least 4 rows with eta and rho > 0 and rising, up to more than p_h. "
                    "The file is searched beside the deck and in the working folder.",
         .example = "oil.csv",
         .names = deck::Names::file}}});
}

Liquid read_liquid(const deck::Part& lubricant) {
  const std::string viscosity = lubricant.word("viscosity"), density = lubricant.word("density");
  const std::size_t complaints = lubricant.deck.errors.size();
  read_bulk_modulus(lubricant);
  // After an error there, a missing K0 would only add another one.
  if (lubricant.deck.errors.size() == complaints) check_constants(lubricant, viscosity, density);
  Liquid liquid;
  if (!lubricant.deck.errors.empty()) return liquid;

  constexpr double pascal = 1.0;
  const double K0 = lubricant.number("K0"), K0_prime = lubricant.number("K0_prime");
  if (density == "tait") liquid.density = make_tait(K0, K0_prime, pascal);
  if (density == "murnaghan") liquid.density = make_murnaghan(K0, K0_prime, pascal);
  if (viscosity == "doolittle")
    liquid.viscosity = make_doolittle(
        {lubricant.number("doolittle_B"), lubricant.number("doolittle_R0"), K0, K0_prime, lubricant.number("eta0")},
        pascal);
  if (viscosity == "yasutomi") {
    const YasutomiConstants constants = read_yasutomi(lubricant);
    liquid.viscosity = make_yasutomi(constants, pascal);
    settle(lubricant, "eta0", deck::shortest(yasutomi_eta0(constants)), "value of the law at ambient pressure");
  }
  if (viscosity == "table" || density == "table")
    add_table(lubricant, viscosity == "table", density == "table", liquid);
  if (liquid.viscosity && lubricant.deck.errors.empty())
    settle(lubricant, "alpha", deck::shortest(pressure_coefficients(*liquid.viscosity).alpha_star),
           "alpha* of the law, 1/alpha* = int eta0/eta dp");
  return liquid;
}

}  // namespace ehl::rheology
