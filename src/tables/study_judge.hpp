#pragma once
// Judges the rows of a study: deviations from a reference, and the Pareto front.
#include <span>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "tables/study_point.hpp"
#include "transient/march.hpp"

namespace ehl::program {

/// An extrapolated value and its estimated error, relative to the value.
struct Extrapolated {
  double value = core::unknown;
  double error = core::unknown;
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

/// True if a point has a film that can be judged: it is complete, or it stopped after its fixed number of cycles.
bool has_film(const StudyPoint& point);

/// The reference run of the errors of runs in time.
struct TimeReference {
  StudyPoint run{};
  StudyPoint coarser{};          ///< a run with a larger tolerance and larger steps; it shows the
                                 ///< accuracy of the reference
  std::vector<double> errors{};  ///< the difference between the two runs, for each quantity
  std::vector<transient::Place> probes{};
};

/// The largest difference of two runs over their common times, for each quantity. Hc, Hm and P_max are relative to
/// the reference at the same time. The pressure at a probe, which may be zero, is relative to the largest value of
/// the reference at that probe.
/// limits: NaN if a run is not complete or there is no common time; NaN for a probe if the reference is zero at all
/// times and the other run is not.
std::vector<double> errors_in_time(const StudyPoint& reference, const StudyPoint& point);

/// Fills in the deviations, and marks the Pareto fronts of deviation and seconds for each quantity. A point is on the
/// front if no other point is at least as accurate and cheaper, or more accurate and at most as expensive. An error
/// below that of the reference counts as equal to it, so that no point wins by chance.
void judge(const Reference& reference, std::vector<StudyPoint>& points);
void judge(const TimeReference& reference, std::vector<StudyPoint>& points);

/// The cheapest point with an error of Hc (or Hm) of at most `wanted`. The errors of the same method must stay below
/// `wanted` on all finer grids of the study: a value that passes through the correct one by chance does not count.
/// in: quantity: 0 for Hc, 1 for Hm. out: index; points.size() if there is none.
std::size_t cheapest(const std::vector<StudyPoint>& points, std::size_t quantity, double wanted);

}  // namespace ehl::program
