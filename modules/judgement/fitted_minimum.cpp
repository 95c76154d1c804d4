#include "judgement/fitted_minimum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace ehl::judgement {
namespace {

/// Cells along x and y beyond which a fit is rejected. The valley of the film beside the contact is oblique and much
/// longer than wide: along it the smallest node is often a cell or two from the minimum.
constexpr double reach = 2.5;

/// A point near a node, in cells from it, and the film there.
struct Near {
  int i, j;
  double x = 0.0, y = 0.0;
  double value = 0.0;
};

/// True if the film does not vary along Y: any curvature along Y then keeps the minimum on its line.
bool one_line(const core::Patch& grid) { return grid.domain.line; }

std::optional<Near> minimum_of_paraboloid(const core::Patch& grid, const core::Field& film, int i, int j) {
  if (i < 1 || j < 1 || i >= grid.nx || j > grid.last_line()) return std::nullopt;
  const auto H = [&](int k, int line) { return film(k, grid.holder(line)); };
  const double g = 0.5 * (H(i + 1, j) - H(i - 1, j));
  const double k = 0.5 * (H(i, j + 1) - H(i, j - 1));
  const double a = H(i + 1, j) - 2.0 * H(i, j) + H(i - 1, j);
  const double c = one_line(grid) ? 1.0 : H(i, j + 1) - 2.0 * H(i, j) + H(i, j - 1);
  const double b = 0.25 * (H(i + 1, j + 1) - H(i + 1, j - 1) - H(i - 1, j + 1) + H(i - 1, j - 1));
  const double determinant = a * c - b * b;
  if (!(a > 0.0 && determinant > 0.0)) return std::nullopt;
  const double x = (b * k - c * g) / determinant;
  const double y = (b * g - a * k) / determinant;
  if (!(std::abs(x) <= reach && std::abs(y) <= reach)) return std::nullopt;
  return Near{i, j, x, y, film(i, j) + 0.5 * (g * x + k * y)};
}

/// Interpolation through five nodes along a line: the weight of each at t cells from the middle one, and its first two
/// derivatives.
struct Along {
  std::array<double, 5> value{}, slope{}, curvature{};
  int first = 0;  ///< nodes before `first` and as many at the other end have no weight
};
Along along(double t) {
  constexpr double by_powers[5][5] = {{0.0, 2.0 / 24, -1.0 / 24, -2.0 / 24, 1.0 / 24},
                                      {0.0, -4.0 / 6, 4.0 / 6, 1.0 / 6, -1.0 / 6},
                                      {1.0, 0.0, -5.0 / 4, 0.0, 1.0 / 4},
                                      {0.0, 4.0 / 6, 4.0 / 6, -1.0 / 6, -1.0 / 6},
                                      {0.0, -2.0 / 24, -1.0 / 24, 2.0 / 24, 1.0 / 24}};
  Along at{};
  for (std::size_t k = 0; k < 5; ++k) {
    const double* c = by_powers[k];
    at.value[k] = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
    at.slope[k] = c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * 4.0 * c[4]));
    at.curvature[k] = 2.0 * c[2] + t * (6.0 * c[3] + t * 12.0 * c[4]);
  }
  return at;
}

/// Interpolation along Y. One line has one node there and no slope.
Along along_Y(const core::Patch& grid, double t) {
  const std::array<double, 5> middle{0.0, 0.0, 1.0, 0.0, 0.0};
  return one_line(grid) ? Along{middle, {}, middle, 2} : along(t);
}
/// True if all nodes of the interpolation around line j are on the grid.
bool fits_along_Y(const core::Patch& grid, int j) {
  return one_line(grid) || (j >= 2 && (grid.north == core::Edge::mirror ? j : j + 2) <= grid.ny);
}

