#include "steady/scales.hpp"

#include <algorithm>
#include <cmath>

#include "contact/film_formulas.hpp"
#include "contact/groups.hpp"
#include "core/constants.hpp"

namespace ehl::steady {
namespace {

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

// Expected central film by the formula of Nijenbanning, Venner and Moes, good to 15 %. For an oblique contact the films
// of both components of the speed are combined; the result is up to 25 % too thick.
double expected_central_film(double M, double L, const contact::Ellipse& shape) {
  return contact::gap(shape).oblique() ? film_oblique(M, L, shape) : film_by_formula(M, L, shape);
}

// in: film, the expected central film.
double circular_load(double M, double L, const contact::Ellipse& shape, double film) {
  if (contact::circular(shape)) return M;
  // The film of an elastic circular contact in a^2/R falls with the power 3/4 of the load.
  const contact::AlongEntrainment along = contact::along_entrainment(shape, M, L);
  const double over_approach = film / shape.approach;
  return along.M * std::pow(expected_central_film(along.M, along.L, {}) / over_approach, 4.0 / 3.0);
}

// The central film times min(0.9, s (M/50)^(-1/5)), with M of circular_load(). s is 0.6 for a piezoviscous and 0.9 for
// an isoviscous lubricant, fitted to own solutions, and smaller beside slender contacts. 0.8 of the central film for a
// line contact.
double expected_least_film(double M, double L, const contact::Ellipse& shape, double film, double circular_M) {
  constexpr double share_of_line = 0.8;
  if (contact::line(shape)) return share_of_line * film;
  const contact::AlongEntrainment along = contact::along_entrainment(shape, M, L);
  const contact::Asymptotes limits = contact::asymptotes(along.M, along.L, along.radius_ratio);
  const double isoviscous = std::pow(limits.elastic_isoviscous, 8.0);
  const double piezoviscous = std::pow(limits.elastic_piezoviscous, 8.0);
  const double at_50 = 0.6 + 0.3 * isoviscous / (isoviscous + piezoviscous);
  // Most of the lubricant escapes beside a slender contact.
  const double side_flow = std::pow(std::max(1.0, along.radius_ratio), -0.6);
  const double share = std::min(0.9, side_flow * at_50 * std::pow(circular_M / 50.0, -0.2));
  return film * share;
}

// At a distance s inside the edge p = p_h sqrt(2 s/l), where l is the semi-axis across the edge. The gap outside is
// therefore proportional to the elastic factor over sqrt(l).
double edge_steepness(const contact::Ellipse& shape) {
  return shape.p_h / shape.a / std::sqrt(contact::extent(shape).shorter);
}

}  // namespace

ContactScales scales_of(double M, double L, const contact::Ellipse& shape) {
  ContactScales scales{.M = M, .L = L, .shape = shape};
  if (!(M > 0.0 && L >= 0.0)) return scales;
  scales.film = expected_central_film(M, L, shape);
  scales.circular_load = circular_load(M, L, shape, scales.film);
  scales.least_film = expected_least_film(M, L, shape, scales.film, scales.circular_load);
  const contact::Extent reach = contact::extent(shape);
  const double sharpest = 0.5 * std::max(1.0, shape.radius_ratio);
  scales.size = std::max(reach.X, std::sqrt(scales.film / contact::gap(shape).least_along_X()));
  scales.shorter_size = std::max(reach.shorter, std::sqrt(scales.film / sharpest));
  scales.slenderness = scales.size / scales.shorter_size;
  scales.edge_steepness = edge_steepness(shape);
  scales.film_zone = std::pow(scales.least_film / scales.edge_steepness, 2.0 / 3.0);
  return scales;
}

}  // namespace ehl::steady
