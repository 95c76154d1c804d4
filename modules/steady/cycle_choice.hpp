#pragma once
// How the multigrid works on a scene: its cycles, weights and coarsest grid.
#include "fmg/parameters.hpp"
#include "steady/scene.hpp"

namespace ehl::steady {

/// How a climb begins, and how cautious it is.
struct Start {
  int cells = 64;                 ///< along x on the first grid, at least
  int sweeps = 20;                ///< relaxations of that grid alone, from the Hertz pressure
  int cycles = 4;                 ///< cycles on that grid, at least
  int coarsest = 32;              ///< cells along x of the coarsest grid of all cycles, at least
  int balances = 10;              ///< relaxations with force balance on the coarsest grid
  double caution_at_first = 1.0;  ///< factor on all under-relaxation weights on the first grid
  double caution = 1.0;           ///< and on the finer ones
  bool across = false;            ///< relaxations along Y too from the first cycle on; of square cells
  double coarseness = 0.0;        ///< the first grid's step, at most, over the one that resolves the film; 0: any
  int pre = 0, post = 0;          ///< relaxations in a cycle, of a line; 0: as many as usual
};

/// ln eta_bar in the Hertz pressure one film zone inside the contact's edge: how steeply epsilon falls there.
double log_viscosity_at_edge(const Scene& scene);

/// Factor to begin with on the weight where epsilon is steep: less than 1 where the viscosity rises so fast inside the
/// contact's edge that full weights oscillate there.
double steep_caution(const Scene& scene);

/// What the scene sets, and for the rest what its contact and cells ask for. Cycles that it leaves open are F(2,0) to
/// the level of the discretization error, V(2,0) of a line; W(2,1) of stretched cells and towards a tolerance; nu_2 is
/// 1 behind a steep edge. More relaxations of contacts long along the motion, and of heavy lines as the start has it.
fmg::Parameters parameters_of(const Scene& scene, const Start& start);

}  // namespace ehl::steady
