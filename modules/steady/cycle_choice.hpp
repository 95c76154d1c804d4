#pragma once
// The choice of cycles, under-relaxation weights and coarsest grid for a scene.
#include "multigrid/parameters.hpp"
#include "steady/scene.hpp"

namespace ehl::steady {

/// How a full multigrid solve starts, and how strongly it is damped.
struct Start {
  int cells = 64;                 ///< cells along x of the first grid, at least
  int sweeps = 20;                ///< relaxations of the first grid alone, from the Hertz pressure
  int cycles = 4;                 ///< cycles on the first grid, at least
  int coarsest = 32;              ///< cells along x of the coarsest grid of every cycle, at least
  int balances = 10;              ///< relaxations with force balance on the coarsest grid
  double damping_at_first = 1.0;  ///< factor on all under-relaxation weights on the first grid
  double damping = 1.0;           ///< the same factor on the finer grids
  bool across = false;            ///< Y sweeps from the first cycle on; square cells only
  double coarseness = 0.0;        ///< largest mesh size of the first grid, in resolving_step(); 0: no limit
  int pre = 0, post = 0;          ///< nu_1 and nu_2 for line contacts; 0: as usual
};

/// ln eta_bar at the Hertz pressure one film zone inside the edge of the contact: how steeply epsilon falls there.
double log_viscosity_at_edge(const Scene& scene);

/// Initial factor on the under-relaxation weight where epsilon is steep. It is below 1 if the viscosity rises so fast
/// inside the edge that full weights oscillate.
double steep_damping(const Scene& scene);

/// The multigrid parameters of a scene: those that the scene sets, the others chosen for its contact and cells.
/// Cycle: F(2,0), or V(2,0) for line contacts, down to the level of the discretization error; W(2,1) on stretched cells
/// and for a given tolerance. nu_2 = 1 if the edge is steep. Contacts elongated in the rolling direction get more
/// relaxations, and so do heavily loaded line contacts, if `start` says so.
multigrid::Parameters parameters_of(const Scene& scene, const Start& start);

}  // namespace ehl::steady
