#pragma once
// The numbers by which a state is judged.
#include <vector>

#include "core/constants.hpp"
#include "core/grid.hpp"
#include "core/quadratic_form.hpp"
#include "judgement/fitted_minimum.hpp"
#include "reynolds/residual.hpp"

namespace ehl::judgement {

/// Every number is NaN until a state has been examined.
struct Measures {
  double Hc = core::unknown;          ///< H at (0,0)
  double Hm = core::unknown;          ///< minimum of H over the nodes
  double residual = core::unknown;    ///< relative residual of the complementarity problem
  double load_error = core::unknown;  ///< relative
  double Hm_X = core::unknown;        ///< where the film is thinnest
  double Hm_Y = core::unknown;
  double Hm_fitted = core::unknown;  ///< minimum of H between the nodes (fitted_minimum.hpp), and its place
  double Hm_fitted_X = core::unknown;
  double Hm_fitted_Y = core::unknown;
  double P_max = core::unknown;  ///< over the nodes
  double P_rim = core::unknown;  ///< over the nodes downstream where the dry contact has P < 0.8: a spike's, if any
  double largest_residual = core::unknown;  ///< at one node, relative to the wedge term as the residual is
  double largest_residual_X = core::unknown;
  double largest_residual_Y = core::unknown;
  double least_P = core::unknown;        ///< over all nodes
  double dry_violation = core::unknown;  ///< largest residual of a cavitated node that calls for P > 0; relative
  double flow_through = core::unknown;   ///< flow through the contact: integral of rho_bar H over |Y| <= 1 at X = 0
  double flow_imbalance =
      core::unknown;  ///< net outflow of the pressurised region within |X|, |Y| <= 1.5, over flow_through
  double flow_imbalance_whole = core::unknown;  ///< net outflow of the whole pressurised region, over flow_through
  /// Smallest oil content Q of all nodes; NaN without the mass conserving model.
  double least_content = core::unknown;
  double oil_imbalance = core::unknown;  ///< net outflow of the domain over its inflow, with the mass conserving model
};

/// A spike lies where the dry contact has less than this share of its largest pressure.
inline constexpr double of_rim = 0.8;

/// The weights of the nodes in the value at (X, Y), as in value_at().
std::vector<NodeWeight> weights_at(const core::Patch& grid, double X, double Y);
/// Value at (X, Y): that of a node within 1e-9 of a cell, else by bicubic interpolation. limits: (X, Y) inside the
/// domain.
double value_at(const core::Patch& grid, const core::Field& field, double X, double Y);

/// A state, and the equations that it should satisfy.
struct Subject {
  const core::Patch& grid;
  reynolds::Fields fields;
  const core::Field& r;  ///< residual of these fields
  const reynolds::Transport& transport;
  reynolds::Cavitation cavitation;
  const core::QuadraticForm& outline;  ///< 1 along the edge of the dry contact
  double carried = 0.0;                ///< load
  double wanted = 0.0;
  const core::Field& on_bodies;  ///< pressure of the fluid and of touching surfaces
};
Measures measures(const Subject& subject);

}  // namespace ehl::judgement
