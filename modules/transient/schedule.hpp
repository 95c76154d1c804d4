#pragma once
// A number that varies in time as the deck says.
#include <optional>
#include <vector>

namespace ehl::transient {

/// Piecewise linear through the points, constant before the first and behind the last; two points at the same time are
/// a jump. A wave multiplies all of it by 1 + amplitude sin(2 pi (T - start)/period) from its start on.
struct Schedule {
  struct Point {
    double T = 0.0;
    double value = 1.0;
  };
  struct Wave {
    double amplitude = 0.0;
    double period = 1.0;
    double start = 0.0;
  };
  std::vector<Point> points{};  ///< T never falls; none: 1 at all times
  std::optional<Wave> wave{};
};

/// Value at T; at a jump the value before it, so that a step of time that ends there sees what it came from.
double value(const Schedule& schedule, double T);

/// Integral from 0 to T >= 0, exact.
double integral(const Schedule& schedule, double T);

/// Smallest value that it takes from 0 to `end`, or a little less.
double least(const Schedule& schedule, double end);

/// Times in [0, end) at which the value jumps, rising.
std::vector<double> jumps(const Schedule& schedule, double end);

/// Times in (0, end) at which only the slope jumps, rising.
std::vector<double> corners(const Schedule& schedule, double end);

/// Longest step of time in which the schedule can be seen: a quarter of the shortest ramp, a twentieth of the period of
/// its wave; infinite where it is constant.
double resolving_step(const Schedule& schedule);

}  // namespace ehl::transient
