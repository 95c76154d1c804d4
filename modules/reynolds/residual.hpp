#pragma once
// Residual of the discrete Reynolds equation, and the coefficient epsilon.
#include <span>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "reynolds/cavitation.hpp"
#include "reynolds/wedge.hpp"

namespace ehl::reynolds {

/// epsilon = rho_bar H^3 / (eta_bar lambda) (eq. 5). in: spans of one length; film thickness H, fluidity = 1/eta_bar.
/// limits: 0 where H < 0, a state that cycles can pass through on the way to a solution but that is none.
void epsilon(std::span<const double> H, std::span<const double> rho_bar, std::span<const double> fluidity,
             double lambda, std::span<double> eps);

/// What the equation needs of a state: nodes of one grid; on a mirrored one with one image line of P and eps.
struct State {
  const core::Field& P;
  const core::Field& H;
  const core::Field& rho_bar;
  const core::Field& eps;
  const core::Field& f;                 ///< right-hand side; an empty field means zero
  const core::Field& eps_across = eps;  ///< epsilon along Y, where it is another one
};

/// r = f - L(P) on the interior nodes, L(P) the left-hand side of eq. (4) with the transport given; 0 on the boundary.
/// On a mirrored grid with image lines. cost: the memory traffic of five fields in and one out. threads: result
/// independent of their number.
void residual(const core::Grid& grid, const State& state, const Transport& transport, int threads, core::Field& r);

/// How far the state is from solving the complementarity problem P >= 0, L(P) <= 0, P L(P) = 0.
struct ResidualNorms {
  double root_mean_square = 0.0;  ///< over the interior: r where P > 0, the violation max(0, L(P) - f) where P = 0
  double wedge = 0.0;             ///< root mean square of the transport term where P > 0: the scale of the equation
  double largest = 0.0;           ///< largest contribution to root_mean_square
  int i = 0;                      ///< and its node
  int j = 0;
  double largest_dry = 0.0;  ///< largest of them where P = 0: a cavitated node whose equation wants pressure
  double least_P = 0.0;      ///< lowest pressure of the interior where it is negative
  double relative() const { return root_mean_square / wedge; }
};

/// in: residual r as made by residual() from the same state. Without cavitation every point counts as P > 0.
ResidualNorms residual_norms(const core::Grid& grid, const State& state, const Transport& transport,
                             Cavitation cavitation, const core::Field& r);

}  // namespace ehl::reynolds
