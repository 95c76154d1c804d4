#include "commands/field_sample.hpp"

#include <algorithm>
#include <cmath>

#include "deck/text.hpp"

namespace ehl::program {
namespace {

constexpr int most_points = 4000;  // along x; more points than the pixels of a picture

struct Range {
  double from = 0.0;
  double to = 0.0;
};

// The part of a range "from:to" that lies on the grid; the whole grid if no range is given.
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
    if (arguments.has("window")) refuse("--window needs --sample N, the number of points in it");
    return field;
  }
  const int points = whole_number(arguments, "sample", 2, most_points);
  if (points < 2) refuse("--sample 1: must be at least 2");
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
