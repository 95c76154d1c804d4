#include "judgement/fitted_minimum.hpp"

#include <cmath>

namespace ehl::judgement {
namespace {

/// Cells along x and y beyond which the paraboloid is not followed. The valley of the film beside the contact is
/// oblique and five times as long as wide: along it the smallest node is often a cell or two from the minimum.
constexpr double reach = 2.5;

}  // namespace

FittedMinimum fitted_minimum(const core::Patch& grid, const core::Field& film, int i, int j) {
  const FittedMinimum node{film(i, j), grid.X(i), grid.Y(j)};
  if (i < 1 || j < 1 || i >= grid.nx || j > grid.last_line()) return node;
  const auto H = [&](int k, int line) { return film(k, line <= grid.ny ? line : 2 * grid.ny - line); };
  // In cells.
  const double g = 0.5 * (H(i + 1, j) - H(i - 1, j));
  const double k = 0.5 * (H(i, j + 1) - H(i, j - 1));
  const double a = H(i + 1, j) - 2.0 * H(i, j) + H(i - 1, j);
  const double c = H(i, j + 1) - 2.0 * H(i, j) + H(i, j - 1);
  const double b = 0.25 * (H(i + 1, j + 1) - H(i + 1, j - 1) - H(i - 1, j + 1) + H(i - 1, j - 1));
  const double determinant = a * c - b * b;
  if (!(a > 0.0 && determinant > 0.0)) return node;
  const double x = (b * k - c * g) / determinant;
  const double y = (b * g - a * k) / determinant;
  if (!(std::abs(x) <= reach && std::abs(y) <= reach)) return node;
  return {node.value + 0.5 * (g * x + k * y), node.X + x * grid.hx(), node.Y + y * grid.hy()};
}

// The paraboloid is level at its minimum: where that is does not matter to first order.
std::vector<NodeWeight> weights_of_fitted_minimum(const core::Patch& grid, const core::Field& film, int i, int j) {
  const FittedMinimum fitted = fitted_minimum(grid, film, i, j);
  const double x = (fitted.X - grid.X(i)) / grid.hx();
  const double y = (fitted.Y - grid.Y(j)) / grid.hy();
  std::vector<NodeWeight> weights{{i, j, 1.0 - x * x - y * y}};
  if (x == 0.0 && y == 0.0) return weights;
  for (const int side : {-1, 1}) {
    weights.push_back({i + side, j, 0.5 * x * (x + side)});
    weights.push_back({i, grid.holder(j + side), 0.5 * y * (y + side)});
    for (const int beside : {-1, 1})
      weights.push_back({i + side, grid.holder(j + beside), 0.25 * side * beside * x * y});
  }
  return weights;
}

}  // namespace ehl::judgement
