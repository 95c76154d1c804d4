#pragma once
// What a starved solution is beside the flooded one.
#include "core/grid.hpp"

namespace ehl::steady {

struct Scene;
struct Solution;

/// Q = rho_bar H at the centre; lengths in a, flows in rho0 u_m a^3/R.
struct Starvation {
  double supply_ratio = 0.0;  ///< r = H_oil/Q of the flooded contact, H_oil at Y = 0
  double factor = 0.0;        ///< Q over that of the flooded contact
  double Hc_flooded = 0.0;
  double Hm_flooded = 0.0;
  bool flooded_converged = false;
  double meniscus_X = 0.0;  ///< on Y = 0: where the inlet becomes full
  int cells_to_inlet = 0;   ///< from the inlet boundary to the first full node of any line
  double filled = 0.0;      ///< share of the inlet boundary where the gap takes no more
  double in = 0.0, through = 0.0, aside = 0.0;
  double imbalance = 0.0;  ///< (out + aside - in)/in
};

/// in: both solutions of one scene on one grid, with and without its supply.
Starvation starvation_of(const Scene& scene, const Solution& starved, const Solution& flooded);

}  // namespace ehl::steady
