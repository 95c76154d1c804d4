#include "commands/field_on_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

constexpr int most_points = 4000;  // along x: more than a picture has pixels

// The value at a place is the sum of weights times the values of `count` nodes from `first` on.
struct Stencil {
  std::size_t first = 0;
  std::size_t count = 0;
  std::array<double, 4> weights{};
};

// Lagrange's polynomial through the four nearest nodes; beside the boundary those that there are.
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

std::vector<double> spaced(double from, double to, std::size_t count) {
  std::vector<double> lines(count, from);
  for (std::size_t k = 1; k < count; ++k)
    lines[k] = from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1);
  return lines;
}

struct Range {
  double from = 0.0;
  double to = 0.0;
};

// The part of a range "from:to" that lies on the lines of a grid; all of them where none is given.
Range range_of(const std::string& text, const std::vector<double>& lines, const std::string& said) {
  const Range whole{lines.front(), lines.back()};
  if (text.empty()) return whole;
  const std::size_t colon = text.find(':');
  const deck::ReadNumber from = deck::read_number(text.substr(0, colon));
  const deck::ReadNumber to = deck::read_number(colon == std::string::npos ? "" : text.substr(colon + 1));
  using Status = deck::ReadNumber::Status;
  if (from.status != Status::number || to.status != Status::number || !(from.value < to.value))
    refuse(said + ": write --window x0:x1 or --window x0:x1,y0:y1, x0 < x1, y0 < y1");
  const Range part{std::max(from.value, whole.from), std::min(to.value, whole.to)};
  if (!(part.from < part.to))
    refuse(said + ": the domain is [" + deck::shortest(whole.from) + ", " + deck::shortest(whole.to) + "]");
  return part;
}

}  // namespace

FieldOnGrid read_field(const ExtractSource& source, const std::string& name, std::size_t step) {
  // A plane has x and y, a section in depth x and z beside it.
  const bool layers = source.file.dims(name).size() == 3;
  const std::string rows = !layers && source.file.axis(name, "z") != "" ? "z" : "y";
  FieldOnGrid read{layers ? source.frame(name, step) : source.numbers(name),
                   source.numbers(source.file.axis(name, "x")), source.numbers(source.file.axis(name, rows)), rows};
  if (read.field.dims.size() != 2 || read.field.dims[0] != read.y.values.size() ||
      read.field.dims[1] != read.x.values.size() || read.field.values.empty())
    throw core::FileError(source.file.path() + ": the file is damaged: " + name + " does not fit its grid");
  return read;
}

FieldOnGrid on_lines(const FieldOnGrid& field, const std::vector<double>& xs, const std::vector<double>& ys) {
  FieldOnGrid made = field;
  made.x.values = xs;
  made.y.values = ys;
  made.field.dims = {ys.size(), xs.size()};
  made.field.values.assign(xs.size() * ys.size(), 0.0);
  const double least = *std::ranges::min_element(field.field.values);
  // Every row of the grid at the new x; then between the rows.
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

bool is_section(const Arguments& arguments) { return arguments.has("along") || arguments.has("at"); }

Section wanted_section(const FieldOnGrid& field, const Arguments& arguments) {
  const std::string axis = arguments.value("along", "x");
  if (axis != "x" && axis != field.rows) refuse("--along " + axis + ": must be x or " + field.rows);
  const std::string other = axis == "x" ? field.rows : "x";
  const std::string given = arguments.value("at", other + "=0");
  const deck::ReadNumber at = deck::read_number(given.starts_with(other + "=") ? given.substr(2) : given);
  if (at.status != deck::ReadNumber::Status::number)
    refuse("--at " + given + ": write --at " + other + "=NUMBER, in " + field.places());
  const std::vector<double>& lines = axis == "x" ? field.y.values : field.x.values;
  if (at.value < std::min(lines.front(), lines.back()) || at.value > std::max(lines.front(), lines.back()))
    refuse("--at " + given + ": the domain is [" + deck::shortest(lines.front()) + ", " + deck::shortest(lines.back()) +
           "]");
  return {axis == "x", at.value};
}

FieldOnGrid sampled(const FieldOnGrid& field, const Arguments& arguments) {
  if (!arguments.has("sample")) {
    if (arguments.has("window")) refuse("--window goes with --sample N, the number of points in it");
    return field;
  }
  const int points = whole_number(arguments, "sample", 2, most_points);
  if (points < 2) refuse("--sample 1: at least 2 points");
  const auto count = static_cast<std::size_t>(points);
  const std::string window = arguments.value("window", "");
  const std::string said = "--window " + window;
  if (is_section(arguments)) {
    const Section section = wanted_section(field, arguments);
    const Range along = range_of(window, section.along_x ? field.x.values : field.y.values, said);
    const std::vector<double> places = spaced(along.from, along.to, count);
    return section.along_x ? on_lines(field, places, {section.at}) : on_lines(field, {section.at}, places);
  }
  const std::size_t comma = window.find(',');
  const Range x = range_of(window.substr(0, comma), field.x.values, said);
  const Range y = range_of(comma == std::string::npos ? "" : window.substr(comma + 1), field.y.values, said);
  const double step = (x.to - x.from) / (points - 1);
  const double rows = std::clamp(std::round((y.to - y.from) / step), 1.0, static_cast<double>(most_points));
  return on_lines(field, spaced(x.from, x.to, count), spaced(y.from, y.to, static_cast<std::size_t>(rows) + 1));
}

}  // namespace ehl::program
