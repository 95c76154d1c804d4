#pragma once
// The columns of a table for contacts in SI: films in nm, pressures in GPa, and the published formulas.
#include <limits>
#include <optional>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/physical_input.hpp"

namespace ehl::program {

/// A case in SI and its film; NaN if there is no film.
struct SiRow {
  Physics physics{};
  std::vector<Formula> formulas{};
  std::optional<Roughness> roughness{};
  double hc = std::numeric_limits<double>::quiet_NaN();  ///< [m]
  double hm = std::numeric_limits<double>::quiet_NaN();
  double p_max = std::numeric_limits<double>::quiet_NaN();     ///< [Pa]
  double error_hc = std::numeric_limits<double>::quiet_NaN();  ///< relative error, of mesh and iteration
  double error_hm = std::numeric_limits<double>::quiet_NaN();
};

/// The shape of the contacts in a table; it decides which formulas and loads have columns.
enum class Bodies { circular, elliptic, line };

/// in: rough: true if the roughness of the surfaces is known.
std::vector<Column<SiRow>> si_columns(Bodies bodies, bool rough);

}  // namespace ehl::program
