#include "tables/study_judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ehl::program {
namespace {

double relative_error(double value, const Extrapolated& reference) { return std::abs(value / reference.value - 1.0); }

void mark_front(double StudyPoint::*error, double known_to, bool StudyPoint::*front, std::vector<StudyPoint>& points) {
  const auto counted = [&](const StudyPoint& point) { return std::max(point.*error, known_to); };
  std::vector<StudyPoint*> order;
  for (StudyPoint& point : points) {
    point.*front = false;
    if (has_film(point) && std::isfinite(point.*error) && std::isfinite(point.seconds)) order.push_back(&point);
  }
  std::ranges::sort(order, {}, [&](const StudyPoint* point) { return std::pair(point->seconds, counted(*point)); });
  double least = std::numeric_limits<double>::infinity();
  for (StudyPoint* point : order) {
    point->*front = counted(*point) < least;
    least = std::min(least, counted(*point));
  }
}

}  // namespace

Extrapolated extrapolated(std::span<const double> values, double least_share) {
  const std::size_t n = values.size();
  if (n < 2) return {};
  const auto richardson = [&](std::size_t k) { return values[k] + (values[k] - values[k - 1]) / 3.0; };
  const double value = richardson(n - 1);
  const double correction = std::abs(value - values[n - 1]);
  const double error = n > 2 ? std::max(std::abs(value - richardson(n - 2)), least_share * correction) : correction;
  return {value, error / std::abs(value)};
}

Reference reference_of(std::span<const StudyPoint> solutions) {
  std::size_t first = solutions.size();
  while (first > 0 && solutions[first - 1].status == "converged") --first;
  // If the finest grid did not converge, the coarser grids serve as the reference.
  if (first == solutions.size() && first > 1) return reference_of(solutions.first(first - 1));
  Reference reference;
  std::vector<double> Hc, Hm;
  for (const StudyPoint& point : solutions.subspan(first)) {
    reference.cells.push_back(point.nx);
    Hc.push_back(point.Hc);
    Hm.push_back(point.Hm);
    reference.residual = std::max(reference.residual, point.residual);
  }
  reference.Hc = extrapolated(Hc, smooth_share);
  reference.Hm = extrapolated(Hm, node_minimum_share);
  return reference;
}

bool has_film(const StudyPoint& point) { return point.status == "converged" || point.status == "stopped"; }

void judge(const Reference& reference, std::vector<StudyPoint>& points) {
  for (StudyPoint& point : points) {
    point.deviation_Hc = relative_error(point.Hc, reference.Hc);
    point.deviation_Hm = relative_error(point.Hm, reference.Hm);
    point.at_reference_Hc = point.deviation_Hc < reference.Hc.error;
    point.at_reference_Hm = point.deviation_Hm < reference.Hm.error;
  }
  mark_front(&StudyPoint::deviation_Hc, reference.Hc.error, &StudyPoint::front_Hc, points);
  mark_front(&StudyPoint::deviation_Hm, reference.Hm.error, &StudyPoint::front_Hm, points);
}

std::size_t cheapest(const std::vector<StudyPoint>& points, double StudyPoint::*error, double wanted) {
  const auto good = [&](const StudyPoint& point) { return has_film(point) && point.*error <= wanted; };
  std::size_t best = points.size();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool lasting = std::all_of(points.begin(), points.end(), [&](const StudyPoint& finer) {
      return finer.variant.cells < points[k].variant.cells ||
             name_of_variant(finer.variant) != name_of_variant(points[k].variant) || good(finer);
    });
    if (good(points[k]) && lasting && (best == points.size() || points[k].seconds < points[best].seconds)) best = k;
  }
  return best;
}

}  // namespace ehl::program
