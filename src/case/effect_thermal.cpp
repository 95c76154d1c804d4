// The effect `thermal`: heat in the film and in the bodies.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/json.hpp"
#include "base/text_format.hpp"
#include "case/coupled_film.hpp"
#include "case/effects.hpp"
#include "case/numbers/number.hpp"
#include "case/thermal_report.hpp"
#include "deck/text.hpp"
#include "rheology/thermal_keys.hpp"
#include "thermal/keys.hpp"

namespace ehl::program {
namespace {

void read(Case& input) {
  const double limit = input.friction ? input.friction->limit : std::numeric_limits<double>::infinity();
  input.heat = thermal_input(input.deck, input.physics, input.scene, limit);
  if (input.heat) input.heat->setup.flow_thinning = input.flow_thinning;
}

FilmSolver film(const Case&) {
  return [](const Case& input, const steady::ProgressCallback& progress, Computed& computed) {
    computed.heat = solve_coupled(input, input.heat->setup, progress, computed.solution);
  };
}

std::string name_of_solid(const Case& input, const char* key) {
  const std::string word = deck::word(input.deck, "thermal", key);
  return word.empty() ? "own constants" : word;
}

std::string what(const Case& input) {
  const HeatInput& heat = *input.heat;
  const auto number = [&](const char* key) { return deck::number(input.deck, "thermal", key); };
  return fmt::format(
      "oil at {:.4g} C, bodies at {:.4g} and {:.4g} C ({} and {}), beta = {:.4g} 1/K, k = {:.4g} W/(m K); "
      "{} nodes across the film",
      number("T_oil"), number("T_body1"), number("T_body2"), name_of_solid(input, "solid1"),
      name_of_solid(input, "solid2"), heat.beta, heat.k, heat.setup.intervals + 1);
}

// The cost: columns of temperatures and heat flows, other fields, and the iterations between the film and the heat.
Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  constexpr double in_a_batch = 8.0;  // a line contact holds one batch of columns
  const double nodes = grid.nodes_x() * (grid.line ? in_a_batch : 0.5 * grid.nodes_y());
  constexpr double columns = 4.0, fields = 40.0;
  const double times_isothermal = grid.line ? 13.0 : 5.0;
  return {.bytes = nodes * sizeof(double) * (columns * (input.heat->setup.intervals + 1) + fields),
          .seconds = times_isothermal * basic_needs(input.scene).seconds};
}

bool kept(const Case& input, const char* field) {
  return std::ranges::find(input.heat->fields, field) != input.heat->fields.end();
}

void add_section(const Case& input, const heat::Fields& fields, results::Section& section) {
  section.group = "/thermal_section";
  section.meaning = "the section along x at y = 0: rows z over h, columns x";
  const int n = input.heat->setup.intervals;
  section.across = {"z", "-", "height over the film thickness, from surface 2", false, {}};
  for (int k = 0; k <= n; ++k) section.across.values.push_back(static_cast<double>(k) / n);
  section.fields = {{"T", "K", "temperature above T_oil", &fields.section_T},
                    {"u", "u_m", "speed along x", &fields.section_u}};
}

void add_content(const Case& input, const Computed& computed, results::Content& content) {
  if (!computed.heat) return;
  const heat::Fields& fields = computed.heat->found.fields;
  const struct {
    const char* name;
    const char* meaning;
    const core::Field* field;
  } all[] = {{"T_mid", "middle of the film", &fields.mid},
             {"T_max", "largest temperature across the film", &fields.largest},
             {"T1", "surface 1", &fields.surface_1},
             {"T2", "surface 2", &fields.surface_2}};
  for (const auto& one : all)
    if (kept(input, one.name))
      content.fields.push_back({one.name, "K", std::string("temperature above T_oil: ") + one.meaning, one.field});
  // Without mu and its error if [friction] has added them.
  numbers::append("thermal", {input, computed}, content.summary);
  if (kept(input, "section")) add_section(input, fields, content.section);
  content.tables.push_back(table_of("thermal_levels", "solutions with heat, grid by grid", thermal_columns(*input.heat),
                                    computed.heat->found.rows));
}

Json json(const Case& input, const Computed& computed) {
  if (!computed.heat) return nullptr;
  Json report;
  add(numbers::quantities("thermal", {input, computed}), report);
  report["levels"] = rows_json(thermal_columns(*input.heat), computed.heat->found.rows);
  report["seconds"] = computed.heat->found.seconds;
  return report;
}

core::Warnings warnings(const Case& input, const Computed& computed) {
  return computed.heat ? thermal_warnings(input, *computed.heat) : core::Warnings{};
}

}  // namespace

Effect thermal_effect() {
  return {.name = "thermal",
          .meaning = "Heat in the film and in the bodies, and its effect on the film.",
          .without = "isothermal",
          .sections = {{.name = "thermal", .called_by = {"T_oil", "solid1", "solid2"}}},
          .costly = {"thermal", "nodes"},
          .keys =
              [] {
                return deck::together({rheology::warm_oil_keys(), thermal::keys()});
              },
          .read = read,
          .stages = {.scene = observe_friction, .film = film},
          .on = [](const Case& input) { return input.heat.has_value(); },
          .what = what,
          .expense = expense,
          .summary = thermal_summary,
          .json = json,
          .warnings = warnings,
          .add_content = add_content,
          .seconds = [](const Computed& computed) { return computed.heat ? computed.heat->found.seconds : NAN; },
          .example = {"-contact.M", "-contact.L", "contact.load=30", "contact.radius_x=9.525e-3",
                      "contact.E_prime=226e9", "motion.u_m=2", "lubricant.eta0=0.04", "thermal.T_oil=40",
                      "thermal.beta=0.042", "thermal.solid1=steel", "thermal.solid2=steel"}};
}

}  // namespace ehl::program
