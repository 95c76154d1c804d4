#include "reynolds/reduced_pressure.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>

namespace ehl::reynolds {
namespace {

/// Intervals of the table, P = (k/intervals)^2: finer where pressures far away are.
constexpr int intervals = 400;
/// Where q rises by a smaller share from knot to knot, P is anything.
constexpr double hardly = 1e-6;

}  // namespace

ReducedPressure::ReducedPressure(const rheology::ViscosityLaw& viscosity) {
  if (std::holds_alternative<rheology::Isoviscous>(viscosity)) return;
  const auto fluidity = [&](double P) { return std::exp(-rheology::log_viscosity_at(viscosity, P)); };
  knots_.push_back({0.0, 0.0, 1.0 / fluidity(0.0)});
  for (int k = 1; k <= intervals; ++k) {
    const double P = static_cast<double>(k) * k / (intervals * intervals);
    const Knot& last = knots_.back();
    const double rise = boost::math::quadrature::gauss<double, 7>::integrate(fluidity, last.P, P);
    if (!(rise > hardly * last.q)) break;
    knots_.push_back({last.q + rise, P, 1.0 / fluidity(P)});
  }
}

double ReducedPressure::P(double q) const {
  if (knots_.empty()) return q;
  // P is not below q: that knot is not above the one wanted, and far away it is the one.
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
