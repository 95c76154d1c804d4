#include "steady/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "contact/groups.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "fmg/full_multigrid.hpp"
#include "steady/resolution.hpp"
#include "transfer/transfer.hpp"

namespace ehl::steady {
namespace {

/// Relative residual and load error of an intermediate solution: a good start for the next one.
constexpr double step_tolerance = 1e-4;
constexpr int most_cycles_of_a_step = 25;
/// Cycles of a step up to which the next one is longer.
constexpr int few_cycles = 6;
constexpr double longer = 1.5;
constexpr double longest_step = 3.0;  // factor of load
constexpr double shortest_step = 1.005;
/// A grid holds the contact where its step is at most this many times the one that resolves the film.
constexpr double coarseness = 1.6;
/// The first load where none is given: a hundredth of the scene's, but not so light that the domain would starve it.
constexpr double first_ratio = 0.01;
constexpr double lightest_M = 20.0;

struct Solved {
  double ln_M;
  core::Field P;
  double H00;
  double Hc;
};

std::size_t level_that_holds(const fmg::Hierarchy& hierarchy, const Scene& scene) {
  const double step = coarseness * resolving_step(scene.M, scene.L, reynolds::Wedge::upstream2, scene.shape);
  std::size_t l = 0;
  while (l + 1 < hierarchy.levels.size() && hierarchy.levels[l].grid.hx() > step) ++l;
  return l;
}

double first_M(const Scene& scene) {
  if (std::isfinite(scene.continuation.load_ratio)) return scene.continuation.load_ratio * scene.M;
  const double lightest = lightest_M * scene.M / circular_load(scene.M, scene.L, scene.shape);
  return std::max(first_ratio * scene.M, std::min(lightest, 0.5 * scene.M));
}

// The last pressure, in Hertz's units, with H00 changed as the central film will: as the power of the load that led
// from the last but one to the last; at first as the published formula has it. (A pressure predicted from the last two
// puts kinks where spike and cavitation boundary have moved, and costs four times the cycles.)
Solved predict(const std::optional<Solved>& previous, const Solved& last, double ln_M, const Scene& scene) {
  Solved guess{ln_M, last.P, last.H00, 0.0};
  const auto expected = [&](double of_ln_M) { return expected_central_film(std::exp(of_ln_M), scene.L, scene.shape); };
  double ratio = expected(ln_M) / expected(last.ln_M);
  if (previous && previous->Hc > 0.0 && last.Hc > 0.0)
    ratio = std::pow(last.Hc / previous->Hc, (ln_M - last.ln_M) / (last.ln_M - previous->ln_M));
  guess.Hc = ratio * last.Hc;
  guess.H00 += guess.Hc - last.Hc;
  return guess;
}

void pose(const Scene& scene, fmg::Problem& problem) {
  problem.lambda = scene.lambda;
  problem.viscosity = scene.viscosity;
  problem.density = scene.density;
  problem.surface = scene.surface;
  problem.thinning = scene.thinning;
}

// Cycles on level l for one load.
ContinuationStep solve_step(Climb& climb, std::size_t l, double M) {
  ContinuationStep step{.M = M, .load_ratio = M / climb.scene.M};
  const Judge judge = [&](int cycle, const StateOfLevel&, const StateOfLevel& now) -> Verdict {
    step.Hc = now.Hc;
    step.Hm = now.Hm;
    step.residual = now.residual;
    report(climb, l, cycle, most_cycles_of_a_step, now, step.load_ratio);
    return {now.residual <= step_tolerance && now.load_error <= step_tolerance ? "" : "not solved yet"};
  };
  Caution caution = climb.caution;  // of this step alone
  const CyclesResult result =
      run_cycles(climb.hierarchy, l, most_cycles_of_a_step, climb.scene.multigrid.relaxation, caution, judge);
  step.cycles = result.cycles;
  step.converged = result.end == CyclesEnd::content;
  return step;
}

// The first load by full multigrid on the grid of level l.
Solved solve_first_load(const Climb& climb, std::size_t l, std::vector<ContinuationStep>& steps) {
  Scene light = under_load(climb.scene, first_M(climb.scene));
  light.grid = core::whole(climb.hierarchy.levels[l].grid);
  light.deformation = mlmi::fitting(light.deformation, light.grid);
  light.multigrid.tolerance = step_tolerance;
  Solution solution = ehl::steady::climb(light, climb.start, climb.progress);
  const LevelRow& row = solution.levels.back();
  steps.push_back({.M = light.M,
                   .load_ratio = light.M / climb.scene.M,
                   .Hc = row.Hc,
                   .Hm = row.Hm,
                   .residual = row.residual,
                   .cycles = row.cycles,
                   .converged = row.residual <= step_tolerance});
  if (!steps.back().converged)
    throw core::SolverError("the first load of the continuation was not solved: " + solution.failed_check);
  return {std::log(light.M), part_on(climb.hierarchy.levels[l].grid, std::move(solution.P)), solution.H00, row.Hc};
}

std::string name_of_load(const Scene& scene, double ln_M) {
  const double M = std::exp(ln_M);
  return "M = " + std::to_string(M) + " (" + std::to_string(100.0 * M / scene.M) + " % of the load)";
}

// From load to load on level l, up to the load of the scene.
void follow_load(Climb& climb, std::size_t l, Solved last, std::vector<ContinuationStep>& steps) {
  const Scene& scene = climb.scene;
  const double target = std::log(scene.M);
  const double direction = target >= last.ln_M ? 1.0 : -1.0;
  double stride = std::log(scene.continuation.step);
  std::optional<Solved> previous;
  while (last.ln_M != target) {
    if (static_cast<int>(steps.size()) >= scene.continuation.max_steps)
      throw core::SolverError("load continuation: " + std::to_string(steps.size()) + " steps (max_steps) reached " +
                              name_of_load(scene, last.ln_M));
    const bool arrives = std::abs(target - last.ln_M) <= 1.001 * stride;
    Solved next = predict(previous, last, arrives ? target : last.ln_M + direction * stride, scene);
    const double M = arrives ? scene.M : std::exp(next.ln_M);
    pose(under_load(scene, M), climb.hierarchy.problem);
    fmg::start_from_state(climb.hierarchy, l, next.P, next.H00);
    steps.push_back(solve_step(climb, l, M));
    if (steps.back().converged) {
      next.P = climb.hierarchy.levels[l].P;
      next.H00 = climb.hierarchy.H00;
      next.Hc = steps.back().Hc;
      previous = std::move(last);
      last = std::move(next);
      if (steps.back().cycles <= few_cycles) stride = std::min(longer * stride, std::log(longest_step));
    } else {
      stride *= 0.5;
      if (stride < std::log(shortest_step))
        throw core::SolverError("load continuation: no step leads on from " + name_of_load(scene, last.ln_M));
    }
  }
}

// The next coarser grid at the load of the scene too, from the solution on level l: without it there would be no
// estimate of the discretization error. Where it cannot hold the contact there is none.
void solve_level_below(Climb& climb, std::size_t l) {
  if (l == 0) return;
  const core::Field P = climb.hierarchy.levels[l].P;
  const double H00 = climb.hierarchy.H00;
  core::Field P_below(climb.hierarchy.levels[l - 1].grid);
  transfer::restrict_injection(P, P_below);
  forget_work(climb.hierarchy);
  fmg::start_from_state(climb.hierarchy, l - 1, P_below, H00);
  try {
    const double began = core::now();
    solve_level(climb, l - 1, climb.scene.multigrid.cycles);
    climb.solution.levels.back().seconds = core::now() - began;
  } catch (const core::SolverError&) {
    climb.solution.levels.clear();
  }
  forget_work(climb.hierarchy);
  fmg::start_from_state(climb.hierarchy, l, P, H00);
}

}  // namespace

namespace {

// The bodies keep their surfaces: with a' = s a, H' = h R/a'^2 and X' = x/a' it is S'(X') = S(s X')/s^2.
std::function<void(const core::Grid&, core::Field&)> scaled(
    std::function<void(const core::Grid&, core::Field&)> surface, double s) {
  if (!surface || s == 1.0) return surface;
  return [surface = std::move(surface), s](const core::Grid& grid, core::Field& S) {
    core::Grid same = grid;
    for (double* bound : {&same.X_a, &same.X_b, &same.Y_a, &same.Y_b}) *bound *= s;
    surface(same, S);
    for (int i = 0; i <= grid.nx; ++i)
      for (double& gap : S.station(i)) gap /= s * s;
  };
}

}  // namespace

Scene under_load(const Scene& scene, double M) {
  const double p_h_factor = std::cbrt(M / scene.M);
  Scene result = scene;
  result.M = M;
  result.lambda = contact::from_moes(M, scene.L, scene.shape).lambda;
  result.viscosity = rheology::rescaled(scene.viscosity, p_h_factor);
  result.density = rheology::rescaled(scene.density, p_h_factor);
  if (scene.thinning) result.thinning = rheology::rescaled(*scene.thinning, p_h_factor);
  result.surface = scaled(scene.surface, p_h_factor);  // a and p_h both grow with the cube root of the load
  return result;
}

Solution climb_by_load(const Scene& scene, const Start& start, const ProgressCallback& progress,
                       std::vector<ContinuationStep>& steps) {
  Climb climb = begin_climb(scene, start, progress);
  const std::size_t l = level_that_holds(climb.hierarchy, scene);
  climb.first = l;
  climb.caution = {.all = start.caution};
  follow_load(climb, l, solve_first_load(climb, l, steps), steps);
  solve_level_below(climb, l);
  const double began = core::now();
  solve_level(climb, l, scene.multigrid.cycles);
  climb.solution.levels.back().seconds = core::now() - began;
  ascend(climb, l);
  return result_of(std::move(climb));
}

}  // namespace ehl::steady
