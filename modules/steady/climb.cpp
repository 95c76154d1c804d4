#include "steady/climb.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "contact/film_formulas.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "fmg/cycle.hpp"
#include "fmg/full_multigrid.hpp"
#include "steady/checks.hpp"
#include "steady/error_estimate.hpp"
#include "steady/state_of_level.hpp"

namespace ehl::steady {
namespace {

/// A state this far from any solution will not come back.
constexpr double hopeless_residual = 1e3;
/// Cycles that stall: this many in which the residual does not even halve.
constexpr int patience = 6;
constexpr double hardly_less = 0.5;
/// Cycles beyond the planned ones that a level below the finest may take to reach its discretization error.
constexpr int most_extra_cycles = 3;

class Climber {
 public:
  Climber(const Scene& scene, const Start& start, const ProgressCallback& progress)
      : scene_(scene), start_(start), progress_(progress), hierarchy_(make_hierarchy(scene, start)) {}

  Solution run() {
    finest_ = hierarchy_.levels.size() - 1;
    while (first_ < finest_ && hierarchy_.levels[first_].grid.nx < start_.cells) ++first_;
    for (std::size_t l = first_; l <= finest_; ++l) {
      const double began = core::now();
      for (fmg::Level& level : hierarchy_.levels) level.evaluations = 0;
      use_caution(l == first_ ? start_.caution_at_first : start_.caution);
      if (l == first_)
        fmg::start_from_hertz(hierarchy_, l, -1.0 + guess_of_central_film(), start_.sweeps);
      else
        fmg::start_from_coarser(hierarchy_, l);
      solve_level(l);
      solution_.levels.back().seconds = core::now() - began;
    }
    solution_.grid = scene_.grid;
    solution_.P = std::move(hierarchy_.finest().P);
    solution_.H = std::move(hierarchy_.finest().H);
    solution_.H00 = hierarchy_.H00;
    solution_.times = hierarchy_.times;
    solution_.deformation = hierarchy_.finest().deformation.description();
    return std::move(solution_);
  }

 private:
  static fmg::Hierarchy make_hierarchy(const Scene& scene, const Start& start) {
    fmg::Parameters parameters = scene.multigrid;
    parameters.coarsest_sweeps = std::max(parameters.coarsest_sweeps, start.balances);
    parameters.least_coarsest_cells = std::max(parameters.least_coarsest_cells, start.coarsest);
    const fmg::Problem problem{.lambda = scene.lambda,
                               .viscosity = scene.viscosity,
                               .density = scene.density,
                               .wedge = scene.wedge,
                               .given_epsilon = {}};
    return fmg::make_hierarchy(problem, parameters, scene.deformation, scene.grid, scene.threads);
  }

  void use_caution(double caution) {
    fmg::RelaxationParameters& weights = hierarchy_.parameters.relaxation;
    weights.weight_distributed = caution * scene_.multigrid.relaxation.weight_distributed;
    weights.weight_single = caution * scene_.multigrid.relaxation.weight_single;
    weights.weight_single_steep = caution * scene_.multigrid.relaxation.weight_single_steep;
  }

  void solve_level(std::size_t l) {
    const bool last_level = l == finest_;
    const int planned = l == first_ ? std::max(start_.cycles, scene_.multigrid.cycles) : scene_.multigrid.cycles;
    const int most =
        last_level ? std::max(scene_.multigrid.max_cycles, planned) : planned + (l == first_ ? 0 : most_extra_cycles);
    const double tolerance = scene_.multigrid.tolerance;
    const bool to_tolerance = last_level && std::isfinite(tolerance);
    solution_.levels.emplace_back();
    StateOfLevel before = state_of_level(hierarchy_, l);
    std::vector<double> residuals;
    for (int cycle = 1; cycle <= most; ++cycle) {
      fmg::fas_cycle(hierarchy_, l);
      const StateOfLevel now = state_of_level(hierarchy_, l);
      if (!(now.residual < hopeless_residual) || !std::isfinite(now.Hc))
        throw core::SolverError(where(l) + ": the cycles diverge");
      record(l, cycle, now);
      report(l, cycle, planned, now);
      if (to_tolerance || cycle >= planned) {
        const LevelRow& row = solution_.levels.back();
        const double asked = last_level ? tolerance : std::numeric_limits<double>::quiet_NaN();
        const LastCycle last{before, now, row.error_Hc, row.error_Hm};
        const std::string unmet = unmet_check(last, asked);
        solution_.verification = verification_of(last);
        solution_.failed_check = unmet.empty() ? unmet : where(l) + ": " + unmet;
        if (unmet.empty()) break;
      }
      residuals.push_back(now.residual);
      if (cycle > planned && cycle > patience &&
          now.residual > hardly_less * residuals[residuals.size() - 1 - static_cast<std::size_t>(patience)])
        break;
      before = now;
    }
    solution_.converged = last_level && solution_.failed_check.empty();
  }

