// Line contacts in time.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "core/norms.hpp"
#include "multigrid/start.hpp"
#include "newton/steps.hpp"
#include "steady/multigrid_solve.hpp"
#include "transient/contact_dae.hpp"
#include "unit/transient/marching.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_line)

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;
using Points = std::vector<Schedule::Point>;

namespace {

steady::LevelRow steady_film(steady::Scene scene) {
  scene.solver.tolerance = 1e-9;
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
  // H00 refers to lengths in a, whatever unit the run uses internally.
  BOOST_TEST(std::abs(all.rows.back().H00 - steady::solve(then).H00) < 1e-4);
  BOOST_TEST(first < 1e-5);
  BOOST_TEST(last < 1e-5);
}

// Pure squeeze between rigid bodies, H = H_0 + X^2/2: (H^3 P')' = lambda H_0' has P = -lambda H_0'/(2 H^2) and the
// load pi/2 = -lambda H_0' pi sqrt(2)/(4 H_0^1.5), so 1/sqrt(H_0) grows by T/(sqrt(2) lambda). The influence of
// elasticity decreases with 1/H_0.
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

// After a ridge has passed through, the contact is unchanged; with mass conservation, no oil appears or disappears.
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

/// The steady film at another load in the units of the run. The half width is proportional to the square root of the
/// load, so that the nodes are the same.
steady::LevelRow film_of_load(double factor, double M, double L, const core::Grid& grid) {
  const double root = std::sqrt(factor);
  steady::Scene scene = roelands_line(factor * M, L, core::line_grid(grid.nx, grid.X_a / root, grid.X_b / root));
  scene.far_field = false;
  steady::LevelRow film = steady_film(scene);
  film.Hc *= factor;
  film.Hm *= factor;
  return film;
}

// A heavily loaded, weakly piezoviscous line contact has a thin film and a steep pressure edge, where chattering cycles
// would need many more steps.
BOOST_AUTO_TEST_CASE(a_heavy_line_whose_load_falls) {
  steady::Scene scene = roelands_line(200, 2, core::line_grid(1024, -2.5, 1.5));
  scene.far_field = false;
  const Marched all = marched(scene, {.load = {.points = {{0, 1}, {0.1, 1}, {0.6, 0.7}}}}, {.end = 4.0});
  BOOST_REQUIRE_MESSAGE(all.report.end == MarchEnd::end_time, all.report.reason);
  const double last = off(all.rows.back(), film_of_load(0.7, 200, 2, scene.grid));
  BOOST_TEST_MESSAGE(all.report.steps << " steps, " << all.report.cycles << " cycles (two a step), "
                                      << all.report.not_solved << " not solved; off by " << last
                                      << " (2e-4: twice rtol)");
  BOOST_TEST(last < 2e-4);
  BOOST_TEST(all.report.not_solved == 0);
  BOOST_TEST(all.report.cycles < 2 * all.report.steps);
}

// A jump of the load creates pressure far outside, whose edge then moves inwards; this needs the Newton fallback.
BOOST_AUTO_TEST_CASE(a_jump_of_the_load_on_a_heavy_line) {
  steady::Scene scene = roelands_line(100, 10, core::line_grid(256, -2.5, 1.5));
  scene.far_field = false;
  const Marched all = marched(scene, {.load = {.points = {{0, 1}, {0.1, 1}, {0.1, 2}}}}, {.end = 8.0});
  BOOST_REQUIRE_MESSAGE(all.report.end == MarchEnd::end_time, all.report.reason);
  const double last = off(all.rows.back(), film_of_load(2, 100, 10, scene.grid));
  BOOST_TEST_MESSAGE(all.report.steps << " steps, " << all.report.cycles << " cycles and " << all.report.newton_steps
                                      << " steps of Newton's method; off by " << last << " (1e-4)");
  BOOST_TEST(last < 1e-4);
  // Newton steps are counted separately.
  int newton_steps = 0;
  for (const StepRow& row : all.rows) newton_steps += row.newton_steps;
  BOOST_TEST(newton_steps > 0);
  BOOST_TEST(newton_steps == all.report.newton_steps);
}

// A steady film is also the solution of an implicit step from that film: f = -c Q. From another pressure and film,
// Newton's steps return to it.
BOOST_AUTO_TEST_CASE(newtons_steps_solve_an_implicit_step) {
  steady::Scene scene = roelands_line(20, 5, core::line_grid(256, -4.5, 1.5));
  scene.far_field = false;
  scene.solver.tolerance = 1e-10;
  const steady::Solution truth = steady::solve(scene);
  multigrid::Run run = steady::begin_multigrid(scene, steady::Start{.coarsest = 32}, {});
  multigrid::Hierarchy& hierarchy = run.hierarchy;
  multigrid::Level& level = hierarchy.finest();
  const core::Field P = core::on_patch(level.grid, truth.P);
  multigrid::start_from_state(hierarchy, run.finest(), {P, truth.H00});
  prepare(hierarchy);
  level.load = *hierarchy.problem.load;
  multigrid::update_film(hierarchy, level);
  constexpr double c = 1000.0;
  hierarchy.transport.squeeze = c;
  for (int i = 0; i <= level.grid.nx; ++i)
    for (int j = 0; j <= level.grid.ny; ++j) level.f(i, j) = -c * level.rho_bar(i, j) * level.H(i, j);
  for (int i = 1; i < level.grid.nx; ++i) level.P(i, 1) *= 1.02;
  core::fill_ghosts(level.grid, level.P);
  hierarchy.H00 += 0.005;
  multigrid::update_film(hierarchy, level);
  newton::Steps steps(hierarchy);
  double P_error = 1.0, H00_error = 1.0;
  int taken = 0;
  for (; taken < 12 && std::max(P_error, H00_error) > 1e-7; ++taken) {
    BOOST_REQUIRE(steps.take());
    P_error = 0.0;
    for (int i = 1; i < level.grid.nx; ++i) P_error = std::max(P_error, std::abs(level.P(i, 1) - P(i, 1)));
    H00_error = std::abs(hierarchy.H00 - truth.H00);
    BOOST_TEST_MESSAGE("P off by " << P_error << ", H00 by " << H00_error);
  }
  BOOST_TEST(taken < 12, "P off by " << P_error << ", H00 by " << H00_error << " (1e-7) after 12 steps");
}

BOOST_AUTO_TEST_SUITE_END()
