#include "core/norms.hpp"

#include <cmath>
#include <functional>

namespace ehl::core {
namespace {

// One partial sum per column, added in a fixed order, so the result cannot depend on the threads.
template <class Term>
double sum_over_interior(const Field& f, Term term) {
  double total = 0.0;
  const bool one_line = f.nodes_y() == 3;
  for (int i = 1; i < f.nodes_x() - 1; ++i) {
    const double* row = f.at_x(i);
    if (one_line) {
      total += term(row[1]);
      continue;
    }
    double partial = 0.0;
#pragma omp simd reduction(+ : partial)
    for (int j = 1; j < f.nodes_y() - 1; ++j) partial += term(row[j]);
    total += partial;
  }
  return total;
}

template <class Better>
Location extreme(const Field& f, Better better) {
  Location best{0, 0, f(0, 0)};
  for (int i = 0; i < f.nodes_x(); ++i)
    for (int j = 0; j < f.nodes_y(); ++j)
      if (better(f(i, j), best.value)) best = {i, j, f(i, j)};
  return best;
}

}  // namespace

double interior_sum(const Field& f) {
  return sum_over_interior(f, [](double v) { return v; });
}

double interior_sum(const Patch& patch, const Field& f) {
  if (patch.north != Edge::mirror) return interior_sum(f);
  double axis = 0.0;
  for (int i = 1; i < patch.nx; ++i) axis += f(i, patch.ny);
  return 2.0 * interior_sum(f) + axis;
}

double root_mean_square(const Field& f) {
  const double points = static_cast<double>(f.nodes_x() - 2) * (f.nodes_y() - 2);
  return std::sqrt(sum_over_interior(f, [](double v) { return v * v; }) / points);
}

double max_abs(const Field& f) {
  double largest = 0.0;
  for (int i = 0; i < f.nodes_x(); ++i)
    for (int j = 0; j < f.nodes_y(); ++j) {
      const double value = std::abs(f(i, j));
      if (!(value <= largest)) largest = value;  // true for NaN too
      if (std::isnan(largest)) return largest;
    }
  return largest;
}

double max_abs_difference(const Field& f, const Field& g) {
  double largest = 0.0;
  for (int i = 0; i < f.nodes_x(); ++i)
    for (int j = 0; j < f.nodes_y(); ++j) {
      const double value = std::abs(f(i, j) - g(i, j));
      if (!(value <= largest)) largest = value;
      if (std::isnan(largest)) return largest;
    }
  return largest;
}

Location minimum(const Field& f) { return extreme(f, std::less<double>{}); }
Location maximum(const Field& f) { return extreme(f, std::greater<double>{}); }

}  // namespace ehl::core
