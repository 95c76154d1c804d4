#pragma once
// Extremes and means over a run in time.
#include <functional>
#include <string>
#include <vector>

#include "case/transient_run.hpp"
#include "core/constants.hpp"

namespace ehl::program {

/// The times over which extremes and means are taken.
struct Window {
  double from = 0.0, to = 0.0;
};

/// From [transient] start_of_means to the end; without that key the last whole period of a cycle, else the whole run.
Window window_of_means(const Case& input, const TransientResult& run);

/// A number over a window; values that are not known are left out, and all are NaN if there is none.
struct Extremes {
  double least = core::unknown, time_of_least = core::unknown;
  double largest = core::unknown, time_of_largest = core::unknown;
  double mean = core::unknown;  ///< over time, by the trapezoidal rule
};
Extremes extremes_of(const TransientResult& run, const Window& window, const std::vector<double>& values);

/// The values of a column of /transient, one for each row: Hc, Hm, P_max, or one that an effect adds. Empty: the run
/// has no such column.
std::vector<double> values_of(const TransientResult& run, const std::string& number);
/// The extremes of such a column in the window of the case.
Extremes extremes_of(const Case& input, const TransientResult& run, const std::string& number);
/// The extremes of the magnitude of such a column.
Extremes extremes_of_magnitude(const Case& input, const TransientResult& run, const std::string& number);

}  // namespace ehl::program
