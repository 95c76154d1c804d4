#pragma once
// Courses: what happens to the contact of a machine in time.
#include <string>
#include <vector>

#include "deck/text_table.hpp"
#include "machines/number.hpp"

namespace ehl::machines {

/// One state of a course, in SI; NaN: the machine does not determine it.
struct CourseState {
  std::string place{};  ///< for messages: "the cam at 30 degrees"
  double t = 0.0;
  double radius_x = 0.0;
  double load = 0.0;  ///< of a line contact, per length
  double u1 = 0.0;
  double u2 = 0.0;
};

/// The table that [transient] cycle = machine stands for; it lacks the columns that the first state does not have.
deck::ColumnTable course_of(const std::vector<CourseState>& states);

/// Smallest and largest values over the course of what varies, and of the mean speed.
std::vector<Number> extremes_of(const std::vector<CourseState>& states, bool line);

}  // namespace ehl::machines
