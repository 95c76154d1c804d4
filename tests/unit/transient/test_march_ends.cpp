// A contact in time: accuracy, output, and the ways in which a run ends.
#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <string>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "unit/transient/marching.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_march_ends)

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;
using ehl::surface::Feature;
using Points = std::vector<Schedule::Point>;

namespace {

/// The load rises by a fifth within a time of 0.4, while a dimple on surface 2 enters.
const Conditions busy{.load = {.points = Points{{0.1, 1}, {0.5, 1.2}}},
                      .on_2 = Feature{.shape = Feature::Shape::dimple, .height = 0.05, .width = 0.5, .X = -1.5}};

/// The film at X = Y = 0, a node, in every frame.
std::vector<double> central_films(const steady::Scene& scene, const Marched& all) {
  std::vector<double> Hc;
  const int i = 5 * scene.grid.nx / 8;
  BOOST_REQUIRE(scene.grid.X(i) == 0.0);
  for (const Frame& frame : all.frames) Hc.push_back(frame.H(i, scene.grid.ny / 2));
  return Hc;
}

/// Each frame belongs to its time: its central film lies between those of the neighbouring rows.
void check_frames_against_rows(const steady::Scene& scene, const Marched& all) {
  const std::vector<double> Hc = central_films(scene, all);
  double worst = 0.0;
  for (std::size_t k = 0; k < Hc.size(); ++k) {
    const double T = all.frames[k].T;
    const auto after = std::ranges::lower_bound(all.rows, T * (1.0 - 1e-14), {}, &StepRow::T);
    const StepRow& b = *after;
    const StepRow& a = after == all.rows.begin() ? b : after[-1];
    const double share = b.T > a.T ? (T - a.T) / (b.T - a.T) : 1.0;
    worst = std::max(worst, std::abs(Hc[k] / (a.Hc + share * (b.Hc - a.Hc)) - 1.0));
  }
  BOOST_TEST_MESSAGE(Hc.size() << " frames off the rows by " << worst << " (allowed 1e-5: interpolation by a line)");
  BOOST_TEST(worst <= 1e-5);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_history_of_the_film_follows_the_tolerance) {
  const steady::Scene scene = marching_scene(64);
  const Conditions conditions{.on_2 = busy.on_2};
  const auto history = [&](double rtol) {
    const MarchParameters parameters{.end = 1.2, .rtol = rtol, .longest_step = 0.1, .output_interval = 0.1};
    return marched(scene, conditions, parameters);
  };
  const std::vector<double> truth = central_films(scene, history(1e-7));
  std::vector<double> errors;
  for (const double rtol : {1e-3, 1e-4, 1e-5}) {
    const Marched all = history(rtol);
    const std::vector<double> Hc = central_films(scene, all);
    BOOST_REQUIRE(Hc.size() == truth.size());
    double error = 0.0;
    for (std::size_t k = 0; k < truth.size(); ++k) error = std::max(error, std::abs(Hc[k] / truth[k] - 1.0));
    BOOST_TEST_MESSAGE("rtol " << rtol << ": Hc off by " << error << " in " << all.report.steps << " steps, "
                               << all.report.cycles << " cycles");
    errors.push_back(error);
  }
  BOOST_TEST_MESSAGE("from 1e-3 to 1e-5 the error falls by " << errors[0] / errors[2] << " (at least 10); at 1e-4 "
                                                             << "allowed 3e-3");
  BOOST_TEST(errors[0] / errors[2] >= 10.0);
  BOOST_TEST(errors[0] > errors[1]);
  BOOST_TEST(errors[1] > errors[2]);
  BOOST_TEST(errors[1] <= 3e-3);
}

BOOST_AUTO_TEST_CASE(frames_come_at_the_times_asked_for) {
  const steady::Scene scene = marching_scene(64);
  const Marched all = marched(scene, busy, {.end = 0.5, .longest_step = 0.01, .output_interval = 0.166});
  std::vector<double> times;
  for (const Frame& frame : all.frames) times.push_back(frame.T);
  // The last two are within one step.
  const std::vector<double> asked{0.0, 0.166, 0.332, 0.498, 0.5};
  BOOST_REQUIRE(times.size() == asked.size());
  for (std::size_t k = 0; k < asked.size(); ++k) BOOST_TEST(std::abs(times[k] - asked[k]) <= 1e-14);
  BOOST_TEST(times.back() == 0.5);
  check_frames_against_rows(scene, all);
  BOOST_TEST((all.frames[1].P.nodes_y() == scene.grid.nodes_y()));
  // The first and the last frame only; if the end is a multiple of the interval, no frame occurs twice.
  BOOST_TEST(marched(scene, {}, {.end = 0.1}).frames.size() == 2U);
  BOOST_TEST(marched(scene, {}, {.end = 0.3, .output_interval = 0.1}).frames.size() == 4U);
  // Also around a jump, within the steps that cross it.
  const Conditions jump{.load = {.points = Points{{0.005, 1}, {0.005, 1.03}}}};
  const Marched around = marched(scene, jump, {.end = 0.01, .output_interval = 0.0005});
  BOOST_TEST(around.frames.size() == 21U);
  check_frames_against_rows(scene, around);
}

BOOST_AUTO_TEST_CASE(it_ends_where_the_film_is_as_thin_as_asked) {
  const steady::Scene scene = marching_scene(64);
  const Points stopping{{0, 1}, {1, 0}};
  const Conditions conditions{.u1 = {.points = stopping}, .u2 = {.points = stopping}};
  const Marched all = marched(scene, conditions, {.end = 3.0, .stop_film = 0.1});
  const double error = std::abs(all.rows.back().Hm / 0.1 - 1.0);
  BOOST_TEST_MESSAGE("ended at T = " << all.report.T << " with Hm off by " << error << " (allowed 1e-4), load by "
                                     << all.rows.back().load_error << " (allowed 1e-6)");
  BOOST_TEST((all.report.end == MarchEnd::film));
  BOOST_TEST(all.report.T < 3.0);
  BOOST_TEST(error <= 1e-4);
  BOOST_TEST(all.rows.back().load_error <= 1e-6);
  BOOST_TEST(all.frames.back().T == all.report.T);
  BOOST_TEST(std::abs(core::minimum(all.frames.back().H).value / 0.1 - 1.0) <= 1e-4);
  // At earlier times the film was thicker.
  for (std::size_t k = 0; k + 1 < all.rows.size(); ++k) BOOST_TEST(all.rows[k].Hm > 0.1);
  // A film that is thin from the start stops the run at once.
  const Marched at_once = marched(scene, conditions, {.end = 3.0, .stop_film = 1.01 * all.rows.front().Hm});
  BOOST_TEST((at_once.report.end == MarchEnd::film));
  BOOST_TEST(at_once.report.T == 0.0);
  BOOST_TEST(at_once.report.steps == 0);
  BOOST_TEST(at_once.frames.size() == 1U);
}

BOOST_AUTO_TEST_CASE(it_ends_where_nothing_changes_any_more) {
  const Conditions jump{.load = {.points = Points{{0, 1.1}, {0, 1}}}};
  const Marched all = marched(marching_scene(64), jump, {.end = 50.0, .stop_steady = 1e-4});
  BOOST_TEST((all.report.end == MarchEnd::steady));
  const auto then = std::ranges::lower_bound(all.rows, all.report.T - 1.0, {}, &StepRow::T);
  const double change = std::abs(all.rows.back().Hc / then->Hc - 1.0);
  BOOST_TEST_MESSAGE("ended at T = " << all.report.T << ", Hc changed by " << change << " in the last time of 1");
  BOOST_TEST(all.report.T > 2.0);
  BOOST_TEST(all.report.T < 20.0);
  BOOST_TEST(change <= 1e-4);
  // Steadiness is detected over a time of 1.
  const double at_once = marched(marching_scene(64), {}, {.end = 5.0, .stop_steady = 1e-4}).report.T;
  BOOST_TEST((at_once >= 1.0 && at_once < 1.2));
}

BOOST_AUTO_TEST_CASE(limits_failures_and_interruptions_are_told) {
  const steady::Scene scene = marching_scene(64);
  const Marched limited = marched(scene, busy, {.end = 1.0, .most_steps = 7});
  BOOST_TEST_MESSAGE(limited.report.reason);
  BOOST_TEST((limited.report.end == MarchEnd::failed));
  BOOST_TEST(limited.report.steps == 7);
  BOOST_TEST(limited.rows.size() == 8U);
  BOOST_TEST(limited.report.reason.find("7 steps") != std::string::npos);

  const steady::Solution start = steady::solve(scene);
  for (const int wanted : {1, 2, 5}) {
    int rows = 0;
    const Observer observer{.row = [&](const StepRow&) { return ++rows < wanted; }, .frame = {}};
    const MarchReport report = march(scene, start, busy, {.end = 1.0}, observer);
    BOOST_TEST((report.end == MarchEnd::interrupted));
    BOOST_TEST(rows == wanted);
    BOOST_TEST(report.steps == wanted - 1);
  }
  // Without an observer.
  BOOST_TEST((march(scene, start, {}, {.end = 0.1}, {}).end == MarchEnd::end_time));
  // An exception of the observer is passed on.
  const Observer throwing{
      .row = [](const StepRow& row) -> bool { return row.T == 0.0 ? true : throw std::runtime_error("mine"); },
      .frame = {}};
  BOOST_CHECK_THROW(march(scene, start, {}, {.end = 0.1}, throwing), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(same_bits_with_one_and_two_threads) {
  steady::Scene scene = marching_scene(256);
  scene.use_symmetry = false;  // half domains are too small for several threads
  const steady::Solution start = steady::solve(scene);
  std::vector<Frame> last;
  for (const int threads : {1, 2}) {
    scene.threads = threads;
    const Observer observer{.row = {}, .frame = [&](Frame&& frame) {
                              if (frame.T > 0.0) last.push_back(std::move(frame));
                            }};
    const Conditions conditions{.on_2 = busy.on_2};
    const MarchReport report = march(scene, start, conditions, {.end = 0.03, .longest_step = 0.02}, observer);
    BOOST_TEST((report.end == MarchEnd::end_time));
    BOOST_TEST_MESSAGE(threads << " threads: " << report.steps << " steps, " << report.cycles << " cycles");
  }
  BOOST_REQUIRE(last.size() == 2U);
  BOOST_TEST(core::max_abs(last[0].P) > 0.9);
  BOOST_TEST(core::max_abs_difference(last[0].P, last[1].P) == 0.0);
  BOOST_TEST(core::max_abs_difference(last[0].H, last[1].H) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
