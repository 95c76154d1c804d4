#include "report/field_on_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/errors.hpp"

namespace ehl::program {
namespace {

// The value at a place is the weighted sum of the values of `count` nodes, beginning with node `first`.
struct Stencil {
  std::size_t first = 0;
  std::size_t count = 0;
  std::array<double, 4> weights{};
};

// Lagrange interpolation through the four nearest nodes; through all of them if the grid has fewer.
Stencil stencil_at(const std::vector<double>& nodes, double at) {
  Stencil made{0, std::min<std::size_t>(4, nodes.size()), {}};
  const auto right = static_cast<std::size_t>(std::ranges::upper_bound(nodes, at) - nodes.begin());
  made.first = std::min(right < 2 ? 0 : right - 2, nodes.size() - made.count);
  for (std::size_t k = 0; k < made.count; ++k) {
    made.weights[k] = 1.0;
    for (std::size_t other = 0; other < made.count; ++other)
      if (other != k)
        made.weights[k] *= (at - nodes[made.first + other]) / (nodes[made.first + k] - nodes[made.first + other]);
  }
  return made;
}

}  // namespace

std::vector<double> spaced(double from, double to, std::size_t count) {
  std::vector<double> lines(count, from);
  for (std::size_t k = 1; k < count; ++k)
    lines[k] = from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1);
  return lines;
}

FieldOnGrid read_field(const ResultSource& source, const std::string& name, std::size_t step) {
  const bool layers = source.file.dims(name).size() == 3;
  const std::string rows = source.file.rows(name);
  FieldOnGrid read{layers ? source.frame(name, step) : source.numbers(name),
                   source.numbers(source.file.axis(name, "x")), source.numbers(source.file.axis(name, rows)), rows};
  if (read.field.dims.size() != 2 || read.field.dims[0] != read.y.values.size() ||
      read.field.dims[1] != read.x.values.size() || read.field.values.empty())
    throw core::FileError(source.file.path() + ": the file is damaged: " + name + " does not match its grid");
  return read;
}

FieldOnGrid on_lines(const FieldOnGrid& field, const std::vector<double>& xs, const std::vector<double>& ys) {
  FieldOnGrid made = field;
  made.x.values = xs;
  made.y.values = ys;
  made.field.dims = {ys.size(), xs.size()};
  made.field.values.assign(xs.size() * ys.size(), 0.0);
  const double least = *std::ranges::min_element(field.field.values);
  // First each row of the grid is interpolated along x, then the rows are interpolated along y.
  const std::size_t rows = field.y.values.size();
  std::vector<double> along_x(rows * xs.size(), 0.0);
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const Stencil at = stencil_at(field.x.values, xs[i]);
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t k = 0; k < at.count; ++k)
        along_x[j * xs.size() + i] += at.weights[k] * field.at(at.first + k, j);
  }
  for (std::size_t j = 0; j < ys.size(); ++j) {
    const Stencil at = stencil_at(field.y.values, ys[j]);
    for (std::size_t i = 0; i < xs.size(); ++i) {
      double& value = made.field.values[j * xs.size() + i];
      for (std::size_t k = 0; k < at.count; ++k) value += at.weights[k] * along_x[(at.first + k) * xs.size() + i];
      value = std::max(value, least);
    }
  }
  return made;
}

}  // namespace ehl::program
