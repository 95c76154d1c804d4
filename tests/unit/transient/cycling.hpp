#pragma once
// Tables of a cycle for tests of runs in time.
#include <cmath>
#include <numbers>

#include "transient/schedule.hpp"
#include "unit/transient/marching.hpp"

namespace ehl::tests {

/// mean + amplitude cos(2 pi T/period), by `rows` rows in each period.
inline transient::Schedule cosine(double mean, double amplitude, double period, double periods, int rows = 64) {
  transient::Schedule schedule{.sampled_over = period};
  for (int k = 0; k <= rows * periods; ++k) {
    const int phase = k % rows;
    const double value = mean + amplitude * std::cos(2.0 * std::numbers::pi * phase / rows);
    schedule.points.push_back({k * period / rows, value});
  }
  return schedule;
}

/// A symmetric reciprocating motion without sliding: u1 = u2 = cos(2 pi T/period).
inline transient::Conditions reciprocating(double period, double periods) {
  const transient::Schedule speed = cosine(0.0, 1.0, period, periods);
  return {.u1 = speed, .u2 = speed};
}

}  // namespace ehl::tests
