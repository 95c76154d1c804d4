#pragma once
// One number for a viscosity law: the pressure coefficients from which film thickness follows.
#include "rheology/laws.hpp"

namespace ehl::rheology {

/// Both times p_h; 0 where viscosity does not rise with pressure.
struct PressureCoefficients {
  double alpha_star = 0.0;  ///< 1/alpha* = int_0^inf eta0/eta dp, the reciprocal asymptotic isoviscous pressure
  double alpha_film = 0.0;  ///< (1 - e^-3)/int_0^(3/alpha*) eta0/eta dp
};

/// By Gauss' rule of ten points on panels over which ln eta rises by at most one; relative error 1e-12, of a table
/// 1e-9. limits: Barus gives alpha twice. source: Blok (1963) for alpha*; Bair, Liu and Wang (2006) for alpha_film.
PressureCoefficients pressure_coefficients(const ViscosityLaw& law);

}  // namespace ehl::rheology
