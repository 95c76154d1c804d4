#include "tables/study_point.hpp"

#include <algorithm>
#include <cmath>

#include "base/machine.hpp"
#include "case/numbers/number.hpp"
#include "core/timer.hpp"
#include "run/pipeline.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

// The work of all levels in units of the finest grid.
double whole_work(const steady::Solution& solution) {
  const auto nodes = [](const steady::LevelRow& row) { return (row.nx + 1.0) * (row.ny + 1.0); };
  double work = 0.0;
  for (const steady::LevelRow& row : solution.levels) work += row.work_units * nodes(row);
  return work / nodes(solution.levels.back());
}

void take(const steady::Solution& solution, StudyPoint& point) {
  point.reason = solution.failed_check;
  point.attempts = static_cast<int>(solution.attempts.size());
  if (solution.levels.empty()) return;
  const steady::LevelRow& finest = solution.levels.back();
  if (solution.converged) point.status = "converged";
  // A fixed number of cycles was asked for and is done, and the film is positive: the point counts
  // although it is not converged.
  else if (point.variant.cycles != "run" && solution.end == steady::CyclesEnd::limit && finest.Hm > 0.0)
    point.status = "stopped";
  point.nx = finest.nx;
  point.ny = finest.ny;
  point.Hc = finest.Hc;
  point.Hm = finest.Hm;
  point.estimate_Hc = finest.mesh_error_Hc;
  point.estimate_Hm = finest.mesh_error_Hm;
  point.residual = finest.residual;
  for (const steady::LevelRow& row : solution.levels)
    point.cycles_by_level += (point.cycles_by_level.empty() ? "" : ";") + std::to_string(row.cycles);
  point.work_units = whole_work(solution);
}

}  // namespace

std::vector<Column<StudyPoint>> study_columns(const std::optional<SiScales>& si) {
  using Point = StudyPoint;
  using numbers::column;
  std::vector<Column<Point>> columns{
      {"cells", "-", "cells along x of the finest grid", part(&Point::variant, &StudyCase::cells)},
      {"wedge", "", "scheme of the wedge term", part(&Point::variant, &StudyCase::wedge)},
      {"evaluator", "", "evaluation of the deformation", part(&Point::variant, &StudyCase::evaluator)},
      {id::cycles, "", "number and shape of the cycles, or run", part(&Point::variant, &StudyCase::cycles)},
      {id::status, "", "how the solution ended", &Point::status},
      column<Point>(id::nx, &Point::nx),
      column<Point>(id::ny, &Point::ny),
      column<Point>(id::Hc, &Point::Hc),
      column<Point>(id::Hm, &Point::Hm),
      {"deviation_Hc", "-", "relative deviation from the reference", &Point::deviation_Hc},
      {"deviation_Hm", "-", "relative deviation from the reference", &Point::deviation_Hm},
      {"estimate_Hc", "-", "relative discretization error as estimated by the run", &Point::estimate_Hc},
      {"estimate_Hm", "-", "relative discretization error as estimated by the run", &Point::estimate_Hm},
      column<Point>(id::residual, &Point::residual),
      {"cycles_by_level", "", "values from the first grid to the finest", &Point::cycles_by_level},
      {"attempts", "-", "number of strategies tried", &Point::attempts},
      {id::work_units, "-", "work of the whole solution, in evaluations of the finest grid", &Point::work_units},
      {id::seconds, "s", "shortest time of the repetitions", &Point::seconds},
      {"seconds_most", "s", "longest time of the repetitions", &Point::seconds_most},
      column<Point>(id::peak_memory, &Point::peak_memory),
      {"at_reference_Hc", "-", "1: the deviation is below the error of the reference", &Point::at_reference_Hc},
      {"at_reference_Hm", "-", "1: the deviation is below the error of the reference", &Point::at_reference_Hm},
      {"front_Hc", "-", "1: on the Pareto front, no cheaper variant is as accurate", &Point::front_Hc},
      {"front_Hm", "-", "1: on the Pareto front, no cheaper variant is as accurate", &Point::front_Hm},
      {id::reason, "", "why there is no solution", &Point::reason}};
  if (!si) return columns;
  const double nm = si_unit("a^2/R", *si).factor;
  const auto in_nm = [nm](double Point::*film) { return [nm, film](const Point& point) { return nm * point.*film; }; };
  const auto film = std::ranges::find(columns, id::Hc, &Column<Point>::name);
  columns.insert(film, {{numbers::column_in_si(id::hc), "nm", numbers::number_of(id::hc).meaning, in_nm(&Point::Hc)},
                        {numbers::column_in_si(id::hm), "nm", numbers::number_of(id::hm).meaning, in_nm(&Point::Hm)}});
  return columns;
}

std::string text_of(const StudyPoint& point) { return csv_text(study_columns(), point); }

void read_text(const std::string& text, StudyPoint& point) { point = csv_read(study_columns(), text); }

StudyPoint measure(Case input, const StudyCase& variant) {
  use_way(variant, input.scene);
  StudyPoint point;
  point.variant = variant;
  point.status = "not-converged";
  point.nx = input.scene.grid.nx;
  point.ny = input.scene.grid.ny;
  Progress silent(true);
  RunSettings settings{.progress = silent, .extent = Extent::film};
  Computed computed;
  const double began = core::now();
  solve_case(input, settings, computed);
  take(computed.solution, point);
  point.seconds = point.seconds_most = core::now() - began;
  point.peak_memory = peak_memory();
  return point;
}

void add_repetition(const Cost& again, Cost& cost) {
  cost.seconds = std::fmin(cost.seconds, again.seconds);
  cost.seconds_most = std::fmax(cost.seconds_most, again.seconds_most);
  cost.peak_memory = std::fmax(cost.peak_memory, again.peak_memory);
}

}  // namespace ehl::program
