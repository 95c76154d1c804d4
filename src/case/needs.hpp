#pragma once
// The memory and computing time that a case will need.
#include "case/scene.hpp"

namespace ehl::program {

/// Approximate needs of a case, for `ehl check`, and to refuse a case that does not fit into memory.
struct Needs {
  double bytes = 0.0;
  double seconds = 0.0;
};

/// Doubles per node of IDA's history of P and Q. [bench: needs_in_time]
inline constexpr double doubles_of_history = 30.0;

/// The grid of the deck. If an accuracy is asked for, the grid that will be found for it, to within one level, from
/// rough estimates of two errors: that of the mesh, from the cell size relative to the zone in which the film is
/// formed, and that of the domain, which decreases with the square of its size.
core::Grid predicted_grid(const steady::Scene& scene);

/// The needs of the basic model alone, and with the effects of the case. The time is that of a full multigrid solution
/// at the first attempt on a machine of the 2020s, to within a factor of 2.
Needs basic_needs(const steady::Scene& scene);
Needs expected_needs(const Case& input);

/// The grids for an accuracy may take this share of the memory that is free when the case is read. The rest is for
/// other programs and for the error of this estimate.
constexpr double share_of_memory = 0.5;

/// If an accuracy is asked for, sets the largest number of nodes that its grids may have, from the bytes per node with
/// all effects of the case and from free_memory().
void bound_accuracy(Case& input);

/// Adds an error to the deck if the machine lacks the memory for the case.
void check_memory(Case& input);

/// How the roughness of a steady contact enters its estimated time, as the end of the line that reports it. Empty if
/// the surfaces are smooth for their film.
std::string what_needs_leave_out(const Case& input);

}  // namespace ehl::program
