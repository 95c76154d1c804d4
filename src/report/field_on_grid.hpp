#pragma once
// A field of a result with the lines of its grid, as it is or between its nodes.
#include <string>
#include <vector>

#include "report/result_source.hpp"

namespace ehl::program {

struct FieldOnGrid {
  results::Array field;
  results::Array x;
  results::Array y;          ///< or z, of a section in depth
  std::string rows = {"y"};  ///< its name

  std::string places() const { return x.unit == "a" ? "Hertz radii a" : x.unit; }
  double at(std::size_t i, std::size_t j) const { return field.values[j * x.values.size() + i]; }
};

/// in: step: which field of several times or depths. errors: core::FileError where it does not fit its grid.
FieldOnGrid read_field(const ResultSource& source, const std::string& name, std::size_t step);

/// The same field on other lines: cubic between the four nearest nodes, along x and then along y. Not below the least
/// node, so that a pressure stays >= 0 beside cavitation and the smallest film is that of the report. order: 4.
/// in: lines within the grid.
FieldOnGrid on_lines(const FieldOnGrid& field, const std::vector<double>& xs, const std::vector<double>& ys);

/// `count` >= 2 places from one to another.
std::vector<double> spaced(double from, double to, std::size_t count);

}  // namespace ehl::program
