#pragma once
// The kernel 1/sqrt(t) as a sum of exponentials, so that a convolution with it becomes a recursion in time.
#include <vector>

namespace ehl::thermal {

/// sum of weight exp(-rate t).
struct ExponentialSum {
  std::vector<double> rate{}, weight{};
};

/// 1/sqrt(t) for shortest <= t <= longest, with a relative error of at most 1e-6. For shorter t the sum is bounded and
/// too small. in: 0 < shortest < longest. cost: about nine terms per decade of longest/shortest.
/// source: the trapezoidal rule for 1/sqrt(t) = 2/sqrt(pi) int exp(-t s^2) ds in a variable in which the integrand
/// falls double exponentially at both ends.
ExponentialSum inverse_root(double shortest, double longest);

}  // namespace ehl::thermal
