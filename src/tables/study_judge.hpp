#pragma once
// What the points of a study are held against: the extrapolated film, and each other.
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tables/study_point.hpp"

namespace ehl::program {

/// A limit and how well it is known, both relative to nothing else: error is relative to value.
struct Extrapolated {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// Richardson's extrapolation of second-order values, each from a grid of half the mesh size of the one before:
///   v = v_k + (v_k - v_{k-1})/3.
/// error: with three values the change of v against the one from the grids before, at least a share of the correction
/// (two extrapolations may agree by chance); with two the whole correction. in: values; least_share, below.
/// limits: NaN with fewer than two.
Extrapolated extrapolated(std::span<const double> values, double least_share);
/// For values that converge smoothly: Hc.
constexpr double smooth_share = 0.05;
/// For the minimum over the nodes: how far it is from the minimum between them is of the order of the correction too,
/// and differs from grid to grid without a rule.
constexpr double node_minimum_share = 1.0;

/// The film that errors are relative to.
struct Reference {
  std::vector<int> cells{};  ///< of the grids it comes from, coarse to fine
  Extrapolated Hc{};
  Extrapolated Hm{};
  double residual = 0.0;  ///< the largest on those grids
};

/// From exactly converged second-order solutions, coarse to fine; those that did not converge are left out together
/// with all that are coarser. limits: fewer than two grids: NaN.
Reference reference_of(std::span<const StudyPoint> solutions);

/// True where the film of a point can be judged: solved, or stopped after its cycles.
bool has_film(const StudyPoint& point);

/// Fills in the errors and marks the Pareto fronts of error and seconds, for Hc and Hm. A point is on the front when
/// no other is at least as accurate and cheaper, or more accurate and not dearer. Errors below the reference's own
/// count as that, so that no point is better by chance.
void judge(const Reference& reference, std::vector<StudyPoint>& points);

/// The cheapest point with an error of Hc (or Hm) of at most `wanted`, whose way stays below that on all finer grids of
/// the study too: a value that only passes through the right one does not count. in: member: &StudyPoint::deviation_Hc
/// or deviation_Hm. out: index; points.size() where there is none.
std::size_t cheapest(const std::vector<StudyPoint>& points, double StudyPoint::*error, double wanted);

}  // namespace ehl::program
