#include "transient/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ehl::transient {
namespace {

constexpr int parts_of_a_ramp = 4;  // time steps per ramp [bench: transient_parts_of_a_ramp]
/// A ramp both shorter and steeper (relative to the larger value, per time of 1) than this counts as a jump: the film
/// hardly moves within it, and steps that resolve it would be too short for the cycles.
constexpr double time_of_a_jump = 1e-3;
constexpr double steep = 50.0;
constexpr double parts_of_a_period = 20.0;  // a chord of 18 degrees deviates from a sine by about 1 % of its amplitude

double omega(const Schedule::Wave& wave) { return 2.0 * std::numbers::pi / wave.period; }

bool jumps_between(const Schedule::Point& a, const Schedule::Point& b) {
  const double change = std::abs(b.value - a.value);
  const double larger = std::max(std::abs(a.value), std::abs(b.value));
  return b.T == a.T ? change > 0.0 : b.T - a.T < time_of_a_jump && change > steep * larger * (b.T - a.T);
}

// Value without the wave. At a jump, the value before it.
double linear(const std::vector<Schedule::Point>& points, double T) {
  if (points.empty()) return 1.0;
  const auto after = std::ranges::lower_bound(points, T, {}, &Schedule::Point::T);
  if (after == points.begin()) return points.front().value;
  if (after == points.end()) return points.back().value;
  const Schedule::Point& from = after[-1];
  return from.value + (after->value - from.value) * (T - from.T) / (after->T - from.T);
}

// Integral from a to b of (p + q T) (1 + A sin(w (T - T0))), T0 <= a for A != 0.
double piece(double a, double b, double p, double q, const Schedule::Wave* wave) {
  const double plain = (b - a) * (p + 0.5 * q * (a + b));
  if (!wave) return plain;
  const double w = omega(*wave);
  const auto primitive = [&](double T) {
    const double angle = w * (T - wave->start);
    return -(p + q * T) * std::cos(angle) / w + q * std::sin(angle) / (w * w);
  };
  return plain + wave->amplitude * (primitive(b) - primitive(a));
}

}  // namespace

double value(const Schedule& schedule, double T) {
  const double mean = linear(schedule.points, T);
  if (!schedule.wave || T <= schedule.wave->start) return mean;
  return mean * (1.0 + schedule.wave->amplitude * std::sin(omega(*schedule.wave) * (T - schedule.wave->start)));
}

double integral(const Schedule& schedule, double T) {
  std::vector<double> knots{0.0, T};
  for (const Schedule::Point& point : schedule.points)
    if (point.T > 0.0 && point.T < T) knots.push_back(point.T);
  if (schedule.wave && schedule.wave->start > 0.0 && schedule.wave->start < T) knots.push_back(schedule.wave->start);
  std::ranges::sort(knots);
  double sum = 0.0;
  for (std::size_t k = 1; k < knots.size(); ++k) {
    const double a = knots[k - 1];
    const double b = knots[k];
    if (!(b > a)) continue;
    const double middle = linear(schedule.points, 0.5 * (a + b));
    const double slope = 2.0 * (linear(schedule.points, b) - middle) / (b - a);
    const bool waves = schedule.wave && schedule.wave->start <= a;
    sum += piece(a, b, middle - 0.5 * slope * (a + b), slope, waves ? &*schedule.wave : nullptr);
  }
  return sum;
}

double least(const Schedule& schedule, double end) {
  const double first = linear(schedule.points, 0.0);
  const double last = linear(schedule.points, end);
  double smallest = std::min(first, last);
  double largest = std::max(first, last);
  for (const Schedule::Point& point : schedule.points)
    if (point.T >= 0.0 && point.T < end) {
      smallest = std::min(smallest, point.value);
      largest = std::max(largest, point.value);
    }
  if (!schedule.wave || schedule.wave->start >= end) return smallest;
  // The product is smallest at a corner. A wave with an amplitude above one changes the sign, of the largest value
  // most.
  const double amplitude = std::abs(schedule.wave->amplitude);
  return std::min({smallest * (1.0 - amplitude), smallest * (1.0 + amplitude), largest * (1.0 - amplitude)});
}

std::vector<double> jumps(const Schedule& schedule, double end) {
  std::vector<double> times;
  for (std::size_t k = 1; k < schedule.points.size(); ++k) {
    const Schedule::Point& a = schedule.points[k - 1];
    const Schedule::Point& b = schedule.points[k];
    if (jumps_between(a, b) && a.T >= 0.0 && a.T < end) times.push_back(a.T);
  }
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

double steepest(const Schedule& schedule, double end) {
  if (!jumps(schedule, end).empty()) return std::numeric_limits<double>::infinity();
  double slope = 0.0, largest = schedule.points.empty() ? 1.0 : 0.0;
  for (std::size_t k = 0; k < schedule.points.size(); ++k) {
    const Schedule::Point& b = schedule.points[k];
    largest = std::max(largest, std::abs(b.value));
    if (k == 0 || b.T == schedule.points[k - 1].T || schedule.points[k - 1].T >= end) continue;
    const Schedule::Point& a = schedule.points[k - 1];
    slope = std::max(slope, std::abs(b.value - a.value) / (b.T - a.T));
  }
  if (!schedule.wave || schedule.wave->start >= end) return slope;
  const double amplitude = std::abs(schedule.wave->amplitude);
  return slope * (1.0 + amplitude) + largest * amplitude * omega(*schedule.wave);
}

std::vector<double> corners(const Schedule& schedule, double end) {
  std::vector<double> times;
  const std::size_t count = schedule.sampled_over > 0.0 ? 0 : schedule.points.size();
  for (std::size_t k = 0; k < count; ++k)
    if (k == 0 || !jumps_between(schedule.points[k - 1], schedule.points[k])) times.push_back(schedule.points[k].T);
  if (schedule.wave) times.push_back(schedule.wave->start);
  std::ranges::sort(times);
  const std::vector<double> jumping = jumps(schedule, end);
  std::erase_if(times, [&](double T) { return !(T > 0.0 && T < end) || std::ranges::count(jumping, T) > 0; });
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::vector<double> quarters(const Schedule& schedule, double end) {
  std::vector<double> times;
  if (schedule.sampled_over > 0.0) return times;
  for (std::size_t k = 1; k < schedule.points.size(); ++k) {
    const Schedule::Point& a = schedule.points[k - 1];
    const Schedule::Point& b = schedule.points[k];
    if (b.value == a.value || b.T == a.T || b.T - a.T >= short_ramp || jumps_between(a, b)) continue;
    for (int part = 1; part < parts_of_a_ramp; ++part) {
      const double T = a.T + part * (b.T - a.T) / parts_of_a_ramp;
      if (T < end) times.push_back(T);
    }
  }
  return times;
}

double resolving_step(const Schedule& schedule) {
  if (schedule.sampled_over > 0.0) return schedule.sampled_over / parts_of_a_period;
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < schedule.points.size(); ++k) {
    const Schedule::Point& a = schedule.points[k - 1];
    const Schedule::Point& b = schedule.points[k];
    if (b.T - a.T >= short_ramp && b.value != a.value) step = std::min(step, (b.T - a.T) / parts_of_a_ramp);
  }
  if (schedule.wave) step = std::min(step, schedule.wave->period / parts_of_a_period);
  return step;
}

}  // namespace ehl::transient
