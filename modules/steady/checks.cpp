#include "steady/checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ehl::steady {
namespace {

/// Foretold algebraic error allowed in Hc and Hm, as a share of the estimated discretization error: a tenth is
/// promised, and both numbers are estimates.
constexpr double algebraic_share = 0.05;
/// A larger discretization error than this is no licence to stop earlier: its estimate is too uncertain.
constexpr double largest_licence = 0.05;
/// Largest relative residual and load error of a solution at the level of the discretization error.
constexpr double loose_residual = 2e-2;
constexpr double loose_load_error = 1e-4;
/// Relative residual asked for where the discretization error is unknown.
constexpr double default_tolerance = 1e-6;
/// No cycle is trusted to reduce the error by more, or by less, than this; Hm follows the residual with delay.
constexpr double best_factor = 0.25;
constexpr double worst_factor = 0.9;
/// Relative rounding noise of Hc and Hm.
constexpr double rounding = 1e-11;

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2e", value);
  return buffer;
}

std::string unmet_tolerance(const StateOfLevel& state, double tolerance) {
  if (!(state.residual <= tolerance))
    return "relative residual " + text(state.residual) + " is above " + text(tolerance) +
           "; more max_cycles or a finer grid may help";
  if (!(state.load_error <= tolerance))
    return "load error " + text(state.load_error) + " is above " + text(tolerance) + "; more max_cycles may help";
  return {};
}

std::string unmet_share(const char* name, double left, double discretization_error) {
  if (left <= std::max(algebraic_share * std::min(discretization_error, largest_licence), rounding)) return {};
  return std::string(name) + " still has an algebraic error of about " + text(left) +
         ", too much beside its discretization error " + text(discretization_error) + "; more max_cycles may help";
}

}  // namespace

double foretold_error(const LastCycle& cycle, double StateOfLevel::*value) {
  const double factor = std::clamp(cycle.after.residual / cycle.before.residual, best_factor, worst_factor);
  const double after = cycle.after.*value;
  return std::abs((after - cycle.before.*value) / after) * factor / (1.0 - factor);
}

std::string unmet_check(const LastCycle& cycle, double tolerance) {
  const StateOfLevel& now = cycle.after;
  if (!(now.Hm > 0.0))
    return "the film is negative at its thinnest, H = " + text(now.Hm) +
           ": the mesh is too coarse for this contact; use more cells";
  if (std::isfinite(tolerance)) return unmet_tolerance(now, tolerance);
  if (!std::isfinite(cycle.error_Hc)) return unmet_tolerance(now, default_tolerance);
  if (!(now.residual <= loose_residual)) return unmet_tolerance(now, loose_residual);
  if (!(now.load_error <= loose_load_error)) return unmet_tolerance(now, loose_load_error);
  const std::string unmet = unmet_share("Hc", foretold_error(cycle, &StateOfLevel::Hc), cycle.error_Hc);
  return unmet.empty() ? unmet_share("Hm", foretold_error(cycle, &StateOfLevel::Hm), cycle.error_Hm) : unmet;
}

}  // namespace ehl::steady
