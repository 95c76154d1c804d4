#pragma once
// What flows into the pressurised region against what flows out of it.
#include "core/grid.hpp"
#include "reynolds/residual.hpp"
#include "reynolds/wedge.hpp"

namespace ehl::reynolds {

/// Mass flow in units of rho0 u_m a^3/R (u_m the mean surface speed) through the boundary of the pressurised region.
struct FlowBalance {
  double in = 0.0;       ///< through the faces by which it enters
  double out = 0.0;      ///< through the faces by which it leaves
  double through = 0.0;  ///< integral of rho_bar H over |Y| <= width at X = 0: the flow through the contact
  /// What appears (> 0) or is lost (< 0) inside, relative to the flow through the contact.
  double imbalance() const { return (out - in) / through; }
};

/// The flow along X through the face between the nodes i and i+1 of line j, U rho_bar H - eps dP/dX.
double flow_along(const core::Patch& grid, const Fields& state, const Transport& transport, int i, int j);

/// What is looked at: |X| <= X, |Y| <= Y, and the contact's own half width.
struct Reach {
  double X;
  double Y;
  double width = 1.0;
};

/// Sums the fluxes (U rho_bar H - eps dP/dX, -eps dP/dY) over the faces around the nodes within reach and with P > 0;
/// every interior node stands for a cell hx x hy around it. The fluxes are those of flux.hpp.
/// Then out - in is the sum of hx hy r over the region, without residual() having been asked: zero where eq. (4) holds,
/// whatever the shape of the region.
/// in: P, H, rho_bar and eps of `state`; f is not looked at and must be zero. Without cavitation every node within
/// reach belongs to the region; X, Y > 0, infinity for the whole domain. limits: `through` is taken at the column next
/// to X = 0 and is 0 without a node in |Y| <= width.
/// cost: one pass over P within reach, the other fields along the boundary only.
FlowBalance flow_balance(const core::Patch& grid, const Fields& state, const Transport& transport,
                         Cavitation cavitation, const Reach& reach);
/// |X|, |Y| <= reach of a circular contact.
inline FlowBalance flow_balance(const core::Patch& grid, const Fields& state, const Transport& transport,
                                Cavitation cavitation, double reach) {
  return flow_balance(grid, state, transport, cavitation, Reach{reach, reach});
}

/// Oil through the edges of the domain, in units of rho0 u_m a^3/R: in by the inlet, out by the outlet, aside by both
/// sides; net of what flows back. Where the equation holds, out + aside = in, less what the film stores in time.
struct OilBalance {
  double in = 0.0;
  double out = 0.0;
  double aside = 0.0;
  double stored() const { return in - out - aside; }  ///< per time
  double imbalance() const { return -stored() / in; }
};
/// Of the mass conserving model. in: a state with the content that residual() left.
OilBalance oil_balance(const core::Patch& grid, const Fields& state, const Transport& transport);

}  // namespace ehl::reynolds
