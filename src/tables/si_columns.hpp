#pragma once
// What a table has of contacts in SI: films in nm, pressures in GPa, formulas beside them.
#include <limits>
#include <optional>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/physical_input.hpp"

namespace ehl::program {

/// A case in SI and its film; NaN where there is none.
struct SiRow {
  Physics physics{};
  std::vector<Formula> formulas{};
  std::optional<Roughness> roughness{};
  double hc = std::numeric_limits<double>::quiet_NaN();  ///< [m]
  double hm = std::numeric_limits<double>::quiet_NaN();
  double p_max = std::numeric_limits<double>::quiet_NaN();     ///< [Pa]
  double error_hc = std::numeric_limits<double>::quiet_NaN();  ///< relative, mesh and cycles
  double error_hm = std::numeric_limits<double>::quiet_NaN();
};

/// What the contacts of a table are: their formulas and loads have columns.
enum class Bodies { circular, elliptic, line };

/// in: whether surfaces are of a known roughness.
std::vector<Column<SiRow>> si_columns(Bodies bodies, bool rough);

}  // namespace ehl::program
