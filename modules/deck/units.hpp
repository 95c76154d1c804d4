#pragma once
// Units that a heading of a table may name.
#include <string>
#include <string_view>
#include <vector>

namespace ehl::deck {

/// value in the SI unit = factor * value in this unit + offset.
struct Unit {
  std::string_view name;  ///< as messages write it
  std::string_view si;    ///< the unit in which the program computes: "Pa", "m/s"; "-" for a pure number
  double factor = 1.0;
  double offset = 0.0;
};

/// The unit that a text means: "MPa", "mPa s", "mPa·s", "mPa*s", "kg m^-3", "µm", "%". Letter case counts, because mPa
/// and MPa differ. Null where it is none.
const Unit* find_unit(std::string_view text);

/// The names of all units of a quantity, for messages. in: its SI unit.
std::vector<std::string> units_of(std::string_view si);

}  // namespace ehl::deck
