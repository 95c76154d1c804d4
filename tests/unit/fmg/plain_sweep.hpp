#pragma once
// One sweep of the hybrid line relaxation, written a second time: point by point from the equations, without lanes,
// batches or a band.
#include "fmg/hierarchy.hpp"

namespace ehl::tests {

struct PlainSweep {
  core::Field P;         ///< the pressure after both colours
  int single = 0;        ///< points relaxed alone
  int distributive = 0;  ///< points whose change was distributed
  int held = 0;          ///< cavitated points that stay so
  int clipped = 0;       ///< pressures that the bound P >= 0 stopped
  int bounded = 0;       ///< changes that most_change stopped
  int withheld = 0;      ///< distributed changes that asked a point for more than its pressure, under a squeeze
};

/// The film, epsilon and the density are those of `level` throughout: they are renewed after the sweep.
PlainSweep plain_sweep(const fmg::Problem& problem, const fmg::RelaxationParameters& parameters,
                       const fmg::Level& level);

}  // namespace ehl::tests
