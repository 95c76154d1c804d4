#include "reynolds/far_field.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/errors.hpp"

namespace ehl::reynolds {
namespace {

/// Directions of the angular solution: its error is of second order, 1e-6 of f for a circle, 1e-4 at R_x/R_y = 20.
constexpr int directions = 4096;
constexpr double step = 2.0 * std::numbers::pi / directions;

/// The angular equation at the directions k = 0..directions, the X axis downstream at both ends, where the film is
/// ruptured: (g^3 f')' - 9 g^3 f = lambda s, multiplied by -step^2.
struct Angular {
  std::vector<double> beside;  ///< g^3 between k and k+1
  std::vector<double> own;     ///< diagonal
  std::vector<double> right;
};
Angular angular_equation(const FarFieldOf& of) {
  const auto gap = [&](double phi) { return of.gap.at(std::cos(phi), std::sin(phi)); };
  const auto cubed = [](double x) { return x * x * x; };
  Angular equation;
  for (int k = 0; k <= directions; ++k) equation.beside.push_back(cubed(gap((k + 0.5) * step)));
  for (int k = 0; k <= directions; ++k) {
    const double slope = 2.0 * of.gap.XX * std::cos(k * step) + of.gap.XY * std::sin(k * step);
    const double before = equation.beside[static_cast<std::size_t>(std::max(k - 1, 0))];
    equation.own.push_back(before + equation.beside[static_cast<std::size_t>(k)] +
                           9.0 * step * step * cubed(gap(k * step)));
    equation.right.push_back(-step * step * of.lambda * slope);
  }
  return equation;
}

/// Its solution on the directions that are wet, 0 on the others: elimination without pivoting, as the matrix is
/// diagonally dominant.
std::vector<double> solved_where_wet(const Angular& equation, const std::vector<bool>& wet) {
  const std::size_t n = wet.size();
  std::vector<double> share(n, 0.0);
  std::vector<double> f(n, 0.0);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    if (!wet[k]) continue;
    const double pivot = equation.own[k] - equation.beside[k - 1] * share[k - 1];
    share[k] = equation.beside[k] / pivot;
    f[k] = (equation.right[k] + equation.beside[k - 1] * f[k - 1]) / pivot;
  }
  for (std::size_t k = n - 1; k-- > 1;)
    if (wet[k]) f[k] += share[k] * f[k + 1];
  return f;
}

/// Complementarity by active sets: from all directions on, those that pull are taken out and those that press put back,
/// which ends, as the matrix is one of non-negative type.
std::vector<double> angular_solution(const FarFieldOf& of) {
  const Angular equation = angular_equation(of);
  std::vector<bool> wet(static_cast<std::size_t>(directions) + 1, true);
  for (int round = 0; round < directions; ++round) {
    const std::vector<double> f = solved_where_wet(equation, wet);
    bool changed = false;
    for (std::size_t k = 1; k < directions; ++k) {
      const double presses = equation.right[k] + equation.beside[k - 1] * f[k - 1] + equation.beside[k] * f[k + 1];
      const bool now = wet[k] ? f[k] > 0.0 : presses > 0.0;
      changed = changed || now != wet[k];
      wet[k] = now;
    }
    if (!changed) return f;
  }
  throw core::SolverError("the far field of this gap: the directions in which it is ruptured do not settle");
}

}  // namespace

FarField::FarField(const FarFieldOf& of) : of_(of), strength_(angular_solution(of)) {
  for (int k = 0; k <= directions; ++k) {
    const double g = of.gap.at(std::cos(k * step), std::sin(k * step));
    strength_[static_cast<std::size_t>(k)] *= g * g;
  }
}

double FarField::strength(double cosine, double sine) const {
  double phi = std::atan2(sine, cosine);
  if (phi < 0.0) phi += 2.0 * std::numbers::pi;
  const double at = phi / step;
  const int k = std::min(static_cast<int>(at), directions - 1);
  const double t = at - k;
  // A cubic through four directions: straight pieces would have kinks that a fine grid sees.
  const auto value = [&](int offset) {
    return strength_[static_cast<std::size_t>((k + offset + directions) % directions)];
  };
  return -t * (t - 1.0) * (t - 2.0) / 6.0 * value(-1) + (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0 * value(0) -
         (t + 1.0) * t * (t - 2.0) / 2.0 * value(1) + (t + 1.0) * t * (t - 1.0) / 6.0 * value(2);
}

double FarField::rupture_angle() const {
  int k = directions / 2;  // the X axis upstream
  while (k > 0 && strength_[static_cast<std::size_t>(k)] > 0.0) --k;
  return std::numbers::pi - k * step;
}

// q = integral of 1/eta_bar from 0 to P; from P = q on, Newton's steps, which stay below the solution's bound as 1/eta
// falls.
double FarField::pressure(double reduced) const {
  constexpr double close = 1e-12;
  constexpr int most_steps = 30;
  const auto fluidity = [&](double P) { return std::exp(-rheology::log_viscosity_at(of_.viscosity, P)); };
  double P = reduced;
  for (int k = 0; k < most_steps && reduced > 0.0; ++k) {
    const double q = boost::math::quadrature::gauss<double, 7>::integrate(fluidity, 0.0, P);
    const double change = (reduced - q) / fluidity(P);
    P += change;
    if (std::abs(change) < close * P) return P;
  }
  return reduced > 0.0 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
}

double FarField::P(double X, double Y, double H) const {
  const double r = std::hypot(X, Y);
  if (r == 0.0) return 0.0;
  const double f = strength(X / r, Y / r);
  return f > 0.0 ? pressure(f * r / (H * H)) : 0.0;
}

// In polar coordinates with u = 1/r: the integrand, P u^-3, is smooth and goes to f as u -> 0.
double FarField::load_outside(const core::Grid& domain, double H00) const {
  using Gauss = boost::math::quadrature::gauss<double, 15>;
  const auto along = [&](double phi) {
    const double c = std::cos(phi);
    const double s = std::sin(phi);
    const double to_x = (c > 0.0 ? domain.X_b : domain.X_a) / c;
    const double to_y = (s > 0.0 ? domain.Y_b : domain.Y_a) / s;
    const double f = strength(c, s);
    if (f <= 0.0) return 0.0;
    const double g = of_.gap.at(c, s);
    const auto outside = [&](double u) {
      const double H = H00 + g / (u * u) + of_.deformation * u;
      return pressure(f / (u * H * H)) / (u * u * u);
    };
    return Gauss::integrate(outside, 0.0, 1.0 / std::min(to_x, to_y));
  };
  // Panels between the corners, where the distance to the boundary has a kink, and the lines of rupture.
  std::vector<double> ends{0.0, 2.0 * std::numbers::pi};
  for (const double X : {domain.X_a, domain.X_b})
    for (const double Y : {domain.Y_a, domain.Y_b}) {
      const double phi = std::atan2(Y, X);
      ends.push_back(phi < 0.0 ? phi + 2.0 * std::numbers::pi : phi);
    }
  for (std::size_t k = 1; k < strength_.size(); ++k)
    if ((strength_[k] > 0.0) != (strength_[k - 1] > 0.0)) ends.push_back((static_cast<double>(k) - 0.5) * step);
  for (int k = 1; k < 4; ++k) ends.push_back(k * 0.5 * std::numbers::pi);
  std::ranges::sort(ends);
  double load = 0.0;
  for (std::size_t k = 1; k < ends.size(); ++k)
    if (ends[k] > ends[k - 1]) load += Gauss::integrate(along, ends[k - 1], ends[k]);
  return load;
}

}  // namespace ehl::reynolds
