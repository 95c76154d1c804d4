#pragma once
// Energy equation across the film: columns of nodes from surface 2 (zeta = 0) to surface 1 (zeta = 1), several columns
// at once, one in each lane of a vector register.
//
//   k_bar theta'' + f + convection = 0,   theta = (T - T0)/T0,
//   f = Br H^2 phi [tau_m t_N + s g_x (t_N + tau_m F') + s^2 (F' g_x^2 + (F/tau)_m g_y^2)] + compression,
//
// with phi = 1/eta_bar(P, theta), s = zeta - z_bar; stresses in eta0 u_m R/a^2, velocities in u_m. Sliding shears each
// column with one stress tau_m = S(t_N), t_N = (u1 - u2)/(u_m H I0). The pressure flow is held as a flow, not as a
// gradient g, because a column may have no solution at a given gradient. Moments of the fluidity:
//
//   I0 = int phi,   z_bar = int zeta phi/I0,   M2 = 12 int s^2 phi.
#include <array>

#include "core/simd.hpp"
#include "thermal/column_laws.hpp"

namespace ehl::thermal {

using core::Lanes;

using Profile = std::array<Lanes, most_nodes>;

/// Heat from the neighbours: a (theta_neighbour - theta) with a >= 0, integrated over the layer of each node; the
/// outermost layers are half a step thick. `carried` is the sum of a theta_neighbour over the neighbouring columns.
struct Convection {
  Profile below{}, above{};  ///< a of the nodes k - 1 and k + 1 of the same column
  Profile side{}, carried{};
  Profile compression{};  ///< heat source compression (1 + theta)
};

/// A batch of columns, one per lane.
struct Columns {
  // in
  Lanes P{}, log_eta{};  ///< pressure; ln eta_bar(P) at T0
  Lanes fluidity{};      ///< exp(-log_eta)
  Lanes H{}, k_bar{};
  Lanes flow_x{}, flow_y{};  ///< mean velocities of the pressure flow
  Lanes limit{};             ///< upper bound of tau_m
  Lanes heated{};            ///< share of the width that is sheared
  /// Factors from shear thinning by the pressure flow, on mobility_x, mobility_y and tau_m
  /// (rheology/flow_thinning.hpp).
  Lanes more_x = core::broadcast(1.0), more_y = more_x, less_tau = more_x;
  Lanes given_2{}, self_2{};  ///< surface: theta = given + self q, q the heat flux into it; self = 0: given temperature
  Lanes given_1{}, self_1{};
  Convection convection{};
  bool carries = false;  ///< convection is included
  // in, out
  Profile theta{};
  // out
  Lanes I0{}, z_bar{}, M2{};         ///< I0 and M2 over the fluidity at T0
  Lanes tau_m{};                     ///< magnitude
  Lanes unlimited{};                 ///< tau_m without the limit
  Lanes mobility_x{}, mobility_y{};  ///< F', (F/tau)_m
  Lanes q_1{}, q_2{};                ///< into the surfaces, in k0 T0 R/a^2
  Lanes heat{};              ///< H times the heat generated in the column, in k0 T0 R/a^2; q_1 + q_2 without convection
  Lanes carried_off{};       ///< heat carried off by the oil, in the same unit
  Profile phi{};             ///< over the fluidity at T0
  core::LaneMask clipped{};  ///< the last step was limited by the bounds of theta
  // scratch
  Profile D{}, dD{}, f{}, df{}, f_I0{}, f_M2{}, f_z{}, lower{}, diagonal{}, upper{}, right{}, by_I0{}, by_M2{}, by_z{};
  Profile P_of_node{}, log_eta_of_node{};
  Lanes a{}, b{}, c{}, a_slope{}, b_slope{}, c_slope{};  // f = scale phi (a + b s + c s^2); slopes in ln I0
};

/// Solves all columns by Newton's method. The scheme is of order 4 in the step (Numerov) and tridiagonal except for
/// three moments that couple all nodes. The result of a column does not depend on the others in its batch. returns the
/// number of steps; most + 1 if a column has not converged. cost: three exponentials and 60 operations per node and
/// step.
/// limits: converges from theta = 0 up to a Nahme number of 1e4 (tests). S, F of the shear law as in
/// rheology/shear.hpp.
int solve(const Nodes& nodes, const ColumnLaws& laws, Columns& columns, const Steps& steps);

/// Moments, stresses and heat fluxes at the present temperatures.
void evaluate(const Nodes& nodes, const ColumnLaws& laws, Columns& columns);

}  // namespace ehl::thermal
