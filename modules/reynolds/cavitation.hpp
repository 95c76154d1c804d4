#pragma once
// The cavitation model: which pressures are allowed, and what that means for a point, its residual and its transfers.
// Everybody else asks these functions; for a double or for a batch of lines at once.
#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::reynolds {

enum class Cavitation {
  none,                  ///< any pressure: the linear model problems
  nonnegative_pressure,  ///< P >= 0, L(P) <= f, P (L(P) - f) = 0
  mass_conserving        ///< P >= 0, Q <= rho_bar H, P (rho_bar H - Q) = 0 (content.hpp)
};

/// True where a free boundary is part of the problem.
inline bool ruptures(Cavitation model) { return model != Cavitation::none; }

/// True where the oil of dry points is an unknown of its own.
inline bool conserves(Cavitation model) { return model == Cavitation::mass_conserving; }

/// The nearest pressure that is allowed.
template <class Number>
Number projected(Cavitation model, Number P) {
  return ruptures(model) ? (P < 0.0 ? Number{} : P) : P;
}

/// The pressure behind a correction from a coarse grid. Where the oil of dry points is an unknown, the correction dries
/// no point: the discrete meniscus is not unique, a node or two may be dry or wet, and of its places the one is meant
/// at which relaxations arrive from a full inlet.
inline double corrected(Cavitation model, double P, double change) {
  constexpr double least = 0.1;  // of 0, 0.1 and 0.5: with 0 points beside the meniscus dry and stay so
  return conserves(model) ? (P + change > least * P ? P + change : least * P) : projected(model, P + change);
}

/// True where a point carries no pressure: it is dry.
template <class Number>
auto dry(Cavitation model, Number P) {
  return ruptures(model) ? P <= 0.0 : decltype(P <= 0.0){};
}

/// True where a dry point stays so: its equation, r = f - L(P) >= 0, asks for P < 0.
template <class Number>
auto stays_dry(Cavitation model, Number P, Number r) {
  return ruptures(model) ? (P <= 0.0) & (r >= 0.0) : decltype(P <= 0.0){};
}

/// How far a dry point of a fine grid is from carrying pressure, 0 where it is wet or wants to be. The coarse point
/// must be as far away: with no slack it would be on the edge, and the coarse correction would rise there and never
/// fall.
inline double slack(Cavitation model, double P, double r) { return dry(model, P) && r > 0.0 ? r : 0.0; }

/// Sets a residual or a correction to zero where a point is dry or has a dry one among its eight neighbours: the edge
/// of the cavitated region is left to the relaxation of its own grid. Where the oil of dry points is an unknown, of dry
/// points alone: at a meniscus a residual is oil that the pressure in all of the inlet answers to. in: ghost lines of
/// P; out: of r.
/// Where the coarse grid keeps all stations along X, of a dry point the neighbours along Y alone: nothing is handed on
/// along X. Stretched cells along an edge of constant X, many of them beside each other, are coupled among each other
/// by far more than with what is behind them: without a correction of all together they stand still.
enum class Neighbours { all, across };
void drop_beside_dry(Cavitation model, const core::Patch& grid, const core::Field& P, int threads, core::Field& r,
                     Neighbours of = Neighbours::all);

/// The pressure on the grid of every second node: full weighting where all nine fine points carry pressure, injection
/// otherwise. in: the coarse grid, `fine` with ghost lines; out: with ghost lines.
void restrict_pressure(Cavitation model, const core::Field& fine, const core::Patch& grid, core::Field& coarse);

}  // namespace ehl::reynolds
