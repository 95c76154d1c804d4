#include "newton/steps.hpp"

#include <algorithm>
#include <cmath>

#include "judgement/measures.hpp"
#include "multigrid/boundary.hpp"
#include "newton/gmres.hpp"
#include "newton/solve.hpp"

namespace ehl::newton {
Steps::Steps(multigrid::Hierarchy& hierarchy, const Tuning& tuning)
    : hierarchy_(hierarchy),
      tuning_(tuning),
      equations_(hierarchy, hierarchy.levels.size() - 1),
      preconditioner_(equations_, Preconditioner::Precision::single, Preconditioner::any_size),
      u_(equations_.size()),
      minus_F_(u_.size()),
      change_(u_.size()) {}

bool Steps::factor() {
  scale_of_factors_.clear();
  if (!preconditioner_.factor()) return false;
  scale_of_factors_.resize(u_.size() - 1);
  for (std::size_t k = 0; k < scale_of_factors_.size(); ++k) scale_of_factors_[k] = equations_.scale(k);
  return true;
}

// Rescales the rows: those of older factors have another scale.
void Steps::precondition(std::span<double> v) {
  for (std::size_t k = 0; k < scale_of_factors_.size(); ++k)
    if (equations_.wet(k)) v[k] *= scale_of_factors_[k] / equations_.scale(k);
  preconditioner_.solve(v);
}

bool Steps::take() {
  equations_.unknowns(u_);
  equations_.residual(u_, minus_F_);
  for (double& value : minus_F_) value = -value;
  equations_.linearize(u_);
  const LinearSystem system{[this](auto v, auto Jv) { equations_.jacobian(v, Jv); },
                            [this](auto v) { precondition(v); }};
  GmresResult solved;
  if (!scale_of_factors_.empty()) {
    solved = gmres(system, minus_F_, tuning_.step_tolerance, change_);
    if (!solved.reached || solved.iterations > tuning_.step_worn_out)
      scale_of_factors_.clear();  // new factors now or in the next step
  }
  if (!solved.reached) {
    if (!factor()) return false;
    solved = gmres(system, minus_F_, tuning_.step_tolerance, change_);
    if (!solved.reduced) return false;
  }
  apply();
  return true;
}

void Steps::apply() {
  const multigrid::Level& level = equations_.level();
  double largest = 0.0;
  for (std::size_t k = 0; k + 1 < u_.size(); ++k)
    largest = std::max(largest, std::abs(std::max(u_[k] + change_[k], 0.0) - std::max(u_[k], 0.0)));
  const double Hc = judgement::value_at(level.grid, level.H, 0.0, 0.0);
  const double shift = std::abs(change_.back());
  const double most_shift = longest_shift(Hc);
  double share = 1.0;
  if (largest > tuning_.longest_change) share = tuning_.longest_change / largest;
  if (shift * share > most_shift) share = most_shift / shift;
  for (std::size_t k = 0; k < u_.size(); ++k) u_[k] += share * change_[k];
  equations_.set_state(u_);
  multigrid::renew_boundary(hierarchy_, hierarchy_.finest());
}

}  // namespace ehl::newton
