#include "effects/heat/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ehl::heat {
namespace {

// Below this weight a pass changes too little to be worth one: 0.3 carried all of a map to 20 m/s, srr = 2, 1.5 GPa.
constexpr double least_weight = 0.1;
// The change that the film asks for should fall to this much in a pass; measured 0.1 to 0.5 where nothing is wrong.
constexpr double slow = 0.8;
// Where the discretization error is not known: a single grid.
constexpr double unknown_error = 1e-2;
// A rise in kelvin over T0 below which it counts as none.
constexpr double least_theta = 1e-6;

double relative(double now, double before, double least) {
  return std::abs(now - before) / std::max(std::abs(now), least);
}

// One cycle with the factors as they are. out: false where it leaves no film.
bool cycle(fmg::Run& run, judgement::Measures& measures) {
  fmg::Hierarchy& hierarchy = run.hierarchy;
  // A cycle that diverges is not told of: the state before it is back.
  bool done = false;
  const fmg::CycleObserver observe = [&](int, const judgement::Measures& now) {
    measures = now;
    done = true;
    return fmg::DiscretizationError{};
  };
  fmg::update_film(hierarchy, hierarchy.finest());
  constexpr double never = 0.0;  // the number of cycles is the criterion
  const fmg::CyclesResult result = fmg::run_cycles(
      hierarchy, run.finest(), {.aim = judgement::Aim::residual, .planned = 1, .most = 1, .tolerance = never},
      run.caution, observe);
  run.caution = result.caution;
  return done && std::isfinite(measures.residual) && measures.Hm > 0.0;
}

Pass pass_of(const judgement::Measures& measures, const thermal::Balance& balance, const Pass& before) {
  Pass pass{.Hc = measures.Hc, .Hm = measures.Hm, .mu = balance.friction, .theta = balance.film.theta};
  constexpr double least_mu = 1e-6;
  pass.change = std::max({relative(pass.Hc, before.Hc, 0.0), relative(pass.Hm, before.Hm, 0.0),
                          relative(pass.mu, before.mu, least_mu), relative(pass.theta, before.theta, least_theta)});
  return pass;
}

// What is still wrong after a pass; empty: nothing.
std::string unmet_of(const Pass& pass, const thermal::Balance& balance, double tolerance, double most_defect) {
  if (pass.undone) return "the film does not bear its temperature: smaller steps of load or sliding would lead there";
  if (balance.clipped) return "the temperature stands at its bounds";
  if (pass.change > tolerance)
    return fmt::format("film, friction or temperature still change by {:.1e} per pass (limit {:.1e})", pass.change,
                       tolerance);
  if (!(std::abs(balance.defect) <= most_defect))
    return fmt::format("heat made and heat led away differ by {:.1e} (limit {:.1e})", balance.defect, most_defect);
  return {};
}

}  // namespace

Result heat_up(fmg::Run& run, thermal::FilmTemperature& film, Factors& factors, const Parameters& parameters) {
  fmg::Hierarchy& hierarchy = run.hierarchy;
  fmg::Level& level = hierarchy.finest();
  const double error = run.record.levels.back().error_Hc;
  const double tolerance = parameters.share * (std::isfinite(error) ? error : unknown_error);
  Result result;
  Pass before;
  double weight = 1.0, asked_before = INFINITY;
  for (int n = 0; n < parameters.most; ++n) {
    const fmg::State kept = fmg::state_of(hierarchy, run.finest());
    const fmg::Caution caution = run.caution;
    film.take(level.P, level.H);
    film.sweep();
    result.balance = film.balance();
    const double asked = factors.take(film, weight);
    if (asked > slow * asked_before) weight = std::max(least_weight, 0.7 * weight);
    judgement::Measures measures;
    const bool good = std::isfinite(asked) && cycle(run, measures);
    Pass pass = good ? pass_of(measures, result.balance, before) : before;
    pass.weight = weight;
    pass.undone = !good;
    result.passes.push_back(pass);
    result.unmet = unmet_of(pass, result.balance, tolerance, parameters.defect);
    if (good) {
      if (n > 0 && result.unmet.empty()) return result;
      before = pass;
      asked_before = asked;
      continue;
    }
    core::copy(kept.P, level.P);
    hierarchy.H00 = kept.H00;
    factors.give_back();
    run.caution = caution;
    fmg::update_film(hierarchy, level);
    weight *= 0.5;
    if (weight < least_weight) return result;
  }
  return result;
}

}  // namespace ehl::heat
