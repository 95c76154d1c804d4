#pragma once
// A file with measured viscosity and density.
#include <string>
#include <variant>
#include <vector>

namespace ehl::rheology {

/// Columns of the table; a column that was not required may be empty.
struct FluidTable {
  std::vector<double> p{};    ///< [Pa], rising from 0
  std::vector<double> eta{};  ///< [Pa s], > 0, rising
  std::vector<double> rho{};  ///< [kg/m^3], > 0, rising
};

/// The table, or what is wrong with it: "oil.csv:12: ...".
using ReadTable = std::variant<FluidTable, std::string>;

/// Reads the columns p, eta and, if required, rho by the names and units of the heading; without a heading in this
/// order and in Pa, Pa s and kg/m^3 (deck/text_table.hpp). errors: core::FileError if the file cannot be read.
ReadTable read_fluid_table(const std::string& path, bool with_rho);

}  // namespace ehl::rheology
