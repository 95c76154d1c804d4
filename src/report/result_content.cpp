#include "report/result_content.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/machine.hpp"
#include "base/version.hpp"
#include "case/numbers/number.hpp"
#include "core/processor_level.hpp"
#include "deck/text.hpp"
#include "deck/write.hpp"
#include "report/course_columns.hpp"
#include "surface/resample.hpp"

namespace ehl::program {
namespace {

using results::Quantity;

bool wanted(const Case& input, const std::string& field) {
  return std::find(input.fields.begin(), input.fields.end(), field) != input.fields.end();
}

// A field that follows from the pressure.
struct PressureField {
  const char* name;
  const char* unit;
  const char* meaning;
  core::Field DerivedFields::*field;
  void (*of)(const Case& input, std::span<const double> P, std::span<double> values);
};
constexpr PressureField pressure_fields[] = {
    {"rho_bar", "rho0", "density rho/rho0", &DerivedFields::rho_bar,
     [](const Case& input, auto P, auto values) { rheology::density(input.scene.density, P, values); }},
    {"ln_eta_bar", "-", "ln(eta/eta0)", &DerivedFields::ln_eta_bar,
     [](const Case& input, auto P, auto values) { rheology::log_viscosity(input.scene.viscosity, P, values); }}};

// If an accuracy was asked for, the deck of the result records the grid that was found for it, so that a new run of
// this deck reproduces the solution.
deck::Deck with_grid_of(const steady::Solution& solution, deck::Deck deck) {
  if (std::isnan(solution.accuracy.asked)) return deck;
  const std::string why = "chosen for the accuracy";
  deck::Part{deck, "grid"}.follow("cells", solution.grid.nx, why);
  const deck::Part domain{deck, "domain"};
  domain.follow("x_inlet", solution.grid.X_a, why);
  domain.follow("x_outlet", solution.grid.X_b, why);
  if (!solution.grid.line) domain.follow("y_half", solution.grid.Y_b, why);
  return deck;
}

// The resolution of each measured height map on the mesh.
void add_resolution(const Case& input, const core::Grid& grid, std::vector<Quantity>& list) {
  for (const CarriedSurface* one : carried(input.surfaces)) {
    const auto* map = std::get_if<surface::HeightMap>(&one->relief);
    if (!map) continue;
    const surface::Resolution left = surface::resolution(*map, grid);
    list.push_back({one->section + "_missing_points", static_cast<double>(one->map->filled), "-",
                    "points of the map that were filled from their neighbours"});
    list.push_back({one->section + "_variance_lost", left.variance_lost, "-",
                    "share of the variance of the map that the mesh does not resolve"});
    list.push_back(
        {one->section + "_shortest_wave_x", left.shortest_wave_X, "a", "shortest wave that the mesh resolves along x"});
    list.push_back(
        {one->section + "_shortest_wave_y", left.shortest_wave_Y, "a", "shortest wave that the mesh resolves along y"});
  }
}

// Program, version, machine and date.
std::vector<Quantity> provenance(const Case& input) {
  const Version built = version();
  const std::string folder = input.deck.folders.empty() ? "" : input.deck.folders.front();
  std::vector<std::string> files;
  for (const deck::NamedFile& file : input.files) files.push_back(deck::fingerprint(file));
  std::vector<Quantity> list{
      {"program", "ehl", "", "program that wrote the file"},
      {"version", built.number, "", "its version"},
      {"commit", built.commit, "", "commit of its source"},
      {"dirty", built.dirty ? "true" : "false", "", "whether the source had changes that are in no commit"},
      {"compiler", built.compiler, "", ""},
      {"host_cpu", processor(), "", "processor of the machine"},
      {"cpu_level", core::processor_level(), "", "processor level for which the numerics in use were compiled"},
      {"threads", std::to_string(input.scene.threads), "", "threads used"},
      {"deck_folder", folder, "", "folder of the deck, in which the files that it names are searched"},
      {"date", utc_date(), "", "UTC date of the run"}};
  if (!files.empty())
    list.push_back(
        {"files", deck::joined(files, "\n"), "", "files that the deck names: name, size and hash, one per line"});
  return list;
}

}  // namespace

results::Content content_of(const Case& input, const Computed& computed, std::vector<Quantity> numbers) {
  const steady::Solution& solution = computed.solution;
  results::Content content;
  content.title = input.title;
  content.deck = deck::effective_deck(with_grid_of(solution, input.deck));
  content.provenance = provenance(input);
  content.grid = solution.grid;
  if (const std::optional<SiScales> si = si_scales(input.physics)) content.si = plain_units(*si);
  content.summary = std::move(numbers);
  content.summary.push_back(numbers::given(id::warnings, deck::joined(with_names(computed.outcome.warnings), "\n")));
  for (const std::string& line : surface_lines(input.surfaces, input.physics, solution.grid))
    content.summary.push_back(
        {line.substr(0, line.find(':')), line.substr(line.find(':') + 2), "", "shape on this surface"});
  add_resolution(input, solution.grid, content.summary);
  return content;
}

DerivedFields derived_fields(const Case& input, const steady::Solution& solution) {
  DerivedFields derived;
  if (input.scene.surface) {
    derived.S = core::Field(solution.grid);
    input.scene.surface(solution.grid, derived.S);
  }
  const core::Field& P = steady::fluid_pressure(solution);
  for (const PressureField& one : pressure_fields) {
    if (!wanted(input, one.name)) continue;
    core::Field& field = derived.*one.field = core::Field(solution.grid);
    for (int i = 0; i < solution.grid.nodes_x(); ++i) one.of(input, P.station(i), field.station(i));
  }
  return derived;
}

results::Content result_content(const Case& input, const Computed& computed) {
  const steady::Solution& solution = computed.solution;
  const DerivedFields& derived = computed.derived;
  const numbers::Solved solved{input, computed};
  std::vector<Quantity> list;
  for (const char* group : {"film", "course", "roughness", "verification"}) numbers::append(group, solved, list);
  results::Content content = content_of(input, computed, std::move(list));
  content.scales = numbers::scale_quantities(input);
  std::vector<results::NamedField> fields{{"P", "p_h", "pressure p/p_h", &solution.P},
                                          {"H", "a^2/R", "film thickness h R/a^2", &solution.H}};
  for (const PressureField& one : pressure_fields)
    fields.push_back({one.name, one.unit, one.meaning, &(derived.*one.field)});
  if (const auto& errors = solution.adjoint; errors && errors->map_Hc.nodes_x() > 0) {
    const char* meaning = "contribution per area to its relative discretization error";
    for (const auto& [name, map] :
         {std::pair(id::error_map_Hc, &errors->map_Hc), std::pair(id::error_map_Hm, &errors->map_Hm)})
      if (wanted(input, name)) content.fields.push_back({name, "1/a^2", meaning, map});
  }
  for (const results::NamedField& field : fields)
    if (wanted(input, field.name)) content.fields.push_back(field);
  if (input.scene.surface)
    content.fields.push_back(
        {"S", "a^2/R", "height that the surfaces at rest add to the gap, averaged over cells", &derived.S});
  content.tables = {
      table_of("levels", "full multigrid, level by level: accuracy against time", level_columns(), solution.levels),
      table_of("history", "every cycle on every level", cycle_columns(), solution.history)};
  if (!solution.continuation.empty())
    content.tables.push_back(table_of("continuation", "load continuation: every load that was solved for",
                                      continuation_columns(), solution.continuation));
  return content;
}

}  // namespace ehl::program
