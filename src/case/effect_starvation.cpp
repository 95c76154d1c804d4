// Oil that is missing.
#include <fmt/core.h>

#include <cmath>

#include "base/json.hpp"
#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/supply_input.hpp"
#include "effects/starvation/keys.hpp"

namespace ehl::program {
namespace {

using steady::Starvation;

std::string what(const Case& input) {
  const double H_oil = input.scene.supply(0.0);
  const std::string own = fmt::format("H_oil = {:.4g}", H_oil);
  const std::string text =
      input.physics.si ? fmt::format("{:.4g} nm ({})", 1e9 * H_oil * input.physics.si->hertz.h_scale, own) : own;
  return given(input.deck, "supply", "profile") ? text + " at y = 0, a profile across the track" : text;
}

// The content on every level, and the flooded contact beside it.
Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  constexpr double fields = 4.0 / 3.0 + 2.0;
  return {.bytes = fields * sizeof(double) * grid.nodes_x() * grid.nodes_y(),
          .seconds = 2.0 * basic_needs(input.scene).seconds};
}

// Factors on the flooded central film: Chevalier 1998, by the supply; Hamrock and Dowson 1977, by the meniscus.
double by_supply(const Starvation& found) {
  constexpr double gamma = 3.0;
  const double r = found.supply_ratio;
  return r / std::pow(1.0 + std::pow(r, gamma), 1.0 / gamma);
}
double by_meniscus(const Starvation& found) {
  const double m = -found.meniscus_X;
  const double enough = 1.0 + 3.06 * std::pow(found.Hc_flooded, 0.58);
  return m >= enough ? 1.0 : m > 1.0 ? std::pow((m - 1.0) / (enough - 1.0), 0.29) : 0.0;
}

std::string summary(const Case& input, const Computed& computed) {
  const Starvation& found = *computed.solution.starvation;
  const bool circular = contact::circular(input.scene.shape);
  const char* mark = computed.solution.converged ? "" : "  (NOT CONVERGED)";
  const auto length = [&](double X) {
    return input.physics.si ? fmt::format("{:.1f} um ({:.3f} a)", 1e6 * X * input.physics.si->hertz.a, X)
                            : fmt::format("{:.3f} a", X);
  };
  std::string text =
      fmt::format("starvation   factor {:.4f} of the flooded film (Hc = {:.5f}) at a supply of {:.4f} of it{}\n",
                  found.factor, found.Hc_flooded, found.supply_ratio, mark);
  text += "             meniscus on y = 0 at x = " + length(found.meniscus_X) +
          fmt::format(", {} cells from the inlet boundary where it is nearest\n", found.cells_to_inlet);
  text += fmt::format("             oil in {:.5f}, through the contact {:.5f}, aside {:.2g}; imbalance {:.1e}\n",
                      found.in, found.through, found.aside, found.imbalance);
  text += fmt::format("             formulas: {:.4f} by the supply (Chevalier, gamma = 3)", by_supply(found));
  if (circular) text += fmt::format(", {:.4f} by the meniscus (Hamrock, Dowson 1977)", by_meniscus(found));
  return text + "\n";
}

std::vector<results::Quantity> quantities(const Starvation& found) {
  return {
      {"starvation_factor", found.factor, "-", "rho H at the centre over that of the flooded contact"},
      {"supply_ratio", found.supply_ratio, "-", "r: H_oil over rho H at the centre of the flooded contact"},
      {"Hc_flooded", found.Hc_flooded, "a^2/R", "film at (0,0) of the flooded contact on the same grid"},
      {"Hm_flooded", found.Hm_flooded, "a^2/R", "its smallest film"},
      {"meniscus_x", found.meniscus_X, "a", "where the inlet becomes full on y = 0", "meniscus_X"},
      {"meniscus_cells", static_cast<double>(found.cells_to_inlet), "-", "cells from the inlet to the first full node"},
      {"oil_in", found.in, "rho0 u_m a^3/R", "oil through the inlet boundary"},
      {"oil_through", found.through, "rho0 u_m a^3/R", "oil through the contact, |y| <= 1 at x = 0"},
      {"oil_aside", found.aside, "rho0 u_m a^3/R", "oil through the sides of the domain"},
      {"mass_imbalance", found.imbalance, "-", "(out + aside - in)/in"},
      {"factor_by_supply", by_supply(found), "-", "r/(1 + r^3)^(1/3)"},
      {"factor_by_meniscus", by_meniscus(found), "-", "Hamrock and Dowson 1977; of circles"}};
}

nlohmann::ordered_json json(const Case& input, const Computed& computed) {
  Json report;
  add(quantities(*computed.solution.starvation), report);
  add_in_SI(quantities(*computed.solution.starvation), si_scales(input.physics), report);
  return report;
}

void add_content(const Case&, const Computed& computed, results::Content& content) {
  content.fields.push_back(
      {"theta", "-", "content: share of the gap that the oil fills, Q/(rho H)", &computed.solution.theta});
  for (results::Quantity& one : quantities(*computed.solution.starvation)) content.summary.push_back(std::move(one));
}

}  // namespace

Effect starvation_effect() {
  return {.name = "starvation",
          .meaning = "Oil that is missing at the inlet: what the surfaces bring, and a cavitation that conserves mass.",
          .stage = Stage::unknowns,
          .without = "fully flooded",
          .sections = {{.name = "supply",
                        .called_by = {"H_oil", "layer_m", "layer1_m", "layer2_m", "flow_m3_per_s", "profile"}}},
          .keys = starvation::keys,
          .read = supply_input,
          .on = [](const Case& input) { return static_cast<bool>(input.scene.supply); },
          .what = what,
          .expense = expense,
          .asymmetry = [](const Case& input) -> std::string {
            const bool profile = given(input.deck, "supply", "profile");
            return profile && !input.scene.use_symmetry ? "the profile of the supply" : "";
          },
          .summary = summary,
          .json = json,
          .add_content = add_content,
          .seconds = nullptr,
          .example = {"supply.H_oil=0.2"}};
}

}  // namespace ehl::program
