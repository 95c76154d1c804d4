// Contacts in time with mass conservation: the oil balance, and known final states.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/norms.hpp"
#include "unit/transient/marching.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_oil)

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;
using Points = std::vector<Schedule::Point>;

namespace {

steady::Scene starved_scene(double H_oil) {
  steady::Scene scene = marching_scene(64);
  scene.far_field = false;
  scene.supply = [H_oil](double) { return H_oil; };
  return scene;
}

/// Checks that must hold at every step.
void check_oil(const char* what, const Marched& all, double end) {
  double nowhere = 0.0, lost = 0.0, load = 0.0;
  for (const StepRow& row : all.rows) {
    nowhere = std::max(nowhere, row.oil.from_nowhere);
    lost = std::max(lost, std::abs(row.oil.lost));
    load = std::max(load, row.load_error);
  }
  BOOST_TEST_MESSAGE(what << ": " << all.report.steps << " steps, " << all.report.cycles << " cycles, "
                          << all.report.rejected << " rejected, " << all.report.not_solved
                          << " not solved; oil from nowhere " << nowhere << " (allowed 1e-10), since the start " << lost
                          << " (1e-9), load off by " << load << " (1e-6) " << all.report.reason);
  BOOST_TEST((all.report.end == MarchEnd::end_time));
  BOOST_TEST(all.report.T == end);
  BOOST_TEST(nowhere <= 1e-10);
  BOOST_TEST(lost <= 1e-9);
  BOOST_TEST(load <= 1e-6);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_steady_supply_stays_steady) {
  steady::Scene scene = starved_scene(0.25);
  const Marched all = marched(scene, {}, {.end = 10.0});
  check_oil("constant", all, 10.0);
  scene.solver.tolerance = 1e-10;
  const auto Hc_of = [](const StepRow& row) { return row.Hc; };
  const double moves = largest_difference(all.rows, all.rows.front().Hc, Hc_of);
  const double off = largest_difference(all.rows, steady::solve(scene).levels.back().Hc, Hc_of);
  BOOST_TEST_MESSAGE("Hc moves by " << moves << " (allowed 1e-7), off the steady solver's by " << off
                                    << " (2e-5: a node of the meniscus may be wet or dry)");
  BOOST_TEST(moves <= 1e-7);
  BOOST_TEST(off <= 2e-5);
}

// A supply that falls to 0.6 within a time of 2 ends in the steady film of that supply. The half domain
// and the whole domain agree.
BOOST_AUTO_TEST_CASE(a_supply_that_falls_ends_in_its_steady_film) {
  steady::Scene scene = starved_scene(0.25);
  const Conditions falls{.supply = {.factor = {.points = Points{{0, 1}, {2, 0.6}}}}};
  const Marched half = marched(scene, falls, {.end = 9.0});
  check_oil("supply to 0.6", half, 9.0);
  scene.use_symmetry = false;
  const Marched whole = marched(scene, falls, {.end = 9.0});
  const double P = core::max_abs_difference(half.frames.back().P, whole.frames.back().P);
  const double theta = core::max_abs_difference(half.frames.back().theta, whole.frames.back().theta);
  steady::Scene end = starved_scene(0.6 * 0.25);
  end.solver.tolerance = 1e-9;
  const double Hc = half.rows.back().Hc / steady::solve(end).levels.back().Hc - 1.0;
  BOOST_TEST_MESSAGE("Hc at the end off by " << Hc << " (allowed 2e-4), half and whole: P differs by " << P
                                             << ", theta by " << theta << " (allowed 5e-5: half of rtol)");
  BOOST_TEST(std::abs(Hc) <= 2e-4);
  BOOST_TEST(P <= 5e-5);
  BOOST_TEST(theta <= 5e-5);
}

// A jump of the load presses on the film downstream of the contact; a gap that is not full does not resist.
BOOST_AUTO_TEST_CASE(oil_is_conserved_while_load_and_speed_change) {
  steady::Scene flooded = marching_scene(64);
  flooded.far_field = false;
  Conditions jump{.load = {.points = Points{{0.5, 1}, {0.5, 1.5}}}};
  jump.conserves_mass = true;
  check_oil("load to 1.5 at once, inlet full", marched(flooded, jump, {.end = 3.0}), 3.0);
  const Points stop{{0.5, 1}, {1, 0}, {1.5, 0}, {2, 1}};
  check_oil("stop and start",
            marched(starved_scene(0.25), {.u1 = {.points = stop}, .u2 = {.points = stop}}, {.end = 4.0}), 4.0);
}

// A ball falls on a plate with a layer of oil thinner than the gap. There is no pressure before the ball meets the
// layer, and no flow. Since the layer is thin, the impact is that of a dry ball.
BOOST_AUTO_TEST_CASE(a_ball_falls_on_a_thin_layer) {
  constexpr double layer = 0.05, gap = 1.0, speed = 2.0;
  const Points none{{0, 0}};
  Conditions falls{.load = {.points = none}, .u1 = {.points = none}, .u2 = {.points = none}};
  falls.body = Body{.mass = 1.0 / (speed * speed), .gap = gap, .velocity = -speed};
  const Marched all = marched(starved_scene(layer), falls, {.end = 1.6});
  BOOST_TEST((all.report.end == MarchEnd::end_time));
  const double oil = all.rows.front().oil.stored;
  double met = 0.0, nowhere = 0.0, changed = 0.0, carried = 0.0;
  for (const StepRow& row : all.rows) {
    if (met == 0.0 && row.P_max > 0.0) met = row.T;
    nowhere = std::max(nowhere, row.oil.from_nowhere);
    changed = std::max(changed, std::abs(row.oil.stored / oil - 1.0));
    carried = std::max(carried, row.carried);
  }
  // For a dry ball, mass V^2/2 = (2/5) W (-H00)^(5/2), and the load is (-H00)^(3/2).
  const double dry = std::pow(5.0 / 4.0, 0.6);
  BOOST_TEST_MESSAGE("first pressure at T = " << met << " (" << (gap - layer) / speed << ", a step later), oil " << oil
                                              << " changes by " << changed << ", from nowhere " << nowhere
                                              << " (allowed 1e-10), largest load over that of the dry ball "
                                              << carried / dry << " (0.94 to 1), steps " << all.report.steps);
  BOOST_TEST((met >= (gap - layer) / speed && met <= (gap - layer) / speed + 0.02));
  BOOST_TEST(nowhere <= 1e-10);
  BOOST_TEST(changed <= 1e-10);
  BOOST_TEST((carried / dry <= 1.0 && carried / dry >= 0.94));
}

// If a line contact is supplied with more oil than passes through it, its steady film is the flooded one. In time, the
// layer stays in front of a full inlet, and moves in when the load falls.
BOOST_AUTO_TEST_CASE(more_than_goes_through_a_line) {
  steady::Scene scene = roelands_line(6, 0, core::line_grid(256, -4.5, 1.5));
  scene.far_field = false;
  scene.supply = [](double) { return 0.5; };
  const Points falls{{0, 1}, {0.03, 1}, {0.06, 0.85}};
  const Marched all = marched(scene, {.load = {.points = falls}, .conserves_mass = true}, {.end = 0.3});
  check_oil("a line before which oil stands", all, 0.3);
  BOOST_TEST(all.rows.back().oil.in > 2.0 * all.rows.front().oil.in);
}

BOOST_AUTO_TEST_SUITE_END()
