// The effect `starvation`: an inlet that lacks oil.
#include <fmt/core.h>

#include "base/json.hpp"
#include "case/effects.hpp"
#include "case/numbers/records.hpp"
#include "case/starvation_report.hpp"
#include "case/supply_input.hpp"
#include "effects/starvation/formulas.hpp"
#include "effects/starvation/keys.hpp"

namespace ehl::program {
namespace numbers {
namespace {

const steady::Starvation& starved(Of s) { return *solution(s).starvation; }
const Unit flow{"rho0 u_m a^3/R", "rho0 u_m a^2/R"};

std::string meaning_of_through(Of s) {
  return of_line(s) ? "oil through the contact" : "oil through the contact, |y| <= 1 at x = 0";
}
std::string meaning_of_factor(Of s) {
  return of_line(s) ? "the lesser of r and 1: nothing flows aside" : "r/(1 + r^3)^(1/3)";
}
bool has_passes(Of s) { return !solution(s).passes.empty(); }

Group starvation_numbers() {
  Group group{.name = "starvation"};
  group.on = [](Of s) { return solution(s).starvation.has_value(); };
  group.asked = [](const deck::Deck& deck) { return deck::called_for(deck, "supply"); };
  const auto of = [](double steady::Starvation::*part) { return [part](Of s) { return starved(s).*part; }; };
  using X = steady::Starvation;
  group.numbers = {
      number(id::starvation_factor, "-", "rho H at the centre over that of the flooded contact",
             label("starvation factor"), column(601), on_page(16, "", "film over the flooded one"),
             sweep_page(OfSweep::as_curve), of(&X::factor)),
      number(id::supply_ratio, "-", "r: what is brought on y = 0 over rho H at the centre of the flooded contact",
             column(602), of(&X::supply_ratio)),
      number("Hc_flooded", "a^2/R", "film at (0,0) of the flooded contact on the same grid", column(603),
             of(&X::Hc_flooded)),
      number("Hm_flooded", "a^2/R", "its minimum film", of(&X::Hm_flooded)),
      number(id::meniscus_x, "a", "where the inlet becomes full on y = 0", json("meniscus_X"), column(604),
             of(&X::meniscus_X)),
      number("meniscus_cells", "-", "cells from the inlet to the first full node",
             [](Of s) { return starved(s).cells_to_inlet; }),
      number(id::oil_in, flow, "oil through the inlet boundary", of(&X::in)),
      number("oil_through", flow, "oil through the contact", meaning_here(meaning_of_through), of(&X::through)),
      number("oil_around", flow, "oil that leaves by the outlet and has passed beside the contact",
             [](Of s) { return starved(s).around(); }),
      number(id::oil_aside, flow, "oil through the sides of the domain", of(&X::aside)),
      number(id::mass_imbalance, "-", "(out + aside - in)/in", label("imbalance of oil"), column(606), on_page(17),
             of(&X::imbalance)),
      number("gamma", "-", "exponent for which r/(1 + r^gamma)^(1/gamma) is the factor", column(605),
             [](Of s) {
               return of_line(s) ? core::unknown : starvation::gamma_of(starved(s).supply_ratio, starved(s).factor);
             }),
      number("factor_by_supply", "-", "of the supply alone", meaning_here(meaning_of_factor),
             [](Of s) { return factor_by_supply(s.input, starved(s)); }),
      number("factor_by_meniscus", "-", "Hamrock and Dowson 1977; of circles",
             [](Of s) { return factor_by_meniscus(s.input, starved(s)); }),
      number("flooded_inlet", "a", "inlet of a flooded film by the same",
             [](Of s) { return of_line(s) ? core::unknown : starvation::flooded_inlet(starved(s).Hc_flooded); }),
      number("passes", "-", "number of passes; the numbers are those of the last", only_if(has_passes),
             [](Of s) { return solution(s).passes.back().number; })};
  return group;
}

}  // namespace
}  // namespace numbers

namespace {

std::string what(const Case& input) {
  const double H_oil = input.scene.supply(0.0);
  const std::string own = fmt::format("H_oil = {:.4g}", H_oil);
  const std::string text =
      input.physics.si ? fmt::format("{:.4g} nm ({})", 1e9 * H_oil * input.physics.si->hertz.h_scale, own) : own;
  const std::string where = given(input.deck, "supply", "profile") ? " at y = 0, a profile across the track" : "";
  const int passes = input.scene.passes.number;
  return text + where + (passes > 1 ? fmt::format(", {} passes", passes) : "");
}

// The cost: the oil content on every level, the flooded contact for comparison, and one steady contact per pass.
Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  constexpr double fields = 4.0 / 3.0 + 2.0;
  return {.bytes = fields * sizeof(double) * grid.nodes_x() * grid.nodes_y(),
          .seconds = (1.0 + input.scene.passes.number) * basic_needs(input.scene).seconds};
}

void json(const Case& input, const Computed& computed, Json& report) {
  const steady::Solution& solution = computed.solution;
  if (!solution.passes.empty()) report["track"] = rows_json(pass_columns(input, solution), solution.passes);
}

void add_content(const Case& input, const Computed& computed, results::Content& content) {
  const steady::Solution& solution = computed.solution;
  content.fields.push_back(
      {"theta", "-", "oil content: share of the gap that the oil fills, Q/(rho H)", &solution.theta});
  numbers::append("starvation", {input, computed}, content.summary);
  if (solution.passes.empty()) return;
  content.tables.push_back(
      table_of("passes", "successive contacts on the track", pass_columns(input, solution), solution.passes));
  content.tables.push_back(table_of_tracks(solution));
}

}  // namespace

Effect starvation_effect() {
  return {.name = "starvation",
          .meaning = "Starved lubrication: the surfaces bring a limited amount of oil, and cavitation conserves mass.",
          .without = "fully flooded",
          .sections = {{.name = "supply", .called_by = starvation::supply_keys()}},
          .keys = starvation::keys,
          .numbers = numbers::starvation_numbers,
          .stages = {.scene = supply_input},
          .on = [](const Case& input) { return static_cast<bool>(input.scene.supply); },
          .what = what,
          .expense = expense,
          .asymmetry = [](const Case& input) -> std::string {
            const bool profile = given(input.deck, "supply", "profile");
            return profile && !input.scene.use_symmetry ? "the profile of the supply is not symmetric" : "";
          },
          .summary = starvation_summary,
          .json = json,
          .add_content = add_content,
          .seconds = [](const Computed& computed) { return computed.solution.starvation->seconds; },
          .example = {"supply.H_oil=0.2"}};
}

}  // namespace ehl::program
