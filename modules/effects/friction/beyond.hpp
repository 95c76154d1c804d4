#pragma once
// Friction outside of the domain of a film whose far field is in closed form.
#include <vector>

#include "core/quadratic_form.hpp"
#include "effects/friction/friction.hpp"
#include "reynolds/far_field.hpp"

namespace ehl::friction {

/// The far field of a solved contact, and the film that belongs to it.
struct Outside {
  const reynolds::FarField& field;
  core::QuadraticForm gap;     ///< of the undeformed bodies
  double deformation = 0.0;    ///< far away, times 1/r; of a line times -ln|X|
  reynolds::FarState state{};  ///< of a line with its flow; the speed is less than 1 where the inlet is warm
};

/// Integrals over what lies outside of the domain and is filled with oil, in units of p_h a^2 (of a line p_h a).
struct Beyond {
  double sliding = 0.0;    ///< of tau_m
  double cavitated = 0.0;  ///< part of `sliding` from where the film is ruptured
  double rolling = 0.0;    ///< of (h/2) dp/dx
};

/// Gauss quadrature; the radii by their logarithm, as both integrands fall as 1/r^2 round a point. A line contact
/// without a meniscus is integrated to infinity with X = X_a/u. in: film_at_end as friction_of() has it, by lines of
/// the domain. limits: a film that heat has changed at the boundary of the domain returns to the cold one as 1/r^2.
Beyond beyond(const Film& film, const Parameters& parameters, const std::vector<double>& film_at_end);

/// Share of the width that holds oil, where P = 0. film_at_end: of the line's last node with P > 0 upstream; 0: none,
/// the oil has not been in the contact yet.
double filled(Cavitated cavitated, double H, double film_at_end);

}  // namespace ehl::friction
