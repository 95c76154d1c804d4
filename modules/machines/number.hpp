#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "deck/text_table.hpp"

namespace ehl::machines {

inline constexpr double degree = core::pi / 180.0;

/// A number of a machine element, for text, JSON and result file.
struct Number {
  std::string name{};
  double value = 0.0;
  std::string unit{};     ///< "-" for a pure number
  std::string formula{};  ///< formula and its source
};

/// The number that says how much a course deviates between its states.
inline constexpr char error_of_course[] = "error_of_course";

/// The columns of a course, as those of the table that [transient] cycle names: t [s], radius_x [m], load [N, of a line
/// contact N/m], u1 and u2 [m/s].
inline constexpr int columns_of_course = 5;

/// Contact of a machine element, in SI.
struct Contact {
  std::string section{};  ///< section of the deck from which it follows: "bearing"
  std::string what{};     ///< "ball on the inner race"
  std::vector<Number> numbers{};
  /// What happens to the contact in time, for [transient] cycle = machine; nullopt: the machine has no course.
  std::optional<deck::ColumnTable> course{};
  bool repeats = true;  ///< the last row of the course is the first one
  /// The machine determines speeds only; the other keys of [contact] are the deck's.
  bool only_moves = false;
};

/// A number of the machine; nullptr if it has none of this name.
inline const Number* find_number(const Contact& machine, const std::string& name) {
  const auto number = std::ranges::find(machine.numbers, name, &Number::name);
  return number == machine.numbers.end() ? nullptr : &*number;
}

}  // namespace ehl::machines
