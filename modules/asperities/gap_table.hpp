#pragma once
// A table of gaps: asperity pressures and, if it has them, flow factors.
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace ehl::asperities {

/// Rows with increasing gap. The pressure falls; it may be zero in the last rows, where the surfaces do not touch.
struct GapTable {
  std::vector<double> gap{};             ///< [m]
  std::vector<double> pressure{};        ///< [Pa]
  std::vector<double> phi_x{}, phi_y{};  ///< flow factors; empty if the table has none

  /// Number of rows with a pressure.
  std::size_t touching() const;
};

/// Reads the columns gap [m], pressure [Pa] and, if present, phi_x and phi_y, in the units of the heading. Columns and
/// rows may have any order. out: the table, or what is wrong with the file: "p_a.csv:3: ...". errors: core::FileError
/// if the file cannot be read.
std::variant<GapTable, std::string> read_gap_table(const std::string& path);

}  // namespace ehl::asperities
