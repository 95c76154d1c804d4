#include "steady/resolution.hpp"

#include <algorithm>
#include <cmath>

#include "contact/film_formulas.hpp"
#include "contact/groups.hpp"
#include "core/constants.hpp"

namespace ehl::steady {
namespace {
/// Ratio of length to width above which a contact has cells, weights and grids of its own.
constexpr double slender = 6.0;

// contact_size() along the shorter axis.
double shorter_size(double M, double L, const contact::Ellipse& shape) {
  const double sharpest = 0.5 * std::max(1.0, shape.radius_ratio);
  return std::max(contact::extent(shape).shorter, std::sqrt(expected_central_film(M, L, shape) / sharpest));
}

double film_by_formula(double M, double L, const contact::Ellipse& shape) {
  return contact::H_from_moes_units(contact::nijenbanning_venner_moes(M, L, shape), M, shape);
}

// The film of the entrainment along one of the radii; `speed` is the share of the whole speed.
double film_along(double angle, double speed, double M, double L, const contact::Ellipse& shape) {
  contact::Ellipse straight = shape;
  straight.angle = angle;
  return film_by_formula(M * std::pow(speed, -0.75), L * std::pow(speed, 0.25), straight);
}

// The formula knows one radius along the motion and one across it. Films that grow with the power n of the speed are
// combined as the power 2/n of each component's film, which is exact for a circle at any angle.
double film_oblique(double M, double L, const contact::Ellipse& shape) {
  const double angle = shape.angle * core::pi / 180.0;
  const double x = std::abs(std::cos(angle)), y = std::abs(std::sin(angle));
  const double film_x = film_along(0.0, x, M, L, shape), film_y = film_along(90.0, y, M, L, shape);
  constexpr double faster = 1.05;
  const double next = film_x > film_y ? film_along(0.0, faster * x, M, L, shape) / film_x
                                      : film_along(90.0, faster * y, M, L, shape) / film_y;
  const double power = 2.0 * std::log(faster) / std::log(next);
  return std::pow(std::pow(film_x, power) + std::pow(film_y, power), 1.0 / power);
}

}  // namespace

double expected_central_film(double M, double L, const contact::Ellipse& shape) {
  return contact::gap(shape).oblique() ? film_oblique(M, L, shape) : film_by_formula(M, L, shape);
}

double circular_load(double M, double L, const contact::Ellipse& shape) {
  if (contact::circular(shape)) return M;
  // The film of an elastic circular contact in a^2/R falls with the power 3/4 of the load.
  const contact::AlongEntrainment along = contact::along_entrainment(shape, M, L);
  const double over_approach = expected_central_film(M, L, shape) / shape.approach;
  return along.M * std::pow(expected_central_film(along.M, along.L) / over_approach, 4.0 / 3.0);
}

double expected_least_film(double M, double L, const contact::Ellipse& shape) {
  constexpr double share_of_line = 0.8;
  if (contact::line(shape)) return share_of_line * expected_central_film(M, L, shape);
  const contact::AlongEntrainment along = contact::along_entrainment(shape, M, L);
  const contact::Asymptotes film = contact::asymptotes(along.M, along.L, along.radius_ratio);
  const double isoviscous = std::pow(film.elastic_isoviscous, 8.0);
  const double piezoviscous = std::pow(film.elastic_piezoviscous, 8.0);
  const double at_50 = 0.6 + 0.3 * isoviscous / (isoviscous + piezoviscous);
  // Most of the lubricant escapes beside a slender contact.
  const double side_flow = std::pow(std::max(1.0, along.radius_ratio), -0.6);
  const double share = std::min(0.9, side_flow * at_50 * std::pow(circular_load(M, L, shape) / 50.0, -0.2));
  return expected_central_film(M, L, shape) * share;
}

double contact_size(double M, double L, const contact::Ellipse& shape) {
  return std::max(contact::extent(shape).X,
                  std::sqrt(expected_central_film(M, L, shape) / contact::gap(shape).least_along_X()));
}

double slenderness(double M, double L, const contact::Ellipse& shape) {
  return contact_size(M, L, shape) / shorter_size(M, L, shape);
}

double edge_steepness(const contact::Ellipse& shape) {
  // At a distance s inside the edge p = p_h sqrt(2 s/l), where l is the semi-axis across the edge. The gap outside is
  // therefore proportional to the elastic factor over sqrt(l).
  return shape.p_h / shape.a / std::sqrt(contact::extent(shape).shorter);
}

double film_zone(double M, double L, const contact::Ellipse& shape) {
  return std::pow(expected_least_film(M, L, shape) / edge_steepness(shape), 2.0 / 3.0);
}

double resolving_step(double M, double L, reynolds::Wedge wedge, const contact::Ellipse& shape) {
  const bool second_order = wedge != reynolds::Wedge::upstream1;
  const double share = second_order ? 0.3 : 0.2;
  const double coarsest = second_order ? 0.4 : 0.2;
  return std::min(coarsest * shorter_size(M, L, shape), share * film_zone(M, L, shape));
}

double cell_aspect(const contact::Ellipse& shape) {
  const contact::Extent reach = contact::extent(shape);
  if (reach.Y > 7.0 * reach.X) return 2.0;
  constexpr double longest = 16.0;
  if (reach.X < slender * reach.Y || contact::gap(shape).oblique()) return 1.0;
  double stretch = 1.0;
  while (2.0 * stretch <= std::min(longest, reach.X / reach.Y)) stretch *= 2.0;
  return 1.0 / stretch;
}

bool elongated(const contact::Ellipse& shape) { return slender * shape.kappa < 1.0; }

int resolving_cells(double step, double length, int fewest, int most) {
  int cells = fewest;
  while (2 * cells <= most && length / cells > step) cells *= 2;
  return cells;
}

}  // namespace ehl::steady
