#include "steady/continuation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "contact/groups.hpp"
#include "core/errors.hpp"
#include "multigrid/start.hpp"
#include "steady/resolution.hpp"
#include "transfer/transfer.hpp"

namespace ehl::steady {
namespace {

struct Solved {
  double ln_M;
  multigrid::State state;
  double Hc, Hm;
};

std::size_t level_that_holds(const multigrid::Hierarchy& hierarchy, const Scene& scene) {
  const double step =
      scene.tuning.continuation_coarseness * resolving_step(scene.tuning, scene.contact, reynolds::Wedge::upstream2);
  std::size_t l = 0;
  while (l + 1 < hierarchy.levels.size() &&
         hierarchy.levels[l].grid.hx() / core::stretch(hierarchy.levels[l].grid) > step)
    ++l;
  return l;
}

// By default not so light that the domain would starve it.
double first_M(const Scene& scene) {
  const Tuning& tuning = scene.tuning;
  if (std::isfinite(scene.continuation.load_ratio)) return scene.continuation.load_ratio * scene.contact.M;
  const double lightest = tuning.lightest_M * scene.contact.M / scene.contact.circular_load;
  return std::max(tuning.first_load * scene.contact.M, std::min(lightest, tuning.heaviest_first * scene.contact.M));
}

// Starting state for the next load: the last pressure in Hertz's units, and H00 changed by the expected change of the
// minimum film. That change follows the power of the load fitted to the last two central films, or the published
// formula at first. [bench: predict_H00]
Solved predict(const std::optional<Solved>& previous, const Solved& last, double ln_M, const Scene& scene) {
  Solved guess{ln_M, last.state, 0.0, 0.0};
  const auto expected = [&](double of_ln_M) {
    return scales_of(std::exp(of_ln_M), scene.contact.L, scene.contact.shape).film;
  };
  double ratio = expected(ln_M) / expected(last.ln_M);
  if (previous && previous->Hc > 0.0 && last.Hc > 0.0)
    ratio = std::pow(last.Hc / previous->Hc, (ln_M - last.ln_M) / (last.ln_M - previous->ln_M));
  guess.state.H00 += (ratio - 1.0) * std::max(0.0, last.Hm);
  return guess;
}

/// The scene with the grid of level l as its finest.
Scene on_level(const Scene& scene, const multigrid::Hierarchy& hierarchy, std::size_t l) {
  Scene same = scene;
  same.grid = hierarchy.levels[l].grid.domain;
  same.deformation = mlmi::fitting(same.deformation, hierarchy.levels[l].grid);
  return same;
}

// Cycles for one load on the finest grid of a run. in/out: the damping; a failed step passes on only its relaxation
// after the coarse grid correction.
ContinuationStep solve_step(const Tuning& tuning, multigrid::Run& run, double M, double load_ratio,
                            multigrid::Damping& damping) {
  ContinuationStep step{.M = M, .load_ratio = load_ratio};
  const multigrid::CycleObserver observe = [&](int cycle,
                                               const judgement::Measures& now) -> multigrid::DiscretizationError {
    // If the cycles diverge, these stay at the last finite values.
    if (std::isfinite(now.Hc + now.Hm + now.residual)) {
      step.Hc = now.Hc;
      step.Hm = now.Hm;
      step.residual = now.residual;
    }
    multigrid::report(run, run.finest(), cycle, tuning.continuation_most_cycles, now, step.load_ratio);
    return {};
  };
  const judgement::StoppingCriterion criterion{.aim = judgement::Aim::residual,
                                               .most = tuning.continuation_most_cycles,
                                               .tolerance = tuning.continuation_tolerance};
  const multigrid::CyclesResult result =
      multigrid::run_cycles(run.hierarchy, run.finest(), criterion, damping, observe);
  damping.relax_after = result.damping.relax_after;
  if (result.end == CyclesEnd::converged) damping = result.damping;
  step.cycles = result.cycles;
  step.converged = result.end == CyclesEnd::converged;
  return step;
}

std::string name_of_load(const Scene& scene, double ln_M) {
  const double M = std::exp(ln_M);
  return fmt::format("M = {:.4g} ({:.3g} % of the load)", M, 100.0 * M / scene.contact.M);
}

// The first solution. A default first load that is not solved is tripled. in: the scene on the grid of the
// continuation.
Solved solve_first_load(const Scene& scene, const std::function<Solution(const Scene& light)>& first_load,
                        std::vector<ContinuationStep>& steps) {
  const bool chosen = std::isnan(scene.continuation.load_ratio);
  for (double M = first_M(scene);; M *= scene.tuning.next_first) {
    std::string reason;
    try {
      Scene light = under_load(scene, M);
      light.solver.tolerance = scene.tuning.continuation_tolerance;
      const Solution solution = first_load(light);
      const LevelRow& row = solution.levels.back();
      steps.push_back({.M = M,
                       .load_ratio = M / scene.contact.M,
                       .Hc = row.Hc,
                       .Hm = row.Hm,
                       .residual = row.residual,
                       .cycles = row.cycles,
                       .converged = row.residual <= scene.tuning.continuation_tolerance});
      if (steps.back().converged) return {std::log(M), {solution.P, solution.H00}, row.Hc, row.Hm};
      reason = solution.failed_check;
    } catch (const core::SolverError& error) {
      reason = error.what();
    }
    if (!chosen || scene.tuning.next_first * M > scene.tuning.heaviest_first * scene.contact.M)
      throw core::SolverError("load continuation: its first load, " + name_of_load(scene, std::log(M)) +
                              ", was not solved: " + reason);
  }
}

// Continues from load to load up to that of the scene; every load has grids of its own. in: the scene on the grid of
// the continuation and the first solution; fields are on the domain. out: the last solution.
Solved follow_load(const Scene& scene, const Start& start, const ProgressCallback& progress, Solved last,
                   std::vector<ContinuationStep>& steps, multigrid::Damping& damping, core::PartTimes& times) {
  const Tuning& tuning = scene.tuning;
  const double target = std::log(scene.contact.M);
  const double direction = target >= last.ln_M ? 1.0 : -1.0;
  double stride = std::log(scene.continuation.step);
  std::optional<Solved> previous;
  while (last.ln_M != target) {
    if (static_cast<int>(steps.size()) >= scene.continuation.max_steps)
      throw core::SolverError("load continuation: " + std::to_string(steps.size()) + " steps (max_steps) reached " +
                              name_of_load(scene, last.ln_M));
    const bool arrives = std::abs(target - last.ln_M) <= 1.001 * stride;
    Solved next = predict(previous, last, arrives ? target : last.ln_M + direction * stride, scene);
    const double M = arrives ? scene.contact.M : std::exp(next.ln_M);
    multigrid::Run run = begin_multigrid(under_load(scene, M), start, progress);
    const core::Patch& grid = run.hierarchy.finest().grid;
    multigrid::start_from_state(run.hierarchy, run.finest(), {core::on_patch(grid, next.state.P), next.state.H00});
    steps.push_back(solve_step(scene.tuning, run, M, M / scene.contact.M, damping));
    core::add(run.hierarchy.times, times);
    if (steps.back().converged) {
      next.state = {core::on_domain(grid, run.hierarchy.finest().P), run.hierarchy.H00};
      next.Hc = steps.back().Hc;
      next.Hm = steps.back().Hm;
      previous = std::move(last);
      last = std::move(next);
      if (steps.back().cycles <= tuning.continuation_few_cycles) stride *= tuning.continuation_longer;
    } else {
      stride *= 0.5;
      if (stride < std::log(tuning.continuation_shortest_step))
        throw core::SolverError("load continuation: no step converges from " + name_of_load(scene, last.ln_M));
    }
  }
  return last;
}

// Solves the next coarser grid too at the load of the scene, from the solution on level l, as the estimate of the
// discretization error needs it. If that grid has no solution there is no estimate.
void solve_level_below(multigrid::Run& run, std::size_t l, const multigrid::State& solved) {
  if (l == 0) return;
  const multigrid::LevelStep begin = [&](multigrid::Run&, std::size_t below) {
    multigrid::State start{core::Field(run.hierarchy.levels[below].grid), solved.H00};
    transfer::restrict_injection(solved.P, start.P);
    multigrid::start_from_state(run.hierarchy, below, start);
  };
  try {
    multigrid::for_levels(run, l - 1, l, begin, multigrid::solve_level);
  } catch (const core::SolverError&) {
    run.record.levels.clear();
  }
}

// The bodies keep their surfaces: with a' = s a, H' = h R/a'^2 and X' = x/a' the relief is S'(X') = S(s X')/s^2.
std::function<void(const core::Patch&, core::Field&)> scaled(
    std::function<void(const core::Patch&, core::Field&)> surface, double s) {
  if (!surface || s == 1.0) return surface;
  return [surface = std::move(surface), s](const core::Patch& grid, core::Field& S) {
    core::Patch same = grid;
    for (double* bound : {&same.domain.X_a, &same.domain.X_b}) *bound *= s;
    if (!grid.domain.line)
      for (double* bound : {&same.domain.Y_a, &same.domain.Y_b}) *bound *= s;
    surface(same, S);
    for (int i = 0; i <= grid.nx; ++i)
      for (double& gap : S.station(i)) gap /= s * s;
  };
}

}  // namespace

Scene under_load(const Scene& scene, double M) {
  const double p_h_factor =
      contact::line(scene.contact.shape) ? std::sqrt(M / scene.contact.M) : std::cbrt(M / scene.contact.M);
  Scene result = scene;
  result.contact = scales_of(M, scene.contact.L, scene.contact.shape);
  result.observer = {};
  result.lambda = contact::from_moes(M, scene.contact.L, scene.contact.shape).lambda;
  result.viscosity = rheology::rescaled(scene.viscosity, p_h_factor);
  result.density = rheology::rescaled(scene.density, p_h_factor);
  if (scene.thinning) result.thinning = rheology::rescaled(*scene.thinning, p_h_factor);
  if (scene.supply && p_h_factor != 1.0)  // the same layer of oil
    result.supply = [supply = scene.supply, s = p_h_factor](double Y) { return supply(s * Y) / (s * s); };
  result.surface = scaled(scene.surface, p_h_factor);  // a and p_h have the same dependence on the load
  return result;
}

Solution solve_by_continuation(const Scene& scene, const Start& start,
                               const std::function<Solution(const Scene& light)>& first_load,
                               const ProgressCallback& progress, std::vector<ContinuationStep>& steps) {
  multigrid::Run run = begin_multigrid(scene, start, progress);
  const std::size_t l = level_that_holds(run.hierarchy, scene);
  run.plan.first = l;
  run.plan.cycles = 0;  // no more than on the finer levels
  run.damping = {.all = start.damping};
  const Scene on_grid = on_level(scene, run.hierarchy, l);
  const Solved last = follow_load(on_grid, start, progress, solve_first_load(on_grid, first_load, steps), steps,
                                  run.damping, run.hierarchy.times);
  const multigrid::State solved{core::on_patch(run.hierarchy.levels[l].grid, last.state.P), last.state.H00};
  solve_level_below(run, l, solved);
  const multigrid::LevelStep begin = [&](multigrid::Run&, std::size_t k) {
    k == l ? multigrid::start_from_state(run.hierarchy, l, solved) : multigrid::start_from_below(run, k);
  };
  multigrid::for_levels(run, l, run.hierarchy.levels.size(), begin, multigrid::solve_level);
  return end_multigrid(scene, std::move(run));
}

}  // namespace ehl::steady
