#pragma once
// A steady contact with heat on one grid: the film's temperature and the cycles in turn, until neither changes the
// other.
#include <limits>
#include <string>
#include <vector>

#include "effects/heat/factors.hpp"
#include "fmg/full_multigrid.hpp"
#include "judgement/measures.hpp"
#include "thermal/film_temperature.hpp"

namespace ehl::heat {

/// After a pass: a sweep of the film's temperature, and a cycle with what it makes of the coefficients.
struct Pass {
  double Hc = 0.0, Hm = 0.0, mu = 0.0;
  double theta = 0.0;   ///< largest of the film
  double change = 0.0;  ///< largest of these four, relative, over what is allowed of it
  double weight = 1.0;  ///< with which the factors were taken
  bool undone = false;  ///< the film did not bear them
};

/// When the passes end.
struct Parameters {
  double first_weight = 1.0;  ///< of what the first pass's temperature asks of the coefficients
  int most = 40;              ///< passes
  /// Hc, Hm, mu and the hottest film change by less than this share of their discretization error.
  double share = 0.1;
  double defect = 1e-3;       ///< of the balance of heat
  std::vector<Pass> below{};  ///< the solutions on coarser grids, coarse to fine, which tell those errors
  /// Relative residual and load error to reach; NaN: what the discretization error asks for.
  double tolerance = std::numeric_limits<double>::quiet_NaN();
  /// Without solutions below: the relative error of all four. NaN: unknown.
  double error = std::numeric_limits<double>::quiet_NaN();
  /// Something may settle slowly below what changes quickly: the larger factor of the last two passes is believed.
  bool slow = false;
};

struct Result {
  std::vector<Pass> passes{};
  std::string unmet{};  ///< why it is no solution; empty where it is one
  thermal::Balance balance{};
};

/// From a state on level l, whose model has the factors' effect, to the thermal solution: criteria as above, and the
/// checks of every steady solution (judgement/stopping.hpp). A pass that leaves no film is undone, and the factors are
/// taken by half; likewise with less weight where the change they ask for does not fall. Enters the last row of the
/// record. Rate measured: 0.1 to 0.3 per pass, 4 to 6 passes from an isothermal solution.
/// limits: the rescue by Newton's method and load continuation are not tried. errors: core::Interrupted.
Result heat_up(fmg::Run& run, std::size_t l, thermal::FilmTemperature& film, Factors& factors,
               const Parameters& parameters);

}  // namespace ehl::heat
