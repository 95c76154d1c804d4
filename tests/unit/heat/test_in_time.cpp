// Heat in a run in time, film and temperatures coupled: steady contacts stay, the heat balance, the order of the steps.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "effects/heat/in_time.hpp"
#include "effects/heat/solve.hpp"
#include "steady/solve.hpp"
#include "transient/march.hpp"
#include "unit/heat/heated_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_heat_in_time)

using namespace ehl;
using support::along, support::BaseCase, support::teeth;

namespace {

/// A steady contact with heat, and its continuation in time.
struct Hot {
  BaseCase base;
  thermal::Setup setup;
  steady::Scene scene;
  heat::Solution steady;
};

Hot hot(const BaseCase& base, const core::Grid& grid) {
  Hot made{.base = base, .setup = base.setup(core::Patch(grid)), .scene = {}, .steady = {}};
  made.scene = support::scene_of(base, made.setup, grid);
  made.scene.solver.tolerance = 1e-9;
  made.scene.adjoint_errors = false;
  const steady::Solution cold = steady::solve(made.scene);
  BOOST_TEST_REQUIRE(cold.converged, cold.failed_check);
  made.steady = heat::solve(made.scene, made.setup, {}, cold, {});
  BOOST_TEST_REQUIRE(made.steady.film.converged, made.steady.film.failed_check);
  return made;
}

/// One accepted step.
struct Step {
  double T = 0.0, Hc = 0.0, film = 0.0, surface_1 = 0.0, surface_2 = 0.0, mu = 0.0, defect = 0.0;
};

transient::Conditions conditions_of(const BaseCase& base) {
  transient::Conditions conditions;
  conditions.u1.points = {{0.0, 1.0 + 0.5 * base.srr}};
  conditions.u2.points = {{0.0, 1.0 - 0.5 * base.srr}};
  conditions.thinning_k = base.setup(core::Patch(support::square(8))).thinning->k / std::abs(base.srr);
  return conditions;
}

std::vector<Step> marched(const Hot& contact, const transient::Conditions& conditions,
                          const transient::MarchParameters& parameters) {
  heat::InTime heat(contact.setup, conditions, parameters.end, 1, {});
  const transient::Coupling coupling = heat.coupling();
  std::vector<Step> steps;
  const transient::Observer observer{.row = [&](const transient::StepRow& row) {
    const thermal::Balance& now = heat.balance();
    steps.push_back(
        {row.T, row.Hc, now.film.theta, now.surface_1.theta, now.surface_2.theta, now.friction, now.defect});
    return true;
  }};
  const transient::MarchReport report =
      transient::march(contact.scene, contact.steady.film, conditions, parameters, observer, nullptr, &coupling);
  BOOST_TEST_MESSAGE(report.steps << " steps, " << static_cast<double>(report.cycles) / report.steps << " cycles each, "
                                  << report.rejected << " rejected, " << report.not_solved << " not solved, "
                                  << report.seconds << " s");
  BOOST_TEST_REQUIRE((report.end == transient::MarchEnd::end_time), report.reason);
  return steps;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_steady_contact_stays_where_it_is) {
  for (const bool line : {true, false}) {
    const Hot contact = line ? hot(teeth(), along(256)) : hot(BaseCase{}, support::square(64));
    const std::vector<Step> steps = marched(contact, conditions_of(contact.base), {.end = 10.0});
    const auto compare = [&](const char* name, double Step::*value, double steady) {
      double moves = 0.0;
      for (const Step& step : steps) moves = std::max(moves, std::abs(step.*value / steps.front().*value - 1.0));
      const double apart = std::abs(steps.front().*value / steady - 1.0);
      BOOST_TEST_MESSAGE((line ? "line: " : "point: ")
                         << name << " moves by " << moves << " (allowed 1e-6), apart from the steady solver by "
                         << apart << " (allowed 2e-3)");
      BOOST_TEST(moves <= 1e-6);
      BOOST_TEST(apart <= 2e-3);
    };
    compare("Hc", &Step::Hc, contact.steady.rows.back().Hc);
    compare("film", &Step::film, contact.steady.in_film.theta);
    compare("surface 1", &Step::surface_1, contact.steady.on_1.theta);
    compare("surface 2", &Step::surface_2, contact.steady.on_2.theta);
    double worst = 0.0;
    for (const Step& step : steps) worst = std::max(worst, std::abs(step.defect));
    BOOST_TEST_MESSAGE("heat balance " << worst << " (allowed 1e-3)");
    BOOST_TEST(worst <= 1e-3);
  }
}

// A load that oscillates: steps of a fixed length, against very short ones with a small tolerance.
BOOST_AUTO_TEST_CASE(the_steps_are_of_second_order) {
  const Hot contact = hot(teeth(), along(256));
  transient::Conditions conditions = conditions_of(contact.base);
  conditions.load.wave = transient::Schedule::Wave{.amplitude = 0.1, .period = 4.0};
  const auto at_end = [&](double longest, double rtol) {
    return marched(contact, conditions, {.end = 2.0, .rtol = rtol, .longest_step = longest}).back();
  };
  const Step exact = at_end(0.01, 1e-6), coarse = at_end(0.08, 1e-2), fine = at_end(0.04, 1e-2);
  for (const auto& [name, value] : {std::pair("film", &Step::film), {"mu", &Step::mu}}) {
    const auto error = [&, part = value](const Step& step) { return std::abs(step.*part / exact.*part - 1.0); };
    const double order = std::log2(error(coarse) / error(fine));
    BOOST_TEST_MESSAGE(name << ": errors " << error(coarse) << ", " << error(fine) << ": order " << order
                            << " (at least 1.5)");
    BOOST_TEST(order >= 1.5);
  }
}

// The first steps of a small tolerance are short; the far field must follow them.
BOOST_AUTO_TEST_CASE(the_error_of_a_point_contact_follows_the_tolerance) {
  const Hot contact = hot(BaseCase{}, support::square(32));
  transient::Conditions conditions = conditions_of(contact.base);
  conditions.load.wave = transient::Schedule::Wave{.amplitude = 0.1, .period = 4.0};
  const auto at_end = [&](double rtol) {
    return marched(contact, conditions, {.end = 2.0, .rtol = rtol, .longest_step = 0.2}).back();
  };
  const Step exact = at_end(1e-6), loose = at_end(1e-3), tight = at_end(1e-5);
  for (const auto& [name, value] : {std::pair("Hc", &Step::Hc), {"film", &Step::film}, {"mu", &Step::mu}}) {
    const auto error = [&, part = value](const Step& step) { return std::abs(step.*part / exact.*part - 1.0); };
    BOOST_TEST_MESSAGE(name << ": error " << error(loose) << " with rtol = 1e-3, " << error(tight)
                            << " with 1e-5 (at most 0.3 times that)");
    BOOST_TEST(error(tight) <= 0.3 * error(loose));
  }
}

BOOST_AUTO_TEST_SUITE_END()
