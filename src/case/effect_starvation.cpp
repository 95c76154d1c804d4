// The effect `starvation`: an inlet that lacks oil.
#include <fmt/core.h>

#include "base/json.hpp"
#include "case/effects.hpp"
#include "case/numbers/number.hpp"
#include "case/starvation_report.hpp"
#include "case/supply_input.hpp"
#include "effects/starvation/keys.hpp"

namespace ehl::program {
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

nlohmann::ordered_json json(const Case& input, const Computed& computed) {
  Json report;
  const steady::Solution& solution = computed.solution;
  const std::vector<results::Quantity> list = numbers::quantities("starvation", {input, computed});
  add(list, report);
  add_in_SI(list, si_scales(input.physics), report);
  if (solution.passes.empty()) return report;
  report["track"] = rows_json(pass_columns(input, solution), solution.passes);
  return report;
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
