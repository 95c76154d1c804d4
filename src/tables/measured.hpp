#pragma once
// A measured traction curve: a CSV file.
#include <string>
#include <vector>

namespace ehl::program {

struct MeasuredPoint {
  double srr = 0.0;    ///< slide-roll ratio, not in per cent
  double mu = 0.0;     ///< friction coefficient
  double sigma = 0.0;  ///< standard error of mu; 0: not given
};

/// Reads the rows "slide-roll ratio, friction coefficient[, standard error]" and sorts them by the ratio. # begins a
/// comment; a heading may precede the rows.
/// errors: core::FileError with file and line: a malformed row, a ratio above 2 (probably in per cent), a coefficient
/// above 1, a standard error that only some rows have.
std::vector<MeasuredPoint> read_measured(const std::string& path);

}  // namespace ehl::program
