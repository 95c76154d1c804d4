#include "machines/bearing.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "machines/number.hpp"

namespace ehl::machines {
namespace {

using core::pi;

// -1 for the inner race, which lies inside the circle of the centres; +1 for the outer.
double side(const Bearing& bearing) { return bearing.race == Race::inner ? -1.0 : 1.0; }

/// Sums of the forces of all elements along and across the load, for K = 1 and a ring displaced by 1 in the direction
/// theta.
struct Force {
  double along = 0.0;
  double across = 0.0;
};

double azimuth_of(const RadialLoad& load, int element) {
  return load.azimuth * degree + 2.0 * pi * element / load.elements;
}

// Approach of the ring to an element; negative: it moves away.
double approach(const RadialLoad& load, int element, double theta) {
  return std::cos(azimuth_of(load, element) - theta);
}

double pressed(const RadialLoad& load, int element, double theta) {
  return std::pow(std::max(0.0, approach(load, element, theta)), load.exponent);
}

Force force(const RadialLoad& load, double theta) {
  Force sum;
  for (int j = 0; j < load.elements; ++j) {
    const double Q = pressed(load, j, theta);
    sum.along += Q * std::cos(azimuth_of(load, j));
    sum.across += Q * std::sin(azimuth_of(load, j));
  }
  return sum;
}

}  // namespace

double gamma(const Bearing& bearing) {
  return bearing.diameter * std::cos(bearing.contact_angle * degree) / bearing.pitch_diameter;
}

double race_radius(const Bearing& bearing) {
  return 0.5 * (bearing.pitch_diameter / std::cos(bearing.contact_angle * degree) + side(bearing) * bearing.diameter);
}

double radius_along(const Bearing& bearing) {
  return 1.0 / (2.0 / bearing.diameter - side(bearing) / race_radius(bearing));
}

double radius_across(double diameter, double conformity) { return diameter * conformity / (2.0 * conformity - 1.0); }

Turning complete(const Turning& two, double gamma) {
  Turning all = two;
  if (std::isnan(all.cage)) all.cage = 0.5 * (all.inner * (1.0 - gamma) + all.outer * (1.0 + gamma));
  if (std::isnan(all.inner)) all.inner = (2.0 * all.cage - all.outer * (1.0 + gamma)) / (1.0 - gamma);
  if (std::isnan(all.outer)) all.outer = (2.0 * all.cage - all.inner * (1.0 - gamma)) / (1.0 + gamma);
  return all;
}

double rolling_speed(const Bearing& bearing, const Turning& turning) {
  const double g = gamma(bearing);
  return pi / 120.0 * bearing.pitch_diameter * (1.0 - g * g) * std::abs(turning.inner - turning.outer);
}

std::vector<double> element_loads(const RadialLoad& load) {
  // A ring that moves at right angles to the load approaches at least one of three or more elements, so the force
  // across the load changes sign between the two directions.
  constexpr int halvings = 60;  // pi/2^60 is less than the rounding of an angle
  double below = -0.5 * pi, above = 0.5 * pi;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (below + above);
    (force(load, middle).across < 0.0 ? below : above) = middle;
  }
  const double stiffness = load.load / force(load, below).along;
  constexpr double rounding = 1e-12;  // of an approach: at right angles to the motion it is zero up to rounding
  std::vector<double> loads;
  for (int j = 0; j < load.elements; ++j)
    loads.push_back(approach(load, j, below) > rounding ? stiffness * pressed(load, j, below) : 0.0);
  return loads;
}

}  // namespace ehl::machines
