#pragma once
// The numbers by which a state is judged.
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
  double Hm_fitted = 0.0;  ///< minimum of H between the nodes (fitted_minimum.hpp), and where it is
  double Hm_fitted_X = 0.0;
  double Hm_fitted_Y = 0.0;
  double P_max = 0.0;  ///< over the nodes
  double P_rim = 0.0;  ///< over those downstream where the dry contact has less than 0.8: of a spike, if there is one
  double largest_residual = 0.0;  ///< at one node; relative to the wedge term, like the residual
  double largest_residual_X = 0.0;
  double largest_residual_Y = 0.0;
  double least_P = 0.0;         ///< over all nodes
  double dry_violation = 0.0;   ///< largest residual in a cavitated node whose equation wants pressure; relative
  double flow_through = 0.0;    ///< through the contact: integral of rho_bar H over |Y| <= 1 at X = 0
  double flow_imbalance = 0.0;  ///< out of the pressurised region within |X|, |Y| <= 1.5 less in, over flow_through
  double flow_imbalance_whole = 0.0;  ///< the same of all of the pressurised region
  double oil_imbalance = 0.0;         ///< out of the domain less in, over in, of the mass conserving model
};

/// The nodes' shares in the value at (X, Y), as below.
std::vector<NodeWeight> weights_at(const core::Patch& grid, double X, double Y);
/// Value at (X, Y): the node's where there is one within 1e-9 of a cell, else by bicubic interpolation.
/// limits: (X, Y) inside the domain.
double value_at(const core::Patch& grid, const core::Field& field, double X, double Y);

/// A state and the equations it is held against.
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
