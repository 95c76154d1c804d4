#pragma once
// A light contact on a coarse grid, integrated in time, and its results.
#include <algorithm>
#include <cmath>
#include <vector>

#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"
#include "transient/march.hpp"

namespace ehl::tests {

/// M = 50, L = 10 with Roelands (z = 0.68, alpha = 2.2e-8 1/Pa) and Dowson-Higginson on n x n cells.
inline steady::Scene marching_scene(int n, double M = 50.0, double L = 10.0) {
  return roelands_scene(M, L, {n, n, -2.5, 1.5, -2.0, 2.0});
}

/// All results of a run in time.
struct Marched {
  transient::MarchReport report{};
  std::vector<transient::StepRow> rows{};
  std::vector<transient::Frame> frames{};
};

inline Marched marched_from(const steady::Solution& start, const steady::Scene& scene,
                            const transient::Conditions& conditions, const transient::MarchParameters& parameters) {
  Marched all;
  const transient::Observer observer{
      .row =
          [&](const transient::StepRow& row) {
            all.rows.push_back(row);
            return true;
          },
      .frame = [&](transient::Frame&& frame) { all.frames.push_back(std::move(frame)); }};
  all.report = transient::march(scene, start, conditions, parameters, observer);
  return all;
}

/// Starts from the steady solution of the scene, which is computed first.
inline Marched marched(const steady::Scene& scene, const transient::Conditions& conditions,
                       const transient::MarchParameters& parameters) {
  return marched_from(steady::solve(scene), scene, conditions, parameters);
}

/// The largest relative difference between a value of the rows and a given value.
template <class Value>
double largest_difference(const std::vector<transient::StepRow>& rows, double to, Value value) {
  double largest = 0.0;
  for (const transient::StepRow& row : rows) largest = std::max(largest, std::abs(value(row) / to - 1.0));
  return largest;
}

}  // namespace ehl::tests
