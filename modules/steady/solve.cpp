#include "steady/solve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "contact/film_formulas.hpp"
#include "core/errors.hpp"
#include "core/norms.hpp"
#include "fmg/cycle.hpp"
#include "fmg/full_multigrid.hpp"
#include "steady/error_estimate.hpp"
#include "steady/state_of_level.hpp"

namespace ehl::steady {
namespace {

/// How an attempt begins. The first is fast and right for most contacts; the later ones are slower and safer.
struct Start {
  int cells;       ///< along x, at least
  int sweeps;      ///< single-grid relaxations from the Hertz pressure
  int cycles;      ///< cycles on the first level
  double caution;  ///< factor on all under-relaxation weights
};
constexpr Start starts[] = {{64, 20, 4, 1.0}, {128, 40, 6, 1.0}, {128, 80, 10, 0.7}, {256, 80, 10, 0.5}};

/// A state this far from any solution will not come back: the attempt is given up.
constexpr double hopeless_residual = 1e3;
/// Algebraic error allowed in Hc and Hm, as a share of the discretization error.
constexpr double algebraic_share = 0.1;
/// Largest relative residual and load error of a solution at the level of the discretization error.
constexpr double loose_residual = 2e-2;
constexpr double loose_load_error = 1e-4;
/// Relative residual asked for where no error estimate exists (a single level).
constexpr double default_tolerance = 1e-6;

class Solver {
 public:
  Solver(const Scene& scene, const ProgressCallback& progress) : scene_(scene), progress_(progress) {}

  Solution run() {
    const double start = core::now();
    std::string last_failure;
    bool solved = false;
    const std::size_t count = std::size(starts);
    for (std::size_t attempt = 0; attempt < count && !solved; ++attempt) {
      if (attempt > 0 && starts[attempt].cells > scene_.grid.nx && starts[attempt - 1].cells > scene_.grid.nx) continue;
      solution_ = Solution{};
      try {
        climb(starts[attempt]);
        solved = solution_.converged || attempt + 1 == count;
        last_failure = solution_.failed_check;
      } catch (const core::SolverError& error) {
        last_failure = error.what();
        solution_.failed_check = last_failure;
      }
      if (!solved) solution_.warnings.clear();
    }
    solution_.seconds = core::now() - start;
    return std::move(solution_);
  }

 private:
  // The full multigrid: solve on a coarse grid, interpolate, a few cycles, and so on to the finest.
  void climb(const Start& start) {
    fmg::Parameters parameters = scene_.multigrid;
    parameters.relaxation.weight_distributed *= start.caution;
    parameters.relaxation.weight_single *= start.caution;
    parameters.relaxation.weight_single_steep *= start.caution;
    const fmg::Problem problem{.lambda = scene_.lambda,
                               .viscosity = scene_.viscosity,
                               .density = scene_.density,
                               .wedge = scene_.wedge,
                               .given_epsilon = {}};
    fmg::Hierarchy hierarchy =
        fmg::make_hierarchy(problem, parameters, scene_.deformation, scene_.grid, scene_.threads);
    solution_.deformation = hierarchy.finest().deformation.description();
    const std::size_t finest = hierarchy.levels.size() - 1;
    std::size_t first = 0;
    while (first < finest && hierarchy.levels[first].grid.nx < start.cells) ++first;

    fractions_done_ = 0.0;
    for (std::size_t l = first; l <= finest; ++l) {
      const double began = core::now();
      for (fmg::Level& level : hierarchy.levels) level.evaluations = 0;
      if (l == first)
        fmg::start_from_hertz(hierarchy, l, -1.0 + guess_of_central_film(), start.sweeps);
      else
        fmg::start_from_coarser(hierarchy, l);
      solve_level(hierarchy, first, l, finest,
                  l == first ? std::max(start.cycles, parameters.cycles) : parameters.cycles);
      solution_.levels.back().seconds = core::now() - began;
    }
    solution_.grid = scene_.grid;
    solution_.P = std::move(hierarchy.finest().P);
    solution_.H = std::move(hierarchy.finest().H);
    solution_.H00 = hierarchy.H00;
    solution_.times = hierarchy.times;
  }

  void solve_level(fmg::Hierarchy& hierarchy, std::size_t first, std::size_t l, std::size_t finest, int planned) {
    const bool last_level = l == finest;
    const bool to_tolerance = last_level && std::isfinite(scene_.multigrid.tolerance);
    const int most = last_level ? std::max(scene_.multigrid.max_cycles, planned) : planned;
    solution_.levels.emplace_back();
    StateOfLevel before = state_of_level(hierarchy, l);
    for (int cycle = 1; cycle <= most; ++cycle) {
      fmg::fas_cycle(hierarchy, l);
      const StateOfLevel now = state_of_level(hierarchy, l);
      if (!(now.residual < hopeless_residual) || !std::isfinite(now.Hc))
        throw core::SolverError(where(hierarchy, l) + ": the cycles diverge (relative residual " + text(now.residual) +
                                ")");
      record(hierarchy, l, cycle, now);
      report(hierarchy, first, l, finest, cycle, planned, now);
      if (to_tolerance) {
        solution_.failed_check = unmet_tolerance(hierarchy, l, scene_.multigrid.tolerance, now);
        if (solution_.failed_check.empty()) break;
      } else if (last_level && cycle >= planned) {
        solution_.failed_check = unmet_check(hierarchy, l, before, now);
        if (solution_.failed_check.empty()) break;
      }
      before = now;
    }
    solution_.converged = last_level && solution_.failed_check.empty();
  }

