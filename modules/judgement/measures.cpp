#include "judgement/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/norms.hpp"
#include "reynolds/flow_balance.hpp"

namespace ehl::judgement {
namespace {

/// |X| and |Y|, in half sides of the rectangle around the ellipse (Hertz radii for a circle), up to which mass balance
/// is checked. The region contains all of the thin film, the spike and the constrictions, but little of the inlet,
/// where far more oil flows back and forth.
constexpr double contact_reach = 1.5;

// Half the sides of the rectangle around an outline.
struct Sides {
  double X, Y;
};
Sides sides_of(const core::QuadraticForm& outline) {
  if (outline.YY == 0.0) return {1.0 / std::sqrt(outline.XX), 0.5};  // for the single line of a line contact
  const double determinant = outline.XX * outline.YY - 0.25 * outline.XY * outline.XY;
  return {std::sqrt(outline.YY / determinant), std::sqrt(outline.XX / determinant)};
}

struct Interpolation {
  int first = 0;
  std::array<double, 4> weights{};
};

// Cubic Lagrange interpolation through four nodes around the position t (in cells).
Interpolation interpolation(double t, int cells) {
  if (std::abs(t - std::round(t)) < 1e-9) {
    const int node = static_cast<int>(std::round(t));
    Interpolation at_node{std::clamp(node, 0, cells - 3), {}};
    at_node.weights[static_cast<std::size_t>(node - at_node.first)] = 1.0;
    return at_node;
  }
  Interpolation result{std::clamp(static_cast<int>(std::floor(t)) - 1, 0, cells - 3), {}};
  for (int a = 0; a < 4; ++a) {
    double weight = 1.0;
    for (int b = 0; b < 4; ++b)
      if (b != a) weight *= (t - result.first - b) / (a - b);
    result.weights[static_cast<std::size_t>(a)] = weight;
  }
  return result;
}

double largest_on_rim(const core::Patch& grid, const core::Field& P, const core::QuadraticForm& outline) {
  double largest = 0.0;
  for (int i = 0; i <= grid.nx; ++i) {
    if (grid.X(i) <= 0.0) continue;
    for (int j = 0; j <= grid.ny; ++j)
      if (outline.at(grid.X(i), grid.Y(j)) > 1.0 - of_rim * of_rim) largest = std::max(largest, P(i, j));
  }
  return largest;
}

}  // namespace

std::vector<NodeWeight> weights_at(const core::Patch& grid, double X, double Y) {
  const Interpolation x = interpolation((X - grid.domain.X_a) / grid.hx(), grid.nx);
  if (grid.domain.line) {
    std::vector<NodeWeight> along;
    for (int a = 0; a < 4; ++a) along.push_back({x.first + a, 1, x.weights[static_cast<std::size_t>(a)]});
    return along;
  }
  const Interpolation y = interpolation((Y - grid.domain.Y_a) / grid.hy(), grid.domain.ny);
  std::vector<NodeWeight> weights;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      weights.push_back({x.first + a, grid.holder(y.first + b),
                         x.weights[static_cast<std::size_t>(a)] * y.weights[static_cast<std::size_t>(b)]});
  return weights;
}

double value_at(const core::Patch& grid, const core::Field& field, double X, double Y) {
  double value = 0.0;
  for (const auto& [i, j, weight] : weights_at(grid, X, Y)) value += weight * field(i, j);
  return value;
}

Measures measures(const Subject& subject) {
  const auto& [grid, fields, r, transport, cavitation, outline, carried, wanted, on_bodies] = subject;
  const reynolds::ResidualNorms norms = reynolds::residual_norms(grid, fields, transport, cavitation, r);
  const Sides sides = sides_of(outline);
  const auto flow = [&](double reach) {
    return reynolds::flow_balance(subject.grid, subject.fields, subject.transport, subject.cavitation,
                                  {reach * sides.X, reach * sides.Y, sides.Y});
  };
  const reynolds::FlowBalance contact = flow(contact_reach);
  const core::Location Hm = core::minimum(fields.H);
  const FittedMinimum fitted = fitted_minimum(grid, fields.H, Hm.i, Hm.j);
  return {.Hc = value_at(grid, fields.H, 0.0, 0.0),
          .Hm = Hm.value,
          .residual = norms.relative(),
          .load_error = std::abs(carried - wanted) / wanted,
          .Hm_X = grid.X(Hm.i),
          .Hm_Y = grid.Y(Hm.j),
          .Hm_fitted = fitted.value,
          .Hm_fitted_X = fitted.X,
          .Hm_fitted_Y = fitted.Y,
          .P_max = core::maximum(on_bodies).value,
          .P_rim = largest_on_rim(grid, on_bodies, outline),
          .largest_residual = norms.largest / norms.wedge,
          .largest_residual_X = grid.X(norms.i),
          .largest_residual_Y = grid.Y(norms.j),
          .least_P = norms.least_P,
          .dry_violation = norms.largest_dry / norms.wedge,
          .flow_through = contact.through,
          .flow_imbalance = contact.imbalance(),
          .flow_imbalance_whole = flow(std::numeric_limits<double>::infinity()).imbalance(),
          .least_content = fields.content != nullptr ? core::minimum(*fields.content).value : core::unknown,
          .oil_imbalance =
              reynolds::conserves(cavitation) ? reynolds::oil_balance(grid, fields, transport).imbalance() : 0.0};
}

}  // namespace ehl::judgement
