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
#include "fmg/start.hpp"
#include "judgement/error_estimate.hpp"
#include "reynolds/wedge.hpp"
#include "steady/climb.hpp"
#include "steady/error_bars.hpp"
#include "steady/warnings.hpp"
#include "transfer/transfer.hpp"

namespace ehl::heat {
namespace {

// Number of coarser grids, as the error estimate needs.
constexpr std::size_t grids_below = 2;
// Line contacts, whose coarse grids are cheap, start on a grid of at most this many cells: on finer ones the isothermal
// film, especially a starved one, may be too far from the thermal solution for the cycles to converge.
constexpr int cells_of_first_line = 64;
// Tolerances on the coarser grids: enough for a good start and an error estimate.
constexpr double residual_below = 1e-3, change_below = 2e-3;
// Tolerance on the first grid. An inlet with recirculation settles slowly; on finer grids its remaining change per pass
// is below the allowed one and would stay. [bench: heat_change_of_first]
constexpr double change_of_first = 3e-4;

// The sequence of grids and the state of the iteration.
struct Ladder {
  steady::Scene scene;  // with the effect of the factors
  fmg::Run run;
  std::shared_ptr<Factors> factors;
  double first_weight = 1.0;  // under-relaxation factor of the first pass on the first grid
  std::vector<Pass> found{};  // coarse to fine
  std::vector<Row> rows{};
  std::optional<thermal::FilmTemperature> film{}, below{};
  Result last{};
};

// Share of the contact's load that the domain carries.
double share_of_load(const fmg::Run& run, std::size_t l) {
  const core::Patch& patch = run.hierarchy.levels[l].grid;
  double sum = 0.0;
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) sum += patch.lines(j) * run.hierarchy.levels[l].P(i, j);
  const std::optional<double>& load = run.hierarchy.problem.load;
  return load ? sum * patch.hx() * patch.hy() / *load : 1.0;
}

Ladder begin(steady::Scene scene, const steady::ProgressCallback& progress) {
  const auto factors = std::make_shared<Factors>(std::vector<core::Patch>{scene.grid});
  scene.effects.push_back(Factors::effect(factors));
  const steady::Start start{.coarsest = steady::held_by(64, scene) ? 32 : 64};
  fmg::Run run = steady::begin_climb(scene, start, progress);
  run.caution = run.plan.above;
  return {.scene = std::move(scene), .run = std::move(run), .factors = factors};
}

std::vector<core::Patch> patches_from(const fmg::Run& run, std::size_t l) {
  std::vector<core::Patch> patches;
  for (std::size_t k = l + 1; k-- > 0;) patches.push_back(run.hierarchy.levels[k].grid);
  return patches;
}

fmg::State injected(const fmg::Run& run, std::size_t l, const steady::Solution& isothermal) {
  core::Field P = core::on_patch(run.hierarchy.levels.back().grid, isothermal.P);
  for (std::size_t k = run.finest(); k > l; --k) {
    core::Field below(run.hierarchy.levels[k - 1].grid);
    transfer::restrict_injection(P, below);
    P = std::move(below);
  }
  return {std::move(P), isothermal.H00};
}

// Largest temperatures downstream where the dry contact pressure is below this share of its maximum: a spike, if there
// is one, lies there.
void look_behind(const thermal::FilmTemperature& film, const core::Patch& patch, const core::QuadraticForm& outline,
                 int intervals, Row& row) {
  constexpr double of_rim = 0.8;
  for (int i = 0; i <= patch.nx; ++i) {
    if (patch.X(i) <= 0.0) continue;
    for (int j = 0; j <= patch.ny; ++j) {
      if (outline.at(patch.X(i), patch.Y(j)) <= 1.0 - of_rim * of_rim) continue;
      for (int k = 0; k <= intervals; ++k) row.film_behind = std::fmax(row.film_behind, film.theta(i, j, k));
      row.surface_1_behind = std::fmax(row.surface_1_behind, film.theta(i, j, intervals));
      row.surface_2_behind = std::fmax(row.surface_2_behind, film.theta(i, j, 0));
    }
  }
}

// Passes on one grid, from its current state.
void pass_on(Ladder& ladder, std::size_t l, thermal::Setup setup) {
  fmg::Run& run = ladder.run;
  fmg::RowTimer timer(run);
  const double began = core::now();
  setup.patch = run.hierarchy.levels[l].grid;
  setup.threads = run.hierarchy.threads_on(setup.patch);
  std::optional<thermal::FilmTemperature> coarser = std::move(ladder.below);
  ladder.below = std::move(ladder.film);
  ladder.film.emplace(setup);
  if (ladder.below) ladder.film->start_from(*ladder.below, coarser ? &*coarser : nullptr);
  Parameters parameters{.below = ladder.found, .tolerance = run.hierarchy.parameters.tolerance};
  parameters.slow = ladder.found.empty();
  if (ladder.found.empty()) parameters.first_weight = ladder.first_weight;
  if (l < run.finest()) {
    parameters.tolerance = residual_below;
    parameters.below.clear();
    parameters.error = (ladder.found.empty() ? change_of_first : change_below) / parameters.share;
  }
  run.record.levels.emplace_back();
  ladder.last = heat_up(run, l, *ladder.film, *ladder.factors, parameters);
  timer.stop();
  run.record.levels.back().observed =
      steady::observed(ladder.scene, run.hierarchy, l, core::on_domain(setup.patch, ladder.film->I0()),
                       core::on_domain(setup.patch, ladder.film->less_tau()));
  const Pass& pass = ladder.last.passes.back();
  const thermal::Balance& balance = ladder.last.balance;
  ladder.found.push_back(pass);
  ladder.rows.push_back({.nx = setup.patch.nx,
                         .ny = setup.patch.domain.ny,
                         .passes = static_cast<int>(ladder.last.passes.size()),
                         .Hc = pass.Hc,
                         .Hm = pass.Hm,
                         .mu = balance.friction * share_of_load(run, l),
                         .film = balance.film.theta,
                         .surface_1 = balance.surface_1.theta,
                         .surface_2 = balance.surface_2.theta,
                         .defect = balance.defect,
                         .seconds = core::now() - began});
  look_behind(*ladder.film, setup.patch, run.hierarchy.problem.geometry.outline, setup.intervals, ladder.rows.back());
}

// From grid `first` to the finest. returns true if all grids converged.
bool climb(Ladder& ladder, std::size_t first, const thermal::Setup& setup, const steady::Solution& isothermal) {
  fmg::Run& run = ladder.run;
  run.record.levels.clear();
  run.caution = run.plan.above;
  ladder.found.clear();
  ladder.rows.clear();
  ladder.film.reset();
  ladder.below.reset();
  fmg::State two_below;
  try {
    for (std::size_t l = first; l <= run.finest(); ++l) {
      if (l == first) {
        *ladder.factors = Factors(patches_from(run, l));
        fmg::start_from_state(run.hierarchy, l, injected(run, l, isothermal));
      } else {
        fmg::State below = fmg::state_of(run.hierarchy, l - 1);
        *ladder.factors = Factors(patches_from(run, l), *ladder.factors);
        if (two_below.P.nodes_x() > 0)
          fmg::start_from_two_coarser(run.hierarchy, l, two_below,
                                      reynolds::order(run.hierarchy.problem.transport.wedge));
        else
          fmg::start_from_coarser(run.hierarchy, l);
        two_below = std::move(below);
      }
      pass_on(ladder, l, setup);
      if (!ladder.last.unmet.empty()) return false;
    }
  } catch (const core::SolverError& error) {
    ladder.last.unmet = error.what();
    return false;
  }
  return true;
}

std::size_t first_grid(const fmg::Run& run) {
  const std::size_t finest = run.finest(), least = std::min(run.plan.first, finest);
  std::size_t first = std::max(least, finest - std::min(finest, grids_below));
  const auto too_fine = [&](const core::Patch& grid) { return grid.domain.line && grid.nx > cells_of_first_line; };
  while (first > least && too_fine(run.hierarchy.levels[first].grid)) --first;
  return first;
}

// If a grid is too coarse for the thermal solution, the sequence starts again on the next finer one.
Ladder found(const steady::Scene& scene, const thermal::Setup& setup, const steady::Solution& isothermal,
             const steady::ProgressCallback& progress, double first_weight = 1.0) {
  Ladder ladder = begin(scene, progress);
  ladder.first_weight = first_weight;
  const std::size_t finest = ladder.run.finest();
  std::size_t first = first_grid(ladder.run);
  while (!climb(ladder, first, setup, isothermal) && first < finest)
    first = std::min(finest, first + std::max<std::size_t>(1, ladder.rows.size()));
  return ladder;
}

// Line contacts: V cycles first; if they fail, F cycles with this under-relaxation factor in the first pass.
// [bench: heat_gentle]
constexpr double gentle = 0.25;
Ladder found_by_some_cycle(const steady::Scene& scene, const thermal::Setup& setup, const steady::Solution& isothermal,
                           const steady::ProgressCallback& progress) {
  Ladder ladder = found(scene, setup, isothermal, progress);
  const bool free = scene.grid.line && !scene.multigrid.cycle && std::isnan(scene.multigrid.tolerance);
  if (ladder.last.unmet.empty() || !free) return ladder;
  steady::Scene careful = scene;
  careful.multigrid.cycle = fmg::Cycle::F;
  Ladder other = found(careful, setup, isothermal, progress, gentle);
  return other.last.unmet.empty() ? std::move(other) : std::move(ladder);
}

// Error of Hc and Hm from the length of the inlet, per |ln(epsilon/epsilon_cold)| at the first node of a line contact:
// oil that returns from upstream is warmer or colder than the boundary condition assumes.
// [bench: heat_share_of_warm_inlet]
constexpr double share_of_warm_inlet = 0.03;

// An unresolved spike is hotter on each finer grid, so the sequence gives no error of the film temperature. The
// surfaces are hardly heated by the spike, and their errors include its growth.
void judge_below_spike(const steady::ErrorBars& bars, Solution& result) {
  result.spike_unresolved = bars.spike_unresolved;
  if (!bars.spike_unresolved) return;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  result.in_film.error = unknown;
}

void complete(const steady::Scene& scene, const steady::Solution& isothermal, bool film_is_cold, double warm_inlet,
              steady::Solution& film) {
  film.method = isothermal.method + (film_is_cold ? ", then a fixed-point iteration with thinning by the flow"
                                                  : ", then a fixed-point iteration with heat");
  film.attempts = isothermal.attempts;
  film.continuation = isothermal.continuation;
  film.domain_error_Hc = isothermal.domain_error_Hc;
  core::add(isothermal.times, film.times);
  film.error_bars = steady::error_bars_of(scene, film);
  film.error_bars.domain += share_of_warm_inlet * warm_inlet;
  film.warnings = steady::warnings_of(scene, film);
}

}  // namespace

