#include "report/course_columns.hpp"

#include "case/numbers/number.hpp"

namespace ehl::program {

using numbers::column;

std::vector<Column<steady::LevelRow>> level_columns() {
  using Row = steady::LevelRow;
  return {{"level", "-", "grid level", &Row::level},
          column<Row>(id::nx, &Row::nx),
          column<Row>(id::ny, &Row::ny),
          column<Row>(id::Hc, &Row::Hc),
          column<Row>(id::Hm, &Row::Hm),
          {id::mesh_error_Hc, "-", "estimated relative discretization error", &Row::mesh_error_Hc},
          {id::mesh_error_Hm, "-", "estimated relative discretization error", &Row::mesh_error_Hm},
          column<Row>(id::Hm_fitted, &Row::Hm_fitted),
          column<Row>(id::P_max, &Row::P_max),
          {"order_Hc", "-", "observed order of convergence", &Row::order_Hc},
          column<Row>(id::residual, &Row::residual),
          column<Row>(id::load_error, &Row::load_error),
          {id::cycles, "-", "cycles on the level", &Row::cycles},
          {id::work_units, "-", "in residual and deformation evaluations on the level", &Row::work_units},
          {id::seconds, "s", "time on the level", &Row::seconds}};
}

std::vector<Column<steady::CycleRow>> cycle_columns() {
  using Row = steady::CycleRow;
  return {{"level", "-", "grid level", &Row::level},
          {"cycle", "-", "cycle on the level", &Row::cycle},
          column<Row>(id::residual, &Row::residual),
          column<Row>(id::load_error, &Row::load_error),
          column<Row>(id::Hc, &Row::Hc),
          column<Row>(id::Hm, &Row::Hm)};
}

std::vector<Column<steady::ContinuationStep>> continuation_columns() {
  using Row = steady::ContinuationStep;
  return {column<Row>(id::M, &Row::M),
          {"load_ratio", "-", "load over that of the case", &Row::load_ratio},
          {id::Hc, "a^2/R", "film at (0,0); NaN where the first cycle diverged", &Row::Hc},
          {id::Hm, "a^2/R", "minimum film", &Row::Hm},
          column<Row>(id::residual, &Row::residual),
          {id::cycles, "-", "cycles for this load", &Row::cycles},
          {id::converged, "-", "1: solved; 0: rejected, a shorter step follows", &Row::converged}};
}

}  // namespace ehl::program
