#pragma once
// Data that all columns of the energy equation share (column.hpp).
#include <array>

#include "rheology/shear.hpp"
#include "rheology/thermal_viscosity.hpp"

namespace ehl::thermal {

/// Size of the arrays of a column. [bench: thermal_most_nodes]
inline constexpr int most_nodes = 65;

/// The nodes zeta_k = k/intervals and the weights of integrals over them.
struct Nodes {
  int intervals = 0;
  double step = 0.0;
  std::array<double, most_nodes> zeta{};
  std::array<double, most_nodes> simpson{};  ///< weights of the moments
  std::array<double, most_nodes> heat{};     ///< weights that close the heat balance of the scheme exactly; order 4
};
/// in: intervals even, 4 to 64. errors: InputError.
Nodes make_nodes(int intervals);

/// Data that all columns share.
struct ColumnLaws {
  rheology::ThermalViscosity viscosity;
  rheology::ShearThinning thinning{rheology::Eyring{}, 0.0};  ///< k = 0: Newtonian
  double sliding = 0.0;                                       ///< (u1 - u2)/u_m
  double Br = 0.0;                                            ///< eta0 u_m^2/(k0 T0)
  /// Bounds of theta during the iteration.
  double theta_least = -0.1, theta_most = 2.5;
};

/// Limits of Newton's method for a column.
struct Steps {
  int most = 30;
  double tolerance = 1e-12;  ///< on the change of theta
};

}  // namespace ehl::thermal
