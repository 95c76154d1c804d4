#include "thermal/moving_source.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <utility>

namespace ehl::thermal {
namespace {

// Beyond this argument erf is 1 to rounding.
constexpr double end_of_erf = 5.9;

// A of the cells first..last at one s: half the difference of erf between the edges of a cell, displaced by `shift`.
struct Shares {
  int first = 0, last = -1;  // outside, A is below rounding
  std::vector<double> A{};   // of first..last; A[0] belongs to first
};

void shares(double h, double s, double shift, int least, int most, Shares& out) {
  const double reach = end_of_erf * 2.0 * s;
  out.first = static_cast<int>(std::max<double>(least, std::floor((shift - reach) / h - 0.5)));
  out.last = static_cast<int>(std::min<double>(most, std::ceil((shift + reach) / h + 0.5)));
  double left = std::erf(((out.first - 0.5) * h - shift) / (2.0 * s));
  for (int d = out.first; d <= out.last; ++d) {
    const double right = std::erf(((d + 0.5) * h - shift) / (2.0 * s));
    out.A[static_cast<std::size_t>(d - out.first)] = 0.5 * (right - left);
    left = right;
  }
}

struct Range {
  double begin, end;
};

// Panels of s on which the Gauss rule with ten points is accurate enough. They grow with s, but the edge of the moving
// cell must not pass a diffusion length within a panel: 2 s in place, 1/Pe in s.
Range next_panel(double s, double h, double Pe) {
  const double of_motion = Pe > 0.0 ? 2.0 / Pe : INFINITY;
  if (s == 0.0) return {0.0, std::min({h / 24.0, Pe > 0.0 ? std::sqrt(h / (8.0 * Pe)) : INFINITY, of_motion})};
  return {s, s + std::min(0.5 * s, of_motion)};
}

}  // namespace

SourceTable moving_source_table(int n_x, int n_y, double hx, double hy, double Pe) {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  SourceTable table{n_x, n_y,
                    std::vector<double>(static_cast<std::size_t>(2 * n_x + 1) * static_cast<std::size_t>(n_y + 1))};
  Shares along{.A = std::vector<double>(static_cast<std::size_t>(2 * n_x + 1))};
  Shares beside{.A = std::vector<double>(static_cast<std::size_t>(n_y + 1))};
  const double length = (n_x + 1) * hx, width = (n_y + 1) * hy, h = std::min(hx, hy);
  const auto add = [&](double s, double weight) {
    shares(hx, s, Pe * s * s, -n_x, n_x, along);
    shares(hy, s, 0.0, 0, n_y, beside);
    for (int d = along.first; d <= along.last; ++d) {
      const double factor = weight * along.A[static_cast<std::size_t>(d - along.first)];
      double* row = &table.G[table.at(d, beside.first)];
      for (int k = 0; k <= beside.last - beside.first; ++k) row[k] += factor * beside.A[static_cast<std::size_t>(k)];
    }
  };
  // Until the last cell has been passed or, at rest, until the remainder is known in closed form.
  const double at_rest = 1e6 * std::max(length, width);
  double s = 0.0;
  while (s < at_rest && Pe * s * s < length + 2.0 * end_of_erf * s) {
    const Range panel = next_panel(s, h, Pe);
    const double centre = 0.5 * (panel.begin + panel.end), half = 0.5 * (panel.end - panel.begin);
    for (std::size_t k = 0; k < 5; ++k)
      for (const double side : {-1.0, 1.0})
        add(centre + side * half * Gauss::abscissa()[k],
            2.0 / std::sqrt(std::numbers::pi) * half * Gauss::weights()[k]);
    s = panel.end;
  }
  // Remainder: A_x A_y = hx hy/(4 pi s^2) for a source at rest; zero for a moving one.
  const double rest = s >= at_rest ? hx * hy / (2.0 * std::pow(std::numbers::pi, 1.5) * s) : 0.0;
  for (double& G : table.G) G += rest;
  return table;
}

std::vector<double> line_weights(int n, double hx, double Pe) {
  std::vector<double> weights(static_cast<std::size_t>(n + 1));
  const double scale = 4.0 / 3.0 * std::sqrt(hx / (std::numbers::pi * Pe));
  const auto power = [](double m) { return m * std::sqrt(m); };
  weights[0] = scale;
  for (int m = 1; m <= n; ++m)
    weights[static_cast<std::size_t>(m)] = scale * (power(m + 1.0) - 2.0 * power(m) + power(m - 1.0));
  return weights;
}

void subtract_lines(const std::vector<double>& weights, SourceTable& table) {
  for (int d = 0; d <= table.n_x; ++d) table.G[table.at(d, 0)] -= weights[static_cast<std::size_t>(d)];
}

std::vector<double> take_downstream(SourceTable& table) {
  std::vector<double> weights(static_cast<std::size_t>(table.n_x + 1));
  for (int d = 0; d <= table.n_x; ++d) std::swap(weights[static_cast<std::size_t>(d)], table.G[table.at(d, 0)]);
  return weights;
}

}  // namespace ehl::thermal
