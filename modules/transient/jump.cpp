#include "transient/jump.hpp"

namespace ehl::transient {
namespace {

/// Tolerance of the step in IDA's weighted norm: IDA's own value for its nonlinear solver.
constexpr double tolerance = 1.0 / 3.0;

}  // namespace

bool solve_euler_step(ContactDae& dae, const Drive& drive, EulerStep& step) {
  const auto slope = [&] {
    for (std::size_t n = 0; n < step.y.size(); ++n) step.yp[n] = (step.y[n] - step.old[n]) / step.length;
  };
  step.yp.resize(step.y.size());
  slope();
  std::vector<double> weights(step.y.size());
  std::vector<double> correction(step.y.size());
  dae.weights(step.y, weights);
  const StageResult result =
      dae.solve({step.T, 1.0 / step.length, step.y, step.yp, weights, tolerance}, drive, correction);
  step.cycles += result.cycles;
  step.newton_steps += result.newton_steps;
  if (!result.solved) return false;
  for (std::size_t n = 0; n < step.y.size(); ++n) step.y[n] += correction[n];
  slope();
  return true;
}

Drive part_of_the_way(const Drive& from, const Drive& to, double share) {
  const auto between = [share](double a, double b) { return a == b ? a : a + share * (b - a); };
  return {.load = from.load + share * (to.load - from.load),
          .speed = from.speed + share * (to.speed - from.speed),
          .supply = between(from.supply, to.supply),
          .sliding = from.sliding + share * (to.sliding - from.sliding),
          .radius = between(from.radius, to.radius)};
}

bool solve_step_across(ContactDae& dae, const Drive& from, const Drive& to, EulerStep& step) {
  double bit = 1.0;
  const double least_bit = dae.tuning().least_bit;
  for (double share = 0.0; share < 1.0;) {
    const double next = share + bit > 1.0 - 0.5 * least_bit ? 1.0 : share + bit;
    if (solve_euler_step(dae, part_of_the_way(from, to, next), step))
      share = next;
    else if (bit > least_bit)
      bit *= 0.5;
    else
      return false;
  }
  return true;
}

}  // namespace ehl::transient
