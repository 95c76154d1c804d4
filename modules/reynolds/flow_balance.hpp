#pragma once
// Balance of the flows into and out of the pressurised region.
#include "core/grid.hpp"
#include "reynolds/residual.hpp"
#include "reynolds/wedge.hpp"

namespace ehl::reynolds {

/// Mass flow in units of rho0 u_m a^3/R (u_m the mean surface speed) through the boundary of the pressurised region.
struct FlowBalance {
  double in = 0.0;       ///< through the faces by which it enters
  double out = 0.0;      ///< through the faces by which it leaves
  double through = 0.0;  ///< integral of rho_bar H over |Y| <= width at X = 0: the flow through the contact
  /// Mass that appears (> 0) or is lost (< 0) inside, relative to the flow through the contact.
  double imbalance() const { return (out - in) / through; }
};

/// The flow along X through the face between the nodes i and i+1 of line j, U rho_bar H - eps dP/dX.
double flow_along(const core::Patch& grid, const Fields& state, const Transport& transport, int i, int j);

/// The region of a balance, |X| <= X and |Y| <= Y, and the half width of the contact.
struct Reach {
  double X;
  double Y;
  double width = 1.0;
};

/// Sums the fluxes (U rho_bar H - eps dP/dX, -eps dP/dY) over the faces around the nodes within reach and with P > 0;
/// every interior node stands for a cell hx x hy around it. The fluxes are those of flux.hpp. Then out - in is the sum
/// of hx hy r over the region, without a call of residual(): zero where eq. (4) holds, for any shape of the region.
///
/// in: P, H, rho_bar and eps of `state`; f is not read and must be zero. Without cavitation every node within reach
/// belongs to the region; X, Y > 0, infinity for the whole domain. limits: `through` is taken at the column next to X =
/// 0 and is 0 without a node in |Y| <= width. cost: one pass over P within reach, the other fields along the boundary
/// of the region only.
FlowBalance flow_balance(const core::Patch& grid, const Fields& state, const Transport& transport,
                         Cavitation cavitation, const Reach& reach);
/// Flow balance of a circular contact within |X|, |Y| <= reach.
inline FlowBalance flow_balance(const core::Patch& grid, const Fields& state, const Transport& transport,
                                Cavitation cavitation, double reach) {
  return flow_balance(grid, state, transport, cavitation, Reach{reach, reach});
}

/// Oil through the boundaries of the domain, in units of rho0 u_m a^3/R: in through the inlet, out through the outlet,
/// aside through both sides; each net of what flows back. Where the equation holds, out + aside = in, less what the
/// film stores per time.
struct OilBalance {
  double in = 0.0;
  double out = 0.0;
  double aside = 0.0;
  double stored() const { return in - out - aside; }  ///< in the film, per time
  double imbalance() const { return -stored() / in; }
};
/// Oil balance in the mass-conserving model. in: a state with the content that residual() has written.
OilBalance oil_balance(const core::Patch& grid, const Fields& state, const Transport& transport);

}  // namespace ehl::reynolds
