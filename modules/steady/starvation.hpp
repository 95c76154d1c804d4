#pragma once
// Comparison of a starved solution with the flooded one.
#include "core/grid.hpp"

namespace ehl::steady {

struct Scene;
struct Solution;

/// Q = rho_bar H at the centre. Lengths are in a, flows in rho0 u_m a^3/R, for a line contact in rho0 u_m a^2/R.
struct Starvation {
  double supply_ratio = 0.0;  ///< r = H_oil/Q of the flooded contact, H_oil on Y = 0
  double factor = 0.0;        ///< Q over that of the flooded contact
  double Hc_flooded = 0.0;
  double Hm_flooded = 0.0;
  bool flooded_converged = false;
  bool line = false;        ///< a line contact
  double meniscus_X = 0.0;  ///< where the inlet becomes full on Y = 0
  int cells_to_inlet = 0;   ///< from the inlet boundary to the first full node of any line
  double filled = 0.0;      ///< share of the inlet boundary where the supply fills the gap
  double in = 0.0, through = 0.0, aside = 0.0;
  double around() const { return in - aside - through; }  ///< passes beside the contact and leaves by the outlet
  double imbalance = 0.0;                                 ///< (out + aside - in)/in
  double seconds = 0.0;                                   ///< time for the supply: all but that of the flooded contact
};

/// One of several contacts on the same track; oil on y = 0 in units of H.
struct Pass {
  int number = 1;
  double supply = 0.0;        ///< layer that is brought
  double supply_error = 0.0;  ///< relative, due to the mesh of all previous passes; NaN: not known (layer_error.hpp)
  double left = 0.0;          ///< layer that is left behind
  double supply_ratio = 0.0;  ///< supply over rho_bar H at the centre of the flooded contact
  double factor = 0.0;        ///< rho_bar H at the centre over that of the flooded contact
  double Hc = 0.0, Hm = 0.0, P_max = 0.0;
  double meniscus_X = 0.0;
  double in = 0.0, aside = 0.0, imbalance = 0.0;
  int steps = 0;        ///< cycles on the finest grid, or Newton steps
  int first_order = 0;  ///< chattering nodes, behind which the flux is of first order
  double residual = 0.0;
  bool chatters = false;  ///< true if nodes at the edge of the film chatter (passes.cpp)
};

/// rho_bar H C at the centre.
double carried_at_centre(const Scene& scene, const Solution& solution);
/// X at which the inlet becomes full on line j: within the cell of the last node without pressure, in proportion to its
/// oil content.
double meniscus_on(const Solution& solution, int j);

/// in: both solutions of one scene on one grid, with and without its supply.
Starvation starvation_of(const Scene& scene, const Solution& starved, const Solution& flooded);

}  // namespace ehl::steady
