#include "newton/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "core/timer.hpp"
#include "multigrid/boundary.hpp"
#include "multigrid/chattering.hpp"
#include "newton/equations.hpp"
#include "newton/gmres.hpp"
#include "newton/preconditioner.hpp"

namespace ehl::newton {
namespace {

/// The numbers by which a state is judged.
struct State {
  double residual = 0.0;    ///< of the complementarity problem, relative
  double load_error = 0.0;  ///< relative
  double Hc = 0.0;          ///< H at the node next to (0, 0)
  double Hm = 0.0;          ///< minimum of H over the nodes
  double far_change = 0.0;  ///< change of the far field since the last step: of a pressure, or of the load, relative
  double touching = 0.0;    ///< complementarity error of touching surfaces, as a pressure
  double measure() const { return std::max({residual, load_error, far_change, touching}); }
};

// Largest of |H - H_b| where P_c > 0, and of H_b - H elsewhere, over K_00.
double touching_error(const multigrid::Hierarchy& hierarchy, const multigrid::Level& level) {
  if (!level.touching) return 0.0;
  const double H_b = multigrid::boundary_film(hierarchy);
  double largest = 0.0;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) {
      const double gap = level.H(i, j) - H_b;
      largest = std::max(largest, level.touching->P_c(i, j) > 0.0 ? std::abs(gap) : -gap);
    }
  return largest / multigrid::film_response(level, 0);
}

// A step holds the boundary pressure and the load outside fixed. Both follow from the film but change little with it,
// so that the steps converge nearly as fast as without a far field.
State judge(multigrid::Hierarchy& hierarchy, multigrid::Level& level) {
  const core::EnclosingTimer timer(hierarchy.times, core::Part::checks);
  const double far_change = multigrid::renew_boundary(hierarchy, level);
  multigrid::update_residual(hierarchy, level);
  const core::Patch& grid = level.grid;
  const reynolds::ResidualNorms norms = reynolds::residual_norms(grid, multigrid::fields(level), hierarchy.transport,
                                                                 hierarchy.problem.cavitation, level.r);
  return {.residual = norms.relative(),
          .load_error = std::abs(multigrid::carried_load(level) - level.load) / level.load,
          .Hc = level.H(static_cast<int>(std::lround(-grid.domain.X_a / grid.hx())),
                        static_cast<int>(std::lround(-grid.domain.Y_a / grid.hy()))),
          .Hm = core::minimum(level.H).value,
          .far_change = far_change,
          .touching = touching_error(hierarchy, level)};
}

class NewtonIteration {
 public:
  NewtonIteration(multigrid::Hierarchy& hierarchy, std::size_t l, const Parameters& parameters)
      : hierarchy_(hierarchy),
        level_(hierarchy.levels[l]),
        parameters_(parameters),
        tuning_(parameters.tuning),
        equations_(hierarchy, l),
        preconditioner_(equations_),
        u_(equations_.size()),
        minus_F_(u_.size()),
        d_(u_.size()) {}

  Result run(const Progress& progress) {
    multigrid::update_film(hierarchy_, level_);
    State state = judge(hierarchy_, level_);
    equations_.unknowns(u_);
    remember(state);
    if (core::max_abs(multigrid::pressure_on_bodies(level_)) == 0.0)
      return fail("no node carries pressure at the start");
    while (!good(state)) {
      const int taken = static_cast<int>(result_.steps.size());
      if (!std::isfinite(state.residual)) return fail("the residual is not finite");
      if (taken - best_step_ >= (best_measure_ < tuning_.near ? tuning_.patience_at_the_end : tuning_.patience)) {
        if (best_measure_ > parameters_.tolerance_of_rounding)
          return fail(fmt::format("no progress in the last {} steps", taken - best_step_));
        state = back_to_best();
        break;
      }
      if (taken >= parameters_.max_steps) return fail(fmt::format("after {} steps", taken));
      const std::string trouble = step(state);
      if (!trouble.empty()) return fail(trouble);
      state = judge(hierarchy_, level_);
      result_.steps.push_back({state.residual, iterations_});
      if (stalls_at_an_edge(taken) && multigrid::mark_chattering(hierarchy_.parameters.tuning, level_) > 0) {
        state = judge(hierarchy_, level_);
        best_.clear();  // the equations have changed
      }
      remember(state);
      if (progress && !progress(result_.steps.back())) throw core::Interrupted();
    }
    result_.equations_met = true;
    if (!(state.Hm > 0.0))
      return fail(
          fmt::format("the discrete film of this grid is not positive (minimum {:.2g}): use more cells", state.Hm));
    result_.converged = true;
    return std::move(result_);
  }

 private:
  bool stalls_at_an_edge(int taken) const {
    return best_measure_ > parameters_.tolerance_of_rounding && taken - best_step_ >= 2;
  }
  bool good(const State& state) const { return state.measure() <= parameters_.tolerance; }

