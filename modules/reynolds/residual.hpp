#pragma once
// Residual of the discrete Reynolds equation.
#include "core/field.hpp"
#include "core/grid.hpp"
#include "reynolds/cavitation.hpp"
#include "reynolds/wedge.hpp"

namespace ehl::reynolds {

/// What the equation needs: nodes of one patch; P and eps with ghost lines.
struct Fields {
  const core::Field& P;
  const core::Field& H;
  const core::Field& rho_bar;
  const core::Field& eps;
  const core::Field& f;                 ///< right-hand side; an empty field means zero
  const core::Field& eps_across = eps;  ///< epsilon along Y, where it is another one
  Face face = Face::mean;               ///< how both are kept
  /// theta (flux.hpp) of the face behind each node along X: of Face::mean without a third-order wedge not read.
  const core::Field& third_order = eps;
  const core::Field* content = nullptr;  ///< Q, where it is not rho_bar H everywhere (content.hpp)
  /// Of that model: > 0 at nodes that swing between wet and dry; the flux behind the next one is of first order.
  const core::Field* swings = nullptr;
};

/// r = f - L(P) on the interior nodes, L(P) the left-hand side of eq. (4) with the transport given; 0 on the boundary.
/// out: with ghost lines. cost: the memory traffic of five fields in and one out. threads: result
/// independent of their number.
void residual(const core::Patch& grid, const Fields& state, const Transport& transport, int threads, core::Field& r);

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
ResidualNorms residual_norms(const core::Patch& grid, const Fields& state, const Transport& transport,
                             Cavitation cavitation, const core::Field& r);

}  // namespace ehl::reynolds
