#pragma once
// One sweep of the hybrid line relaxation, implemented independently: point by point from the equations, without vector
// lanes, batches or a band matrix.
#include "multigrid/hierarchy.hpp"

namespace ehl::tests {

struct PlainSweep {
  core::Field P;         ///< the pressure after both colours
  int single = 0;        ///< points with Gauss-Seidel relaxation
  int distributive = 0;  ///< points with distributive relaxation
  int held = 0;          ///< cavitated points that stay cavitated
  int clipped = 0;       ///< pressures limited by P >= 0
  int bounded = 0;       ///< changes limited by most_change
  int withheld = 0;      ///< distributed changes that were not applied to a point, because they exceeded
                         ///< its pressure under a squeeze
};

/// The film, epsilon and the density are those of `level`: they are updated after the sweep.
PlainSweep plain_sweep(const multigrid::Problem& problem, const multigrid::RelaxationParameters& parameters,
                       const multigrid::Level& level);

}  // namespace ehl::tests