  /// Central film thickness of the published formula: good to 15 % and enough to begin with.
  double guess_of_central_film() const {
    const double H_moes = contact::nijenbanning_venner_moes(scene_.M, scene_.L);
    return H_moes * std::pow(1.5 * scene_.M, -2.0 / 3.0);
  }

  void record(const fmg::Hierarchy& hierarchy, std::size_t l, int cycle, const StateOfLevel& now) {
    const core::Grid& grid = hierarchy.levels[l].grid;
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
    row.work_units = work_units(hierarchy, l);
    const ErrorEstimate Hc = error_of(&LevelRow::Hc);
    const ErrorEstimate Hm = error_of(&LevelRow::Hm);
    row.error_Hc = Hc.relative_error;
    row.order_Hc = Hc.order;
    row.error_Hm = Hm.relative_error;
  }

  ErrorEstimate error_of(double LevelRow::*value) const {
    std::vector<double> values;
    for (const LevelRow& row : solution_.levels) values.push_back(row.*value);
    return estimate_error(values, scene_.wedge == reynolds::Wedge::upstream2 ? 2.0 : 1.0);
  }

  static double work_units(const fmg::Hierarchy& hierarchy, std::size_t l) {
    double nodes = 0.0;
    for (std::size_t k = 0; k <= l; ++k) {
      const fmg::Level& level = hierarchy.levels[k];
      nodes += static_cast<double>(level.evaluations) * level.grid.nodes_x() * level.grid.nodes_y();
    }
    const core::Grid& grid = hierarchy.levels[l].grid;
    return nodes / (static_cast<double>(grid.nodes_x()) * grid.nodes_y());
  }

  void report(const fmg::Hierarchy& hierarchy, std::size_t first, std::size_t l, std::size_t finest, int cycle,
              int planned, const StateOfLevel& now) {
    if (!progress_) return;
    // A cycle on the next level costs about four times as much.
    double whole = 0.0;
    double done = 0.0;
    for (std::size_t k = first; k <= finest; ++k) {
      const double cost = std::exp2(2.0 * static_cast<double>(k - first));
      whole += cost;
      if (k < l) done += cost;
      if (k == l) done += cost * std::min(1.0, static_cast<double>(cycle) / planned);
    }
    const core::Grid& grid = hierarchy.levels[l].grid;
    fractions_done_ = std::max(fractions_done_, done / whole);
    const Progress progress{.level = static_cast<int>(l) + 1,
                            .levels = static_cast<int>(finest) + 1,
                            .cycle = cycle,
                            .cycles = planned,
                            .nx = grid.nx,
                            .ny = grid.ny,
                            .residual = now.residual,
                            .Hc = now.Hc,
                            .fraction = fractions_done_};
    if (!progress_(progress)) throw core::Interrupted();
  }

  static std::string text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.2e", value);
    return buffer;
  }
  static std::string where(const fmg::Hierarchy& hierarchy, std::size_t l) {
    const core::Grid& grid = hierarchy.levels[l].grid;
    return "level " + std::to_string(l + 1) + " (" + std::to_string(grid.nx) + " x " + std::to_string(grid.ny) +
           " cells)";
  }

  static std::string unmet_tolerance(const fmg::Hierarchy& hierarchy, std::size_t l, double tolerance,
                                     const StateOfLevel& now) {
    if (!(now.residual <= tolerance))
      return where(hierarchy, l) + ": relative residual " + text(now.residual) + " is above the tolerance " +
             text(tolerance) + "; more max_cycles, a W cycle or a finer grid may help";
    if (!(now.load_error <= std::max(tolerance, 1e-12)))
      return where(hierarchy, l) + ": load error " + text(now.load_error) + " is above the tolerance " +
             text(tolerance) + "; more max_cycles may help";
    return {};
  }

  // At the level of the discretization error: the last cycle moved neither Hc nor Hm by more than a share of it.
  std::string unmet_check(const fmg::Hierarchy& hierarchy, std::size_t l, const StateOfLevel& before,
                          const StateOfLevel& now) const {
    const LevelRow& row = solution_.levels.back();
    if (!std::isfinite(row.error_Hc)) return unmet_tolerance(hierarchy, l, default_tolerance, now);
    const double moved_Hc = std::abs(now.Hc - before.Hc) / now.Hc;
    const double moved_Hm = std::abs(now.Hm - before.Hm) / now.Hm;
    if (!(now.residual <= loose_residual))
      return where(hierarchy, l) + ": relative residual " + text(now.residual) + " is above " + text(loose_residual) +
             "; a finer grid may help";
    if (!(now.load_error <= loose_load_error))
      return where(hierarchy, l) + ": load error " + text(now.load_error) + " is above " + text(loose_load_error);
    if (!(moved_Hc <= std::max(algebraic_share * row.error_Hc, 1e-10)))
      return where(hierarchy, l) + ": the last cycle changed Hc by " + text(moved_Hc) + ", more than a tenth of the " +
             "discretization error " + text(row.error_Hc) + "; more max_cycles may help";
    if (!(moved_Hm <= std::max(algebraic_share * row.error_Hm, 1e-10)))
      return where(hierarchy, l) + ": the last cycle changed Hm by " + text(moved_Hm) + ", more than a tenth of the " +
             "discretization error " + text(row.error_Hm) + "; more max_cycles may help";
    return {};
  }

  const Scene& scene_;
  const ProgressCallback& progress_;
  Solution solution_;
  double fractions_done_ = 0.0;
};

}  // namespace

Solution solve(const Scene& scene, const ProgressCallback& progress) { return Solver(scene, progress).run(); }

}  // namespace ehl::steady
