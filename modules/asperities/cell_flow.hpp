#pragma once
// Reynolds' equation on a rough cell: how much a mean pressure gradient lets through.
#include <vector>

#include "asperities/cosine_transform.hpp"

namespace ehl::asperities {

enum class FlowAlong { x, y };

/// The mean flow along one axis over that of a smooth gap of the given height.
struct CellFlow {
  double factor = 0.0;    ///< phi = (mean of g^3 dp/dx)/(h^3 times the mean of dp/dx)
  double residual = 0.0;  ///< of the linear system
  int iterations = 0;
};

/// Solves div(g^3 grad p) = 0 with p = 1 and 0 on two opposite edges and no flow through the other two, the numerical
/// experiment of Patir and Cheng; on the mirrored cell this is a periodic flow under a mean gradient. Where g <= 0 the
/// surfaces touch and nothing flows; what these points enclose takes no part.
///
/// Between two points the gap is a straight line to the middle and another one from there; the middle is the cubic
/// through four points, or the mean of the two where one of the four touches. The conductance follows exactly: a line
/// from g1 to g2 has the resistance (g1 + g2)/(2 g1^2 g2^2) per length.
/// in: gap [m] at the points. out: factor 0 if no way is open, or h <= 0. order: 2 for an open gap.
CellFlow flow_through(const Cell& cell, const std::vector<double>& gap, double h, FlowAlong along);

}  // namespace ehl::asperities
