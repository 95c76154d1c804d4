#include "reynolds/reduced_pressure.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>

namespace ehl::reynolds {
namespace {

/// Intervals of the table, P = (k/intervals)^2: finer at the low pressures far from the contact.
constexpr int intervals = 400;
/// Where q rises by a smaller share from knot to knot, it does not determine P any more.
constexpr double hardly = 1e-6;

}  // namespace

// Some intervals at once, since the law is faster for many pressures than for one after the other. A first call of the
// quadrature rule collects its pressures, a second one gets their fluidities.
ReducedPressure::ReducedPressure(const rheology::ViscosityLaw& viscosity) {
  if (std::holds_alternative<rheology::Isoviscous>(viscosity)) return;
  using Rule = boost::math::quadrature::gauss<double, 7>;
  constexpr int at_once = 25;
  static_assert(intervals % at_once == 0);
  const auto knot = [](int k) { return static_cast<double>(k) * k / (intervals * intervals); };
  std::vector<double> P, fluidity;
  knots_.push_back({0.0, 0.0, 1.0 / std::exp(-rheology::log_viscosity_at(viscosity, 0.0))});
  for (int first = 1; first <= intervals; first += at_once) {
    P.clear();
    for (int k = first; k < first + at_once; ++k) {
      Rule::integrate([&](double p) { return P.push_back(p), 0.0; }, knot(k - 1), knot(k));
      P.push_back(knot(k));
    }
    fluidity.resize(P.size());
    rheology::log_viscosity(viscosity, P, fluidity);
    for (double& value : fluidity) value = std::exp(-value);
    auto next = fluidity.begin();
    for (int k = first; k < first + at_once; ++k) {
      const double rise = Rule::integrate([&](double) { return *next++; }, knot(k - 1), knot(k));
      const double q = knots_.back().q;
      if (!(rise > hardly * q)) return;
      knots_.push_back({q + rise, knot(k), 1.0 / *next++});
    }
  }
}

double ReducedPressure::P(double q) const {
  if (knots_.empty()) return q;
  // P >= q, so this knot is not above the one that is wanted; far from the contact it is that one.
  auto k = static_cast<std::size_t>(intervals * std::sqrt(std::max(q, 0.0)));
  while (k + 1 < knots_.size() && knots_[k + 1].q <= q) ++k;
  if (k + 1 >= knots_.size()) return std::numeric_limits<double>::quiet_NaN();
  const Knot& a = knots_[k];
  const Knot& b = knots_[k + 1];
  const double step = b.q - a.q;
  const double t = (q - a.q) / step;
  const double s = 1.0 - t;
  return s * s * (1.0 + 2.0 * t) * a.P + t * t * (1.0 + 2.0 * s) * b.P + s * t * step * (s * a.slope - t * b.slope);
}

}  // namespace ehl::reynolds
