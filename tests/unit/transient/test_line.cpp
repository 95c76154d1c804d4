// Line contacts in time.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "unit/transient/marching.hpp"

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;
using Points = std::vector<Schedule::Point>;

namespace {

steady::LevelRow steady_film(steady::Scene scene) {
  scene.multigrid.tolerance = 1e-9;
  return steady::solve(scene).levels.back();
}

double off(const StepRow& row, const steady::LevelRow& truth) {
  return std::max(std::abs(row.Hc / truth.Hc - 1.0), std::abs(row.Hm / truth.Hm - 1.0));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_line_comes_to_the_steady_film_of_its_speed) {
  const steady::Scene scene = roelands_line(20, 5, core::line_grid(256, -4.5, 1.5));
  const Points faster{{0, 1}, {0.5, 1}, {1.0, 1.3}};
  const Marched all = marched(scene, {.u1 = {.points = faster}, .u2 = {.points = faster}}, {.end = 10.0});
  BOOST_TEST((all.report.end == MarchEnd::end_time), all.report.reason);
  steady::Scene then = scene;
  then.lambda *= 1.3;
  const double first = off(all.rows.front(), steady_film(scene)), last = off(all.rows.back(), steady_film(then));
  BOOST_TEST_MESSAGE(all.report.steps << " steps; off the steady films by " << first << " and " << last << " (1e-5)");
  // H00 is that of lengths in a, whatever the march computes with.
  BOOST_TEST(std::abs(all.rows.back().H00 - steady::solve(then).H00) < 1e-4);
  BOOST_TEST(first < 1e-5);
  BOOST_TEST(last < 1e-5);
}

// Squeeze alone between rigid bodies, H = H_0 + X^2/2: (H^3 P')' = lambda H_0' has P = -lambda H_0'/(2 H^2), the load
// pi/2 = -lambda H_0' pi sqrt(2)/(4 H_0^1.5), so that 1/sqrt(H_0) grows by T/(sqrt(2) lambda). What is
// left of their elasticity goes out with 1/H_0.
BOOST_AUTO_TEST_CASE(rigid_cylinders_that_only_squeeze) {
  constexpr double stopped = 5.0;
  const steady::Scene scene = roelands_line(0.05, 0, core::line_grid(256, -240, 240));
  const Points stop{{0, 1}, {1, 1}, {stopped, 0}};
  const Marched all = marched(scene, {.u1 = {.points = stop}, .u2 = {.points = stop}}, {.end = 30.0});
  BOOST_REQUIRE_MESSAGE(all.report.end == MarchEnd::end_time, all.report.reason);
  const StepRow& to = all.rows.back();
  const StepRow& from = *std::ranges::find_if(all.rows, [&](const StepRow& row) { return row.T >= stopped + 1.0; });
  const double grown = 1.0 / std::sqrt(to.Hc) - 1.0 / std::sqrt(from.Hc);
  const double error = grown / ((to.T - from.T) / (std::numbers::sqrt2 * scene.lambda)) - 1.0;
  BOOST_TEST_MESSAGE("H_0 from " << from.Hc << " to " << to.Hc << ": off by " << error << " (0.004)");
  BOOST_TEST(to.Hc < 0.8 * from.Hc);
  BOOST_TEST(std::abs(error) < 0.004);
}

// A ridge that rides through the contact leaves it as it was; where mass is conserved, oil neither comes nor goes.
BOOST_AUTO_TEST_CASE(a_ridge_rides_through_a_line) {
  const steady::Scene scene = roelands_line(20, 5, core::line_grid(256, -4.5, 1.5));
  const surface::Feature ridge{
      .shape = surface::Feature::Shape::ridge, .height = 0.01, .width = 0.4, .X = -5.5, .front = true};
  for (const bool content : {false, true}) {
    const Marched all = marched(scene, {.on_1 = ridge, .conserves_mass = content}, {.end = 13.0});
    BOOST_TEST((all.report.end == MarchEnd::end_time), all.report.reason);
    const double moved = largest_difference(all.rows, all.rows.front().Hc, [](const StepRow& row) { return row.Hc; });
    const double left = off(all.rows.back(), steady_film(scene));
    BOOST_TEST_MESSAGE(all.report.steps << " steps, Hc moves by " << moved << ", in the end off by " << left
                                        << ", oil from nowhere " << all.report.worst_oil_error);
    BOOST_TEST(moved > 0.02);
    BOOST_TEST(left < 2e-4);
    BOOST_TEST(all.report.worst_oil_error < 1e-10);
  }
}
