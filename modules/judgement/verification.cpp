#include "judgement/verification.hpp"

#include <cmath>

#include "judgement/stopping.hpp"

namespace ehl::judgement {

Verification verification_of(const Tuning& tuning, const LastCycle& cycle) {
  const Measures& now = cycle.after;
  const auto change = [](double before, double after) { return std::abs((after - before) / after); };
  return {.residual = now.residual,
          .largest_residual = now.largest_residual,
          .largest_residual_X = now.largest_residual_X,
          .largest_residual_Y = now.largest_residual_Y,
          .least_P = now.least_P,
          .least_content = now.least_content,
          .dry_violation = now.dry_violation,
          .load_error = now.load_error,
          .change_Hc = change(cycle.before.Hc, now.Hc),
          .change_Hm = change(cycle.before.Hm, now.Hm),
          .algebraic_error_Hc = predicted_error(tuning, cycle, &Measures::Hc),
          .algebraic_error_Hm = predicted_error(tuning, cycle, &Measures::Hm),
          .Hm = now.Hm,
          .Hm_X = now.Hm_X,
          .Hm_Y = now.Hm_Y,
          .flow_through = now.flow_through,
          .flow_imbalance = now.flow_imbalance,
          .flow_imbalance_whole = now.flow_imbalance_whole};
}

}  // namespace ehl::judgement
