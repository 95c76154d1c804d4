#include "effects/heat/solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "effects/heat/report.hpp"
#include "judgement/error_estimate.hpp"
#include "multigrid/start.hpp"
#include "reynolds/wedge.hpp"
#include "steady/error_bars.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/warnings.hpp"
#include "transfer/transfer.hpp"

namespace ehl::heat {
namespace {

// Number of coarser grids, as the error estimate needs.
constexpr std::size_t grids_below = 2;

// The sequence of grids and the state of the iteration.
struct HeatedRun {
  steady::Scene scene;  // with factors
  multigrid::Run run;
  Tuning tuning;
  double first_weight = 1.0;  // under-relaxation factor of the first pass on the first grid
  std::vector<Pass> found{};  // coarse to fine
  std::vector<Row> rows{};
  std::optional<thermal::FilmTemperature> film{}, below{};
  Result last{};
};

// Share of the contact's load that the domain carries.
double share_of_load(const multigrid::Run& run, std::size_t l) {
  const core::Patch& patch = run.hierarchy.levels[l].grid;
  double sum = 0.0;
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) sum += patch.lines(j) * run.hierarchy.levels[l].P(i, j);
  const std::optional<double>& load = run.hierarchy.problem.load;
  return load ? sum * patch.hx() * patch.hy() / *load : 1.0;
}

HeatedRun begin(steady::Scene scene, const Tuning& tuning, const steady::ProgressCallback& progress) {
  scene.has_factors = true;
  const steady::Start start{.coarsest = steady::held_by(64, scene) ? 32 : 64};
  multigrid::Run run = steady::begin_multigrid(scene, start, progress);
  run.damping = run.plan.above;
  return {.scene = std::move(scene), .run = std::move(run), .tuning = tuning};
}

multigrid::State injected(const multigrid::Run& run, std::size_t l, const steady::Solution& isothermal) {
  core::Field P = core::on_patch(run.hierarchy.levels.back().grid, isothermal.P);
  for (std::size_t k = run.finest(); k > l; --k) {
    core::Field below(run.hierarchy.levels[k - 1].grid);
    transfer::restrict_injection(P, below);
    P = std::move(below);
  }
  return {std::move(P), isothermal.H00};
}

// Largest temperatures at the rim, where a spike lies if there is one.
void look_behind(const thermal::FilmTemperature& film, const core::Patch& patch, const core::QuadraticForm& outline,
                 int intervals, Row& row) {
  for (int i = 0; i <= patch.nx; ++i) {
    if (patch.X(i) <= 0.0) continue;
    for (int j = 0; j <= patch.ny; ++j) {
      if (outline.at(patch.X(i), patch.Y(j)) <= 1.0 - judgement::of_rim * judgement::of_rim) continue;
      for (int k = 0; k <= intervals; ++k) row.film_behind = std::fmax(row.film_behind, film.theta(i, j, k));
      row.surface_1_behind = std::fmax(row.surface_1_behind, film.theta(i, j, intervals));
      row.surface_2_behind = std::fmax(row.surface_2_behind, film.theta(i, j, 0));
    }
  }
}

// Passes on one grid, from its current state.
void pass_on(HeatedRun& heated, std::size_t l, thermal::Setup setup) {
  multigrid::Run& run = heated.run;
  multigrid::RowTimer timer(run);
  const double began = core::now();
  setup.patch = run.hierarchy.levels[l].grid;
  setup.threads = run.hierarchy.threads_on(setup.patch);
  std::optional<thermal::FilmTemperature> coarser = std::move(heated.below);
  heated.below = std::move(heated.film);
  heated.film.emplace(setup);
  if (heated.below) heated.film->start_from(*heated.below, coarser ? &*coarser : nullptr);
  const Tuning& tuning = heated.tuning;
  Parameters parameters{.below = heated.found, .tolerance = run.hierarchy.parameters.tolerance, .tuning = tuning};
  parameters.slow = heated.found.empty();
  if (heated.found.empty()) parameters.first_weight = heated.first_weight;
  if (l < run.finest()) {
    // Enough for a good start and an error estimate. An inlet with recirculation settles slowly: on finer grids its
    // remaining change per pass is below the allowed one and would stay.
    parameters.tolerance = tuning.change_below;
    parameters.below.clear();
    parameters.error = (heated.found.empty() ? tuning.change_of_first : tuning.change_below) / parameters.share;
  }
  run.record.levels.emplace_back();
  heated.last = heat_up(run, l, *heated.film, parameters);
  timer.stop();
  run.record.levels.back().observed =
      steady::observed(heated.scene, run.hierarchy, l, core::on_domain(setup.patch, heated.film->I0()),
                       core::on_domain(setup.patch, heated.film->less_tau()));
  const Pass& pass = heated.last.passes.back();
  const thermal::Balance& balance = heated.last.balance;
  heated.found.push_back(pass);
  heated.rows.push_back({.nx = setup.patch.nx,
                         .ny = setup.patch.domain.ny,
                         .passes = static_cast<int>(heated.last.passes.size()),
                         .Hc = pass.Hc,
                         .Hm = pass.Hm,
                         .mu = balance.friction * share_of_load(run, l),
                         .film = balance.film.theta,
                         .surface_1 = balance.surface_1.theta,
                         .surface_2 = balance.surface_2.theta,
                         .defect = balance.defect,
                         .seconds = core::now() - began});
  look_behind(*heated.film, setup.patch, run.hierarchy.problem.geometry.outline, setup.intervals, heated.rows.back());
}

// From grid `first` to the finest. returns true if all grids converged.
bool solve_levels(HeatedRun& heated, std::size_t first, const thermal::Setup& setup,
                  const steady::Solution& isothermal) {
  multigrid::Run& run = heated.run;
  run.record.levels.clear();
  run.damping = run.plan.above;
  heated.found.clear();
  heated.rows.clear();
  heated.film.reset();
  heated.below.reset();
  multigrid::State two_below;
  try {
    for (std::size_t l = first; l <= run.finest(); ++l) {
      if (l == first) {
        reset_factors(run.hierarchy, l);
        multigrid::start_from_state(run.hierarchy, l, injected(run, l, isothermal));
      } else {
        multigrid::State below = multigrid::state_of(run.hierarchy, l - 1);
        interpolate_factors(run.hierarchy, l);
        if (two_below.P.nodes_x() > 0)
          multigrid::start_from_two_coarser(run.hierarchy, l, two_below,
                                            reynolds::order(run.hierarchy.problem.transport.wedge));
        else
          multigrid::start_from_coarser(run.hierarchy, l);
        two_below = std::move(below);
      }
      pass_on(heated, l, setup);
      if (!heated.last.unmet.empty()) return false;
    }
  } catch (const core::SolverError& error) {
    heated.last.unmet = error.what();
    return false;
  }
  return true;
}

// Line contacts, whose coarse grids are cheap, start on a coarse grid: on finer ones the isothermal film, especially a
// starved one, may be too far from the thermal solution for the cycles to converge.
std::size_t first_grid(const Tuning& tuning, const multigrid::Run& run) {
  const std::size_t finest = run.finest(), least = std::min(run.plan.first, finest);
  std::size_t first = std::max(least, finest - std::min(finest, grids_below));
  const auto too_fine = [&](const core::Patch& grid) {
    return grid.domain.line && grid.nx > tuning.cells_of_first_line;
  };
  while (first > least && too_fine(run.hierarchy.levels[first].grid)) --first;
  return first;
}

// If a grid is too coarse for the thermal solution, the sequence starts again on the next finer one.
HeatedRun found(const steady::Scene& scene, const thermal::Setup& setup, const Tuning& tuning,
                const steady::Solution& isothermal, const steady::ProgressCallback& progress,
                double first_weight = 1.0) {
  HeatedRun heated = begin(scene, tuning, progress);
  heated.first_weight = first_weight;
  const std::size_t finest = heated.run.finest();
  std::size_t first = first_grid(tuning, heated.run);
  while (!solve_levels(heated, first, setup, isothermal) && first < finest)
    first = std::min(finest, first + std::max<std::size_t>(1, heated.rows.size()));
  return heated;
}

// Line contacts: V cycles first; if they fail, F cycles with a smaller under-relaxation factor in the first pass.
HeatedRun found_by_some_cycle(const steady::Scene& scene, const thermal::Setup& setup, const Tuning& tuning,
                              const steady::Solution& isothermal, const steady::ProgressCallback& progress) {
  HeatedRun heated = found(scene, setup, tuning, isothermal, progress);
  const bool free = scene.grid.line && !scene.solver.cycle && std::isnan(scene.solver.tolerance);
  if (heated.last.unmet.empty() || !free) return heated;
  steady::Scene careful = scene;
  careful.solver.cycle = multigrid::Cycle::F;
  HeatedRun other = found(careful, setup, tuning, isothermal, progress, tuning.gentle);
  return other.last.unmet.empty() ? std::move(other) : std::move(heated);
}

// An unresolved spike is hotter on each finer grid, so the sequence gives no error of the film temperature. The
// surfaces are hardly heated by the spike, and their errors include its growth.
void judge_below_spike(const steady::ErrorBars& bars, Solution& result) {
  result.spike_unresolved = bars.spike_unresolved;
  if (!bars.spike_unresolved) return;
  result.in_film.error = core::unknown;
}

// in: inlet_error, of Hc and Hm from the length of the inlet: oil that returns from upstream is warmer or colder than
// the boundary condition assumes.
void complete(const steady::Scene& scene, const steady::Solution& isothermal, bool film_is_cold, double inlet_error,
              steady::Solution& film) {
  film.method = isothermal.method + (film_is_cold ? ", then a fixed-point iteration with thinning by the flow"
                                                  : ", then a fixed-point iteration with heat");
  film.path = isothermal.path;
  film.attempts = isothermal.attempts;
  film.continuation = isothermal.continuation;
  film.domain_error_Hc = isothermal.domain_error_Hc;
  core::add(isothermal.times, film.times);
  film.error_bars = steady::error_bars_of(scene, film);
  film.error_bars.domain += inlet_error;
  film.warnings = steady::warnings_of(scene, film);
}

}  // namespace

