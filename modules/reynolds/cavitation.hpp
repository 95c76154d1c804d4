#pragma once
// The cavitation model: which pressures are allowed, and what follows for a point, its residual and its transfer
// between grids. All other code asks these functions, for a double or for a batch of lines at once.
#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::reynolds {

enum class Cavitation {
  none,                  ///< any pressure: the linear model problems
  nonnegative_pressure,  ///< P >= 0, L(P) <= f, P (L(P) - f) = 0
  mass_conserving        ///< P >= 0, Q <= rho_bar H, P (rho_bar H - Q) = 0 (content.hpp)
};

/// True if the film may cavitate: a free boundary is part of the problem.
inline bool ruptures(Cavitation model) { return model != Cavitation::none; }

/// True if the oil content of cavitated points is an unknown of its own.
inline bool conserves(Cavitation model) { return model == Cavitation::mass_conserving; }

/// The nearest pressure that the model allows.
template <class Number>
Number projected(Cavitation model, Number P) {
  return ruptures(model) ? (P < 0.0 ? Number{} : P) : P;
}

/// The pressure after a correction from a coarse grid. In the mass-conserving model a correction cavitates no point:
/// the discrete meniscus is not unique, since a node or two may be full or not, and the solution meant is the one that
/// relaxations reach from a full inlet.
inline double corrected(Cavitation model, double P, double change) {
  constexpr double least = 0.1;  // of P [bench: least_correction]
  return conserves(model) ? (P + change > least * P ? P + change : least * P) : projected(model, P + change);
}

/// True where a point carries no pressure.
template <class Number>
auto dry(Cavitation model, Number P) {
  return ruptures(model) ? P <= 0.0 : decltype(P <= 0.0){};
}

/// True where a cavitated point stays so: its equation, r = f - L(P) >= 0, asks for P < 0.
template <class Number>
auto stays_dry(Cavitation model, Number P, Number r) {
  return ruptures(model) ? (P <= 0.0) & (r >= 0.0) : decltype(P <= 0.0){};
}

/// How far a cavitated point of a fine grid is from carrying pressure; 0 for the others. The coarse point must be as
/// far away: with no slack it would be on the edge, where the coarse correction rises and never falls.
inline double slack(Cavitation model, double P, double r) { return dry(model, P) && r > 0.0 ? r : 0.0; }

/// Sets a residual or a correction to zero at cavitated points and at those with one among their eight neighbours: the
/// edge of the cavitated region is left to the relaxation of its own grid. In the mass-conserving model only cavitated
/// points are set to zero, since a residual at a meniscus is oil to which the pressure in all of the inlet responds.
/// in: ghost lines of P. in, out: ghost lines of r.
///
/// Neighbours::across, where the coarse grid keeps all columns (constant X): only neighbours along Y count, since
/// nothing is transferred along X. Along an edge of constant X stretched cells are coupled to each other far more than
/// to the cells behind them, and do not converge without a common correction.
enum class Neighbours { all, across };
void drop_beside_dry(Cavitation model, const core::Patch& grid, const core::Field& P, int threads, core::Field& r,
                     Neighbours of = Neighbours::all);

/// The pressure on the grid of every second node: full weighting where all nine fine points carry pressure, injection
/// otherwise. in: the coarse grid, `fine` with ghost lines; out: with ghost lines.
void restrict_pressure(Cavitation model, const core::Field& fine, const core::Patch& grid, core::Field& coarse);

}  // namespace ehl::reynolds
