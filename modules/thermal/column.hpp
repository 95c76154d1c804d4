#pragma once
// The energy equation across the film: columns of nodes from surface 2 (zeta = 0) to surface 1 (zeta = 1), several side
// by side, one in each lane of a vector register.
//
//   k_bar theta'' + f + (what the oil carries) = 0,   theta = (T - T0)/T0,
//   f = Br H^2 phi [tau_m t_N + s g_x (t_N + tau_m F') + s^2 (F' g_x^2 + (F/tau)_m g_y^2)] + compression,
// phi = 1/eta_bar(P, theta), s = zeta - z_bar; stresses in eta0 u_m R/a^2, velocities in u_m. Sliding shears every
// column by one tau_m = S(t_N), t_N = (u1 - u2)/(u_m H I0); the pressure's own flow is kept as a flow, not as a
// gradient g, because at a given gradient a column may have no solution. With moments of the fluidity I0 = int phi,
// z_bar = int zeta phi/I0, M2 = 12 int s^2 phi.
#include <array>

#include "core/simd.hpp"
#include "thermal/column_laws.hpp"

namespace ehl::thermal {

using core::Lanes;

using Profile = std::array<Lanes, most_nodes>;

/// What neighbours bring: a(theta_neighbour - theta) with a >= 0, over the layer of each node; the outermost have half
/// a step. `carried` is the sum of a theta_neighbour of the neighbouring columns.
struct Convection {
  Profile below{}, above{};  ///< a of the nodes k - 1 and k + 1 of the column itself
  Profile side{}, carried{};
  Profile compression{};  ///< source compression (1 + theta)
};

/// A batch of columns.
struct Columns {
  // in
  Lanes P{}, log_eta{};  ///< pressure; ln eta_bar(P) at T0
  Lanes fluidity{};      ///< exp(-log_eta)
  Lanes H{}, k_bar{};
  Lanes flow_x{}, flow_y{};  ///< mean velocities of the flow that pressure drives
  Lanes limit{};             ///< on tau_m
  Lanes heated{};            ///< share of the width that is sheared
  /// What the pressure's own flow makes of mobility_x, mobility_y and tau_m (rheology/flow_thinning.hpp).
  Lanes more_x = core::broadcast(1.0), more_y = more_x, less_tau = more_x;
  Lanes given_2{}, self_2{};  ///< surface: theta = given + self q, q the heat into it; self = 0: theta is given
  Lanes given_1{}, self_1{};
  Convection convection{};
  bool carries = false;  ///< convection counts
  // in, out
  Profile theta{};
  // out
  Lanes I0{}, z_bar{}, M2{};         ///< I0 and M2 over the fluidity at T0
  Lanes tau_m{};                     ///< magnitude
  Lanes unlimited{};                 ///< what it were without the limit
  Lanes mobility_x{}, mobility_y{};  ///< F', (F/tau)_m
  Lanes q_1{}, q_2{};                ///< into the surfaces, in k0 T0 R/a^2
  Lanes heat{};              ///< H times what is made in the column, in the same unit; q_1 + q_2 without convection
  Lanes carried_off{};       ///< by the oil, likewise
  Profile phi{};             ///< over the fluidity at T0
  core::LaneMask clipped{};  ///< theta was kept from its bounds in the last step
  // scratch
  Profile D{}, dD{}, f{}, df{}, f_I0{}, f_M2{}, f_z{}, lower{}, diagonal{}, upper{}, right{}, by_I0{}, by_M2{}, by_z{};
  Profile P_of_node{}, log_eta_of_node{};
  Lanes a{}, b{}, c{}, a_slope{}, b_slope{}, c_slope{};  // f = scale phi (a + b s + c s^2); slopes in ln I0
};

/// Newton's method for every column: fourth order in the step (Numerov), tridiagonal but for the three moments that
/// all nodes share. Each column goes its own way: the others in its batch change nothing. out: number of steps; most +
/// 1 where a column is not done. cost: a step takes three exponentials and 60 operations per node. limits: robust from
/// theta = 0 up to a Nahme number of 1e4 (tests); S, F of the shear law as rheology/shear.hpp.
int solve(const Nodes& nodes, const ColumnLaws& laws, Columns& columns, const Steps& steps);

/// Moments, stresses and heat fluxes at the temperatures as they are.
void evaluate(const Nodes& nodes, const ColumnLaws& laws, Columns& columns);

}  // namespace ehl::thermal
