#pragma once
// Norms and sums in a fixed order: the result does not depend on the number of threads.
#include "core/field.hpp"

namespace ehl::core {

/// Sum of f over the interior nodes. order of summation: along y within a column, then over the columns.
double interior_sum(const Field& f);
/// Sum over the interior of the patch's domain, mirror images included.
double interior_sum(const Patch& patch, const Field& f);

/// sqrt(mean of f^2 over the interior nodes).
double root_mean_square(const Field& f);

/// max |f| over all nodes; NaN if there is one.
double max_abs(const Field& f);

/// max |f - g| over all nodes; NaN if there is one. limits: same shape.
double max_abs_difference(const Field& f, const Field& g);

/// A node and its value.
struct Location {
  int i = 0;
  int j = 0;
  double value = 0.0;
};

/// Smallest value over all nodes, and the first node in storage order that has it.
Location minimum(const Field& f);
/// Largest value over all nodes, and the first node in storage order that has it.
Location maximum(const Field& f);

}  // namespace ehl::core