  /// One Newton step from the given state, shortened if it changes P or H00 too much. out: the reason of a failure.
  std::string step(const State& state) {
    equations_.unknowns(u_);
    equations_.residual(u_, minus_F_);
    for (double& value : minus_F_) value = -value;
    equations_.linearize(u_);
    GmresResult solved;
    if (keep_factors_) solved = gmres(system_, minus_F_, linear_tolerance(state), d_);
    if (!solved.reduced) {  // no factors yet, or they are too old
      if (!preconditioner_.factor()) return "the preconditioner is singular";
      solved = gmres(system_, minus_F_, keep_factors_ ? tuning_.loose : linear_tolerance(state), d_);
      if (!solved.reduced) return "the linear solver does not converge";
      iterations_when_fresh_ = solved.iterations;
    }
    equations_.complete(minus_F_, d_);
    take_step(longest_shift(state.Hc));
    iterations_ = solved.iterations;
    keep_factors_ = last_change_ < tuning_.small_change && iterations_ <= iterations_when_fresh_;
    return "";
  }

  /// The linear tolerance is no tighter than what the last Newton step needs. Where the last step was small, the
  /// iteration converges, and the next system is solved accurately.
  double linear_tolerance(const State& state) const {
    if (!(last_change_ < tuning_.small_change)) return tuning_.loose;
    return std::clamp(tuning_.last_bit * parameters_.tolerance / state.residual, tuning_.tight, tuning_.loose);
  }

  // Where the surfaces touch, the film does not depend on how the oil and the contact share the pressure. There the
  // step limit acts on each node alone: what the oil's pressure may not change yet, that of the contact does. With
  // epsilon at half points this leads away from the solution of a smooth contact. [bench: boundary_film_step]
  void limit_split() {
    for (std::size_t k = 0; k < equations_.nodes(); ++k) {
      if (equations_.touch(k) != Equations::Touch::touches) continue;
      const double from = std::max(u_[k], 0.0), to = std::max(u_[k] + d_[k], 0.0);
      const double held = std::clamp(to, from - tuning_.longest_change, from + tuning_.longest_change);
      if (held == to) continue;
      d_[k] = held - u_[k];
      d_[equations_.nodes() + k] += to - held;
    }
  }

  void take_step(double most_shift) {
    double change = 0.0;
    if (!multigrid::at_half_points(level_)) limit_split();
    for (std::size_t k = 0; k < equations_.nodes(); ++k)
      change = std::max(change, std::abs(std::max(u_[k] + d_[k], 0.0) - std::max(u_[k], 0.0)));
    const double shift = std::abs(d_.back());
    double share = 1.0;
    if (change > tuning_.longest_change) share = tuning_.longest_change / change;
    if (shift * share > most_shift) share = most_shift / shift;
    for (std::size_t k = 0; k < u_.size(); ++k) u_[k] += share * d_[k];
    equations_.set_state(u_);
    last_change_ = share < 1.0 ? std::numeric_limits<double>::infinity() : change;
  }

  void remember(const State& state) {
    const double measure = state.measure();
    if (!best_.empty() && !(measure < best_measure_)) return;
    best_ = u_;
    best_measure_ = measure;
    best_step_ = static_cast<int>(result_.steps.size());
  }

  State back_to_best() {
    equations_.set_state(best_);
    return judge(hierarchy_, level_);
  }

  Result fail(const std::string& reason) {
    const State state = back_to_best();
    result_.reason = fmt::format("Newton's method: {}; relative residual {:.2g}, load error {:.2g} (required {:.2g})",
                                 reason, state.residual, state.load_error, parameters_.tolerance);
    return std::move(result_);
  }

  multigrid::Hierarchy& hierarchy_;
  multigrid::Level& level_;
  const Parameters& parameters_;
  const Tuning& tuning_;
  Equations equations_;
  Preconditioner preconditioner_;
  std::vector<double> u_, minus_F_, d_, best_;
  const LinearSystem system_{[this](auto v, auto Jv) { equations_.jacobian(v, Jv); },
                             [this](auto v) { preconditioner_.solve(v); }};
  Result result_;
  bool keep_factors_ = false;
  int iterations_ = 0;
  int iterations_when_fresh_ = 0;
  double last_change_ = std::numeric_limits<double>::infinity();
  double best_measure_ = std::numeric_limits<double>::infinity();
  int best_step_ = 0;
};

}  // namespace

// An absolute part, plus a share of the film.
double longest_shift(double Hc) { return 0.1 + 0.3 * std::abs(Hc); }

Result solve(multigrid::Hierarchy& hierarchy, std::size_t l, const Parameters& parameters, const Progress& progress) {
  const multigrid::Problem& problem = hierarchy.problem;
  if (!problem.load || !reynolds::ruptures(problem.cavitation) || problem.film.given_epsilon)
    throw core::InputError(
        "Newton's method needs the complete problem: a load to carry, cavitation, epsilon of the film");
  return NewtonIteration(hierarchy, l, parameters).run(progress);
}

}  // namespace ehl::newton
