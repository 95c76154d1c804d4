#include "transient/conditions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ehl::transient {
namespace {

// Supply over that of the scene, at the surface speeds u1 and u2.
double supply_at(const Supply& supply, double T, double u1, double u2) {
  const double factor = value(supply.factor, T);
  const double speed = 0.5 * (u1 + u2);
  if (!(speed > 0.0)) return factor;  // nothing flows in
  if (supply.is_flow) return factor / speed;
  return std::isnan(supply.layer1) ? factor : factor * (u1 * supply.layer1 + u2 * supply.layer2) / speed;
}

}  // namespace

Drive drive_at(const Conditions& conditions, double T) {
  constexpr double a_little = 1e-6;
  const double load = value(conditions.load, T);
  const double u1 = value(conditions.u1, T), u2 = value(conditions.u2, T);
  return {.load = load,
          .speed = 0.5 * (u1 + u2),
          .load_rate = (load - value(conditions.load, T - a_little)) / a_little,
          .supply = supply_at(conditions.supply, T, u1, u2),
          .sliding = std::abs(u1 - u2)};
}

Course course_of(const Conditions& conditions) {
  Course course;
  course.body = conditions.body;
  if (conditions.on_1 || conditions.on_2)
    course.surface = [&](const core::Patch& grid, double T, core::Field& S) {
      S.fill(0.0);
      if (conditions.on_1) surface::add_gap(*conditions.on_1, grid, integral(conditions.u1, T), S);
      if (conditions.on_2) surface::add_gap(*conditions.on_2, grid, integral(conditions.u2, T), S);
    };
  return course;
}

bool symmetric(const Conditions& conditions) {
  const auto none_or_symmetric = [](const std::optional<surface::Relief>& relief) {
    return !relief || surface::symmetric(*relief);
  };
  return none_or_symmetric(conditions.on_1) && none_or_symmetric(conditions.on_2);
}

std::vector<double> stops_of(const Conditions& conditions, double end) {
  std::vector<double> stops{end};
  for (const Schedule* schedule : {&conditions.load, &conditions.u1, &conditions.u2, &conditions.supply.factor})
    for (const auto& times : {jumps(*schedule, end), corners(*schedule, end), quarters(*schedule, end)})
      stops.insert(stops.end(), times.begin(), times.end());
  std::ranges::sort(stops);
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  return stops;
}

bool jumps_at(const Conditions& conditions, double T, double end) {
  const auto jumps_there = [&](const Schedule& schedule) { return std::ranges::count(jumps(schedule, end), T) > 0; };
  return jumps_there(conditions.load) || jumps_there(conditions.u1) || jumps_there(conditions.u2) ||
         jumps_there(conditions.supply.factor);
}

double longest_step(const Conditions& conditions, double end) {
  double step = std::min(conditions.tuning.longest_step, 0.01 * end);
  for (const Schedule* schedule : {&conditions.load, &conditions.u1, &conditions.u2, &conditions.supply.factor})
    step = std::min(step, resolving_step(*schedule));
  if (conditions.body) {
    const double share_of_vibration = conditions.tuning.share_of_vibration;
    const Body& body = *conditions.body;
    step = std::min(step, share_of_vibration * 2.0 * std::numbers::pi / natural_frequency(body));
    if (body.gap && body.velocity < 0.0) step = std::min(step, share_of_vibration * *body.gap / -body.velocity);
  }
  const auto fastest = [&](const Schedule& schedule) {
    double most = std::abs(value(schedule, 0.0));
    for (const Schedule::Point& point : schedule.points) most = std::max(most, std::abs(point.value));
    return most * (schedule.wave ? 1.0 + std::abs(schedule.wave->amplitude) : 1.0);
  };
  if (conditions.on_1) step = std::min(step, surface::resolving_distance(*conditions.on_1) / fastest(conditions.u1));
  if (conditions.on_2) step = std::min(step, surface::resolving_distance(*conditions.on_2) / fastest(conditions.u2));
  return step;
}

}  // namespace ehl::transient
