// A contact in time: what must not change, what must return, and what must agree.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "core/norms.hpp"
#include "unit/transient/marching.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_march)

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;
using ehl::surface::Feature;
using Points = std::vector<Schedule::Point>;

namespace {

double Hc_of(const StepRow& row) { return row.Hc; }
double Hm_of(const StepRow& row) { return row.Hm; }

/// The load of the frame relative to that of the scene, by the trapezoidal rule; the pressure is zero on the boundary.
double carried(const steady::Scene& scene, const Frame& frame) {
  return core::interior_sum(frame.P) * scene.grid.hx() * scene.grid.hy() / (2.0 * std::numbers::pi / 3.0);
}

const Feature dimple{.shape = Feature::Shape::dimple, .height = 0.05, .width = 0.5, .X = -1.5};

/// Checks for every run that reaches its end.
void check_complete(const char* what, const Marched& all, double end) {
  double load_error = 0.0;
  int steps = 0, cycles = 0;
  bool rises = true;
  for (std::size_t k = 1; k < all.rows.size(); ++k) {
    rises = rises && all.rows[k].T > all.rows[k - 1].T;
    steps += 1;
    cycles += all.rows[k].cycles;
  }
  for (const StepRow& row : all.rows) load_error = std::max(load_error, row.load_error);
  BOOST_TEST_MESSAGE(what << ": " << steps << " steps, " << cycles << " cycles, load off by " << load_error
                          << " (allowed 1e-6) " << all.report.reason);
  BOOST_TEST((all.report.end == MarchEnd::end_time));
  BOOST_TEST(all.report.T == end);
  BOOST_REQUIRE(!all.rows.empty());
  BOOST_TEST(all.rows.front().T == 0.0);
  BOOST_TEST(all.rows.back().T == end);
  BOOST_TEST(rises);
  BOOST_TEST(load_error <= 1e-6);
  BOOST_TEST(all.report.worst_load_error == load_error);
  BOOST_TEST((all.report.steps == steps && all.report.cycles == cycles));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_steady_contact_stays_where_it_is) {
  const steady::Scene scene = marching_scene(64);
  const Marched all = marched(scene, {}, {.end = 20.0});
  check_complete("constant", all, 20.0);
  // Cycles without any effect would keep the first row, so the reference is the steady solver.
  steady::Scene exact = scene;
  exact.solver.tolerance = 1e-10;
  const steady::Solution steady = steady::solve(exact);
  const double Hc = largest_difference(all.rows, steady.levels.back().Hc, Hc_of);
  const double Hm = largest_difference(all.rows, steady.levels.back().Hm, Hm_of);
  BOOST_TEST_MESSAGE("Hc moves by " << Hc << ", Hm by " << Hm << " (allowed 1e-8)");
  BOOST_TEST(Hc <= 1e-8);
  BOOST_TEST(Hm <= 1e-8);
}

BOOST_AUTO_TEST_CASE(from_a_wrong_start_it_comes_to_the_steady_film) {
  steady::Scene scene = marching_scene(64);
  const Marched load = marched(scene, {.load = {.points = Points{{0, 1.3}, {0, 1}}}}, {.end = 8.0});
  check_complete("load 1.3 to 1 at once", load, 8.0);
  const Points slower{{0, 0.7}, {0, 1}};
  const Marched speed = marched(scene, {.u1 = {.points = slower}, .u2 = {.points = slower}}, {.end = 8.0});
  check_complete("speed 0.7 to 1 at once", speed, 8.0);
  scene.solver.tolerance = 1e-9;
  const steady::LevelRow truth = steady::solve(scene).levels.back();
  for (const Marched* all : {&load, &speed}) {
    const StepRow& last = all->rows.back();
    const double Hc = std::abs(last.Hc / truth.Hc - 1.0);
    const double Hm = std::abs(last.Hm / truth.Hm - 1.0);
    BOOST_TEST_MESSAGE("from " << all->rows.front().Hc << " to Hc " << Hc << " and Hm " << Hm
                               << " off the steady ones (allowed 1e-5)");
    BOOST_TEST(Hc <= 1e-5);
    BOOST_TEST(Hm <= 1e-5);
    BOOST_TEST(std::abs(all->rows.front().Hc / truth.Hc - 1.0) > 0.02);
    BOOST_TEST(all->report.restarts == 1);
  }
}

BOOST_AUTO_TEST_CASE(whatever_varies_is_followed_to_the_end) {
  const steady::Scene scene = marching_scene(64);
  const auto both = [](const Points& points) { return Conditions{.u1 = {.points = points}, .u2 = {.points = points}}; };
  const Marched load = marched(scene, {.load = {.points = Points{{0.1, 1}, {0.1, 1.3}, {0.5, 1.2}}}},
                               {.end = 0.3, .longest_step = 0.02});
  check_complete("load jump, and a ramp behind it", load, 0.3);
  BOOST_TEST((std::abs(load.rows.back().load - 1.25) < 1e-14 && load.report.restarts == 1));
  const double share = carried(scene, load.frames.back());
  BOOST_TEST_MESSAGE("the pressure carries " << share << " (1.25, allowed 1e-6)");
  BOOST_TEST(std::abs(share - 1.25) <= 1e-6);
  const Marched speed = marched(scene, both({{0.5, 1}, {0.5, 0.5}}), {.end = 0.8, .longest_step = 0.02});
  check_complete("speed jump", speed, 0.8);
  BOOST_TEST((speed.rows.back().speed == 0.5 && speed.report.restarts == 1));
  BOOST_TEST(speed.rows.back().Hm < 0.98 * speed.rows.front().Hm);
  const Marched stop =
      marched(scene, both({{0.1, 1}, {0.4, 0}, {0.7, 0}, {1.0, 1}}), {.end = 1.1, .longest_step = 0.03});
  check_complete("start and stop", stop, 1.1);
  BOOST_TEST(stop.report.restarts == 0);
  for (const double corner : {0.1, 0.4, 0.7, 1.0}) BOOST_TEST(std::ranges::count(stop.rows, corner, &StepRow::T) == 1);
  const Marched sine =
      marched(scene, {.load = {.wave = Schedule::Wave{0.3, 1.0, 0.25}}}, {.end = 0.7, .longest_step = 0.02});
  check_complete("load sine", sine, 0.7);
  const Marched dent = marched(scene, {.on_1 = dimple}, {.end = 2.0, .longest_step = 0.05});
  check_complete("dimple on surface 1", dent, 2.0);
  BOOST_TEST(largest_difference(dent.rows, dent.rows.front().Hc, Hc_of) > 0.05);
  // Two jumps that are closer than the first steps after a jump, the second equally close to the end.
  const Points close{{0.05, 1}, {0.05, 1.05}, {0.0505, 1.05}, {0.0505, 1}};
  const Marched quick = marched(scene, {.load = {.points = close}}, {.end = 0.051, .longest_step = 0.01});
  check_complete("two jumps", quick, 0.051);
  BOOST_TEST(quick.report.restarts == 2);
}

// Isoviscous oil fills the gap downstream of the contact without pressure. When the bodies approach, all of it carries
// load at once. The cycles of a short step, in which c K is as large as epsilon/h^2, must find the nodes with pressure.
BOOST_AUTO_TEST_CASE(a_load_that_doubles_in_a_twentieth_comes_to_its_own_steady_film) {
  const auto isoviscous = [](double M, double scale) {
    steady::Scene scene = roelands_scene(M, 1.0, {64, 64, -3.5 / scale, 2.0 / scale, -2.75 / scale, 2.75 / scale});
    scene.contact = steady::scales_of(scene.contact.M, 0.0);
    scene.viscosity = rheology::Isoviscous{};
    scene.density = rheology::Incompressible{};
    return scene;
  };
  const Points doubled{{0.1, 1}, {0.15, 2}};
  const Marched all = marched(isoviscous(30.0, 1.0), {.load = {.points = doubled}}, {.end = 6.0});
  check_complete("isoviscous, load 1 to 2", all, 6.0);
  // The contact of the final state in the units of twice the load: M doubles, lengths scale with a, films with a^2/R.
  const double a = std::cbrt(2.0);
  steady::Scene twice = isoviscous(60.0, a);
  twice.solver.tolerance = 1e-9;
  const steady::LevelRow truth = steady::solve(twice).levels.back();
  const double Hc = std::abs(all.rows.back().Hc / (truth.Hc * a * a) - 1.0);
  const double Hm = std::abs(all.rows.back().Hm / (truth.Hm * a * a) - 1.0);
  BOOST_TEST_MESSAGE("Hc off by " << Hc << ", Hm by " << Hm << " (allowed 3e-4); " << all.report.not_solved
                                  << " attempts not solved (allowed 5)");
  BOOST_TEST(Hc <= 3e-4);
  BOOST_TEST(Hm <= 3e-4);
  BOOST_TEST(all.report.not_solved <= 5);
}

BOOST_AUTO_TEST_CASE(a_jump_is_a_very_steep_ramp) {
  const steady::Scene scene = marching_scene(64);
  const MarchParameters parameters{.end = 0.03, .longest_step = 0.002};
  const StepRow jump = marched(scene, {.load = {.points = Points{{0.02, 1}, {0.02, 1.2}}}}, parameters).rows.back();
  const StepRow ramp = marched(scene, {.load = {.points = Points{{0.02, 1}, {0.021, 1.2}}}}, parameters).rows.back();
  const double Hc = std::abs(jump.Hc / ramp.Hc - 1.0), Hm = std::abs(jump.Hm / ramp.Hm - 1.0);
  const double H00 = std::abs(jump.H00 - ramp.H00);
  BOOST_TEST_MESSAGE("Hc " << Hc << ", Hm " << Hm << ", H00 " << H00 << " apart (allowed 5e-4: half of the ramp)");
  BOOST_TEST(Hc <= 5e-4);
  BOOST_TEST(Hm <= 5e-4);
  BOOST_TEST(H00 <= 5e-4);
}

BOOST_AUTO_TEST_CASE(a_mirrored_dimple_gives_the_mirrored_contact) {
  const steady::Scene scene = marching_scene(64);
  Feature aside = dimple;
  aside.Y = 0.4;
  const Marched upper = marched(scene, {.on_1 = aside}, {.end = 1.2, .longest_step = 0.03});
  aside.Y = -0.4;
  const Marched lower = marched(scene, {.on_1 = aside}, {.end = 1.2, .longest_step = 0.03});
  const core::Field& one = upper.frames.back().H;
  const core::Field& two = lower.frames.back().H;
  double apart = 0.0, asymmetry = 0.0;
  for (int i = 0; i <= scene.grid.nx; ++i)
    for (int j = 0; j <= scene.grid.ny; ++j) {
      apart = std::max(apart, std::abs(one(i, j) - two(i, scene.grid.ny - j)));
      asymmetry = std::max(asymmetry, std::abs(one(i, j) - one(i, scene.grid.ny - j)));
    }
  BOOST_TEST_MESSAGE("films apart " << apart << " (allowed 1e-10: rounding, grown by the steps); each differs from its "
                                    << "own image by " << asymmetry << " (more than 0.01)");
  BOOST_TEST(apart <= 1e-10);
  BOOST_TEST(asymmetry > 0.01);
}

BOOST_AUTO_TEST_CASE(half_of_the_domain_is_the_whole) {
  steady::Scene scene = marching_scene(64);
  // No node cavitates or refills: if rounding decided the time of this, the steps would differ by
  // less than their tolerance.
  const Conditions conditions{.on_1 = dimple};
  const Marched half = marched(scene, conditions, {.end = 0.8, .longest_step = 0.02});
  scene.use_symmetry = false;
  const Marched whole = marched(scene, conditions, {.end = 0.8, .longest_step = 0.02});
  BOOST_REQUIRE(half.rows.size() == whole.rows.size());
  double apart = 0.0;
  for (std::size_t k = 0; k < half.rows.size(); ++k)
    apart = std::max(apart, std::abs(half.rows[k].Hc / whole.rows[k].Hc - 1.0));
  const double fields = core::max_abs_difference(half.frames.back().H, whole.frames.back().H);
  BOOST_TEST_MESSAGE("Hc apart by " << apart << ", last film by " << fields << " (allowed 1e-8)");
  BOOST_TEST(apart <= 1e-8);
  BOOST_TEST(fields <= 1e-8);
}

BOOST_AUTO_TEST_SUITE_END()
