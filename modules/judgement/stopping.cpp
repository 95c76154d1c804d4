#include "judgement/stopping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ehl::judgement {
namespace {

/// Relative rounding error of Hc and Hm.
constexpr double rounding = 1e-11;
/// An oil content below zero by more than this share of the film is more than rounding.
constexpr double rounding_of_content = 1e-10;
/// The film of a first grid has settled in this cycle at the earliest. [bench: settled_change]
constexpr int fewest_first_cycles = 3;

std::string text(double value) { return std::isfinite(value) ? fmt::format("{:.2e}", value) : "not finite"; }

// Checks that every state must pass.
std::string impossible(const Measures& now) {
  if (!std::isfinite(now.Hm + now.least_P)) return "the cycles diverged: the film or the pressure is not finite";
  // Hc may be an interpolated value.
  if (const double least = std::min(now.Hm, now.Hc); !(least > 0.0))
    return "the minimum of the film is negative, H = " + text(least) +
           ": the mesh is too coarse for this contact; use more cells";
  if (!(now.least_P >= 0.0)) return "the minimum of the pressure is negative, P = " + text(now.least_P);
  return {};
}

std::string unmet_residual(const Measures& now, double residual, double load_error) {
  if (!(now.residual <= residual))
    return "relative residual " + text(now.residual) + " is above " + text(residual) +
           "; raise max_cycles or use a finer grid";
  if (!(now.load_error <= load_error))
    return "load error " + text(now.load_error) + " is above " + text(load_error) + "; raise max_cycles";
  return {};
}

std::string unmet_balance(const Tuning& tuning, const Measures& now, double mesh_error_Hc) {
  if (!(now.dry_violation <= tuning.largest_dry_violation))
    return "complementarity is violated: a cavitated node has the residual " + text(now.dry_violation) +
           " of the wedge term, above " + text(tuning.largest_dry_violation) + "; raise max_cycles";
  const double licence =
      std::isfinite(mesh_error_Hc) ? std::min(mesh_error_Hc, tuning.largest_licence) : tuning.largest_licence;
  const double allowed = std::max(tuning.flow_share * licence, tuning.least_flow_licence);
  if (!(std::abs(now.flow_imbalance) <= allowed))
    return "mass is not conserved around the contact: the imbalance is " + text(now.flow_imbalance) +
           " of the flow through it, above " + text(allowed) + "; raise max_cycles or use a finer grid";
  return {};
}

std::string unmet_share(const Tuning& tuning, const char* name, double left, double discretization_error) {
  if (left <= std::max(tuning.algebraic_share * std::min(discretization_error, tuning.largest_licence), rounding))
    return {};
  return std::string(name) + " still has an algebraic error of about " + text(left) +
         ", too large compared with its discretization error " + text(discretization_error) + "; raise max_cycles";
}

bool settled(const Tuning& tuning, int cycle, const Measures& before, const Measures& now) {
  const auto change = [](double was, double is) { return std::abs((is - was) / is); };
  return cycle >= fewest_first_cycles && now.Hm > 0.0 && change(before.Hc, now.Hc) < tuning.settled_change &&
         change(before.Hm, now.Hm) < tuning.settled_change;
}

}  // namespace

// Hm follows the residual with delay.
double predicted_error(const Tuning& tuning, const LastCycle& cycle, double Measures::*value) {
  const double factor =
      std::clamp(cycle.after.residual / cycle.before.residual, tuning.best_factor, tuning.worst_factor);
  const double after = cycle.after.*value;
  return std::abs((after - cycle.before.*value) / after) * factor / (1.0 - factor);
}

std::string unmet_film(const Tuning& tuning, const LastCycle& cycle) {
  std::string unmet = impossible(cycle.after);
  if (unmet.empty())
    unmet = unmet_share(tuning, "Hc", predicted_error(tuning, cycle, &Measures::Hc), cycle.mesh_error_Hc);
  if (unmet.empty())
    unmet = unmet_share(tuning, "Hm", predicted_error(tuning, cycle, &Measures::Hm), cycle.mesh_error_Hm);
  return unmet;
}

std::string unmet_oil(const Tuning& tuning, const Measures& now) {
  if (now.least_content < -rounding_of_content * std::abs(now.Hc))
    return "the oil content is negative at its lowest, Q = " + text(now.least_content) +
           ": the mesh is too coarse for this film; use more cells";
  if (std::abs(now.oil_imbalance) <= tuning.largest_oil_imbalance) return {};
  return "oil is not conserved: the imbalance is " + text(now.oil_imbalance) + " of the inflow, above " +
         text(tuning.largest_oil_imbalance) + "; raise max_cycles or use a finer grid";
}

std::string unmet_check(const Tuning& tuning, const LastCycle& cycle, double tolerance) {
  const Measures& now = cycle.after;
  if (std::string unmet = impossible(now); !unmet.empty()) return unmet;
  const bool by_tolerance = std::isfinite(tolerance) || !std::isfinite(cycle.mesh_error_Hc);
  const double asked = std::isfinite(tolerance) ? tolerance : tuning.default_tolerance;
  std::string unmet = by_tolerance ? unmet_residual(now, asked, asked)
                                   : unmet_residual(now, tuning.loose_residual, tuning.loose_load_error);
  if (unmet.empty()) unmet = unmet_balance(tuning, now, cycle.mesh_error_Hc);
  if (by_tolerance) return unmet;
  return unmet.empty() ? unmet_film(tuning, cycle) : unmet;
}

Verdict judged(const Tuning& tuning, const StoppingCriterion& criterion, int cycle, const LastCycle& last) {
  const Measures& now = last.after;
  if (criterion.aim == Aim::residual) return {unmet_residual(now, criterion.tolerance, criterion.tolerance)};
  if (criterion.aim != Aim::solution && now.residual > criterion.of_start && !no_solution(tuning, now))
    return {unmet_residual(now, criterion.of_start, std::numeric_limits<double>::infinity())};
  if (criterion.aim == Aim::first_start && settled(tuning, cycle, last.before, now)) return {};
  if (std::isnan(criterion.tolerance) && cycle < criterion.planned) return {"the planned cycles are not finished"};
  const bool only_a_start = criterion.aim != Aim::solution && std::isfinite(last.mesh_error_Hc);
  return {only_a_start ? unmet_film(tuning, last) : unmet_check(tuning, last, criterion.tolerance),
          no_solution(tuning, now)};
}

bool no_solution(const Tuning& tuning, const Measures& now) {
  return now.residual < tuning.solved_residual && !(now.Hm > 0.0);
}

}  // namespace ehl::judgement
