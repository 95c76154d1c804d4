#pragma once
// Fixed-point iteration for a steady contact with heat on one grid: film temperature and multigrid cycles alternate
// until both are converged. One iteration is called a pass.
#include <limits>
#include <string>
#include <vector>

#include "effects/heat/factors.hpp"
#include "effects/heat/tuning.hpp"
#include "judgement/measures.hpp"
#include "multigrid/full_multigrid.hpp"
#include "thermal/film_temperature.hpp"

namespace ehl::heat {

/// Result of a pass: a sweep of the film temperature, and cycles with the resulting coefficients.
struct Pass {
  double Hc = 0.0, Hm = 0.0, mu = 0.0;
  double theta = 0.0;   ///< largest temperature of the film
  double change = 0.0;  ///< largest remaining change of these four, relative, over the allowed one
  double weight = 1.0;  ///< under-relaxation factor of the coefficient factors
  bool undone = false;  ///< rejected: the cycles found no film with these coefficients
};

/// Limits and stopping criterion of the passes.
struct Parameters {
  double first_weight = 1.0;  ///< under-relaxation factor of the first pass
  int most = 40;              ///< number of passes
  /// Allowed remaining change of Hc, Hm, mu and the largest temperature, over their discretization errors.
  double share = 0.1;
  double defect = 1e-3;       ///< allowed relative defect of the heat balance
  std::vector<Pass> below{};  ///< solutions on coarser grids, coarse to fine, which give those errors
  /// Required relative residual and load error; NaN: chosen from the discretization error.
  double tolerance = std::numeric_limits<double>::quiet_NaN();
  /// Relative discretization error of all four without coarser solutions. NaN: unknown.
  double error = std::numeric_limits<double>::quiet_NaN();
  /// Slowly settling parts may hide behind fast ones: use the larger contraction factor of the last two passes.
  bool slow = false;
  Tuning tuning{};
};

/// Result of the thermal iteration on one grid.
struct Result {
  std::vector<Pass> passes{};
  std::string unmet{};  ///< criterion that is not met; empty if converged
  thermal::Balance balance{};
};

/// Iterates from a state on level l, whose model has the factors' effect, to the thermal solution. Converged if the
/// above criteria and the checks of every steady solution (judgement/stopping.hpp) hold. A pass that finds no film is
/// undone and repeated with half the under-relaxation factor. The factor also falls if the required change does not
/// fall. Updates the last row of the record.
/// limits: neither the Newton fallback nor load continuation is available. errors: core::Interrupted.
Result heat_up(multigrid::Run& run, std::size_t l, thermal::FilmTemperature& film, const Parameters& parameters);

}  // namespace ehl::heat
