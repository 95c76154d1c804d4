// The conditions of a contact in time: speeds, load and surfaces at a time, and the times at which steps must end.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "core/norms.hpp"
#include "transient/conditions.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_conditions)

using namespace ehl;
using namespace ehl::transient;
using ehl::surface::Feature;
using Points = std::vector<Schedule::Point>;
using Times = std::vector<double>;

namespace {

/// Surface 1 stops within a time of 2, surface 2 jumps from 1 to 3 at T = 1.
Conditions sliding() {
  Conditions conditions;
  conditions.load.points = {{0.5, 1}, {0.5, 1.3}, {4, 1.3}};
  conditions.u1.points = {{0, 2}, {2, 0}};
  conditions.u2.points = {{1, 1}, {1, 3}};
  conditions.on_1 = Feature{.shape = Feature::Shape::dimple, .height = 0.2, .width = 0.5, .X = -2.0};
  conditions.on_2 = Feature{.shape = Feature::Shape::ridge, .height = 0.1, .width = 0.3, .X = -3.0};
  return conditions;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_drive_is_load_and_mean_speed) {
  const Conditions conditions = sliding();
  BOOST_TEST(drive_at(conditions, 0.5).load == 1.0);
  BOOST_TEST(drive_at(conditions, 0.6).load == 1.3);
  BOOST_TEST(drive_at(conditions, 0.5).speed == 0.5 * (1.5 + 1.0));
  BOOST_TEST(drive_at(conditions, 1.5).speed == 0.5 * (0.5 + 3.0));
  BOOST_TEST((drive_at({}, 3.0).load == 1.0 && drive_at({}, 3.0).speed == 1.0));
  BOOST_TEST(!course_of({}).surface);
}

BOOST_AUTO_TEST_CASE(every_surface_moves_with_its_own_speed) {
  const Conditions conditions = sliding();
  const Course course = course_of(conditions);
  const core::Grid grid{32, 16, -2.5, 1.5, -1, 1};
  core::Field S(grid);
  S.fill(7.0);  // overwritten, not added to
  // Surface 1 has moved by 2T - T^2/2 until it stops, surface 2 by T, plus 3 (T - 1) after its jump.
  const struct { double T, one, two; } expected[] = {{0, 0, 0}, {1, 1.5, 1}, {1.5, 1.875, 2.5}, {3, 2, 7}};
  for (const auto& at : expected) {
    course.surface(grid, at.T, S);
    double worst = 0.0;
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) {
        const double X = grid.X(i), Y = grid.Y(j);
        const double one = 0.2 * std::exp(-(std::pow(X + 2.0 - at.one, 2) + Y * Y) / 0.25);
        const double two = -0.1 * std::exp(-std::pow((X + 3.0 - at.two) / 0.3, 2));
        worst = std::max(worst, std::abs(S(i, j) - one - two));
      }
    BOOST_TEST_MESSAGE("at T = " << at.T << " the surfaces are off by " << worst << " (allowed 1e-14: rounding)");
    BOOST_TEST(worst <= 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(steps_end_at_jumps_and_corners) {
  BOOST_TEST(stops_of({}, 3.0) == Times{3});
  BOOST_TEST(stops_of(sliding(), 3.0) == (Times{0.5, 1, 2, 3}));
  BOOST_TEST(stops_of(sliding(), 9.0) == (Times{0.5, 1, 2, 4, 9}));
  for (const double T : {0.5, 1.0}) BOOST_TEST(jumps_at(sliding(), T, 9.0));
  for (const double T : {0.0, 2.0, 4.0, 9.0}) BOOST_TEST(!jumps_at(sliding(), T, 9.0));
  // If two schedules jump at the same time, there is one stop.
  Conditions together = sliding();
  together.load.points = {{1, 1}, {1, 2}};
  BOOST_TEST(stops_of(together, 3.0) == (Times{1, 2, 3}));
  const Conditions at_start{.load = {.points = Points{{0, 1.3}, {0, 1}}}};
  BOOST_TEST(stops_of(at_start, 1.0) == (Times{0, 1}));
  BOOST_TEST(jumps_at(at_start, 0.0, 1.0));
}

BOOST_AUTO_TEST_CASE(the_longest_step_sees_all_that_varies) {
  BOOST_TEST(longest_step({}, 100.0) == 0.1);
  BOOST_TEST(longest_step({}, 2.0) == 0.02);
  const auto close = [](double step, double expected) { return std::abs(step / expected - 1.0) < 1e-12; };
  const Conditions ramp{.load = {.points = Points{{1, 1}, {1.2, 2}}}};
  BOOST_TEST(close(longest_step(ramp, 100.0), 0.05));
  const Conditions wave{.u2 = {.wave = Schedule::Wave{0.2, 1.0, 0.0}}};
  BOOST_TEST(close(longest_step(wave, 100.0), 0.05));
  // A quarter of the width at the highest speed of its surface; for a surface at rest there is no limit.
  Conditions fast{.u1 = {.points = Points{{0, 1}, {1, 1}, {1, 4}}}};
  fast.on_1 = Feature{.shape = Feature::Shape::dimple, .height = 0.1, .width = 0.4};
  BOOST_TEST(close(longest_step(fast, 100.0), 0.1 / 4.0));
  fast.u1.wave = Schedule::Wave{0.25, 10.0, 0.0};
  BOOST_TEST(close(longest_step(fast, 100.0), 0.1 / 5.0));
  Conditions standing{.u2 = {.points = Points{{0, 0}}}};
  standing.on_2 = Feature{.shape = Feature::Shape::cavity, .height = 0.1, .width = 0.01};
  BOOST_TEST(longest_step(standing, 100.0) == 0.1);
}

BOOST_AUTO_TEST_CASE(one_feature_aside_makes_the_contact_unsymmetric) {
  Conditions conditions = sliding();
  BOOST_TEST(symmetric(conditions));
  std::get<Feature>(*conditions.on_1).Y = 0.3;
  BOOST_TEST(!symmetric(conditions));
  conditions = sliding();
  std::get<Feature>(*conditions.on_2).angle = 0.5;
  BOOST_TEST(!symmetric(conditions));
  BOOST_TEST(symmetric(Conditions{}));
}

// A map moves with its own speed, by at most its point distance in one time step.
BOOST_AUTO_TEST_CASE(a_measured_map_is_carried_like_a_feature) {
  ehl::surface::HeightMap map{
      .gap = {9, 9, std::vector<double>(81, 0.0)}, .dx = 0.1, .dy = 0.1, .X = -1.0, .Y = 0.0, .step = 0.05};
  map.gap(4, 4) = 0.2;
  Conditions conditions;
  conditions.u1 = {.points = {{0.0, 1.0}, {1.0, 2.0}}};
  conditions.on_1 = map;
  BOOST_TEST(symmetric(conditions));
  BOOST_TEST(longest_step(conditions, 100.0) == 0.05 / 2.0);
  const Course course = course_of(conditions);
  // The centre has moved to -1 + (1 + 2)/2 = 0.5 at T = 1, a node of a fine mesh.
  const core::Grid grid{400, 8, -2.0, 2.0, -0.04, 0.04};
  core::Field S(grid);
  course.surface(grid, 1.0, S);
  const core::Location top = core::maximum(S);
  BOOST_TEST_MESSAGE("highest at X = " << grid.X(top.i) << ", " << top.value);
  BOOST_TEST(std::abs(grid.X(top.i) - 0.5) < 1e-12);
  BOOST_TEST(std::abs(top.value - 0.2) < 2e-3);
  map.gap(4, 1) = 0.1;
  conditions.on_1 = map;
  BOOST_TEST(!symmetric(conditions));
}

BOOST_AUTO_TEST_SUITE_END()
