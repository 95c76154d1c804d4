#include "newton/solve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "core/timer.hpp"
#include "newton/equations.hpp"
#include "newton/kinsol.hpp"
#include "newton/preconditioner.hpp"

namespace ehl::newton {
namespace {

/// A step this small, in units of p_h, is on its way in: solve its system accurately, and keep the factors.
constexpr double small_change = 0.02;
constexpr double loose = 1e-2;
constexpr double tight = 1e-5;
constexpr double last_bit = 0.03;
/// Old factors are used until they cost this many times the iterations that they took when they were new.
constexpr double worn_out = 2.0;
/// Longest change of H00 in one step: an absolute part, and a share of the film at the centre.
constexpr double longest_shift = 0.1;
constexpr double longest_shift_share = 0.3;
/// Give up when the best state met is this many steps old; near the solution, this many.
constexpr int patience = 20;
constexpr int patience_at_the_end = 5;
constexpr double near = 1e-6;

std::string in_figures(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

/// By what a state is judged.
struct State {
  double residual = 0.0;    ///< of the complementarity problem, relative
  double load_error = 0.0;  ///< relative
  double Hc = 0.0;          ///< H at the node next to (0, 0)
  double Hm = 0.0;          ///< minimum of H over the nodes
};

State judge(fmg::Hierarchy& hierarchy, fmg::Level& level) {
  const core::EnclosingTimer timer(hierarchy.times, core::Part::checks);
  fmg::update_residual(hierarchy, level);
  const core::Patch& grid = level.grid;
  const reynolds::ResidualNorms norms =
      reynolds::residual_norms(grid, fmg::fields(level), hierarchy.transport, hierarchy.problem.cavitation, level.r);
  return {.residual = norms.relative(),
          .load_error = std::abs(fmg::carried_load(level) - level.load) / level.load,
          .Hc = level.H(static_cast<int>(std::lround(-grid.domain.X_a / grid.hx())),
                        static_cast<int>(std::lround(-grid.domain.Y_a / grid.hy()))),
          .Hm = core::minimum(level.H).value};
}

class NewtonIteration {
 public:
  NewtonIteration(fmg::Hierarchy& hierarchy, std::size_t l, const Parameters& parameters)
      : hierarchy_(hierarchy),
        level_(hierarchy.levels[l]),
        parameters_(parameters),
        equations_(hierarchy, l),
        preconditioner_(equations_),
        u_(equations_.size()),
        old_(u_),
        problem_(make_problem()),
        kinsol_(problem_) {}

  Result run(const Progress& progress) {
    fmg::update_film(hierarchy_, level_);
    State state = judge(hierarchy_, level_);
    equations_.unknowns(u_);
    remember(state);
    if (core::max_abs(level_.P) == 0.0) return fail("no node carries pressure at the start");
    while (!good(state)) {
      if (static_cast<int>(result_.steps.size()) >= parameters_.max_steps)
        return fail("after " + std::to_string(parameters_.max_steps) + " steps");
      const std::string trouble = step(state);
      if (!trouble.empty()) return fail(trouble);
      state = judge(hierarchy_, level_);
      result_.steps.push_back({state.residual, static_cast<int>(iterations_)});
      remember(state);
      if (progress && !progress(result_.steps.back())) throw core::Interrupted();
      if (!std::isfinite(state.residual)) return fail("the residual is not finite");
      const int age = static_cast<int>(result_.steps.size()) - best_step_;
      if (age >= (best_measure_ < near ? patience_at_the_end : patience))
        return fail("no progress in the last " + std::to_string(age) + " steps");
    }
    result_.equations_met = true;
    if (!(state.Hm > 0.0))
      return fail("the discrete film of this grid is not positive (minimum " + in_figures(state.Hm) +
                  "): use more cells");
    result_.converged = true;
    return std::move(result_);
  }

 private:
  KrylovProblem make_problem() {
    KrylovProblem problem;
    problem.size = equations_.size();
    problem.residual = [this](std::span<const double> u, std::span<double> F) {
      equations_.residual(u, F);
      return std::ranges::all_of(F, [](double value) { return std::isfinite(value); });
    };
    problem.linearize = [this](std::span<const double> u) {
      equations_.linearize(u);
      if (keep_factors_) return true;
      fresh_factors_ = true;
      return preconditioner_.factor();
    };
    problem.jacobian = [this](std::span<const double> v, std::span<double> Jv) { equations_.jacobian(v, Jv); };
    problem.precondition = [this](std::span<double> v) { preconditioner_.solve(v); };
    return problem;
  }

  bool good(const State& state) const {
    return state.residual <= parameters_.tolerance && state.load_error <= parameters_.tolerance;
  }

  /// One Newton step from the state given, shortened where it changes P or H00 too much. out: what went wrong.
  std::string step(const State& state) {
    equations_.unknowns(u_);
    std::ranges::copy(u_, old_.begin());
    KinsolStep newton = take_step(linear_tolerance(state));
    if (!newton.reason.empty() && keep_factors_) {  // they may have been too old
      keep_factors_ = false;
      std::ranges::copy(old_, u_.begin());
      newton = take_step(loose);
    }
    if (!newton.reason.empty()) return newton.reason;
    shorten(longest_shift + longest_shift_share * std::abs(state.Hc));
    equations_.set_state(u_);
    iterations_ = newton.linear_iterations;
    if (fresh_factors_) iterations_when_fresh_ = iterations_;
    keep_factors_ = last_change_ < small_change &&
                    static_cast<double>(iterations_) <= worn_out * static_cast<double>(iterations_when_fresh_);
    return "";
  }

  /// No tighter than what the step needs to end it all.
  double linear_tolerance(const State& state) const {
    if (!(last_change_ < small_change)) return loose;
    return std::clamp(last_bit * parameters_.tolerance / state.residual, tight, loose);
  }

  KinsolStep take_step(double linear_tolerance) {
    fresh_factors_ = false;
    return kinsol_.step(u_, linear_tolerance);
  }

  void shorten(double most_shift) {
    double change = 0.0;
    for (std::size_t k = 0; k + 1 < u_.size(); ++k)
      change = std::max(change, std::abs(std::max(u_[k], 0.0) - std::max(old_[k], 0.0)));
    const double shift = std::abs(u_.back() - old_.back());
    double share = 1.0;
    if (change > parameters_.longest_change) share = parameters_.longest_change / change;
    if (shift * share > most_shift) share = most_shift / shift;
    for (std::size_t k = 0; k < u_.size(); ++k) u_[k] = old_[k] + share * (u_[k] - old_[k]);
    last_change_ = share < 1.0 ? std::numeric_limits<double>::infinity() : change;
  }

  void remember(const State& state) {
    const double measure = std::max(state.residual, state.load_error);
    if (!best_.empty() && !(measure < best_measure_)) return;
    best_ = u_;
    best_measure_ = measure;
    best_step_ = static_cast<int>(result_.steps.size());
  }

  Result fail(const std::string& reason) {
    equations_.set_state(best_);
    const State state = judge(hierarchy_, level_);
    result_.reason = "Newton's method: " + reason + "; relative residual " + in_figures(state.residual) +
                     ", load error " + in_figures(state.load_error) + " (asked " + in_figures(parameters_.tolerance) +
                     ")";
    return std::move(result_);
  }

  fmg::Hierarchy& hierarchy_;
  fmg::Level& level_;
  const Parameters& parameters_;
  Equations equations_;
  Preconditioner preconditioner_;
  std::vector<double> u_, old_, best_;
  KrylovProblem problem_;
  Kinsol kinsol_;
  Result result_;
  bool keep_factors_ = false;
  bool fresh_factors_ = false;
  long iterations_ = 0;
  long iterations_when_fresh_ = 0;
  double last_change_ = std::numeric_limits<double>::infinity();
  double best_measure_ = std::numeric_limits<double>::infinity();
  int best_step_ = 0;
};

}  // namespace

Result solve(fmg::Hierarchy& hierarchy, std::size_t l, const Parameters& parameters, const Progress& progress) {
  const fmg::Problem& problem = hierarchy.problem;
  if (!problem.load || !reynolds::ruptures(problem.cavitation) || problem.film.given_epsilon)
    throw core::InputError("Newton's method needs the whole problem: a load to carry, cavitation, epsilon of the film");
  return NewtonIteration(hierarchy, l, parameters).run(progress);
}

}  // namespace ehl::newton
