#pragma once
// Norms and sums over the interior nodes, in a fixed order: the same bits for any number of threads.
#include "core/field.hpp"

namespace ehl::core {

/// sum over the interior nodes of f. order of summation: along y within a station, then the stations in order.
double interior_sum(const Field& f);
/// The same over the interior of the patch's domain, images included.
double interior_sum(const Patch& patch, const Field& f);

/// sqrt(mean over the interior nodes of f^2).
double root_mean_square(const Field& f);

/// max |f| over all nodes; NaN where one is met, so that it shows.
double max_abs(const Field& f);

/// max |f - g| over all nodes; NaN where one is met. limits: same shape.
double max_abs_difference(const Field& f, const Field& g);

struct Location {
  int i = 0;
  int j = 0;
  double value = 0.0;
};

/// The smallest value over all nodes and the first node (in storage order) that has it.
Location minimum(const Field& f);
/// The largest value over all nodes and the first node (in storage order) that has it.
Location maximum(const Field& f);

}  // namespace ehl::core
