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
constexpr double loose_residual = 4e-3;
constexpr double loose_load_error = 1e-4;
/// Mass that may appear or vanish around the contact: a share of the discretization error of Hc, and what is always
/// allowed; relative to the flow through the contact.
constexpr double flow_share = 0.25;
constexpr double least_flow_licence = 1e-4;
/// Largest residual, relative to the wedge term, of a cavitated node whose equation wants pressure.
constexpr double largest_dry_violation = 2e-2;
/// Relative residual asked for where the discretization error is unknown.
constexpr double default_tolerance = 1e-6;
/// No cycle is trusted to reduce the error by more, or by less, than this; Hm follows the residual with delay.
constexpr double best_factor = 0.25;
constexpr double worst_factor = 0.9;
/// The start of a level may by chance be closer to the solution than what its first cycle leaves.
constexpr double best_factor_at_first = 0.5;
/// Relative rounding noise of Hc and Hm.
constexpr double rounding = 1e-11;

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2e", value);
  return buffer;
}

// What no state may have, whatever else is asked.
std::string impossible(const StateOfLevel& now) {
  if (!(now.Hm > 0.0))
    return "the film is negative at its thinnest, H = " + text(now.Hm) +
           ": the mesh is too coarse for this contact; use more cells";
  if (!(now.least_P >= 0.0)) return "the pressure is negative at its lowest, P = " + text(now.least_P);
  return {};
}

std::string unmet_residual(const StateOfLevel& now, double residual, double load_error) {
  if (!(now.residual <= residual))
    return "relative residual " + text(now.residual) + " is above " + text(residual) +
           "; more max_cycles or a finer grid may help";
  if (!(now.load_error <= load_error))
    return "load error " + text(now.load_error) + " is above " + text(load_error) + "; more max_cycles may help";
  return {};
}

std::string unmet_balance(const StateOfLevel& now, double error_Hc) {
  if (!(now.dry_violation <= largest_dry_violation))
    return "a cavitated node wants pressure: its residual is " + text(now.dry_violation) +
           " of the wedge term, above " + text(largest_dry_violation) + "; more max_cycles may help";
  const double licence = std::isfinite(error_Hc) ? std::min(error_Hc, largest_licence) : largest_licence;
  const double allowed = std::max(flow_share * licence, least_flow_licence);
  if (!(std::abs(now.flow_imbalance) <= allowed))
    return "mass is not conserved around the contact: " + text(now.flow_imbalance) +
           " of the flow through it appears or is lost, allowed is " + text(allowed) +
           "; more max_cycles or a finer grid may help";
  return {};
}

std::string unmet_share(const char* name, double left, double discretization_error) {
  if (left <= std::max(algebraic_share * std::min(discretization_error, largest_licence), rounding)) return {};
  return std::string(name) + " still has an algebraic error of about " + text(left) +
         ", too much beside its discretization error " + text(discretization_error) + "; more max_cycles may help";
}

}  // namespace

double foretold_error(const LastCycle& cycle, double StateOfLevel::*value) {
  const double best = cycle.first ? best_factor_at_first : best_factor;
  const double factor = std::clamp(cycle.after.residual / cycle.before.residual, best, worst_factor);
  const double after = cycle.after.*value;
  return std::abs((after - cycle.before.*value) / after) * factor / (1.0 - factor);
}

std::string unmet_film(const LastCycle& cycle) {
  std::string unmet = impossible(cycle.after);
  if (unmet.empty()) unmet = unmet_share("Hc", foretold_error(cycle, &StateOfLevel::Hc), cycle.error_Hc);
  if (unmet.empty()) unmet = unmet_share("Hm", foretold_error(cycle, &StateOfLevel::Hm), cycle.error_Hm);
  return unmet;
}

std::string unmet_check(const LastCycle& cycle, double tolerance) {
  const StateOfLevel& now = cycle.after;
  if (std::string unmet = impossible(now); !unmet.empty()) return unmet;
  const bool by_tolerance = std::isfinite(tolerance) || !std::isfinite(cycle.error_Hc);
  const double asked = std::isfinite(tolerance) ? tolerance : default_tolerance;
  std::string unmet =
      by_tolerance ? unmet_residual(now, asked, asked) : unmet_residual(now, loose_residual, loose_load_error);
  if (unmet.empty()) unmet = unmet_balance(now, cycle.error_Hc);
  if (by_tolerance) return unmet;
  return unmet.empty() ? unmet_film(cycle) : unmet;
}

}  // namespace ehl::steady
