#pragma once
// A field of a result with its grid lines, either as stored or interpolated between its nodes.
#include <string>
#include <vector>

#include "report/result_source.hpp"

namespace ehl::program {

struct FieldOnGrid {
  results::Array field;
  results::Array x;
  results::Array y;          ///< the second axis: y, or z for a section in depth
  std::string rows = {"y"};  ///< name of the second axis

  std::string places() const { return x.unit == "a" ? "Hertz radii a" : x.unit; }
  double at(std::size_t i, std::size_t j) const { return field.values[j * x.values.size() + i]; }
};

/// in: step: the index of the time or the depth. errors: core::FileError if the field does not fit its grid.
FieldOnGrid read_field(const ResultSource& source, const std::string& name, std::size_t step);

/// The field interpolated to other grid lines: cubic (through the four nearest nodes) along x, then along y. The result
/// is not below the lowest of these nodes, so that a pressure stays >= 0 at the edge of cavitation and the minimum film
/// is that of the report. order: 4.
/// in: xs, ys within the grid.
FieldOnGrid on_lines(const FieldOnGrid& field, const std::vector<double>& xs, const std::vector<double>& ys);

/// `count` >= 2 evenly spaced places, both ends included.
std::vector<double> spaced(double from, double to, std::size_t count);

}  // namespace ehl::program
