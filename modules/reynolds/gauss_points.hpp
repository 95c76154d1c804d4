#pragma once
// Gauss' rule for integrals of the far field.
#include <boost/math/quadrature/gauss.hpp>
#include <cstddef>
#include <utility>
#include <vector>

namespace ehl::reynolds {

/// Points and weights of Gauss' rule on (0, 1).
template <unsigned points>
std::vector<std::pair<double, double>> gauss_points() {
  using Rule = boost::math::quadrature::gauss<double, points>;
  std::vector<std::pair<double, double>> rule;
  for (std::size_t k = 0; k < Rule::abscissa().size(); ++k)
    for (const double sign : {-1.0, 1.0})
      if (sign > 0.0 || Rule::abscissa()[k] > 0.0)
        rule.emplace_back(0.5 * (1.0 + sign * Rule::abscissa()[k]), 0.5 * Rule::weights()[k]);
  return rule;
}

}  // namespace ehl::reynolds
