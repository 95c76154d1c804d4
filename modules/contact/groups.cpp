#include "contact/groups.hpp"

#include <cmath>

#include "core/constants.hpp"

namespace ehl::contact {
namespace {

using core::pi;

// (a/R)^2 = (3W/2)^(2/3) for a circle and 8W/pi for a line; with M instead of W the same in Moes' scaling.
double moes_scale(double M, const Ellipse& shape) {
  if (line(shape)) return 8.0 / pi * M;
  return std::pow(1.5 * M, 2.0 / 3.0) * (shape.a * shape.a);
}

// Exponent of 2U in M = W (2U)^-exponent.
double power_of_speed(const Ellipse& shape) { return line(shape) ? 0.5 : 0.75; }

}  // namespace

Groups from_moes(double M, double L, const Ellipse& shape) {
  if (line(shape))
    return {.M = M,
            .L = L,
            .lambda = 3.0 * pi * pi / (8.0 * M * M),
            .alpha_bar = L * std::sqrt(M / (2.0 * pi)),
            .shape = shape};
  const double of_circle = std::cbrt(128.0 * pi * pi * pi / 3.0) * std::pow(M, -4.0 / 3.0);
  const double lambda = of_circle / (shape.a * shape.a * shape.a * shape.p_h);
  const double alpha_bar = L / pi * std::cbrt(1.5 * M) * shape.p_h;
  return {.M = M, .L = L, .lambda = lambda, .alpha_bar = alpha_bar, .shape = shape};
}

Groups with_typical_U(const Groups& groups) {
  constexpr double typical_U = 1e-11;
  return std::isnan(groups.U) ? from_moes(groups.M, groups.L, typical_U, groups.shape) : groups;
}

Groups from_moes(double M, double L, double U, const Ellipse& shape) {
  Groups groups = from_moes(M, L, shape);
  groups.W = M * std::pow(2.0 * U, power_of_speed(shape));
  groups.U = U;
  groups.G = L * std::pow(2.0 * U, -0.25);
  return groups;
}

Groups from_hamrock_dowson(double W, double U, double G, const Ellipse& shape) {
  Groups groups = from_moes(W * std::pow(2.0 * U, -power_of_speed(shape)), G * std::pow(2.0 * U, 0.25), shape);
  groups.W = W;
  groups.U = U;
  groups.G = G;
  return groups;
}

Groups from_si(const SiContact& contact) {
  const double over_length = line(contact.shape) ? 1.0 : contact.radius;
  const double W = contact.load / (contact.E_prime * contact.radius * over_length);
  const double U = contact.eta0 * 0.5 * contact.u_s / (contact.E_prime * contact.radius);
  return from_hamrock_dowson(W, U, contact.alpha * contact.E_prime, contact.shape);
}

SiContact to_si(const Groups& groups, double radius, double E_prime, double eta0) {
  SiContact contact{};
  contact.load = groups.W * E_prime * radius * (line(groups.shape) ? 1.0 : radius);
  contact.radius = radius;
  contact.E_prime = E_prime;
  contact.u_s = 2.0 * groups.U * E_prime * radius / eta0;
  contact.eta0 = eta0;
  contact.alpha = groups.G / E_prime;
  contact.shape = groups.shape;
  return contact;
}

double relative_half_width(double W, const Ellipse& shape) {
  return line(shape) ? std::sqrt(moes_scale(W, shape)) : std::cbrt(1.5 * W) * shape.a;
}

double hertz_pressure(const Groups& groups, double alpha) { return groups.alpha_bar / alpha; }

double H_from_moes_units(double H_moes, double M, const Ellipse& shape) { return H_moes / moes_scale(M, shape); }
double H_to_moes_units(double H, double M, const Ellipse& shape) { return H * moes_scale(M, shape); }
double H_from_thickness_over_radius(double h_over_R, double W, const Ellipse& shape) {
  return h_over_R / moes_scale(W, shape);
}

}  // namespace ehl::contact
