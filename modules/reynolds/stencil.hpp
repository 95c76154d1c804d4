#pragma once
// The discrete Reynolds equation at one node (eq. 4), for a double or for a batch of lines at once.
#include <array>

#include "reynolds/wedge.hpp"

namespace ehl::reynolds {

/// epsilon/h^2 at the four half points around a node: arithmetic means of the nodes' values (below eq. 4),
/// e.g. west = (eps_{i-1,j} + eps_{i,j}) / (2 hx^2). Along X and along Y with epsilons of their own, where these
/// differ.
template <class Number>
struct HalfPoints {
  Number west, east, south, north;
};

template <class Number>
HalfPoints<Number> half_points(Number west, Number east, Number centre, Number south, Number north,
                               Number centre_across, double half_over_hx2, double half_over_hy2) {
  return {(west + centre) * half_over_hx2, (east + centre) * half_over_hx2, (south + centre_across) * half_over_hy2,
          (north + centre_across) * half_over_hy2};
}

/// The same of a node of two fields, eps along X and eps_across along Y: the same field where they are one.
template <class Field>
HalfPoints<double> half_points_at(const Field& eps, const Field& eps_across, int i, int j, double half_over_hx2,
                                  double half_over_hy2) {
  return half_points(eps(i - 1, j), eps(i + 1, j), eps(i, j), eps_across(i, j - 1), eps_across(i, j + 1),
                     eps_across(i, j), half_over_hx2, half_over_hy2);
}

/// The Poiseuille terms: sum over the four neighbours of e (P_neighbour - P_centre).
template <class Number>
Number poiseuille(const HalfPoints<Number>& e, Number west, Number east, Number south, Number north, Number centre) {
  return e.west * (west - centre) + e.east * (east - centre) + e.south * (south - centre) + e.north * (north - centre);
}

/// Weights of rho_bar H at i, i-1, i-2 in U d(rho_bar H)/dX + c rho_bar H at column i >= 1.
inline std::array<double, 3> transport_weights(const Transport& transport, int i, double hx) {
  const double U = transport.speed;
  if (transport.wedge == Wedge::upstream2 && i >= 2)
    return {U * 1.5 / hx + transport.squeeze, U * -2.0 / hx, U * 0.5 / hx};
  return {U / hx + transport.squeeze, -U / hx, 0.0};
}

}  // namespace ehl::reynolds
