#pragma once
#include <string>
#include <vector>

namespace ehl::machines {

/// A number of a machine element, for text, JSON and result file.
struct Number {
  std::string name{};
  double value = 0.0;
  std::string unit{};     ///< "-" for a pure number
  std::string formula{};  ///< formula and its source
};

/// Contact of a machine element, in SI.
struct Contact {
  std::string section{};  ///< section of the deck from which it follows: "bearing"
  std::string what{};     ///< "ball on the inner race"
  std::vector<Number> numbers{};
};

}  // namespace ehl::machines
