#include "reynolds/far_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/errors.hpp"
#include "reynolds/gauss_points.hpp"

namespace ehl::reynolds {
namespace {

/// Directions of the angular solution, whose error is of second order. [bench: far_field_directions] The first solution
/// uses few of them: from a start with all directions wet the lines of rupture move by hardly more than one direction
/// per iteration.
constexpr int directions = 4096;
constexpr int first_directions = 64;
constexpr double step = 2.0 * std::numbers::pi / directions;

/// Effect of an approach that falls as 1/r, over that of a uniform one: f_2/f_1, where q = r^-5 f_2 and (g^3 f_2')' - 5
/// g^3 f_2 is the left-hand side. The value is that of a circle without rupture, and approximately that of ellipses.
constexpr double yielding = 8.0 / 5.0;

/// The angular equation at the directions k = 0..n, with the downstream X axis, where the film is ruptured, at both
/// ends: (g^3 f')' - power g^3 f = -source, multiplied by the square of the step.
struct Angular {
  std::vector<double> beside;  ///< g^3 between k and k+1
  std::vector<double> own;     ///< diagonal
  std::vector<double> right;
};
template <class Source>
Angular angular_equation(const core::QuadraticForm& gap, int n, double power, Source source) {
  const double width = 2.0 * std::numbers::pi / n;
  const auto g3 = [&](double k) {
    const double g = gap.at(std::cos(k * width), std::sin(k * width));
    return g * g * g;
  };
  Angular equation;
  for (int k = 0; k <= n; ++k) equation.beside.push_back(g3(k + 0.5));
  for (int k = 0; k <= n; ++k) {
    const double before = equation.beside[static_cast<std::size_t>(std::max(k - 1, 0))];
    equation.own.push_back(before + equation.beside[static_cast<std::size_t>(k)] + power * width * width * g3(k));
    equation.right.push_back(width * width * source(k * width));
  }
  return equation;
}

/// Solution on the wet directions, 0 on the others. Elimination without pivoting: the matrix is diagonally dominant.
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

/// Complementarity by an active set method: wet directions with f <= 0 become ruptured, and ruptured ones with a
/// positive source become wet. It ends since the matrix is an M-matrix. in: an estimate of the wet directions. out: the
/// wet directions, and f.
std::vector<double> solved_with_rupture(const Angular& equation, std::vector<bool>& wet) {
  for (std::size_t round = 0; round < wet.size(); ++round) {
    std::vector<double> f = solved_where_wet(equation, wet);
    bool changed = false;
    for (std::size_t k = 1; k + 1 < wet.size(); ++k) {
      const double presses = equation.right[k] + equation.beside[k - 1] * f[k - 1] + equation.beside[k] * f[k + 1];
      const bool now = wet[k] ? f[k] > 0.0 : presses > 0.0;
      changed = changed || now != wet[k];
      wet[k] = now;
    }
    if (!changed) return f;
  }
  throw core::SolverError("the far field of this gap: the directions of rupture do not converge");
}

}  // namespace

FarField::FarField(const FarFieldOf& of) : of_(of), pressure_(of.viscosity) {
  if (line()) return;
  const auto& [XX, XY, YY] = of.gap;
  const double trace = XX + YY;
  const double b = 0.5 * XY;
  const double scale = of.lambda / ((XX + 2.0 * trace) * (YY + 2.0 * trace) - b * b);
  k_X_ = scale * ((YY + 2.0 * trace) * XX - b * b);
  k_Y_ = scale * ((XX + 2.0 * trace) * b - b * XX);
  c_ = of.lambda / (4.0 * trace);
  const auto diverging = [&](double phi) { return 2.0 * of.gap.XX * std::cos(phi) + of.gap.XY * std::sin(phi); };
  std::vector<bool> wet(static_cast<std::size_t>(first_directions) + 1, true);
  for (int n = first_directions;; n *= 4) {
    wedge_ = solved_with_rupture(
        angular_equation(of.gap, n, 9.0, [&](double phi) { return -of.lambda * diverging(phi); }), wet);
    if (n == directions) break;
    std::vector<bool> finer;
    for (int k = 0; k <= 4 * n; ++k) finer.push_back(wet[static_cast<std::size_t>((k + 2) / 4)]);
    wet = finer;
  }
  squeeze_ = solved_where_wet(angular_equation(of.gap, directions, 8.0, [&](double) { return of.lambda; }), wet);
  for (int k = 0; k <= directions; ++k) {
    const double g = of.gap.at(std::cos(k * step), std::sin(k * step));
    wedge_[static_cast<std::size_t>(k)] *= g * g;
    squeeze_[static_cast<std::size_t>(k)] *= g * g;
  }
  if (of.domain.X_a < of.domain.X_b) make_stations(of.domain);
}

FarPoint FarField::toward(double cosine, double sine) const {
  double phi = std::atan2(sine, cosine);
  if (phi < 0.0) phi += 2.0 * std::numbers::pi;
  const double at = phi / step;
  const int k = std::min(static_cast<int>(at), directions - 1);
  const double t = at - k;
  // A cubic through four directions: linear interpolation has kinks that a fine grid resolves.
  const double weights[] = {-t * (t - 1.0) * (t - 2.0) / 6.0, (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
                            -(t + 1.0) * t * (t - 2.0) / 2.0, (t + 1.0) * t * (t - 1.0) / 6.0};
  FarPoint point{.unruptured = -(k_X_ * cosine + k_Y_ * sine)};
  for (int n = 0; n < 4; ++n) {
    const auto direction = static_cast<std::size_t>((k + n - 1 + directions) % directions);
    point.wedge += weights[n] * wedge_[direction];
    point.squeeze += weights[n] * squeeze_[direction];
  }
  return point;
}

FarPoint FarField::at(double X, double Y) const {
  if (line()) return {.X = X};
  const double r = std::hypot(X, Y);
  if (r == 0.0) return {};  // no direction; the pressure of the wedge vanishes with r
  FarPoint point = toward(X / r, Y / r);
  point.wedge *= r;
  point.unruptured *= r;
  point.yielding = yielding * (of_.deformation / r + by_coatings(r));
  return point;
}

// The solutions without rupture, plus what rupture adds to that of the wedge and takes from that of the squeeze. While
// the bodies approach each other the correction by rupture is a^2/(a + b) = a - b + b^2/a - ..., which is never
// negative.
double FarField::P(const FarPoint& point, double H, const FarState& state) const {
  if (line()) return P_of_line(point.X, H, state);
  const double approach = state.approach - point.yielding * state.load_rate;
  double q_H2 = state.speed * point.wedge + approach * point.squeeze;
  if (approach > 0.0) {
    const double a = state.speed * std::max(point.wedge - point.unruptured, 0.0);
    const double b = approach * std::max(c_ - point.squeeze, 0.0);
    q_H2 = state.speed * point.unruptured + approach * c_ + (a > 0.0 ? a * a / (a + b) : 0.0);
  }
  return q_H2 > 0.0 ? pressure_.P(q_H2 / (H * H)) : 0.0;
}

// With u = X/s, s upstream of X, the integrand is smooth and goes as u^2 for u -> 0.
double FarField::P_of_line(double X, double H, const FarState& state) const {
  if (X >= 0.0) return 0.0;
  static const auto rule = gauss_points<10>();
  const double deformation = state.load * of_.deformation;
  double q = 0.0;
  for (const auto& [u, weight] : rule) {
    const double film = H + of_.gap.XX * X * X * (1.0 / (u * u) - 1.0) + deformation * std::log(u) +
                        state.load * (by_coatings(-X / u) - by_coatings(-X));
    q += weight * (film - state.flow) / (film * film * film * u * u);
  }
  q *= -of_.lambda * state.speed * X;
  return q > 0.0 ? pressure_.P(q) : 0.0;
}

double FarField::load_outside_of_line(const FarState& state) const {
  static const auto rule = gauss_points<10>();
  double load = 0.0;
  for (const auto& [u, weight] : rule) {
    const double X = of_.domain.X_a / u;
    const double H =
        state.H00 + of_.gap.XX * X * X - state.load * of_.deformation * std::log(-X) + state.load * by_coatings(-X);
    load -= weight * P_of_line(X, H, state) * X / u;
  }
  return load;
}

double FarField::rupture_angle() const {
  int k = directions / 2;  // the X axis upstream
  while (k > 0 && wedge_[static_cast<std::size_t>(k)] > 0.0) --k;
  return std::numbers::pi - k * step;
}

// In polar coordinates with u = 1/r: the integrand, P u^-3, is smooth and tends to f as u -> 0. The panels end at the
// corners of the domain, where the distance to the boundary has a kink, at the axes, and at the lines of rupture.
void FarField::make_stations(const core::Grid& domain) {
  std::vector<double> ends{0.0, 2.0 * std::numbers::pi};
  for (const double X : {domain.X_a, domain.X_b})
    for (const double Y : {domain.Y_a, domain.Y_b}) {
      const double phi = std::atan2(Y, X);
      ends.push_back(phi < 0.0 ? phi + 2.0 * std::numbers::pi : phi);
    }
  for (std::size_t k = 1; k < wedge_.size(); ++k)
    if ((wedge_[k] > 0.0) != (wedge_[k - 1] > 0.0)) ends.push_back((static_cast<double>(k) - 0.5) * step);
  for (int k = 1; k < 4; ++k) ends.push_back(k * 0.5 * std::numbers::pi);
  std::ranges::sort(ends);
  const auto around = gauss_points<10>();
  const auto along = gauss_points<7>();
  const bool symmetric = !of_.gap.oblique() && domain.Y_a == -domain.Y_b;
  const double times = symmetric ? 2.0 : 1.0;
  for (std::size_t k = 1; k < ends.size(); ++k)
    for (const auto& [part, angle_weight] : around) {
      if (symmetric && ends[k - 1] >= std::numbers::pi * (1.0 - 1e-12)) break;
      const double width = ends[k] - ends[k - 1];
      const double phi = ends[k - 1] + width * part;
      const double c = std::cos(phi);
      const double s = std::sin(phi);
      const double to_x = (c > 0.0 ? domain.X_b : domain.X_a) / c;
      const double to_y = (s > 0.0 ? domain.Y_b : domain.Y_a) / s;
      const double nearest = 1.0 / std::min(to_x, to_y);
      const FarPoint direction = toward(c, s);
      for (const auto& [share, weight] : along) {
        const double u = nearest * share;
        const double deformation = of_.deformation * u + by_coatings(1.0 / u);
        stations_.push_back(
            {.point = {direction.wedge / u, direction.squeeze, direction.unruptured / u, yielding * deformation},
             .gap = of_.gap.at(c, s) / (u * u),
             .deformation = deformation,
             .weight = times * width * angle_weight * nearest * weight / (u * u * u)});
      }
    }
}

double FarField::load_outside(const FarState& state) const {
  if (line()) return load_outside_of_line(state);
  double load = 0.0;
  for (const Station& station : stations_)
    load += station.weight * P(station.point, state.H00 + station.gap + state.load * station.deformation, state);
  return load;
}

}  // namespace ehl::reynolds
