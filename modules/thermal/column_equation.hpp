#pragma once
// Discrete energy equation of a column, as used for its evaluation (column.cpp) and by Newton's method
// (column_newton.cpp).
#include "thermal/column.hpp"

namespace ehl::thermal {

/// Copies P and ln eta_bar of the column to each of its nodes.
void spread(const Nodes& nodes, Columns& at);
/// phi, moments, stresses, source f and its slope at the present temperatures.
void sources(const Nodes& nodes, const ColumnLaws& laws, Columns& at);
/// Updates them after a last step that changed theta by `change`. In converged columns the change is small, and the
/// viscosities are extrapolated linearly, which saves the exponentials; the error of phi is of second order in the
/// change. In all other columns they are evaluated again.
void follow(const Nodes& nodes, const ColumnLaws& laws, const Profile& change, core::LaneMask done, Columns& at);
/// Heat carried into the layer of node k by convection.
Lanes carried_into(const Nodes& nodes, const Columns& at, std::size_t k);
/// H q at a surface: k_bar times the slope of theta there, from the two nodes next to it. f = -k_bar theta''.
Lanes wall_flux(const Nodes& nodes, const Columns& at, std::size_t wall, std::size_t one, std::size_t two);
/// Computes q_1, q_2, heat and carried_off.
void heat_flow(const Nodes& nodes, Columns& at);

}  // namespace ehl::thermal