Solution solve(const steady::Scene& scene, const thermal::Setup& setup, const Tuning& tuning,
               const steady::Solution& isothermal, const steady::ProgressCallback& progress) {
  const double began = core::now();
  HeatedRun heated = found_by_some_cycle(scene, setup, tuning, isothermal, progress);
  multigrid::Record& record = heated.run.record;
  record.converged = heated.last.unmet.empty();
  record.failed_check = record.converged ? ""
                                         : multigrid::name_of_level(heated.run.hierarchy, heated.run.finest()) +
                                               (setup.cold() ? ", with thinning by the flow: " : ", with heat: ") +
                                               heated.last.unmet;
  record.end = record.converged ? multigrid::CyclesEnd::converged : multigrid::CyclesEnd::limit;
  const multigrid::Level& level = heated.run.hierarchy.finest();
  Solution result = report(tuning, scene.solver.judgement, {*heated.film, level.grid, level.P, level.H, setup},
                           heated.last.balance, heated.rows);
  const double warm_inlet = std::abs(std::log(heated.run.hierarchy.far_motion.mobility));
  result.film = steady::solution_of(heated.scene, std::move(heated.run));
  result.film.C_centre = result.C;
  result.undone = !result.film.converged && !heated.last.passes.empty() && heated.last.passes.back().undone;
  complete(scene, isothermal, setup.cold(), tuning.share_of_warm_inlet * warm_inlet, result.film);
  judge_below_spike(result.film.error_bars, result);
  result.seconds = core::now() - began;
  result.film.seconds = isothermal.seconds + result.seconds;
  return result;
}

}  // namespace ehl::heat
