#pragma once
// A measured traction curve: a CSV file.
#include <string>
#include <vector>

namespace ehl::program {

struct MeasuredPoint {
  double srr = 0.0;    ///< slide-roll ratio, not in per cent
  double mu = 0.0;     ///< friction coefficient
  double sigma = 0.0;  ///< its standard error; 0: not told
};

/// Rows "slide-roll ratio, friction coefficient[, its standard error]" in the order of the ratio; # begins a comment, a
/// heading may stand before them. errors: core::FileError with file and line: no such row, a ratio beyond 2 (per
/// cent), a coefficient beyond 1, a standard error that some rows have and others lack.
std::vector<MeasuredPoint> read_measured(const std::string& path);

}  // namespace ehl::program
