// What a climb writes down and tells while it goes on.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/errors.hpp"
#include "steady/climb.hpp"
#include "steady/error_estimate.hpp"

namespace ehl::steady {
namespace {

ErrorEstimate error_of(const Climb& climb, double LevelRow::*value) {
  std::vector<double> values;
  for (const LevelRow& row : climb.solution.levels) values.push_back(row.*value);
  if (climb.scene.wedge == reynolds::Wedge::upstream2) return estimate_error(values, 2.0);
  const LevelRow& last = climb.solution.levels.back();
  const double h = (climb.scene.grid.X_b - climb.scene.grid.X_a) / last.nx;
  return estimate_error(values, 1.0, first_order_floor(h, last.Hm_fitted));
}

double work_units(const fmg::Hierarchy& hierarchy, std::size_t l) {
  double nodes = 0.0;
  for (std::size_t k = 0; k <= l; ++k) {
    const fmg::Level& level = hierarchy.levels[k];
    const core::Grid grid = core::whole(level.grid);
    nodes += static_cast<double>(level.evaluations) * grid.nodes_x() * grid.nodes_y();
  }
  const core::Grid grid = core::whole(hierarchy.levels[l].grid);
  return nodes / (static_cast<double>(grid.nodes_x()) * grid.nodes_y());
}

}  // namespace

void record(Climb& climb, std::size_t l, int cycle, const StateOfLevel& now) {
  const core::Grid grid = core::whole(climb.hierarchy.levels[l].grid);
  const int number = static_cast<int>(l) + 1;
  climb.solution.history.push_back({number, cycle, now.residual, now.load_error, now.Hc, now.Hm});
  LevelRow& row = climb.solution.levels.back();
  row.level = number;
  row.nx = grid.nx;
  row.ny = grid.ny;
  row.Hc = now.Hc;
  row.Hm = now.Hm;
  row.Hm_fitted = now.Hm_fitted;
  row.P_max = now.P_max;
  row.residual = now.residual;
  row.load_error = now.load_error;
  row.cycles = cycle;
  row.work_units = work_units(climb.hierarchy, l);
  const ErrorEstimate Hc = error_of(climb, &LevelRow::Hc);
  row.error_Hc = Hc.relative_error;
  row.order_Hc = Hc.order;
  row.error_Hm =
      error_of(climb, &LevelRow::Hm_fitted).relative_error + std::abs(row.Hm - row.Hm_fitted) / std::abs(row.Hm);
}

void report(const Climb& climb, std::size_t l, int cycle, int planned, const StateOfLevel& now, double load_ratio) {
  if (!climb.progress) return;
  // A cycle on the next level costs about four times as much. The checks may ask for more cycles than planned: the
  // last part of the bar is theirs.
  constexpr double share_of_planned = 0.9;
  double whole = 0.0;
  double done = 0.0;
  for (std::size_t k = climb.first; k <= climb.finest(); ++k) {
    const double cost = std::exp2(2.0 * static_cast<double>(k - climb.first));
    whole += cost;
    if (k < l) done += cost;
    const double extra = 1.0 - std::exp2(static_cast<double>(planned - cycle));
    const double cycles_done =
        cycle <= planned ? share_of_planned * cycle / planned : share_of_planned + (1.0 - share_of_planned) * extra;
    if (k == l) done += cost * cycles_done;
  }
  const core::Grid grid = core::whole(climb.hierarchy.levels[l].grid);
  const Progress progress{.level = static_cast<int>(l) + 1,
                          .levels = static_cast<int>(climb.finest()) + 1,
                          .cycle = cycle,
                          .cycles = planned,
                          .nx = grid.nx,
                          .ny = grid.ny,
                          .residual = now.residual,
                          .Hc = now.Hc,
                          .fraction = done / whole,
                          .load_ratio = load_ratio};
  if (!climb.progress(progress)) throw core::Interrupted();
}

std::string name_of_level(const fmg::Hierarchy& hierarchy, std::size_t l) {
  const core::Grid grid = core::whole(hierarchy.levels[l].grid);
  return "level " + std::to_string(l + 1) + " (" + std::to_string(grid.nx) + " x " + std::to_string(grid.ny) +
         " cells)";
}

}  // namespace ehl::steady
