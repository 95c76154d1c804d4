#pragma once
// Units allowed in headings of tables.
#include <string>
#include <string_view>
#include <vector>

namespace ehl::deck {

/// value in the SI unit = factor * value in this unit + offset.
struct Unit {
  std::string_view name;  ///< as written in messages
  std::string_view si;    ///< unit in which the program computes: "Pa", "m/s"; "-" for a pure number
  double factor = 1.0;
  double offset = 0.0;
};

/// Unit for a text: "MPa", "mPa s", "mPa·s", "mPa*s", "kg m^-3", "µm", "%". Letter case matters, because mPa and MPa
/// differ. nullptr if there is none.
const Unit* find_unit(std::string_view text);

/// Names of all units of a quantity, for messages. in: its SI unit.
std::vector<std::string> units_of(std::string_view si);

}  // namespace ehl::deck
