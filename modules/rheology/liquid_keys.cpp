// The keys of [lubricant] that belong to single laws.
#include <cmath>

#include "deck/file.hpp"
#include "deck/record.hpp"
#include "rheology/fluid_table.hpp"
#include "rheology/keys.hpp"
#include "rheology/pressure_coefficient.hpp"
#include "rheology/temperature.hpp"

namespace ehl::rheology {
namespace {

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

deck::Records<YasutomiConstants> yasutomi_records() {
  using namespace deck::record;
  return deck::only_with<YasutomiConstants>(
      needs("viscosity", {"yasutomi"}),
      {key("Tg0", &YasutomiConstants::Tg0, unit("C"), Range{-273.15, 1000.0, true, false}, example("-83.2"),
           "Glass transition temperature at ambient pressure, Tg = Tg0 + A1 ln(1 + A2 p)."),
       key("A1", &YasutomiConstants::A1, unit("K"), up_to(1e12), example("188.95"),
           "Constant of the glass transition, Tg = Tg0 + A1 ln(1 + A2 p)."),
       key("A2", &YasutomiConstants::A2, unit("1/Pa"), up_to(1e-6), example("0.719e-9"),
           "Constant of the glass transition, Tg = Tg0 + A1 ln(1 + A2 p)."),
       key("b1", &YasutomiConstants::b1, unit("1/Pa"), Range{0.0, 1e-6}, example("8.2e-9"),
           "Constant of F = (1 + b1 p)^b2."),
       key("b2", &YasutomiConstants::b2, Range{-10.0, 0.0}, example("-0.53"), "Constant of F = (1 + b1 p)^b2."),
       key("C1", &YasutomiConstants::C1, up_to(100.0), example("16.09"),
           "First constant of the equation of Williams, Landel and Ferry."),
       key("C2", &YasutomiConstants::C2, unit("K"), up_to(1e3), example("17.38"),
           "Second constant of the equation of Williams, Landel and Ferry."),
       key("eta_g", &YasutomiConstants::eta_g, unit("Pa s"), Range{1e3, 1e15}, example("1e12"),
           "Viscosity at the glass transition.")});
}

YasutomiConstants read_yasutomi(const deck::Part& lubricant) {
  YasutomiConstants constants = deck::read(lubricant, yasutomi_records());
  constants.T = lubricant.number("temperature");
  return constants;
}

}  // namespace

std::vector<deck::Key> liquid_keys() {
  using namespace deck::record;
  return deck::together(
      {{key("K0", unit("Pa"), Range{1e7, 1e12}, example("1.192e9"),
            "Bulk modulus at ambient pressure and at the temperature of the contact. Required for density = tait "
            "and murnaghan and for viscosity = doolittle."),
        key("K00", unit("Pa"), Range{1e8, 1e14}, example("8.658e9"),
            "Factor of the bulk modulus against temperature: K0 = K00 exp(-beta_K T), T in kelvin. K00, beta_K "
            "and temperature replace K0."),
        key("beta_K", unit("1/K"), Range{1e-5, 0.1}, example("6.332e-3"),
            "Decay of the bulk modulus with temperature, see K00. Required with K00."),
        key("K0_prime", Range{1.0, 50.0}, example("11.74"),
            "Derivative K0' of the bulk modulus with respect to pressure. Required with K0.")},
       deck::only_with(
           {.name = "viscosity", .words = {"doolittle"}},
           {key("doolittle_B", up_to(1e3), example("4.71"), "Doolittle's factor B."),
            key("doolittle_R0", Range{0.0, 1.0, true, true}, example("0.6568"),
                "Occupied volume R0 over the volume at ambient pressure, at the temperature of the contact.")}),
       deck::keys_of("lubricant", yasutomi_records()),
       {key("table", example("oil.csv"), file,
            "CSV file with the columns p [Pa], rising from 0, eta [Pa s] and rho [kg/m^3]; a heading may give another "
            "order and other units, such as p [MPa], eta [mPa s]. For viscosity = table, density = table, or both. It "
            "needs at least 4 rows with eta and rho > 0 and rising, up to more than p_h. The file is searched beside "
            "the deck and in the working folder.")}});
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
