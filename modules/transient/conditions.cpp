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
  if (speed == 0.0) return factor;  // nothing flows in
  if (supply.is_flow) return factor / std::abs(speed);
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
          .sliding = std::abs(u1 - u2),
          .radius = value(conditions.radius, T)};
}

std::array<const Schedule*, 5> schedules_of(const Conditions& conditions) {
  return {&conditions.load, &conditions.u1, &conditions.u2, &conditions.radius, &conditions.supply.factor};
}

Course course_of(const Conditions& conditions) {
  Course course;
  course.body = conditions.body;
  course.bends = !conditions.radius.points.empty();
  if (conditions.on_1 || conditions.on_2)
    course.surface = [&conditions](const core::Patch& grid, double T, core::Field& S) {
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

std::vector<double> stops_of(const Conditions& conditions, double end, double period) {
  std::vector<double> stops{end};
  constexpr double rounding = 1e-12;
  for (double n = 1.0; n * period < end * (1.0 - rounding); ++n) stops.push_back(n * period);
  for (const Schedule* schedule : schedules_of(conditions))
    for (const auto& times : {jumps(*schedule, end), corners(*schedule, end), quarters(*schedule, end)})
      stops.insert(stops.end(), times.begin(), times.end());
  std::ranges::sort(stops);
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  return stops;
}

bool jumps_at(const Conditions& conditions, double T, double end) {
  return std::ranges::any_of(schedules_of(conditions), [&](const Schedule* schedule) {
    return std::ranges::count(jumps(*schedule, end), T) > 0;
  });
}

double longest_step(const Conditions& conditions, double end) {
  double step = std::min(conditions.tuning.longest_step, 0.01 * end);
  for (const Schedule* schedule : schedules_of(conditions)) step = std::min(step, resolving_step(*schedule));
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
