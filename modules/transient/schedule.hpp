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

/// Times in [0, end) at which the value jumps, rising; a change within less than 1e-3 at more than 50 in a time of 1,
/// of the larger value, is a jump where it begins.
std::vector<double> jumps(const Schedule& schedule, double end);

/// Steepest slope that it has from 0 to `end`, or a little more; infinite where it jumps.
double steepest(const Schedule& schedule, double end);

/// Times in (0, end) at which only the slope jumps, rising.
std::vector<double> corners(const Schedule& schedule, double end);

/// Ramps shorter than this are seen by steps that must end at their quarters: all the others may be longer.
inline constexpr double short_ramp = 0.04;

/// Times before `end` at which a step must end for a short ramp: its quarters; rising for each ramp.
std::vector<double> quarters(const Schedule& schedule, double end);

/// Longest step of time in which the schedule can be seen, its short ramps apart: a quarter of the shortest ramp, a
/// twentieth of the period of its wave; infinite where it is constant.
double resolving_step(const Schedule& schedule);

}  // namespace ehl::transient
