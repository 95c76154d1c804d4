// Cycles: radius, load and speed that vary together, and their quasi-steady states.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "transient/quasi_steady.hpp"
#include "unit/transient/cycling.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_cycle)

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;

namespace {

steady::LevelRow steady_film(steady::Scene scene) {
  scene.solver.tolerance = 1e-9;
  return steady::solve(scene).levels.back();
}

struct States {
  MarchReport report{};
  std::vector<StepRow> rows{};
};
States states_of(const steady::Scene& scene, const Conditions& conditions, const std::vector<double>& times) {
  States states;
  steady::Scene to_rounding = scene;
  to_rounding.solver.tolerance = 1e-9;
  const auto keep = [&](const StepRow& row) {
    states.rows.push_back(row);
    return true;
  };
  states.report = quasi_steady(to_rounding, conditions, {}, times, {.row = keep});
  return states;
}

}  // namespace

// A line contact of half the radius under the same load has M sqrt(2), L 2^(1/4) and a/sqrt(2): the same H = h R/a^2
// means the same film thickness, and the grid in its own Hertz radii is longer by sqrt(2), with the same nodes.
BOOST_AUTO_TEST_CASE(half_the_radius_is_the_contact_of_that_radius) {
  const double root = std::sqrt(2.0);
  const steady::Scene scene = roelands_line(10, 5, core::line_grid(256, -4.5, 1.5));
  const steady::LevelRow truth =
      steady_film(roelands_line(10 * root, 5 * std::sqrt(root), core::line_grid(256, -4.5 * root, 1.5 * root)));
  const Conditions conditions{.radius = {.points = {{0, 1}, {0.5, 1}, {1.5, 0.5}}}};
  const Marched all = marched(scene, conditions, {.end = 8.0});
  BOOST_REQUIRE_MESSAGE(all.report.end == MarchEnd::end_time, all.report.reason);
  const States states = states_of(scene, conditions, {0.0, 1.0, 2.0});
  const double in_time = all.rows.back().Hc / truth.Hc - 1.0, quasi = states.rows.back().Hc / truth.Hc - 1.0;
  const double before = all.rows.front().Hc / truth.Hc - 1.0;
  BOOST_TEST_MESSAGE("Hc off by " << in_time << " at the end, quasi-steady by " << quasi
                                  << " (allowed 1e-5); before the change by " << before);
  BOOST_TEST(std::abs(in_time) <= 1e-5);
  BOOST_TEST(std::abs(quasi) <= 1e-5);
  BOOST_TEST(std::abs(before) > 0.05);
}

// A heavy line contact starts as a pair of teeth does, with a third of the load and of the radius: M and L of that
// state, whose h is H a^2/R with a third of the scene's a^2/R.
BOOST_AUTO_TEST_CASE(a_start_with_another_radius_is_the_contact_of_that_radius) {
  const double third = 1.0 / 3.0, M = 50, L = 10;
  const steady::Scene scene = roelands_line(M, L, core::line_grid(512, -4.5, 1.5));
  const steady::LevelRow truth =
      steady_film(roelands_line(M * std::sqrt(third), L / std::pow(third, 0.25), core::line_grid(512, -13.5, 4.5)));
  const Conditions conditions{.load = {.points = {{0, third}}}, .radius = {.points = {{0, third}}}};
  const Marched all = marched(scene, conditions, {.end = 1e-3});
  BOOST_REQUIRE_MESSAGE(all.report.end == MarchEnd::end_time, all.report.reason);
  const double start = all.rows.front().Hc / (third * truth.Hc) - 1.0;
  BOOST_TEST_MESSAGE("Hc at time 0 is off by " << start << " (allowed 1e-4)");
  BOOST_TEST(std::abs(start) <= 1e-4);
}

// The user stops while the second state is being solved: the rows end there, and that state is not known.
BOOST_AUTO_TEST_CASE(a_state_under_way_can_be_stopped) {
  const steady::Scene scene = roelands_line(10, 5, core::line_grid(64, -4.5, 1.5));
  std::vector<StepRow> rows;
  const auto keep = [&](const StepRow& row) {
    rows.push_back(row);
    return true;
  };
  const MarchReport report = quasi_steady(scene, {}, {}, {0.0, 1.0, 2.0}, {.row = keep}, [&] { return rows.empty(); });
  BOOST_TEST((report.end == MarchEnd::interrupted));
  BOOST_TEST(report.not_found == 0);
  BOOST_TEST_REQUIRE(rows.size() == 2U);
  BOOST_TEST((rows[0].Hc > 0.0 && std::isnan(rows[1].Hc)));
}

