#pragma once
// What a case will need of the machine.
#include "case/scene.hpp"

namespace ehl::program {

/// What the case will need, nearly: for `check`, and to refuse what cannot fit.
struct Needs {
  double bytes = 0.0;
  double seconds = 0.0;
};

/// The grid that is given; or the one that an accuracy will lead to, within a level: by the error that a mesh has
/// beside the zones where the film is made, and the rough error of the domain, which falls with the square of its size.
core::Grid foretold_grid(const steady::Scene& scene);

/// Of the basic model alone, and with the effects that the case calls for. The seconds are those of a solution that the
/// full multigrid finds at once, on a machine of the 2020s: right within a factor of 2.
Needs basic_needs(const steady::Scene& scene);
Needs expected_needs(const Case& input);

/// Share of the memory that is free when a case is read which the grids for an accuracy may take. The rest is left to
/// other programs, and to what the estimate of the needs is off.
constexpr double share_of_memory = 0.5;

/// Where an accuracy is asked for: the nodes of the largest grid that it may lead to, from the bytes that a node takes
/// with all effects of the case, and from free_memory().
void bound_accuracy(Case& input);

/// Complains in the case's deck where the machine has not the memory for it.
void check_memory(Case& input);

}  // namespace ehl::program
