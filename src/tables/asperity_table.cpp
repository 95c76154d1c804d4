#include "tables/asperity_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/text_format.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

using asperities::MapColumn;
using asperities::MapRow;

/// Difference of the gap on half of the points, in Sq, from which on it is worth a warning; of a flow factor likewise.
constexpr double much_in_gap = 0.1, much_in_factor = 0.05;
constexpr double oblique_lay = 0.3, fewest_lengths = 10.0, skewed = 0.5;

std::string map_text(const AsperityRun& run) {
  const asperities::Cell& cell = run.result.cell;
  std::string text = fmt::format("{}: {} x {} points, {} x {}", run.map, run.nx, run.ny, length((run.nx - 1) * run.dx),
                                 length((run.ny - 1) * run.dy));
  if (run.filled > 0) text += fmt::format(", {} missing points filled from their neighbours", run.filled);
  text += "; levelled" + (run.filters.empty() ? "" : ", " + run.filters);
  if (run.result.block > 1)
    text += fmt::format(", means of {0} x {0} points (Sq {1} before)", run.result.block, length(run.result.Sq_map));
  return text + fmt::format(", mirrored at its edges; {} x {} points computed", cell.nx, cell.ny);
}

std::string bodies_text(const AsperityRun& run) {
  const double hardness = run.parameters.hardness;
  return "E' = " + pressure(run.parameters.E_prime) +
         (std::isfinite(hardness) ? ", hardness " + pressure(hardness) : ", elastic");
}

bool all_known(const AsperityRun& run, const MapColumn& column) {
  return std::ranges::all_of(run.result.rows, [&](const MapRow& row) { return std::isfinite(column.of(row)); });
}

}  // namespace

std::string asperity_csv(const AsperityRun& run) {
  const asperities::RoughnessNumbers& z = run.result.roughness;
  std::string text =
      std::string(asperity_mark) + "\n# program: " + this_program() + "\n# map: " + map_text(run) +
      "\n# bodies: " + bodies_text(run) + "\n# Sq: " + csv_cell(z.Sq) + "\n# slope: " + csv_cell(z.slope) +
      "\n# gamma: " + csv_cell(z.peklenik) +
      "\n# gap: distance of the mean planes of the deformed surfaces; film: mean open gap; pressure: mean; "
      "area: share in contact; phi: flow over that of a smooth gap\n# error: difference from half of the "
      "points; pressure_gw: Greenwood and Williamson; phi_x_pc: Patir and Cheng\n";
  for (const MapRow& row : run.result.rows)
    if (!row.converged) text += "# NOT CONVERGED: the contact at " + pressure(row.pressure) + "\n";
  std::vector<MapColumn> columns;
  for (const MapColumn& column : asperities::map_columns())
    if (all_known(run, column)) columns.push_back(column);
  std::string line;
  for (const MapColumn& column : columns)
    line += (line.empty() ? "" : ",") + fmt::format("{} [{}]", column.name, column.unit);
  text += line + "\n";
  for (const MapRow& row : run.result.rows) {
    line.clear();
    for (const MapColumn& column : columns) line += (line.empty() ? "" : ",") + fmt::format("{:.8g}", column.of(row));
    text += line + "\n";
  }
  return text;
}

std::string asperity_report(const AsperityRun& run) {
  const asperities::RoughnessNumbers& z = run.result.roughness;
  std::string text = "map          " + map_text(run) + "\n";
  text += fmt::format(
      "roughness    Sq {}, slope {:.4g}, correlation length {} along x, {} along y, gamma {}, skewness {:.3f}, "
      ""
      "kurtosis {:.3f}\n",
      length(z.Sq), z.slope, std::isfinite(z.correlation_x) ? length(z.correlation_x) : "-",
      std::isfinite(z.correlation_y) ? length(z.correlation_y) : "-", known("{:.3g}", z.peklenik), z.skewness,
      z.kurtosis);
  text += fmt::format(
      "summits      eta beta sigma {:.4f}, sigma/beta {:.3g}, sigma {}, mean {} above the mean plane (spectral "
      "moments)\n",
      z.eta_beta_sigma, z.sigma_over_beta, length(z.summit_sigma), length(z.summit_height));
  text += "bodies       " + bodies_text(run) + "\n\n";
  text += fmt::format("{:>9} {:>7} {:>11} {:>11} {:>9} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "gap", "gap/Sq",
                      "pressure", "Gr.-Will.", "contact", "phi_x", "phi_y", "Patir x", "Patir y", "err gap", "err phi");
  for (const MapRow& row : run.result.rows) {
    text +=
        fmt::format("{:>9} {:>7.3f} {:>11} {:>11} {:>9} {:>8.4f} {:>8.4f} {:>8} {:>8} {:>8} {:>8}{}\n", length(row.gap),
                    row.gap / z.Sq, row.pressure > 0.0 ? pressure(row.pressure) : "0",
                    row.pressure > 0.0 && std::isfinite(row.pressure_gw) ? pressure(row.pressure_gw) : "-",
                    row.pressure > 0.0 ? percent(row.area) : "0", row.phi_x, row.phi_y, known("{:.4f}", row.phi_x_pc),
                    known("{:.4f}", row.phi_y_pc), known("{:.3f}", row.error_gap / z.Sq),
                    known("{:.4f}", std::max(row.error_phi_x, row.error_phi_y)), convergence_mark(row.converged));
  }
  return text + "(err: difference from half of the points, of the gap over Sq)\n";
}

core::Warnings asperity_warnings(const AsperityRun& run) {
  const asperities::RoughnessNumbers& z = run.result.roughness;
  const asperities::Cell& cell = run.result.cell;
  core::Warnings warnings;
  double gap = 0.0, factor = 0.0;
  for (const MapRow& row : run.result.rows) {
    gap = std::max(gap, std::isfinite(row.error_gap) ? row.error_gap / z.Sq : 0.0);
    for (const double error : {row.error_phi_x, row.error_phi_y})
      factor = std::max(factor, std::isfinite(error) ? error : 0.0);
  }
  if (gap > much_in_gap || factor > much_in_factor)
    warnings.push_back(
        {"points", fmt::format("the shortest waves have few points: with half of them the gap differs by up "
                               "to {:.2f} Sq and a flow factor by up to {:.3f}; a finer map, or a larger "
                               "--points, is needed",
                               gap, factor)});
  // A lay along one axis may have no end there.
  const double x = cell.length_x() / z.correlation_x, y = cell.length_y() / z.correlation_y;
  const bool few_x = x < fewest_lengths, few_y = y < fewest_lengths;
  if (few_x || few_y || !(std::isfinite(x) || std::isfinite(y)))
    warnings.push_back({"longest_wave",
                        "the longest waves are as long as the map, so it is no fair sample of them: "
                        "measure a larger area, or take long waves away with --longest_wave"});
  if (std::abs(z.oblique) > oblique_lay)
    warnings.push_back({"lay",
                        "the lay is at an angle to the axes of the map, and becomes a lay at both angles when the map "
                        "is mirrored: turn the map"});
  if (std::abs(z.skewness) > skewed)
    warnings.push_back(
        {"heights", fmt::format("the heights are not Gaussian (skewness {:.2f}): the formulas beside do not "
                                "hold for this map, the computed columns do",
                                z.skewness)});
  if (std::ranges::any_of(run.result.rows, [](const MapRow& row) { return !row.converged; }))
    warnings.push_back({"contact", "contacts did not converge: see the marked rows"});
  return warnings;
}

}  // namespace ehl::program
