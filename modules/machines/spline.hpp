#pragma once
// Cubic splines through the points of a table.
#include <vector>

namespace ehl::machines {

/// Piecewise cubic with continuous first and second derivatives.
struct Spline {
  std::vector<double> x{};       ///< rising
  std::vector<double> y{};       ///< values
  std::vector<double> second{};  ///< second derivatives
};

/// The spline through at least two points whose slope is zero at both ends. Errors for equal distances h: h^4 in the
/// values and h^2 y""/12 in the second derivative.
Spline clamped_spline(std::vector<double> x, std::vector<double> y);

/// The spline of a function with a period, through points of one period of which the last repeats the first.
Spline periodic_spline(const std::vector<double>& x, const std::vector<double>& y);

struct SplineValue {
  double value = 0.0;
  double slope = 0.0;
  double second = 0.0;
};
/// in: x within the points.
SplineValue at(const Spline& spline, double x);

}  // namespace ehl::machines
