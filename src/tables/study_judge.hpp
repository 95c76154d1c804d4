#pragma once
// Judges the points of a study: errors against the extrapolated film, and the Pareto front.
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tables/study_point.hpp"

namespace ehl::program {

/// An extrapolated value and its estimated error, relative to the value.
struct Extrapolated {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// Richardson extrapolation of second-order values, each on a grid with half the mesh size of the one before:
///   v = v_k + (v_k - v_{k-1})/3.
/// error: with three or more values, the difference between v and the extrapolation from the coarser grids,
/// but at least least_share of the correction v - v_k (two extrapolations may agree by chance); with two
/// values, the whole correction.
/// in: values, coarse to fine; least_share: one of the constants below. limits: NaN for fewer than two values.
Extrapolated extrapolated(std::span<const double> values, double least_share);
/// For values that converge smoothly: Hc.
constexpr double smooth_share = 0.05;
/// For the minimum over the nodes. Its distance from the true minimum is of the order of the correction, and varies
/// irregularly from grid to grid.
constexpr double node_minimum_share = 1.0;

/// The reference film of the errors.
struct Reference {
  std::vector<int> cells{};  ///< cells of the grids that the extrapolation uses, coarse to fine
  Extrapolated Hc{};
  Extrapolated Hm{};
  double residual = 0.0;  ///< the largest residual on those grids
};

/// in: second-order solutions that are converged to rounding, coarse to fine. A solution that did not converge is left
/// out together with all coarser ones. limits: NaN for fewer than two grids.
Reference reference_of(std::span<const StudyPoint> solutions);

/// True if a point has a film that can be judged: it converged, or it stopped after its fixed number of cycles.
bool has_film(const StudyPoint& point);

/// Fills in the errors, and marks the Pareto fronts of error and seconds for Hc and Hm. A point is on the front if no
/// other point is at least as accurate and cheaper, or more accurate and at most as expensive. An error below that of
/// the reference counts as equal to it, so that no point wins by chance.
void judge(const Reference& reference, std::vector<StudyPoint>& points);

/// The cheapest point with an error of Hc (or Hm) of at most `wanted`. The errors of the same method must stay below
/// `wanted` on all finer grids of the study: a value that passes through the correct one by chance does not count.
/// in: error: &StudyPoint::deviation_Hc or deviation_Hm. out: index; points.size() if there is none.
std::size_t cheapest(const std::vector<StudyPoint>& points, double StudyPoint::*error, double wanted);

}  // namespace ehl::program
