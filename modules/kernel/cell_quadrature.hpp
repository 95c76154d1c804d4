#pragma once
// Gauss-Legendre quadrature of a smooth function over one cell.
#include <array>
#include <cstdlib>

namespace ehl::kernel {

/// Nodes on (-1/2, 1/2) and weights with the sum 1.
template <int points>
struct GaussRule;

template <>
struct GaussRule<3> {
  static constexpr std::array<double, 3> node{-0.3872983346207416885, 0.0, 0.3872983346207416885};
  static constexpr std::array<double, 3> weight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
};

template <>
struct GaussRule<4> {
  static constexpr std::array<double, 4> node{-0.4305681557970262876, -0.1699905217924281324, 0.1699905217924281324,
                                              0.4305681557970262876};
  static constexpr std::array<double, 4> weight{0.1739274225687269287, 0.3260725774312730713, 0.3260725774312730713,
                                                0.1739274225687269287};
};

template <>
struct GaussRule<6> {
  static constexpr std::array<double, 6> node{-0.4662347571015760139, -0.3306046932331322568, -0.1193095930415984983,
                                              0.1193095930415984983,  0.3306046932331322568,  0.4662347571015760139};
  static constexpr std::array<double, 6> weight{0.0856622461895851725, 0.1803807865240693038, 0.2339569672863455237,
                                                0.2339569672863455237, 0.1803807865240693038, 0.0856622461895851725};
};

/// hx hy times the mean of f over the cell hx x hy centred at (X, Y).
/// order: for f = 1/r and a centre d cells away the relative error is about (4d)^(-2 points).
template <int points, class Function>
inline double integrate_over_cell(double X, double Y, double hx, double hy, Function f) {
  using Rule = GaussRule<points>;
  double sum = 0.0;
  for (std::size_t a = 0; a < points; ++a) {
    double line = 0.0;
    for (std::size_t b = 0; b < points; ++b)
      line += Rule::weight[b] * f(X + Rule::node[a] * hx, Y + Rule::node[b] * hy);
    sum += Rule::weight[a] * line;
  }
  return hx * hy * sum;
}

/// Distances, in cells, from which on the rules with 6, 4 and 3 points are exact to rounding.
inline constexpr double distance_for_6 = 6.0;
inline constexpr double distance_for_4 = 32.0;
inline constexpr double distance_for_3 = 160.0;

}  // namespace ehl::kernel
