// One implicit step, solved by multigrid cycles; for line contacts by Newton's method if the cycles do not converge.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "multigrid/boundary.hpp"
#include "multigrid/cycle.hpp"
#include "multigrid/cycles.hpp"
#include "transient/contact_dae.hpp"
#include "transient/nodes.hpp"

namespace ehl::transient {
// Norm of the last change, in IDA's weights.
double ContactDae::change(const Stage& stage, double H00_before) {
  const multigrid::Level& level = hierarchy_.finest();
  const std::span<const double> weights = stage.weights;
  double sum = 0.0;
  for_nodes(level.grid, reversed_, [&](int i, int j, std::size_t k) {
    const double Q = content(i, j);
    const double dP = weights[k] * (level.P(i, j) - P_before_(i, j));
    const double dQ = weights[nodes_ + k] * (Q - Q_before_(i, j));
    sum += dP * dP + dQ * dQ;
    P_before_(i, j) = level.P(i, j);
    Q_before_(i, j) = Q;
  });
  const double dH00 = weights[2 * nodes_] * (hierarchy_.H00 - H00_before);
  sum += dH00 * dH00;
  if (course_.body) {
    const double dV = weights[2 * nodes_ + 1] * stage.cj * (hierarchy_.H00 - H00_before);
    sum += dV * dV;
  }
  return std::sqrt(sum / static_cast<double>(size()));
}

void ContactDae::cycle() {
  multigrid::fas_cycle(hierarchy_, hierarchy_.levels.size() - 1,
                       multigrid::cautious(hierarchy_.parameters, {.all = weight_}));
  multigrid::renew_boundary(hierarchy_, hierarchy_.finest());
}

// Sets the predicted state and the coefficients of the implicit step.
void ContactDae::begin(const Stage& stage, const Drive& drive) {
  multigrid::Level& level = hierarchy_.finest();
  set_state(stage.T, drive, stage.y_predicted);
  hierarchy_.transport.squeeze = stage.cj;
  take_motion(drive, -stage.yp_predicted[2 * nodes_]);
  hierarchy_.far_motion.slope = stage.cj;
  hierarchy_.far_motion.origin = hierarchy_.H00;
  multigrid::renew_load_outside(hierarchy_, level);
  if (course_.body) move_body(stage);
  set_known(stage);
  for_nodes(level.grid, [&](int i, int j, std::size_t) {
    P_before_(i, j) = level.P(i, j);
    Q_before_(i, j) = content(i, j);
  });
  hierarchy_.coarsest_weight = 1.0;
}

// The right-hand side of the implicit step.
void ContactDae::set_known(const Stage& stage) {
  multigrid::Level& level = hierarchy_.finest();
  for_nodes(level.grid, reversed_, [&](int i, int j, std::size_t k) {
    level.f(i, j) = stage.yp_predicted[nodes_ + k] - stage.cj * stage.y_predicted[nodes_ + k];
  });
  if (!control_.coupling) return;
  for_nodes(level.grid, [&](int i, int j, std::size_t) {
    level.f(i, j) += stage.cj * (stored_share_(i, j) - 1.0) * level.rho_bar(i, j) * level.H(i, j);
  });
}

bool ContactDae::newton_can() const {
  const multigrid::Level& level = hierarchy_.levels.back();
  return level.grid.domain.line && !conserves_mass() && level.load > 0.0;
}

// With a strong squeeze the load is corrected after the last cycle only: the common factor changes the film, times cj,
// by more than a cycle reduces. Line contacts are always treated so: the level of a
// half-plane's deformation is free, and H00 would oscillate.
bool ContactDae::balanced_by_cycle(const Stage& stage) const {
  return !hierarchy_.problem.geometry.kernel.plane && stage.cj < control_.tuning.strong_squeeze;
}

// measured: convergence factor; in: assumed for the first iteration, out: as last measured.
StageResult ContactDae::iterate(const Stage& stage, Iteration kind, double& measured) {
  multigrid::Level& level = hierarchy_.finest();
  StageResult result{.solved = false};
  const Tuning& tuning = control_.tuning;
  // Single cycles may fail while nodes cavitate or refill. While the pressure's edge moves by one node per step, no
  // Newton step reduces the change.
  const int patience = kind == Iteration::cycles ? tuning.patience : tuning.patience_of_newton;
  int& taken = kind == Iteration::cycles ? result.cycles : result.newton_steps;
  const bool balanced = kind == Iteration::cycles && balanced_by_cycle(stage);
  double last = std::numeric_limits<double>::quiet_NaN();
  double least = std::numeric_limits<double>::infinity();
  int in_vain = 0;
  while (!result.solved && taken < control_.most_cycles) {
    const double H00_before = hierarchy_.H00;
    ++taken;
    if (control_.coupling) renew_coupling(stage, taken);
    try {
      if (kind == Iteration::cycles)
        cycle();
      else if (!newton_->take())
        return result;
    } catch (const core::SolverError&) {
      return result;
    }
    if (balanced) balance_load();
    if (conserves_mass()) multigrid::update_residual(hierarchy_, level);
    const double now = change(stage, H00_before);
    if (!std::isfinite(now)) return result;
    if (taken > 1) measured = std::max(tuning.best_rate, now / last);
    in_vain = now > tuning.worst_rate * least ? in_vain + 1 : 0;
    if (in_vain >= patience && now > stage.tolerance) return result;
    const double rate = std::clamp(measured, taken == 1 ? tuning.best_first_rate : tuning.best_rate, tuning.worst_rate);
    result.solved = now * rate / (1.0 - rate) <= stage.tolerance;
    if (result.solved && !balanced) {
      const double H00_of_cycle = hierarchy_.H00;
      balance_load();
      if (conserves_mass()) multigrid::update_residual(hierarchy_, level);
      result.solved = change(stage, H00_of_cycle) <= stage.tolerance;
    }
    // If the oil balance cannot be closed, the cycles go on, and in the end the time step is cut.
    if (result.solved && conserves_mass()) result.solved = correct_mass();
    last = now;
    least = std::min(least, now);
  }
  if (!(core::minimum(level.H).value > 0.0)) result.solved = false;
  multigrid::renew_load_outside(hierarchy_, level);
  return result;
}

// What an effect on the coefficients changes from cycle to cycle. in: the number of this cycle. After the first few the
// factors stay, because those of a node at the edge of the film may chatter.
void ContactDae::renew_coupling(const Stage& stage, int cycle) {
  if (control_.coupling->in_cycles && cycle <= control_.tuning.patience) {
    multigrid::Level& level = hierarchy_.finest();
    take_factors(control_.coupling->respond(stage.T, level.P, level.H));
    multigrid::update_coefficients(hierarchy_, level);
  }
  set_known(stage);
}

// The effect responds to the solved state, and the step is solved again with its factors, until the state stays.
StageResult ContactDae::respond(const Stage& stage, Iteration kind, double& rate) {
  multigrid::Level& level = hierarchy_.finest();
  StageResult all{.solved = false};
  for (int pass = 0; pass < control_.tuning.patience; ++pass) {
    state(before_);
    take_factors(control_.coupling->respond(stage.T, level.P, level.H));
    multigrid::update_coefficients(hierarchy_, level);
    const StageResult again = iterate(stage, kind, rate);
    all.cycles += again.cycles;
    all.newton_steps += again.newton_steps;
    if (!again.solved) return all;
    state(now_);
    double sum = 0.0;
    for (std::size_t k = 0; k < now_.size(); ++k) {
      const double moved = stage.weights[k] * (now_[k] - before_[k]);
      sum += moved * moved;
    }
    all.solved = std::sqrt(sum / static_cast<double>(size())) <= stage.tolerance;
    if (all.solved) return all;
  }
  return all;
}

// A state that the cycles cannot treat, such as a film outside the range of the closed far field, calls for a shorter
// step.
StageResult ContactDae::attempt(const Stage& stage, const Drive& drive, std::span<double> correction) {
  StageResult result{.solved = false};
  try {
    result = solved(stage, drive, correction);
  } catch (const core::SolverError&) {
    result = {.solved = false};
  }
  hierarchy_.outside_line = {};
  return result;
}

// Without Newton's method cycles that diverge are damped, as at the start. The following steps keep what has helped.
StageResult ContactDae::solve(const Stage& stage, const Drive& drive, std::span<double> correction) {
  const StageResult first = attempt(stage, drive, correction);
  const multigrid::Tuning& damping = hierarchy_.parameters.tuning;
  const double before = weight_, damped = damping.back_off * weight_;
  if (first.solved || newton_can() || damped < damping.least_all) return first;
  weight_ = damped;
  StageResult second = attempt(stage, drive, correction);
  second.cycles += first.cycles;
  if (!second.solved) weight_ = before;
  return second;
}

StageResult ContactDae::solved(const Stage& stage, const Drive& drive, std::span<double> correction) {
  begin(stage, drive);
  StageResult result{.solved = false};
  if (newton_stages_ == 0) {
    result = iterate(stage, Iteration::cycles, rate_);
    if (result.solved) newton_next_ = 1;
  }
  if (!result.solved && newton_can()) {
    if (newton_stages_ == 0) {
      begin(stage, drive);
      // Newton's method solves a number of implicit steps before cycles are tried again. The number doubles with each
      // failure of the cycles.
      newton_stages_ = std::exchange(newton_next_, std::min(control_.tuning.most_by_newton, 2 * newton_next_));
    } else {
      --newton_stages_;
    }
    if (!newton_) newton_ = std::make_unique<newton::Steps>(hierarchy_, control_.newton);
    double rate = control_.tuning.best_first_rate;
    const int cycles = result.cycles;
    result = iterate(stage, Iteration::newton, rate);
    result.cycles = cycles;
  }
  if (result.solved && control_.coupling && !control_.coupling->in_cycles) {
    double rate = rate_;
    const StageResult again = respond(stage, result.newton_steps > 0 ? Iteration::newton : Iteration::cycles, rate);
    result = {again.solved, result.cycles + again.cycles, result.newton_steps + again.newton_steps};
  }
  if (!result.solved) return result;
  if (course_.body) take_velocity(stage, drive);
  count_oil(stage);
  state(correction);
  for (std::size_t k = 0; k < correction.size(); ++k) correction[k] -= stage.y_predicted[k];
  return result;
}

}  // namespace ehl::transient
