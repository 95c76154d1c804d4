#include "steady/cycles.hpp"

#include <cmath>
#include <vector>

#include "core/errors.hpp"
#include "core/field.hpp"
#include "fmg/cycle.hpp"

namespace ehl::steady {
namespace {

/// A state this far from any solution will not come back.
constexpr double hopeless_residual = 1e3;
/// Cycles that stall: this many since the last change of caution in which the residual does not even halve.
constexpr int patience = 6;
constexpr double hardly_less = 0.5;
/// A cycle that leaves more of the residual than this, and leaves it so high for the second time, is a reason for more
/// caution; not the first two of a series, which still feel the interpolation, nor beside rounding errors.
constexpr double poor_factor = 0.75;
/// A cycle without relaxations after the correction that leaves more than this gets one. Such cycles leave 0.2 to 0.3
/// where they work, those with one 0.1 to 0.2 for a third more work.
constexpr double rough_factor = 0.4;
constexpr int settling_cycles = 2;
constexpr double rounding_residual = 1e-10;
constexpr double back_off_steep = 0.8;
constexpr double least_steep = 0.6;
constexpr double back_off_all = 0.8;
constexpr double least_all = 0.5;

/// More caution; false when there is none left to take.
bool back_off(Caution& caution) {
  if (caution.steep * back_off_steep >= least_steep)
    caution.steep *= back_off_steep;
  else if (caution.all * back_off_all >= least_all)
    caution.all *= back_off_all;
  else
    return false;
  return true;
}

struct Saved {
  core::Field P;
  double H00;
};

}  // namespace

void use_caution(const Caution& caution, const fmg::RelaxationParameters& weights, fmg::RelaxationParameters& used) {
  used.weight_distributed = caution.all * weights.weight_distributed;
  used.weight_single = caution.all * weights.weight_single;
  used.weight_single_steep = caution.all * caution.steep * weights.weight_single_steep;
}

CyclesResult run_cycles(fmg::Hierarchy& hierarchy, std::size_t l, int most, const fmg::RelaxationParameters& weights,
                        Caution& caution, const Judge& judge) {
  fmg::Level& level = hierarchy.levels[l];
  fmg::RelaxationParameters& used = hierarchy.parameters.relaxation;
  use_caution(caution, weights, used);
  const Saved start{level.P, hierarchy.H00};
  StateOfLevel before = state_of_level(hierarchy, l);
  CyclesResult result;
  std::vector<double> residuals;  // since the last change of caution
  while (result.cycles < most) {
    ++result.cycles;
    std::string diverged;
    StateOfLevel now;
    try {
      fmg::fas_cycle(hierarchy, l);
      now = state_of_level(hierarchy, l);
      if (!(now.residual < hopeless_residual) || !std::isfinite(now.Hc)) diverged = "the cycles diverge";
    } catch (const core::SolverError& error) {
      diverged = error.what();
    }
    if (!diverged.empty()) {
      level.P = start.P;
      hierarchy.H00 = start.H00;
      fmg::update_film(hierarchy, level);
      result.unmet = diverged;
      result.end = CyclesEnd::diverged;
      if (caution.all * back_off_all < least_all) return result;
      caution.all *= back_off_all;
      if (hierarchy.parameters.post == 0) hierarchy.parameters.post = 1;
      use_caution(caution, weights, used);
      before = state_of_level(hierarchy, l);
      residuals.clear();
      continue;
    }
    const Verdict verdict = judge(result.cycles, before, now);
    result.unmet = verdict.unmet;
    if (result.unmet.empty() || verdict.no_solution) {
      result.end = verdict.no_solution ? CyclesEnd::no_solution : CyclesEnd::content;
      return result;
    }
    residuals.push_back(now.residual);
    if (hierarchy.parameters.post == 0 && result.cycles > 1 && now.residual > rough_factor * before.residual &&
        now.residual > rounding_residual) {
      hierarchy.parameters.post = 1;
      residuals = {now.residual};
    }
    const std::size_t count = residuals.size();
    if (count > patience && now.residual > hardly_less * residuals[count - 1 - patience]) {
      result.end = CyclesEnd::stalled;
      return result;
    }
    if (count > settling_cycles && now.residual > poor_factor * before.residual &&
        now.residual > poor_factor * residuals[count - 3] && now.residual > rounding_residual && back_off(caution)) {
      use_caution(caution, weights, used);
      residuals = {before.residual, now.residual};
    }
    before = now;
  }
  result.end = CyclesEnd::limit;
  return result;
}

}  // namespace ehl::steady