  /// Central film thickness of the published formula: good to 15 % and enough to begin with.
  double guess_of_central_film() const {
    return contact::H_from_moes_units(contact::nijenbanning_venner_moes(scene_.M, scene_.L), scene_.M);
  }

  void record(std::size_t l, int cycle, const StateOfLevel& now) {
    const core::Grid& grid = hierarchy_.levels[l].grid;
    const int number = static_cast<int>(l) + 1;
    solution_.history.push_back({number, cycle, now.residual, now.load_error, now.Hc, now.Hm});
    LevelRow& row = solution_.levels.back();
    row.level = number;
    row.nx = grid.nx;
    row.ny = grid.ny;
    row.Hc = now.Hc;
    row.Hm = now.Hm;
    row.residual = now.residual;
    row.load_error = now.load_error;
    row.cycles = cycle;
    row.work_units = work_units(l);
    const ErrorEstimate Hc = error_of(&LevelRow::Hc);
    row.error_Hc = Hc.relative_error;
    row.order_Hc = Hc.order;
    row.error_Hm = error_of(&LevelRow::Hm).relative_error;
  }

  ErrorEstimate error_of(double LevelRow::*value) const {
    std::vector<double> values;
    for (const LevelRow& row : solution_.levels) values.push_back(row.*value);
    return estimate_error(values, scene_.wedge == reynolds::Wedge::upstream2 ? 2.0 : 1.0);
  }

  double work_units(std::size_t l) const {
    double nodes = 0.0;
    for (std::size_t k = 0; k <= l; ++k) {
      const fmg::Level& level = hierarchy_.levels[k];
      nodes += static_cast<double>(level.evaluations) * level.grid.nodes_x() * level.grid.nodes_y();
    }
    const core::Grid& grid = hierarchy_.levels[l].grid;
    return nodes / (static_cast<double>(grid.nodes_x()) * grid.nodes_y());
  }

  void report(std::size_t l, int cycle, int planned, const StateOfLevel& now) {
    if (!progress_) return;
    // A cycle on the next level costs about four times as much.
    double whole = 0.0;
    double done = 0.0;
    for (std::size_t k = first_; k <= finest_; ++k) {
      const double cost = std::exp2(2.0 * static_cast<double>(k - first_));
      whole += cost;
      if (k < l) done += cost;
      if (k == l) done += cost * std::min(1.0, static_cast<double>(cycle) / planned);
    }
    const core::Grid& grid = hierarchy_.levels[l].grid;
    const Progress progress{.level = static_cast<int>(l) + 1,
                            .levels = static_cast<int>(finest_) + 1,
                            .cycle = cycle,
                            .cycles = planned,
                            .nx = grid.nx,
                            .ny = grid.ny,
                            .residual = now.residual,
                            .Hc = now.Hc,
                            .fraction = done / whole};
    if (!progress_(progress)) throw core::Interrupted();
  }

  std::string where(std::size_t l) const {
    const core::Grid& grid = hierarchy_.levels[l].grid;
    return "level " + std::to_string(l + 1) + " (" + std::to_string(grid.nx) + " x " + std::to_string(grid.ny) +
           " cells)";
  }

  const Scene& scene_;
  const Start& start_;
  const ProgressCallback& progress_;
  fmg::Hierarchy hierarchy_;
  Solution solution_;
  std::size_t first_ = 0;
  std::size_t finest_ = 0;
};

}  // namespace

Solution climb(const Scene& scene, const Start& start, const ProgressCallback& progress) {
  return Climber(scene, start, progress).run();
}

}  // namespace ehl::steady
