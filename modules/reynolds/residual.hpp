#pragma once
// Residual of the discrete Reynolds equation.
#include "core/field.hpp"
#include "core/grid.hpp"
#include "reynolds/cavitation.hpp"
#include "reynolds/wedge.hpp"

namespace ehl::reynolds {

/// The fields in the equation, on the nodes of one patch; P and eps with ghost lines.
struct Fields {
  const core::Field& P;
  const core::Field& H;
  const core::Field& rho_bar;
  const core::Field& eps;
  const core::Field& f;                 ///< right-hand side; an empty field means zero
  const core::Field& eps_across = eps;  ///< epsilon along Y, if it differs
  Face face = Face::mean;               ///< how both are stored
  /// theta (flux.hpp) of the face downstream of each node along X; not read with Face::mean and a wedge of lower order.
  const core::Field& third_order = eps;
  const core::Field* content = nullptr;  ///< Q of the mass-conserving model (content.hpp); else null
  /// Mass-conserving model: > 0 at chattering nodes; the flux downstream of the next node is of first order.
  const core::Field* chatters = nullptr;
};

/// r = f - L(P) on the interior nodes, L(P) the left-hand side of eq. (4) with the given transport; 0 on the boundary.
/// out: with ghost lines. cost: memory traffic of five fields in and one out. threads: the result is independent of
/// their number.
void residual(const core::Patch& grid, const Fields& state, const Transport& transport, int threads, core::Field& r);

/// How far the state is from solving the complementarity problem P >= 0, L(P) <= f, P (L(P) - f) = 0.
struct ResidualNorms {
  double root_mean_square = 0.0;  ///< over the interior: r where P > 0, the violation max(0, L(P) - f) where P = 0
  double wedge = 0.0;             ///< root mean square of the transport term where P > 0: the scale of the equation
  double largest = 0.0;           ///< largest contribution to root_mean_square
  int i = 0;                      ///< node of that contribution
  int j = 0;
  double largest_dry = 0.0;  ///< largest cavitation residual: a node with P = 0 whose equation asks for P > 0
  double least_P = 0.0;      ///< lowest pressure of the interior if it is negative, else 0
  double relative() const { return root_mean_square / wedge; }
};

/// Norms of a residual. in: r by residual() of the same state. Without cavitation every point counts as P > 0.
ResidualNorms residual_norms(const core::Patch& grid, const Fields& state, const Transport& transport,
                             Cavitation cavitation, const core::Field& r);

}  // namespace ehl::reynolds
