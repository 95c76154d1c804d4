#pragma once
// Friction of the oil outside the domain, if the film has a closed far field.
#include <vector>

#include "core/quadratic_form.hpp"
#include "effects/friction/friction.hpp"
#include "reynolds/far_field.hpp"

namespace ehl::friction {

/// Far field of a solved contact, and its film.
struct Outside {
  const reynolds::FarField& field;
  core::QuadraticForm gap;     ///< of the undeformed bodies
  double deformation = 0.0;    ///< of a point contact far away, times 1/r; of a line contact times -ln|X|
  reynolds::FarState state{};  ///< of a line contact with its flow; its speed is below 1 if the inlet is warm
};

/// Integrals over the part outside the domain that is filled with oil, in units of p_h a^2 (line contact: p_h a).
struct Beyond {
  double sliding = 0.0;    ///< of tau_m
  double cavitated = 0.0;  ///< part of `sliding` where the film is cavitated
  double rolling = 0.0;    ///< of (h/2) dp/dx
};

/// Gauss quadrature, in ln r for point contacts because both integrands decay as 1/r^2. A line contact without a
/// meniscus is integrated to infinity with X = X_a/u. in: film_at_end per line of the domain, as in friction_of().
/// limits: a temperature change of the film at the boundary is assumed to decay as 1/r^2.
Beyond beyond(const Film& film, const Parameters& parameters, const std::vector<double>& film_at_end);

/// Share of the width that is filled with oil where P = 0. in: film_at_end, the film at the last node upstream with P >
/// 0 on the same line; 0 if there is none because the oil has not passed the contact.
double filled(Cavitated cavitated, double H, double film_at_end);

}  // namespace ehl::friction