/// Newton's method from the paraboloid's minimum; the point stays in the middle of the five nodes along x and y.
std::optional<Near> minimum_of_quartic(const core::Patch& grid, const core::Field& film, const Near& begin) {
  constexpr int most_steps = 20;
  constexpr double longest_step = 0.5, at_rest = 1e-8;
  Near at = begin;
  for (int step = 0; step < most_steps; ++step) {
    const int di = static_cast<int>(std::lround(at.x)), dj = static_cast<int>(std::lround(at.y));
    at = {at.i + di, at.j + dj, at.x - di, at.y - dj};
    if (std::abs(at.i - begin.i) > reach || std::abs(at.j - begin.j) > reach) return std::nullopt;
    if (at.i < 2 || at.i + 2 > grid.nx || !fits_along_Y(grid, at.j)) return std::nullopt;
    const Along x = along(at.x), y = along_Y(grid, at.y);
    const auto sum = [&](const std::array<double, 5>& by_x, const std::array<double, 5>& by_y) {
      double all = 0.0;
      for (int k = 0; k < 5; ++k)
        for (int l = y.first; l < 5 - y.first; ++l)
          all += by_x[static_cast<std::size_t>(k)] * by_y[static_cast<std::size_t>(l)] *
                 film(at.i + k - 2, grid.holder(at.j + l - 2));
      return all;
    };
    const double g = sum(x.slope, y.value), k = sum(x.value, y.slope);
    const double a = sum(x.curvature, y.value), b = sum(x.slope, y.slope);
    const double c = sum(x.value, y.curvature);
    const double determinant = a * c - b * b;
    if (!(a > 0.0 && determinant > 0.0)) return std::nullopt;
    const double dx = std::clamp((b * k - c * g) / determinant, -longest_step, longest_step);
    const double dy = std::clamp((b * g - a * k) / determinant, -longest_step, longest_step);
    at.value = sum(x.value, y.value);
    if (std::max(std::abs(dx), std::abs(dy)) < at_rest) return at;
    at.x += dx;
    at.y += dy;
  }
  return std::nullopt;
}

struct Fit {
  Near at;
  bool quartic = false;
};
/// in: i, j, the smallest node.
Fit fit(const core::Patch& grid, const core::Field& film, int i, int j) {
  const Near node{i, grid.lines(j) > 0.0 ? j : 1, 0.0, 0.0, film(i, j)};
  const std::optional<Near> paraboloid = minimum_of_paraboloid(grid, film, node.i, node.j);
  if (!paraboloid) return {node};
  const std::optional<Near> quartic = minimum_of_quartic(grid, film, *paraboloid);
  if (quartic && quartic->value <= node.value) return {*quartic, true};
  return {*paraboloid};
}

}  // namespace

FittedMinimum fitted_minimum(const core::Patch& grid, const core::Field& film, int i, int j) {
  const Near at = fit(grid, film, i, j).at;
  return {at.value, grid.X(at.i) + at.x * grid.hx(), grid.Y(at.j) + at.y * grid.hy()};
}

// At a minimum the film is level, so that its place does not matter to first order.
std::vector<NodeWeight> weights_of_fitted_minimum(const core::Patch& grid, const core::Field& film, int i, int j) {
  const auto [at, quartic] = fit(grid, film, i, j);
  const auto [x, y] = std::pair(at.x, at.y);
  if (quartic) {
    std::vector<NodeWeight> weights;
    const Along by_x = along(x), by_y = along_Y(grid, y);
    for (std::size_t k = 0; k < 5; ++k)
      for (int l = by_y.first; l < 5 - by_y.first; ++l)
        weights.push_back({at.i + static_cast<int>(k) - 2, grid.holder(at.j + l - 2),
                           by_x.value[k] * by_y.value[static_cast<std::size_t>(l)]});
    return weights;
  }
  const int own = at.j;
  std::vector<NodeWeight> weights{{i, own, 1.0 - x * x - y * y}};
  if (x == 0.0 && y == 0.0) return weights;
  for (const int side : {-1, 1}) {
    weights.push_back({i + side, own, 0.5 * x * (x + side)});
    weights.push_back({i, grid.holder(own + side), 0.5 * y * (y + side)});
    for (const int beside : {-1, 1})
      weights.push_back({i + side, grid.holder(own + beside), 0.25 * side * beside * x * y});
  }
  return weights;
}

}  // namespace ehl::judgement
