#include "tables/study_judge.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/constants.hpp"

namespace ehl::program {
namespace {

double relative_error(double value, const Extrapolated& reference) { return std::abs(value / reference.value - 1.0); }

constexpr std::size_t relative_at_every_time = 3;  // the first three quantities in time: Hc, Hm, P_max

// in: known_to: the error of the reference for this quantity.
void mark_quantity(std::size_t quantity, double known_to, std::vector<StudyPoint>& points) {
  const auto counted = [&](const StudyPoint* point) { return std::max(point->judged[quantity].deviation, known_to); };
  std::vector<StudyPoint*> order;
  for (StudyPoint& point : points) {
    Judged& judged = point.judged[quantity];
    judged.at_reference = judged.deviation < known_to;
    if (has_film(point) && std::isfinite(judged.deviation) && std::isfinite(point.seconds)) order.push_back(&point);
  }
  std::ranges::sort(order, {}, [&](const StudyPoint* point) { return std::pair(point->seconds, counted(point)); });
  double least = std::numeric_limits<double>::infinity();
  for (StudyPoint* point : order) {
    point->judged[quantity].front = counted(point) < least;
    least = std::min(least, counted(point));
  }
}

// in: the errors of the reference; the deviations of a point, one for each quantity.
void judge_by(const std::vector<double>& known_to,
              const std::function<std::vector<double>(const StudyPoint&)>& deviations,
              std::vector<StudyPoint>& points) {
  for (StudyPoint& point : points) {
    const std::vector<double> found = deviations(point);
    point.judged.assign(known_to.size(), {});
    for (std::size_t k = 0; k < std::min(found.size(), known_to.size()); ++k) point.judged[k].deviation = found[k];
  }
  for (std::size_t k = 0; k < known_to.size(); ++k) mark_quantity(k, known_to[k], points);
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

bool has_film(const StudyPoint& point) { return is_complete(point) || point.status == "stopped"; }

std::vector<double> errors_in_time(const StudyPoint& reference, const StudyPoint& point) {
  const std::size_t times = std::min(reference.samples.size(), point.samples.size());
  const std::size_t quantities = reference.samples.empty() ? 0 : reference.samples[0].values.size();
  std::vector<double> errors(quantities, core::unknown);
  if (!is_complete(reference) || !is_complete(point) || times == 0) return errors;
  for (std::size_t k = 0; k < quantities; ++k) {
    double largest = 0.0, scale = 0.0;
    for (std::size_t n = 0; n < times; ++n) {
      const double truth = reference.samples[n].values[k];
      const double difference = std::abs(point.samples[n].values[k] - truth);
      largest = std::max(largest, k < relative_at_every_time ? difference / std::abs(truth) : difference);
      scale = std::max(scale, std::abs(truth));
    }
    if (k < relative_at_every_time) scale = 1.0;
    errors[k] = largest == 0.0 ? 0.0 : scale > 0.0 ? largest / scale : core::unknown;
  }
  return errors;
}

void judge(const Reference& reference, std::vector<StudyPoint>& points) {
  judge_by(
      {reference.Hc.error, reference.Hm.error},
      [&](const StudyPoint& point) {
        return std::vector{relative_error(point.Hc, reference.Hc), relative_error(point.Hm, reference.Hm)};
      },
      points);
}

void judge(const TimeReference& reference, std::vector<StudyPoint>& points) {
  judge_by(
      reference.errors, [&](const StudyPoint& point) { return errors_in_time(reference.run, point); }, points);
}

std::size_t cheapest(const std::vector<StudyPoint>& points, std::size_t quantity, double wanted) {
  const auto good = [&](const StudyPoint& point) { return has_film(point) && point.of(quantity).deviation <= wanted; };
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
