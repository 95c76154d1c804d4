#pragma once
// Pressures for tests and timings of the elastic deformation, and the comparison of two deformations.
#include <algorithm>
#include <cmath>

#include "core/field.hpp"
#include "mlmi/deformation.hpp"

namespace ehl::tests {

/// f(X, Y) at the nodes of the grid.
template <class Function>
core::Field sampled(const core::Patch& grid, Function f) {
  core::Field field(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) field(i, j) = f(grid.X(i), grid.Y(j));
  return field;
}

/// A pressure like that of a heavily loaded contact: Hertz, a tail towards the inlet, a sharp ridge
/// before the outlet, then zero.
inline double contact_pressure(double X, double Y) {
  const double r2 = X * X + Y * Y;
  const double hertz = std::sqrt(std::max(0.0, 1.0 - r2));
  const double tail = X < 0.0 && r2 > 0.8 ? 0.25 * std::exp(-3.0 * (std::sqrt(r2) - 0.9)) * X * X / r2 : 0.0;
  const double outlet = 0.95 * std::sqrt(std::max(0.0, 1.0 - 0.8 * Y * Y));
  if (X > outlet + 0.02) return 0.0;
  const double distance = (X - outlet + 0.06) / 0.03;
  const double ridge = std::abs(Y) < 1.0 ? 0.4 * std::exp(-distance * distance) * (1.0 - Y * Y) : 0.0;
  return std::max(hertz, tail) + ridge;
}

/// Random numbers at all nodes, none zero, identical on every machine.
inline core::Field rough(const core::Patch& grid) {
  core::Field field(grid);
  unsigned state = 12345u;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) {
      state = 1664525u * state + 1013904223u;
      field(i, j) = static_cast<double>(state >> 8) / 16777216.0 - 0.3;
    }
  return field;
}

/// The deformation under P by the method in the parameters.
inline core::Field deformation(const core::Patch& grid, const core::Field& P, const mlmi::Parameters& parameters,
                               int threads = 1) {
  core::Field w(grid);
  mlmi::Deformation(grid, parameters, threads).evaluate(P, w);
  return w;
}

/// The largest difference of dw/dX (central differences) over the nodes.
inline double slope_difference(const core::Patch& grid, const core::Field& a, const core::Field& b) {
  double largest = 0.0;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j)
      largest = std::max(largest, std::abs((a(i + 1, j) - b(i + 1, j)) - (a(i - 1, j) - b(i - 1, j))));
  return largest / (2.0 * grid.hx());
}

}  // namespace ehl::tests