// The states of radius, load and speed by themselves, and a cycle so slow that it passes through them.
BOOST_AUTO_TEST_CASE(a_slow_cycle_is_the_quasi_steady_one) {
  const steady::Scene scene = roelands_line(20, 5, core::line_grid(256, -4.5, 1.5));
  const auto deviation = [&](double period) {
    const Schedule speed = cosine(1.0, 0.3, period, 1.0);
    const Conditions conditions{
        .load = cosine(1.1, 0.1, period, 1.0), .u1 = speed, .u2 = speed, .radius = cosine(0.9, 0.1, period, 1.0)};
    const Marched all = marched(scene, conditions, {.end = period, .longest_step = period / 200.0});
    BOOST_REQUIRE_MESSAGE(all.report.end == MarchEnd::end_time, all.report.reason);
    std::vector<double> times;
    for (const StepRow& row : all.rows) times.push_back(row.T);
    const States states = states_of(scene, conditions, times);
    double worst = 0.0;
    for (std::size_t k = 0; k < times.size(); ++k)
      worst = std::max(worst, std::abs(all.rows[k].Hc / states.rows[k].Hc - 1.0));
    return worst;
  };
  const double slow = deviation(4000.0), fast = deviation(400.0);
  BOOST_TEST_MESSAGE("Hc differs from the quasi-steady film by " << slow << " (allowed 1e-3), ten times faster by "
                                                                 << fast << ", " << fast / slow
                                                                 << " times as much (6 to 14)");
  BOOST_TEST(slow <= 1e-3);
  BOOST_TEST((fast / slow > 6.0 && fast / slow < 14.0));
}

// A state is the same whichever way the oil flows; without speed there is no film, and a light contact is rigid.
BOOST_AUTO_TEST_CASE(states_of_reversal_rest_and_light_load) {
  const steady::Scene scene = roelands_line(20, 5, core::line_grid(128, -4.5, 4.5));
  const Schedule speed{.points = {{0, 1}, {1, 0}, {2, -1}, {3, -0.7}}};
  const Conditions turns{.u1 = speed, .u2 = speed};
  const States turning = states_of(scene, turns, {0, 1, 2, 3});
  BOOST_TEST(turning.report.at_rest == 1);
  BOOST_TEST(std::isnan(turning.rows[1].Hc));
  const double there = turning.rows[2].Hc / turning.rows[0].Hc - 1.0;
  const double place = turning.rows[2].Hm_X + turning.rows[0].Hm_X;
  steady::Scene slower = scene;
  slower.lambda *= 0.7;
  const double off = turning.rows[3].Hc / steady_film(slower).Hc - 1.0;
  BOOST_TEST_MESSAGE("Hc with U = -1 differs by " << there << " from that with U = 1, X of Hm by " << place
                                                  << " from the mirror image (both 1e-7), Hc with U = -0.7 by " << off
                                                  << " from that of its own scene (1e-6)");
  BOOST_TEST(std::abs(there) <= 1e-7);
  BOOST_TEST(std::abs(place) <= 1e-7);
  BOOST_TEST(std::abs(off) <= 1e-6);

  // M = 0.05 by a load of 1/400: the rigid film of M = 0.05, whose h is H a^2/R with the a of M = 20.
  const Conditions lifts{.load = {.points = {{0, 1}, {1, 0.0025}}}};
  const States light = states_of(scene, lifts, {0, 1});
  const double h = light.rows[1].Hc * 20.0, of_its_own = 2.45 / 0.05 * std::numbers::pi / (8.0 * 0.05) * 0.05;
  BOOST_TEST_MESSAGE("rigid film " << h << ", by its own scales " << of_its_own << " (1e-12)");
  BOOST_TEST(std::abs(h / of_its_own - 1.0) <= 1e-12);
}

// Nothing varies: the table changes nothing. Then one speed varies: one period is like the one before.
BOOST_AUTO_TEST_CASE(steady_stays_steady_and_a_cycle_becomes_periodic) {
  const steady::Scene scene = marching_scene(64);
  const Schedule one = cosine(1.0, 0.0, 5.0, 2.0);
  const Conditions constant{.load = one, .u1 = one, .u2 = one, .radius = one};
  const Marched still = marched(scene, constant, {.end = 10.0, .period = 5.0});
  const double moves = largest_difference(still.rows, still.rows.front().Hc, [](const StepRow& row) { return row.Hc; });
  BOOST_TEST_MESSAGE("a constant table moves Hc by " << moves << " (allowed 1e-7)");
  BOOST_TEST(moves <= 1e-7);

  const Schedule speed = cosine(1.0, 0.5, 5.0, 8.0);
  const Conditions varies{.u1 = speed, .u2 = speed};
  const Marched all = marched(scene, varies, {.end = 40.0, .period = 5.0, .stop_periodic = 1e-3});
  BOOST_TEST_MESSAGE(all.report.periods << " periods; Hc and Hm of the last two differ by "
                                        << all.report.change_of_period << " (allowed 1e-3, fewer than 8 periods)");
  BOOST_TEST((all.report.end == MarchEnd::periodic));
  BOOST_TEST(all.report.change_of_period <= 1e-3);
  BOOST_TEST((all.report.periods >= 2 && all.report.periods < 8));
  BOOST_TEST(std::abs(all.report.T - 5.0 * all.report.periods) < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
