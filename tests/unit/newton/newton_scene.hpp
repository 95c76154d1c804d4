#pragma once
// A circular contact on one grid, started from the Hertz pressure, for Newton's method.
#include <cmath>

#include "contact/film_formulas.hpp"
#include "contact/groups.hpp"
#include "multigrid/start.hpp"

namespace ehl::tests {

/// Roelands (z = 0.68, alpha = 2.2e-8 1/Pa) and Dowson-Higginson.
inline multigrid::Problem newton_problem(double M, double L) {
  const contact::Groups groups = contact::from_moes(M, L);
  constexpr double alpha = 2.2e-8;
  const double p_h = groups.alpha_bar / alpha;
  return {.film = {.lambda = groups.lambda,
                   .viscosity = rheology::make_roelands(alpha, rheology::roelands_p0, 0.68, p_h),
                   .density = rheology::make_dowson_higginson(p_h)}};
}

/// The deformation by Fourier transforms is exact.
inline multigrid::Hierarchy newton_hierarchy(const multigrid::Problem& problem, const core::Patch& grid, int threads) {
  mlmi::Parameters deformation;
  deformation.method = mlmi::Method::fft;
  return multigrid::make_hierarchy(problem, {}, deformation, grid, threads);
}

inline multigrid::Hierarchy newton_hierarchy(double M, double L, const core::Patch& grid, int threads,
                                             reynolds::Wedge wedge = reynolds::Wedge::upstream2,
                                             std::optional<rheology::ShearThinning> thinning = {},
                                             reynolds::Face face = reynolds::Face::mean, double supply = 0.0) {
  multigrid::Problem problem = newton_problem(M, L);
  problem.film.thinning = thinning;
  problem.transport = wedge;
  problem.face = face;
  if (supply > 0.0) {
    problem.cavitation = reynolds::Cavitation::mass_conserving;
    problem.supply = [supply](double) { return supply; };
  }
  return newton_hierarchy(problem, grid, threads);
}

/// H00 for the published central film.
inline double first_H00(double M, double L) {
  return -1.0 + contact::H_from_moes_units(contact::nijenbanning_venner_moes(M, L), M);
}

}  // namespace ehl::tests
