#include "effects/heat/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judgement/error_estimate.hpp"
#include "judgement/stopping.hpp"

namespace ehl::heat {
namespace {

using judgement::LastCycle;
using judgement::Measures;

// Below this weight a pass changes too little to be worth one: 0.3 carried all of a map to 20 m/s, srr = 2, 1.5 GPa.
constexpr double least_weight = 0.1;
// The change that the film asks for should fall to this much in a pass; measured 0.1 to 0.5 where nothing is wrong.
constexpr double slow = 0.8;
// Where the discretization error is not known: a single grid.
constexpr double unknown_error = 1e-2;
// No estimate is trusted to be less.
constexpr double least_error = 1e-4;
// A friction, and a rise in kelvin over T0, below which it counts as none.
constexpr double least_mu = 1e-6, least_theta = 1e-6;
// Where no share of the temperature leads on: smaller weights of the relaxations, as the isothermal film may have
// needed.
constexpr double back_off = 0.8, least_caution = 0.5;
// Asked for on a single grid, where nothing tells the discretization error, which is a per cent: passes end with 1e-6
// to 3e-5, because the upwind differences of a temperature that recirculates switch from pass to pass.
constexpr double single_grid_residual = 1e-4;
constexpr double order = 2.0;  // of mu and temperatures, as of the film

// The change of a number in a pass over what is allowed of it. least: below it the number counts as none.
double over_allowed(const Parameters& parameters, const Pass& now, const Pass& before, double Pass::*value,
                    double least = 0.0) {
  std::vector<double> sequence;
  for (const Pass& one : parameters.below) sequence.push_back(one.*value);
  sequence.push_back(now.*value);
  double error =
      parameters.below.empty() ? parameters.error : judgement::estimate_error(sequence, order).relative_error;
  if (std::isnan(error)) error = unknown_error;
  const double allowed = parameters.share * std::clamp(error, least_error, judgement::largest_licence);
  const double size = std::max(std::abs(now.*value), least / allowed);
  return std::abs(now.*value - before.*value) / size / allowed;
}

// One cycle with the factors as they are. out: false where it leaves no film.
bool cycle(fmg::Run& run, std::size_t l, int number, LastCycle& last) {
  fmg::Hierarchy& hierarchy = run.hierarchy;
  // A cycle that diverges is not told of: the state before it is back.
  bool done = false;
  const fmg::CycleObserver observe = [&](int, const Measures& now) {
    done = std::isfinite(now.residual) && now.Hm > 0.0;
    if (done) {
      fmg::enter(hierarchy, l, number, now, run.record);
      constexpr int usual = 4;  // passes
      fmg::report(run, l, number, usual, now);
    }
    return fmg::DiscretizationError{};
  };
  fmg::update_film(hierarchy, hierarchy.levels[l]);
  constexpr double never = 0.0;  // the number of cycles is the criterion
  const fmg::CyclesResult result =
      fmg::run_cycles(hierarchy, l, {.aim = judgement::Aim::residual, .planned = 1, .most = 1, .tolerance = never},
                      run.caution, observe);
  run.caution = result.caution;
  last = result.last;
  last.first = number == 1;
  const fmg::LevelRow& row = run.record.levels.back();
  last.error_Hc = row.error_Hc;
  last.error_Hm = row.error_Hm;
  if (last.after.residual > fmg::rough_factor * last.before.residual) run.caution.relax_after = true;
  return done;
}

Pass pass_of(const Measures& measures, const thermal::Balance& balance, const Pass& before,
             const Parameters& parameters) {
  Pass pass{.Hc = measures.Hc, .Hm = measures.Hm, .mu = balance.friction, .theta = balance.film.theta};
  pass.change =
      std::max({over_allowed(parameters, pass, before, &Pass::Hc), over_allowed(parameters, pass, before, &Pass::Hm),
                over_allowed(parameters, pass, before, &Pass::mu, least_mu),
                over_allowed(parameters, pass, before, &Pass::theta, least_theta)});
  return pass;
}

// What is still wrong after a pass; empty: nothing.
std::string unmet_of(const Pass& pass, const thermal::Balance& balance, const LastCycle& last,
                     const Parameters& parameters) {
  if (pass.undone)
    return "the film does not bear its temperature: no cycle leads on with it; use more cells, or less sliding";
  if (balance.clipped) return "the temperature stands at its bounds";
  if (pass.change > 1.0)
    return fmt::format("film, friction or temperature still change by {:.1f} times what is allowed in a pass",
                       pass.change);
  if (!(std::abs(balance.defect) <= parameters.defect))
    return fmt::format("heat made and heat led away differ by {:.1e} (limit {:.1e})", balance.defect,
                       parameters.defect);
  const bool open = std::isnan(parameters.tolerance) && std::isnan(last.error_Hc);
  return judgement::unmet_check(last, open ? single_grid_residual : parameters.tolerance);
}

}  // namespace

Result heat_up(fmg::Run& run, std::size_t l, thermal::FilmTemperature& film, Factors& factors,
               const Parameters& parameters) {
  fmg::Hierarchy& hierarchy = run.hierarchy;
  fmg::Level& level = hierarchy.levels[l];
  Result result;
  Pass before;
  LastCycle last;
  double weight = 1.0, asked_before = INFINITY;
  for (int n = 1; n <= parameters.most; ++n) {
    const fmg::State kept = fmg::state_of(hierarchy, l);
    const fmg::Caution caution = run.caution;
    film.take(level.P, level.H);
    film.sweep();
    result.balance = film.balance();
    const double asked = factors.take(film, weight);
    if (asked > slow * asked_before) weight = std::max(least_weight, 0.7 * weight);
    const bool good = std::isfinite(asked) && cycle(run, l, n, last);
    Pass pass = good ? pass_of(last.after, result.balance, before, parameters) : before;
    pass.weight = weight;
    pass.undone = !good;
    result.passes.push_back(pass);
    result.unmet = unmet_of(pass, result.balance, last, parameters);
    if (good) {
      run.record.verification = judgement::verification_of(last);
      if (n > 1 && result.unmet.empty()) return result;
      before = pass;
      asked_before = asked;
      continue;
    }
    core::copy(kept.P, level.P);
    hierarchy.H00 = kept.H00;
    factors.give_back();
    fmg::update_film(hierarchy, level);
    weight *= 0.5;
    run.caution = caution;
    if (weight >= least_weight) continue;
    run.caution = {.all = back_off * caution.all, .steep = back_off * caution.steep, .relax_after = true};
    if (run.caution.all < least_caution) return result;
    weight = 1.0;
  }
  return result;
}

}  // namespace ehl::heat