Solution solve(const steady::Scene& scene, const thermal::Setup& setup, const steady::Solution& isothermal,
               const steady::ProgressCallback& progress) {
  const double began = core::now();
  Ladder ladder = found_by_some_cycle(scene, setup, isothermal, progress);
  fmg::Record& record = ladder.run.record;
  record.converged = ladder.last.unmet.empty();
  record.failed_check = record.converged ? ""
                                         : fmg::name_of_level(ladder.run.hierarchy, ladder.run.finest()) +
                                               (setup.cold() ? ", with thinning by the flow: " : ", with heat: ") +
                                               ladder.last.unmet;
  record.end = record.converged ? fmg::CyclesEnd::content : fmg::CyclesEnd::limit;
  const fmg::Level& level = ladder.run.hierarchy.finest();
  Solution result = report(*ladder.film, level.grid, level.P, level.H, setup, ladder.last.balance, ladder.rows);
  const double warm_inlet = std::abs(std::log(ladder.run.hierarchy.far_motion.mobility));
  result.film = steady::solution_of(ladder.scene, std::move(ladder.run));
  result.film.C_centre = result.C;
  result.undone = !result.film.converged && !ladder.last.passes.empty() && ladder.last.passes.back().undone;
  complete(scene, isothermal, setup.cold(), warm_inlet, result.film);
  judge_below_spike(result.film.error_bars, result);
  result.seconds = core::now() - began;
  result.film.seconds = isothermal.seconds + result.seconds;
  return result;
}

}  // namespace ehl::heat
