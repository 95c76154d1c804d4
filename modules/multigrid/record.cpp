#include "multigrid/record.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/errors.hpp"
#include "judgement/error_estimate.hpp"
#include "multigrid/full_multigrid.hpp"

namespace ehl::multigrid {
namespace {

judgement::ErrorEstimate error_of(const Hierarchy& hierarchy, const Record& record, double LevelRow::*value) {
  const std::vector<double> values = column(record.levels, value);
  const core::Grid& domain = hierarchy.levels.back().grid.domain;
  const LevelRow& last = record.levels.back();
  const double h = (domain.X_b - domain.X_a) / last.nx;
  const reynolds::Wedge wedge = hierarchy.problem.transport.wedge;
  const judgement::Tuning& tuning = hierarchy.parameters.judgement;
  if (reynolds::third_order(wedge)) {
    const double share = value == &LevelRow::Hc ? tuning.third_order_floor_of_Hc : tuning.third_order_floor_of_Hm;
    const double stretch = core::stretch(domain);
    double floor = judgement::third_order_floor(h / stretch, last.Hm_fitted, share);
    // The side lobes are narrow along Y, the short side of stretched cells; the film at the ends depends on the long
    // side.
    if (stretch > 1.0) floor = std::max(floor, judgement::third_order_floor(h, last.Hc, share));
    return judgement::estimate_error(tuning, values, 2.0, floor);
  }
  if (wedge == reynolds::Wedge::upstream2) return judgement::estimate_error(tuning, values, 2.0);
  return judgement::estimate_error(tuning, values, 1.0, judgement::first_order_floor(tuning, h, last.Hm_fitted));
}

// Discretization errors of the last row, Hm between the nodes. With a meniscus the estimate by the scatter of the films
// from grid to grid replaces that by an order; with a first-order wedge the larger of the two counts.
judgement::FilmErrors film_errors(const Hierarchy& hierarchy, const Record& record,
                                  const judgement::ErrorEstimate& Hc) {
  const judgement::FilmErrors by_order{Hc.relative_error,
                                       error_of(hierarchy, record, &LevelRow::Hm_fitted).relative_error};
  if (!conserves_mass(hierarchy.levels.back())) return by_order;
  const judgement::FilmErrors beside =
      judgement::errors_beside_meniscus(hierarchy.parameters.judgement, column(record.levels, &LevelRow::Hc),
                                        column(record.levels, &LevelRow::Hm_fitted));
  if (reynolds::order(hierarchy.problem.transport.wedge) > 1.0) return beside;
  return {std::max(by_order.Hc, beside.Hc), std::max(by_order.Hm, beside.Hm)};
}

double work_units(const Hierarchy& hierarchy, std::size_t l) {
  double nodes = 0.0;
  for (std::size_t k = 0; k <= l; ++k) {
    const Level& level = hierarchy.levels[k];
    const core::Grid& grid = level.grid.domain;
    nodes += static_cast<double>(level.evaluations) * grid.nodes_x() * grid.nodes_y();
  }
  for (const Level& level : hierarchy.between)
    nodes += static_cast<double>(level.evaluations) * level.grid.domain.nodes_x() * level.grid.domain.nodes_y();
  const core::Grid& grid = hierarchy.levels[l].grid.domain;
  return nodes / (static_cast<double>(grid.nodes_x()) * grid.nodes_y());
}

}  // namespace

std::vector<double> column(const std::vector<LevelRow>& rows, double LevelRow::*value) {
  std::vector<double> values;
  for (const LevelRow& row : rows)
    if (row.solved() || &row == &rows.back()) values.push_back(row.*value);
  return values;
}

std::vector<double> column_observed(const std::vector<LevelRow>& rows, std::size_t number) {
  std::vector<double> values;
  for (const LevelRow& row : rows)
    if ((row.solved() || &row == &rows.back()) && row.observed.size() > number) values.push_back(row.observed[number]);
  return values;
}

void forget_work(Hierarchy& hierarchy) {
  for (Level& level : hierarchy.levels) level.evaluations = 0;
  for (Level& level : hierarchy.between) level.evaluations = 0;
}

void enter(const Hierarchy& hierarchy, std::size_t l, int cycle, const judgement::Measures& now, Record& record) {
  const core::Grid& grid = hierarchy.levels[l].grid.domain;
  const int number = static_cast<int>(l) + 1;
  record.history.push_back({number, cycle, now.residual, now.load_error, now.Hc, now.Hm});
  LevelRow& row = record.levels.back();
  row.level = number;
  row.nx = grid.nx;
  row.ny = grid.ny;
  row.Hc = now.Hc;
  row.Hm = now.Hm;
  row.Hm_fitted = now.Hm_fitted;
  row.P_max = now.P_max;
  row.P_rim = now.P_rim;
  row.residual = now.residual;
  row.load_error = now.load_error;
  row.cycles = cycle;
  row.work_units = work_units(hierarchy, l);
  const judgement::ErrorEstimate Hc = error_of(hierarchy, record, &LevelRow::Hc);
  row.order_Hc = Hc.order;
  const judgement::FilmErrors errors = film_errors(hierarchy, record, Hc);
  row.mesh_error_Hc = errors.Hc;
  row.mesh_error_Hm = errors.Hm + std::abs(row.Hm - row.Hm_fitted) / std::abs(row.Hm);
}

void observe(Run& run, std::size_t l) {
  if (run.observer) run.record.levels.back().observed = run.observer(run.hierarchy, l);
}

void report(const Run& run, std::size_t l, int cycle, int planned, const judgement::Measures& now, double load_ratio) {
  if (!run.progress) return;
  // A cycle on the next level costs about four times as much. The last part of the progress is for cycles beyond the
  // planned ones, which the checks may ask for.
  constexpr double share_of_planned = 0.9;
  double whole = 0.0;
  double done = 0.0;
  for (std::size_t k = run.plan.first; k <= run.finest(); ++k) {
    const double cost = std::exp2(2.0 * static_cast<double>(k - run.plan.first));
    whole += cost;
    if (k < l) done += cost;
    const double extra = 1.0 - std::exp2(static_cast<double>(planned - cycle));
    const double cycles_done =
        cycle <= planned ? share_of_planned * cycle / planned : share_of_planned + (1.0 - share_of_planned) * extra;
    if (k == l) done += cost * cycles_done;
  }
  const core::Grid& grid = run.hierarchy.levels[l].grid.domain;
  const Progress progress{.level = static_cast<int>(l) + 1,
                          .levels = static_cast<int>(run.finest()) + 1,
                          .cycle = cycle,
                          .cycles = planned,
                          .nx = grid.nx,
                          .ny = grid.ny,
                          .residual = now.residual,
                          .Hc = now.Hc,
                          .fraction = done / whole,
                          .load_ratio = load_ratio};
  if (!run.progress(progress)) throw core::Interrupted();
}

ProgressCallback part_of(const ProgressCallback& whole, double from, double to) {
  if (!whole) return {};
  return [=](const Progress& now) {
    Progress told = now;
    told.fraction = from + (to - from) * now.fraction;
    return whole(told);
  };
}

std::string name_of_level(const Hierarchy& hierarchy, std::size_t l) {
  const core::Grid& grid = hierarchy.levels[l].grid.domain;
  return "level " + std::to_string(l + 1) + " (" + std::to_string(grid.nx) + " x " + std::to_string(grid.ny) +
         " cells)";
}

}  // namespace ehl::multigrid
