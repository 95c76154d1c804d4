#pragma once
// The discrete energy equation of a column: what its value (column.cpp) and Newton's method (column_newton.cpp) share.
#include "thermal/column.hpp"

namespace ehl::thermal {

/// P and ln eta_bar of each node: those of the column.
void spread(const Nodes& nodes, Columns& at);
/// phi, moments, stresses, source f and its slope at the node's own temperature.
void sources(const Nodes& nodes, const ColumnLaws& laws, Columns& at);
/// The same after a last step that changed theta by `change`. Where a column is done the change is small, and its
/// viscosities follow along their slopes, which saves the exponentials; error of phi: the curvature of D, 1e-4 where
/// theta changes by 1e-3, and with its square. Elsewhere they are those of the new temperatures.
void follow(const Nodes& nodes, const ColumnLaws& laws, const Profile& change, core::LaneMask done, Columns& at);
/// What the neighbours bring into the layer of node k.
Lanes carried_into(const Nodes& nodes, const Columns& at, std::size_t k);
/// H q at a surface: k_bar times the slope of theta there, by the two nodes next to it. f = -k_bar theta''.
Lanes wall_flux(const Nodes& nodes, const Columns& at, std::size_t wall, std::size_t one, std::size_t two);
/// q_1, q_2, heat, carried_off.
void heat_flow(const Nodes& nodes, Columns& at);

}  // namespace ehl::thermal
