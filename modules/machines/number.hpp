#pragma once
#include <string>
#include <vector>

namespace ehl::machines {

/// A number of a machine element, as text, JSON and the result file tell it.
struct Number {
  std::string name{};
  double value = 0.0;
  std::string unit{};     ///< "-" for a pure number
  std::string formula{};  ///< how it was found, and by whom
};

/// A contact of the element, in SI.
struct Contact {
  std::string section{};  ///< of the deck, that it follows from: "bearing"
  std::string what{};     ///< "ball on the inner race"
  std::vector<Number> numbers{};
};

}  // namespace ehl::machines
