#include "rheology/keys.hpp"

#include <fmt/format.h>

#include <cmath>

#include "deck/record.hpp"

namespace ehl::rheology {
namespace {

deck::Records<Oil> law_records() {
  using namespace deck::record;
  return {
      key("viscosity", &Oil::viscosity, by_default("roelands"),
          words({"isoviscous", "barus", "roelands", "doolittle", "yasutomi", "table"}),
          "Viscosity law eta/eta0. isoviscous: 1. barus: exp(alpha p). roelands: exp{(alpha p0/z)[(1 + p/p0)^z - 1]}. "
          "doolittle: exp{B R0 [1/(v - R0) - 1/(1 - R0)]} with Tait's volume v. yasutomi: 10^{-C1 x/(C2 + x)} "
          "eta_g/eta0 with x = (T - Tg) F. table: from a file.",
          source("Roelands 1966, as in Venner and ten Napel 1992; Doolittle 1951; Yasutomi, Bair and Winer 1984, Bair "
                 "et al. 2013")),
      key("eta0", &Oil::eta0, unit("Pa s"), up_to(1e6), example("0.25"),
          "Viscosity at ambient pressure. Required for a contact in SI and with viscosity = doolittle. It follows from "
          "yasutomi, from table, and from kv40 and kv100."),
      key("alpha", unit("1/Pa"), Range{1e-12, 1e-6}, example("1.7e-8"), active,
          "Pressure coefficient of the viscosity: the slope of ln eta at ambient pressure; or give alpha_star. "
          "Required for roelands, and for barus in SI. In a dimensionless contact it determines the Hertz pressure, "
          "p_h = alpha_bar/alpha. doolittle, yasutomi and table have their own alpha*, 1/alpha* = int eta0/eta dp.",
          remedy("mineral oils have 1e-8 to 3e-8"), source("1.7e-8: Venner and ten Napel 1992")),
      key("z", Range{least_z, most_z}, needs("viscosity", {"roelands"}), example("0.6"),
          otherwise(
              "alpha p0/(ln eta0 + 9.67) if eta0 is given, else 0.68; with alpha_star: chosen so that alpha* is met"),
          "Exponent z of Roelands' law.", remedy("mineral oils have 0.5 to 0.7"),
          source("Roelands 1966: alpha p0/z = ln eta0 + 9.67")),
      key("p0", &Oil::p0, unit("Pa"), Range{1e6, 1e10}, by_default("1.96e8"), needs("viscosity", {"roelands"}),
          "Reference pressure p0 of Roelands' law.", source("Roelands 1966")),
      key("density", &Oil::density, by_default("dowson-higginson"),
          words({"incompressible", "dowson-higginson", "tait", "murnaghan", "table"}),
          "Density law rho/rho0. incompressible: 1. dowson-higginson: (5.9e8 + 1.34 p)/(5.9e8 + p), p in Pa. tait: "
          "1/v, v = 1 - ln[1 + (1 + K0') p/K0]/(1 + K0'). murnaghan: (1 + K0' p/K0)^(1/K0'). table: from a file.",
          source("Dowson and Higginson 1966; Tait, Murnaghan 1944")),
  };
}

// Roelands' z as given; else computed from eta0 and recorded in the deck.
double read_z(const deck::Part& lubricant, const Oil& oil) {
  if (lubricant.given("z")) return lubricant.number("z");
  if (std::isnan(oil.eta0)) {
    lubricant.choose("z", usual_z, "typical of mineral oils; with eta0 it would be computed");
    return usual_z;
  }
  // alpha p0/z = ln eta0 + 9.67 (Roelands): the lines of all oils meet at one point of the (p, ln eta) plane.
  const double z = oil.alpha * oil.p0 / roelands_log_ratio(oil.eta0);
  const deck::Key& key = lubricant.key("z");
  if (!key.range.contains(z))
    lubricant.complain(
        "eta0",
        fmt::format("with alpha and p0 it means z = alpha p0/(ln eta0 + 9.67) = {:.4g}, which must be {}: {}check eta0 "
                    "[Pa s] and alpha [1/Pa]",
                    z, deck::allowed(key),
                    z < key.range.lower ? "the viscosity of this liquid rises too little with pressure for Roelands' "
                                          "law, as that of water does: set viscosity = barus without z, or "
                                        : "give z, or "));
  lubricant.follow("z", z, "from eta0");
  return z;
}

}  // namespace

std::vector<deck::Key> keys() {
  return deck::together({deck::keys_of("lubricant", law_records()),
                         deck::in_section("lubricant", deck::together({std::vector<deck::Key>{fluid_key()},
                                                                       data_sheet_keys(), liquid_keys()}))});
}

Oil read(deck::Deck& deck) {
  const deck::Part lubricant{deck, "lubricant"};
  Oil oil;
  choose_fluid(lubricant);
  oil.ambient = read_ambient(lubricant);
  oil.liquid = read_liquid(lubricant);
  deck::read(lubricant, law_records(), oil);
  oil.alpha = oil.roelands_alpha = lubricant.number("alpha");
  const bool by_name = lubricant.given("fluid");
  const bool own_eta0 = oil.viscosity == "yasutomi" || oil.viscosity == "table";
  // Also if given incompletely or wrongly, which has been reported already.
  oil.brings_eta0 = by_name || own_eta0 || !lubricant.given_of({"kv40", "kv100", "density15"}).empty();
  oil.brings_alpha = by_name || own_eta0 || oil.viscosity == "doolittle" || lubricant.given("alpha_star");
  read_alpha_star(lubricant, oil);
  // After refused numbers, a z computed from them would only add another error.
  if (oil.viscosity == "roelands" && std::isfinite(oil.alpha) && std::isnan(oil.z) && deck.errors.empty())
    oil.z = read_z(lubricant, oil);
  return oil;
}

}  // namespace ehl::rheology
