// ehl asperities: asperity pressure and flow factors of a measured map.
#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "base/exit_status.hpp"
#include "base/progress.hpp"
#include "base/signals.hpp"
#include "base/text_format.hpp"
#include "case/map_file.hpp"
#include "commands/commands.hpp"
#include "core/constants.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "results/outputs.hpp"
#include "surface/gaussian_filter.hpp"
#include "tables/asperity_table.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

constexpr double steel_on_steel = 226.4e9;  // E' of E = 206 GPa, nu = 0.3 [Pa]
constexpr double same = 0.01;               // relative difference between file and option that counts as equal
constexpr int fewest_points = 16, most_points = 4096;

// The positive number of an option; NaN if it was not given.
double positive(const Arguments& arguments, const std::string& name) {
  if (!arguments.has(name)) return core::unknown;
  const std::string text = arguments.value(name, "");
  const deck::ReadNumber read = deck::read_number(text);
  if (read.status != deck::ReadNumber::Status::number || !(read.value > 0.0) || !std::isfinite(read.value))
    refuse("--" + name + " " + text + ": must be a number > 0, in SI units");
  return read.value;
}

// A length that the option gives or the file states [m]. errors: core::InputError if neither does, or if they differ.
double settled(const std::string& option, double given, double stated, const std::string& path) {
  const double length = std::isfinite(given) ? given : stated;
  if (!std::isfinite(length)) refuse("--" + option + " is missing: " + path + " does not state it; give it in metres");
  if (std::isfinite(given) && std::isfinite(stated) && std::abs(given / stated - 1.0) > same)
    refuse(fmt::format("--{} {:.6g}: {} states {:.6g} m: remove the option, or correct one of them", option, given,
                       path, stated));
  return length;
}

// Takes away the mean plane and the waves that the options name.
void condition(const Arguments& arguments, surface::Heights& z, AsperityRun& run) {
  surface::level(z);
  const double longest = positive(arguments, "longest_wave"), shortest = positive(arguments, "shortest_wave");
  if (longest <= shortest) refuse("--longest_wave must be longer than --shortest_wave: otherwise no wave is left");
  if (std::isfinite(longest)) {
    const surface::Heights longer = surface::long_waves(z, run.dx, run.dy, longest);
    for (std::size_t n = 0; n < z.values.size(); ++n) z.values[n] -= longer.values[n];
    run.filters = "waves longer than " + length(longest) + " taken away";
  }
  if (std::isfinite(shortest)) {
    z = surface::long_waves(z, run.dx, run.dy, shortest);
    run.filters +=
        std::string(run.filters.empty() ? "" : ", ") + "waves shorter than " + length(shortest) + " taken away";
  }
}

// Reads the map. out: its heights [m], positive outwards; names, points and distances in `run`.
surface::Heights heights_of(const Arguments& arguments, AsperityRun& run) {
  run.map = arguments.operands[0];
  const double dx = positive(arguments, "dx"), dy = positive(arguments, "dy"), unit = positive(arguments, "unit");
  ReadHeights read = read_heights(run.map, arguments.value("dataset", "height"), dx);
  if (const auto* wrong = std::get_if<std::string>(&read))
    throw core::FileError(wrong->starts_with(run.map) ? *wrong : run.map + ": " + *wrong);
  MapInFile& file = std::get<MapInFile>(read);
  run.filled = file.filled;
  run.nx = file.heights.nx;
  run.ny = file.heights.ny;
  run.dx = settled("dx", dx, file.dx_m, run.map);
  run.dy = std::isfinite(dy) || std::isfinite(file.dy_m) ? settled("dy", dy, file.dy_m, run.map) : run.dx;
  const double height = settled("unit", unit, file.unit_m, run.map);
  for (double& z : file.heights.values) z *= height;
  const double before = surface::rms(file.heights);
  condition(arguments, file.heights, run);
  if (!(surface::rms(file.heights) > 1e-12 * before))
    throw core::FileError(run.map + ": the map is flat: no heights are left after levelling");
  return std::move(file.heights);
}

asperities::MapParameters parameters_of(const Arguments& arguments) {
  asperities::MapParameters parameters;
  const double E_prime = positive(arguments, "E_prime"), hardness = positive(arguments, "hardness");
  parameters.E_prime = std::isfinite(E_prime) ? E_prime : steel_on_steel;
  parameters.hardness = std::isfinite(hardness) ? hardness : std::numeric_limits<double>::infinity();
  parameters.most_points = whole_number(arguments, "points", parameters.most_points, most_points, fewest_points);
  parameters.rows = whole_number(arguments, "rows", parameters.rows, 50, 4);
  parameters.threads = requested_threads(arguments);
  return parameters;
}

}  // namespace

int asperities(const Arguments& arguments) {
  const std::string path = table_name(arguments);
  const bool overwrite = arguments.has("overwrite");
  results::check_files({arguments.operands[0]}, {{path, results::FileKind::table, overwrite}});
  AsperityRun run;
  run.parameters = parameters_of(arguments);
  const surface::Heights heights = heights_of(arguments, run);
  Progress progress(arguments.has("quiet"));
  run.result = asperities::compute(heights, run.dx, run.dy, run.parameters,
                                   [&](double share, const std::string& step) { return progress.show(share, step); });
  progress.clear();
  write_table(path, asperity_csv(run), overwrite);
  const core::Warnings warnings = asperity_warnings(run);
  print(asperity_report(run) + warning_lines(warnings) + "table        " + path + "\n");
  for (const asperities::MapRow& row : run.result.rows)
    if (!row.converged) return not_converged;
  return solved;
}

}  // namespace ehl::program
