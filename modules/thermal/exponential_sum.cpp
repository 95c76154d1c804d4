#include "thermal/exponential_sum.hpp"

#include <cmath>
#include <numbers>

namespace ehl::thermal {

// s = exp(y - exp(-y))/sqrt(longest): close to a logarithmic variable for large y.
ExponentialSum inverse_root(double shortest, double longest) {
  constexpr double step = 0.26, before = 2.8, beyond = 1.3;  // the ends of y leave out less than the step does
  ExponentialSum sum;
  const int last = static_cast<int>(std::floor((0.5 * std::log(longest / shortest) + beyond) / step));
  for (int k = static_cast<int>(std::ceil(-before / step)); k <= last; ++k) {
    const double y = step * k, e = std::exp(-y), s = std::exp(y - e) / std::sqrt(longest);
    sum.rate.push_back(s * s);
    sum.weight.push_back(2.0 / std::sqrt(std::numbers::pi) * step * s * (1.0 + e));
  }
  return sum;
}

}  // namespace ehl::thermal
