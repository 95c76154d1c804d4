#include "machines/course.hpp"

#include <algorithm>
#include <cmath>

#include "machines/number.hpp"

namespace ehl::machines {

deck::ColumnTable course_of(const std::vector<CourseState>& states) {
  deck::ColumnTable table;
  for (const CourseState& one : states)
    table.rows.push_back({one.place, {one.t, one.radius_x, one.load, one.u1, one.u2}});
  for (const double value : table.rows.front().values) table.present.push_back(std::isfinite(value));
  return table;
}

std::vector<Number> extremes_of(const std::vector<CourseState>& states, bool line) {
  const struct {
    const char* name;
    const char* unit;
    double (*of)(const CourseState& state);
  } quantities[] = {
      {"radius_x", "m", [](const CourseState& state) { return state.radius_x; }},
      {line ? "load_per_length" : "load", line ? "N/m" : "N", [](const CourseState& state) { return state.load; }},
      {"mean_speed", "m/s", [](const CourseState& state) { return 0.5 * (state.u1 + state.u2); }},
      {"sliding_speed", "m/s", [](const CourseState& state) { return state.u1 - state.u2; }}};
  std::vector<Number> numbers;
  for (const auto& [name, unit, of] : quantities) {
    const auto [least, most] = std::ranges::minmax_element(states, {}, of);
    if (std::isnan(of(*least)) || of(*least) == of(*most)) continue;
    numbers.push_back({std::string(name) + "_least", of(*least), unit, "smallest of the course, " + least->place});
    numbers.push_back({std::string(name) + "_most", of(*most), unit, "largest of the course, " + most->place});
  }
  return numbers;
}

}  // namespace ehl::machines
