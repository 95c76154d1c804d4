#include "effects/heat/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judgement/error_estimate.hpp"
#include "judgement/stopping.hpp"
#include "multigrid/factors.hpp"
#include "multigrid/mass_balance.hpp"

namespace ehl::heat {
namespace {

using judgement::LastCycle;
using judgement::Measures;

// Previous pass, its contraction factor, and the q in use.
struct History {
  Pass before;
  double factor = 0.5, q = 0.5;
};

// Estimated remaining change of a quantity over the allowed one: the last change times q/(1 - q). The contraction
// factor q is that of the required change of the coefficients, which is smoother than that of the largest temperature.
// in: least, below which its size counts as zero.
double over_allowed(const judgement::Tuning& judged, const Parameters& parameters, const Pass& now,
                    const History& history, double Pass::*value, double least) {
  const Tuning& tuning = parameters.tuning;
  std::vector<double> sequence;
  for (const Pass& one : parameters.below) sequence.push_back(one.*value);
  sequence.push_back(now.*value);
  double error = parameters.below.empty() ? parameters.error
                                          : judgement::estimate_error(judged, sequence, tuning.order).relative_error;
  if (std::isnan(error)) error = tuning.unknown_error;
  const double allowed = parameters.share * std::clamp(error, tuning.least_error, judged.largest_licence);
  const double size = std::max(std::abs(now.*value), least / allowed);
  const double change = std::abs(now.*value - history.before.*value);
  return change * history.q / (1.0 - history.q) / size / allowed;
}

// Runs cycles with constant factors: one if it reduces the residual enough, more if the damping must increase first.
// returns false if they find no film.
bool cycle(const Tuning& tuning, multigrid::Run& run, std::size_t l, LastCycle& last) {
  multigrid::Hierarchy& hierarchy = run.hierarchy;
  bool done = false;
  const multigrid::CycleObserver observe = [&](int number, const Measures& now) {
    done = std::isfinite(now.residual) && now.Hm > 0.0;
    if (done) {
      multigrid::enter(hierarchy, l, number, now, run.record);
      constexpr int usual = 4;  // passes, for the progress report
      multigrid::report(run, l, number, usual, now);
    }
    return multigrid::DiscretizationError{};
  };
  multigrid::update_film(hierarchy, hierarchy.levels[l]);
  const double before = multigrid::measures_of(hierarchy, l).residual;
  const multigrid::CyclesResult result = multigrid::run_cycles(
      hierarchy, l,
      {.aim = judgement::Aim::residual, .most = tuning.most_cycles, .tolerance = tuning.enough_of_a_pass * before},
      run.damping, observe);
  run.damping = result.damping;
  last = result.last;
  const multigrid::LevelRow& row = run.record.levels.back();
  const double one_grid = judgement::error_of_one_grid(hierarchy.parameters.judgement, hierarchy.levels[l].grid.hx(),
                                                       last.after.Hm, tuning.order);
  last.mesh_error_Hc = std::isnan(row.mesh_error_Hc) ? one_grid : row.mesh_error_Hc;
  last.mesh_error_Hm = std::isnan(row.mesh_error_Hm) ? one_grid : row.mesh_error_Hm;
  if (last.after.residual > hierarchy.parameters.tuning.rough_factor * last.before.residual)
    run.damping.relax_after = true;
  return done && result.end != multigrid::CyclesEnd::diverged;
}

Pass pass_of(const judgement::Tuning& judged, const Measures& measures, const thermal::Balance& balance,
             const History& history, const Parameters& parameters) {
  Pass pass{.Hc = measures.Hc, .Hm = measures.Hm, .mu = balance.friction, .theta = balance.film.theta};
  const auto change_of = [&](double Pass::*value, double least) {
    return over_allowed(judged, parameters, pass, history, value, least);
  };
  pass.change =
      std::max({change_of(&Pass::Hc, 0.0), change_of(&Pass::Hm, 0.0), change_of(&Pass::mu, parameters.tuning.zero),
                change_of(&Pass::theta, parameters.tuning.zero)});
  return pass;
}

// Criterion that a pass does not meet; empty if it meets all.
std::string unmet_of(const judgement::Tuning& judged, const Pass& pass, const thermal::Balance& balance,
                     const LastCycle& last, const Parameters& parameters) {
  if (pass.undone) return "the film cannot be solved at its temperature: no cycle converges from this iteration on";
  if (balance.clipped) return "the temperature has reached its bounds";
  if (pass.change > 1.0)
    return fmt::format("film, friction or temperature still change by {:.1f} times the tolerance of one iteration",
                       pass.change);
  if (!(std::abs(balance.defect) <= parameters.defect))
    return fmt::format("the heat generated and the heat conducted away differ by {:.1e} (limit {:.1e})", balance.defect,
                       parameters.defect);
  return judgement::unmet_check(judged, last, parameters.tolerance);
}

// Closes the oil balance of a solution. in: the state before its pass. returns the criterion that is not met then;
// empty if all are.
std::string correct_mass(multigrid::Run& run, std::size_t l, const multigrid::State& before,
                         const Parameters& parameters, LastCycle& last) {
  multigrid::Hierarchy& hierarchy = run.hierarchy;
  if (!multigrid::conserves_mass(hierarchy.levels[l])) return {};
  const multigrid::RelaxationParameters relaxation = multigrid::cautious(hierarchy.parameters, run.damping).relaxation;
  const auto judge = [&] {
    const int number = run.record.history.back().cycle;
    run.record.history.pop_back();
    multigrid::enter(hierarchy, l, number, last.after, run.record);
    return judgement::Verdict{judgement::unmet_check(hierarchy.parameters.judgement, last, parameters.tolerance)};
  };
  return multigrid::close_or_leave(hierarchy, l, before, relaxation, last.after, judge).unmet;
}

// Updates temperature and factors from the state. returns the change of the coefficients that the film requires.
double renew(const Tuning& tuning, multigrid::Hierarchy& hierarchy, std::size_t l, int pass,
             thermal::FilmTemperature& film, double weight, thermal::Balance& balance) {
  const core::ScopedTimer timer(hierarchy.times, core::Part::heat);
  multigrid::Level& level = hierarchy.levels[l];
  if (multigrid::conserves_mass(level)) {
    multigrid::update_residual(hierarchy, level);
    const core::Field theta = multigrid::theta_of(level);
    film.take(level.P, level.H, &theta);
  } else {
    film.take(level.P, level.H);
  }
  // The slow change that remains after the first passes comes from an inlet with recirculation, where heat passes from
  // line to line only once per sweep.
  const bool slow = pass > tuning.quick;
  // Temperatures carried upstream in the inlet change slowly, so they are swept only in every second of the first
  // passes.
  for (int sweep = 0; sweep < (slow ? tuning.sweeps_when_slow : 1); ++sweep) film.sweep(slow || pass % 2 == 1);
  balance = film.balance();
  return take_factors(hierarchy, l, film, weight);
}

}  // namespace

Result heat_up(multigrid::Run& run, std::size_t l, thermal::FilmTemperature& film, const Parameters& parameters) {
  multigrid::Hierarchy& hierarchy = run.hierarchy;
  multigrid::Level& level = hierarchy.levels[l];
  const Tuning& tuning = parameters.tuning;
  const judgement::Tuning& judged = hierarchy.parameters.judgement;
  Result result;
  History history;
  LastCycle last;
  film::FactorFields factors_before = *level.factors;
  double weight = parameters.first_weight, asked_before = INFINITY;
  for (int n = 1; n <= parameters.most; ++n) {
    const multigrid::State kept = multigrid::state_of(hierarchy, l);
    const multigrid::Damping damping = run.damping;
    factors_before = *level.factors;
    const double asked = renew(tuning, hierarchy, l, n, film, weight, result.balance);
    const double factor = std::clamp(asked / asked_before, judged.best_factor, judged.worst_factor);
    if (n > 1) history.q = n > 2 && parameters.slow ? std::max(factor, history.factor) : factor;
    history.factor = factor;
    // The required change falls by the factor 1 - weight if the film does not react.
    const bool falls = asked < (1.0 - tuning.half_of_it * weight) * asked_before;
    weight = falls ? std::min(1.0, weight / tuning.less) : std::max(tuning.least_weight, tuning.less * weight);
    const bool good = std::isfinite(asked) && cycle(tuning, run, l, last);
    Pass pass = good ? pass_of(judged, last.after, result.balance, history, parameters) : history.before;
    pass.weight = weight;
    pass.undone = !good;
    result.passes.push_back(pass);
    result.unmet = unmet_of(judged, pass, result.balance, last, parameters);
    if (good) {
      if (n > 1 && result.unmet.empty() && l == run.finest())
        result.unmet = correct_mass(run, l, kept, parameters, last);
      run.record.verification = judgement::verification_of(judged, last);
      if (n > 1 && result.unmet.empty()) return result;
      history.before = pass;
      asked_before = asked;
      continue;
    }
    core::copy(kept.P, level.P);
    hierarchy.H00 = kept.H00;
    multigrid::set_factors(hierarchy, l, factors_before);
    multigrid::update_film(hierarchy, level);
    weight *= 0.5;
    run.damping = damping;
    if (weight >= tuning.least_weight) continue;
    // No under-relaxation helps: damping of the cycles, as for a difficult isothermal film.
    const multigrid::Tuning& of_cycles = hierarchy.parameters.tuning;
    run.damping = {.all = of_cycles.back_off * damping.all,
                   .steep = of_cycles.back_off * damping.steep,
                   .relax_after = true,
                   .weighted = damping.weighted};
    if (run.damping.all < of_cycles.least_all) return result;
    weight = 1.0;
  }
  return result;
}

}  // namespace ehl::heat
