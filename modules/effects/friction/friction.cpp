#include "effects/friction/friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/timer.hpp"

namespace ehl::friction {
namespace {

/// Of the load, from which on a stress that no lubricant carries is worth a warning.
constexpr double worth_a_warning = 0.01;

// Weight of a node in the trapezoidal rule, without hx hy.
double weight(const core::Grid& grid, int i, int j) {
  return (i == 0 || i == grid.nx ? 0.5 : 1.0) * (j == 0 || j == grid.ny ? 0.5 : 1.0);
}

// Share of the width that holds oil, where P = 0. film_at_end: of the line's last node with P > 0 upstream; 0: none,
// the oil has not been in the contact yet.
double filled(Cavitated cavitated, double H, double film_at_end) {
  if (cavitated == Cavitated::none) return 0.0;
  if (cavitated == Cavitated::full || film_at_end == 0.0) return 1.0;
  return std::min(1.0, film_at_end / H);
}

// dP/dX at a node.
double slope_of_P(const Film& film, int i, int j) {
  const int west = std::max(i - 1, 0), east = std::min(i + 1, film.grid.nx);
  return (film.P(east, j) - film.P(west, j)) / ((east - west) * film.grid.hx());
}

// 1/eta_y of every node of one station.
struct Fluidity {
  explicit Fluidity(std::size_t nodes) : at_rest(nodes), along(nodes), across(nodes) {}
  void evaluate(const Film& film, int i) {
    rheology::fluidity(film.viscosity, film.P.station(i), at_rest);
    if (film.I0)
      for (std::size_t j = 0; j < at_rest.size(); ++j) at_rest[j] *= (*film.I0)(i, static_cast<int>(j));
    if (film.thinning) rheology::film_fluidity(*film.thinning, film.H.station(i), at_rest, along, across);
  }
  double operator()(const Film& film, int j) const {
    return (film.thinning ? across : at_rest)[static_cast<std::size_t>(j)];
  }
  std::vector<double> at_rest, along, across;
};

// Integral of (H/2) dP/dX, X = X_a/u, to u = 0 by Simpson's rule. The load of the contact bends the bodies by
// -ln|X|/2.
double rolling_upstream(const Film& film) {
  constexpr int parts = 64;
  const double X_a = film.grid.X_a, lambda = film.upstream->lambda;
  double sum = -lambda / X_a;
  for (int k = 1; k <= parts; ++k) {
    const double u = static_cast<double>(k) / parts;
    const double H = film.H(0, 1) + 0.5 * (X_a * X_a * (1.0 / (u * u) - 1.0) + std::log(u));
    const double integrand = -0.5 * lambda * X_a * (H - film.upstream->flow) / (H * H * u * u);
    sum += (k == parts ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) * integrand;
  }
  return sum / (3.0 * parts);
}

// Integral of -(h/2) dp/dy, in p_h times cells.
double side_force(const Film& film, double slope) {
  const core::Grid& grid = film.grid;
  double sum = 0.0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j < grid.ny; ++j)
      sum -= (i == 0 || i == grid.nx ? 0.5 : 1.0) * 0.25 * slope * (film.H(i, j) + film.H(i, j + 1)) *
             (film.P(i, j + 1) - film.P(i, j)) / grid.hy();
  return sum;
}

}  // namespace

Friction friction_of(const Film& film, const Parameters& parameters) {
  const double began = core::now();
  const core::Grid& grid = film.grid;
  Friction result{.parameters = parameters, .thinned = film.thinning.has_value()};
  if (parameters.keep_tau1) result.tau1 = core::Field(grid);
  if (parameters.keep_tau2) result.tau2 = core::Field(grid);
  const auto nodes = static_cast<std::size_t>(grid.nodes_y());
  Fluidity fluidity(nodes);
  std::vector<double> film_at_end(nodes, 0.0);
  double load = 0.0, limited_load = 0.0, unlikely_load = 0.0;
  for (int i = 0; i <= grid.nx; ++i) {
    fluidity.evaluate(film, i);
    for (int j = 0; j <= grid.ny; ++j) {
      const double P = film.P(i, j), H = film.H(i, j), w = weight(grid, i, j);
      const bool wet = P > 0.0;
      double& end = film_at_end[static_cast<std::size_t>(j)];
      if (wet) end = H;
      const double share = wet ? 1.0 : filled(parameters.cavitated, H, end);
      double tau = share > 0.0 && parameters.stress != 0.0 ? parameters.stress / (H * fluidity(film, j)) : 0.0;
      if (wet && film.less_tau) tau *= (*film.less_tau)(i, j);
      if (wet) {
        load += w * P;
        if (std::abs(tau) > largest_limit * P) unlikely_load += w * P;
        if (std::abs(tau) > parameters.limit * P) limited_load += w * P;
        tau = rheology::limited(tau, parameters.limit * P);
        result.largest_stress = std::max(result.largest_stress, std::abs(tau));
      } else {
        tau *= share;
        result.cavitated += w * tau;
      }
      result.sliding += w * tau;
      const double rolling = 0.5 * parameters.slope * H * slope_of_P(film, i, j);
      if (parameters.keep_tau1) result.tau1(i, j) = -tau - rolling;
      if (parameters.keep_tau2) result.tau2(i, j) = tau - rolling;
      if (i < grid.nx) {
        const double part = w / (i == 0 ? 0.5 : 1.0) * 0.25 * parameters.slope * (H + film.H(i + 1, j)) *
                            (film.P(i + 1, j) - P) / grid.hx();
        result.rolling += part;
        if (grid.X(i) < parameters.outer_X) result.outer += part;
      }
    }
  }
  if (film.upstream) result.upstream = parameters.slope * rolling_upstream(film) * grid.ny / grid.hx();
  result.rolling += result.upstream;
  if (parameters.aslant) result.side = side_force(film, parameters.slope);
  for (double* part :
       {&result.sliding, &result.rolling, &result.cavitated, &result.upstream, &result.outer, &result.side})
    *part /= load;
  result.limited_share = limited_load / load;
  result.unlikely_share = unlikely_load / load;
  result.on_1 = -(result.sliding + result.rolling);
  result.on_2 = result.sliding - result.rolling;
  result.seconds = core::now() - began;
  return result;
}

std::vector<std::string> warnings(const Friction& friction) {
  if (friction.unlikely_share < worth_a_warning || friction.parameters.limit <= largest_limit) return {};
  return {fmt::format(
      "friction: on {:.0f} % of the load the shear stress is above {:.2f} p, which no lubricant carries: {}",
      100.0 * friction.unlikely_share, largest_limit,
      friction.thinned ? "check the shear law, or give [friction] limit"
                       : "a Newtonian oil does not describe this friction: give [shear] law, or [friction] limit")};
}

}  // namespace ehl::friction
