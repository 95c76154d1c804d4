#pragma once
// The choice of cycles, under-relaxation weights and coarsest grid for a scene.
#include <string>
#include <vector>

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

/// What the tables of rules (cycle_choice.cpp, starts.cpp) ask of a contact and its cells.
struct Features {
  bool line = false;       ///< a single line of nodes
  bool stretched = false;  ///< cells with hx >= sqrt(2) hy
  bool oblique = false;    ///< the motion is along neither axis of the contact
  bool elongated = false;  ///< in the rolling direction (resolution.hpp)
  bool circular = false;
  bool flattened = false;  ///< the expected film is below the approach of the dry bodies
  bool resolved = false;   ///< the usual first grid resolves the film zones (multigrid_solve.hpp, held_by())
  double edge = 0.0;   ///< ln eta_bar at the Hertz pressure one film zone inside the edge: how steeply epsilon falls
  bool steep = false;  ///< full weights oscillate where epsilon is steep, since `edge` is large
  bool steep_for_line = false;  ///< lines: coarse grids that do not resolve the film zones return poor corrections
};
Features features_of(const Scene& scene);

/// ln eta_bar at the Hertz pressure one film zone inside the edge of the contact.
double log_viscosity_at_edge(const Scene& scene);

/// Initial factor on the under-relaxation weight where epsilon is steep: below 1 if Features::steep.
double steep_damping(const Scene& scene);

/// The multigrid parameters of a scene: those that the scene sets, the others as a table of rules (cycle_choice.cpp)
/// chooses them for its contact and cells.
multigrid::Parameters parameters_of(const Scene& scene, const Start& start);

/// Names of the rules that apply.
std::vector<std::string> rules_of(const Scene& scene, const Start& start);

}  // namespace ehl::steady
