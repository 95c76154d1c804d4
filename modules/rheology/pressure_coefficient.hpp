#pragma once
// Pressure coefficients of a viscosity law, the numbers on which the film thickness depends.
#include "rheology/laws.hpp"

namespace ehl::rheology {

/// Both times p_h; 0 if the viscosity does not rise with pressure.
struct PressureCoefficients {
  double alpha_star = 0.0;  ///< 1/alpha* = int_0^inf eta0/eta dp, the reciprocal asymptotic isoviscous pressure
  double alpha_film = 0.0;  ///< (1 - e^-3)/int_0^(3/alpha*) eta0/eta dp
};

/// Gauss rule with ten points on panels over which ln eta rises by at most one; relative error 1e-12, for tables 1e-9.
/// limits: for Barus both are alpha. source: Blok (1963) for alpha*; Bair, Liu and Wang (2006) for alpha_film.
PressureCoefficients pressure_coefficients(const ViscosityLaw& law);

/// The z for which Roelands' law with alpha p0/z = ln(eta0) + 9.67 has this alpha*. in: alpha_star [1/Pa], p0 [Pa],
/// eta0 [Pa s]. returns NaN if no z from 0.05 to 1.5 has it. error: rounding of alpha*.
double roelands_z_of(double alpha_star, double p0, double eta0);
/// The alpha for which Roelands' law with this z has this alpha*: its slope at ambient pressure, which is larger.
/// in: alpha_star [1/Pa] > 0, p0 [Pa], z > 0.
double roelands_alpha_of(double alpha_star, double p0, double z);

}  // namespace ehl::rheology
