#pragma once
// A quantity that varies in time, as given in the deck.
#include <optional>
#include <vector>

namespace ehl::transient {

/// Piecewise linear through the points, constant before the first and after the last; two points at the same time are a
/// jump. From its start on, a wave multiplies the value by 1 + amplitude sin(2 pi (T - start)/period).
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
  std::vector<Point> points{};  ///< T does not decrease; empty: 1 at all times
  std::optional<Wave> wave{};
  /// > 0: the points sample a smooth course of this duration, so time steps need not end at its corners.
  double sampled_over = 0.0;
};

/// Value at T; at a jump the value before it, so that a time step which ends there sees the old value.
double value(const Schedule& schedule, double T);

/// Integral from 0 to T >= 0, exact.
double integral(const Schedule& schedule, double T);

/// Lower bound of the value between 0 and `end`; the minimum itself except with a wave.
double least(const Schedule& schedule, double end);

/// Times in [0, end) at which the value jumps, ascending. A very short and steep ramp (schedule.cpp) is a jump at its
/// start.
std::vector<double> jumps(const Schedule& schedule, double end);

/// Upper bound of the slope between 0 and `end`; infinite if the value jumps.
double steepest(const Schedule& schedule, double end);

/// Times in (0, end) at which only the slope jumps, ascending.
std::vector<double> corners(const Schedule& schedule, double end);

/// Shorter ramps are resolved by steps that must end at their quarters, so that all other steps may be longer.
inline constexpr double short_ramp = 0.04;

/// Times before `end` at which a step must end because of a short ramp: its quarters, ascending within each ramp.
std::vector<double> quarters(const Schedule& schedule, double end);

/// Longest time step that resolves the schedule except its short ramps: a quarter of the shortest other ramp, a
/// twentieth of the period of the wave; infinite for a constant.
double resolving_step(const Schedule& schedule);

}  // namespace ehl::transient
