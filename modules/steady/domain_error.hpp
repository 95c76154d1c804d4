#pragma once
// How much the film would grow if the domain did not cut off the inlet.
#include "steady/scene.hpp"

namespace ehl::steady {

/// Bound on the pressure that an inlet at X_a cuts off, as a relative change of Hc: half of alpha_bar times
/// (4/3) lambda/|X_a|^3, the rigid far field dP/dX = lambda/H^2, H = X^2/2, integrated from -infinity, with alpha_bar
/// >= 10. Cheap and right within a factor of about 2 where viscosity rises with pressure; too low for light isoviscous
/// loads, whose far field is long enough to be far above any threshold.
double rough_domain_error(const Scene& scene);

/// The inlet boundary that a deck without one gets: the shortest inlet with a rough_domain_error of at most 0.6 %, no
/// shorter than 2.5 and no longer than 46.5 for X_b = 1.5, from a ladder on which (0,0) is a node of every grid with a
/// multiple of 32 cells: |X_a|/X_b = m/(32 - m), m = 20 .. 31. At M = 50, L = 10 that is the paper's -4.5. in: lambda >
/// 0, alpha_bar >= 0, X_b > 0 the outlet boundary. out: X_a < 0.
double chosen_inlet(double lambda, double alpha_bar, double X_b);

/// Relative growth of Hc on a domain twice as long (upstream) and twice as wide: two solutions on coarse grids of the
/// same mesh size. It is a lower bound of the error of the domain; in light loads what lies beyond the double domain
/// can add as much again. order: right within a factor of 2 where it
/// is a percent (the meshes are coarse). out: NaN where one of the two coarse solutions fails. cost: a few hundredths
/// of a second.
double estimate_domain_error(const Scene& scene);

}  // namespace ehl::steady
