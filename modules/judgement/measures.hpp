#pragma once
// The numbers by which a state is judged.
#include <limits>
#include <vector>

#include "core/grid.hpp"
#include "core/quadratic_form.hpp"
#include "judgement/fitted_minimum.hpp"
#include "reynolds/residual.hpp"

namespace ehl::judgement {

struct Measures {
  double Hc = 0.0;          ///< H at (0,0)
  double Hm = 0.0;          ///< minimum of H over the nodes
  double residual = 0.0;    ///< relative residual of the complementarity problem
  double load_error = 0.0;  ///< relative
  double Hm_X = 0.0;        ///< where the film is thinnest
  double Hm_Y = 0.0;
  double Hm_fitted = 0.0;  ///< minimum of H between the nodes (fitted_minimum.hpp), and its place
  double Hm_fitted_X = 0.0;
  double Hm_fitted_Y = 0.0;
  double P_max = 0.0;             ///< over the nodes
  double P_rim = 0.0;             ///< over the nodes downstream where the dry contact has P < 0.8: a spike's, if any
  double largest_residual = 0.0;  ///< at one node, relative to the wedge term as the residual is
  double largest_residual_X = 0.0;
  double largest_residual_Y = 0.0;
  double least_P = 0.0;         ///< over all nodes
  double dry_violation = 0.0;   ///< largest residual of a cavitated node that calls for P > 0; relative
  double flow_through = 0.0;    ///< flow through the contact: integral of rho_bar H over |Y| <= 1 at X = 0
  double flow_imbalance = 0.0;  ///< net outflow of the pressurised region within |X|, |Y| <= 1.5, over flow_through
  double flow_imbalance_whole = 0.0;  ///< net outflow of the whole pressurised region, over flow_through
  /// Smallest oil content Q of all nodes; NaN without the mass conserving model.
  double least_content = std::numeric_limits<double>::quiet_NaN();
  double oil_imbalance = 0.0;  ///< net outflow of the domain over its inflow, with the mass conserving model
};

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
};
Measures measures(const Subject& subject);

}  // namespace ehl::judgement
