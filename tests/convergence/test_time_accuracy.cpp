// The error of the time integration compared with its tolerance, and the cost of a step.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "core/norms.hpp"
#include "judgement/measures.hpp"
#include "unit/transient/marching.hpp"

BOOST_AUTO_TEST_SUITE(test_time_accuracy)

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;
using Points = std::vector<Schedule::Point>;

namespace {

/// A fast rise of the load. In the other case both surfaces stop and start again.
const Conditions ramp{.load = {.points = Points{{0.1, 1}, {0.2, 1.3}}}};
const Points stopping{{0.1, 1}, {0.6, 0}, {0.7, 0}, {1.2, 1}};
const Conditions stop{.u1 = {.points = stopping}, .u2 = {.points = stopping}};
const surface::Feature bump{.shape = surface::Feature::Shape::bump, .height = 0.066, .width = 0.5, .X = -1.5};

struct History {
  std::vector<double> Hc{}, Hm{}, P{};
  MarchReport report{};
};

/// The history at a hundred times, by dense output: Hc, Hm, and P between the nodes at (0.7, 0.1).
History history(const steady::Scene& scene, const steady::Solution& start, const Conditions& conditions, double rtol,
                double longest_step) {
  History all;
  const MarchParameters parameters{.end = 1.5, .rtol = rtol, .longest_step = longest_step, .output_interval = 0.015};
  const Observer observer{.frame = [&](Frame&& frame) {
    all.Hc.push_back(judgement::value_at(scene.grid, frame.H, 0.0, 0.0));
    all.Hm.push_back(core::minimum(frame.H).value);
    all.P.push_back(probed_at(scene.grid, frame.P, frame.H, {{0.7, 0.1}})[0].P);
  }};
  all.report = march(scene, start, conditions, parameters, observer);
  BOOST_REQUIRE((all.report.end == MarchEnd::end_time));
  BOOST_REQUIRE(all.Hc.size() == 101U);
  return all;
}

double error(const std::vector<double>& values, const std::vector<double>& truth) {
  double largest = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k) largest = std::max(largest, std::abs(values[k] / truth[k] - 1.0));
  return largest;
}

double cycles_per_step(const MarchReport& report) { return static_cast<double>(report.cycles) / report.steps; }

/// The reference uses steps of at most 0.004 and a tolerance of 1e-6. The error must decrease with the tolerance, and
/// be at most 0.3 % at 1e-4.
void check_order(const char* what, const Conditions& conditions) {
  // The error in time is the same on any grid, so the reference uses the same grid.
  const steady::Scene scene = marching_scene(64);
  const steady::Solution start = steady::solve(scene);
  const History truth = history(scene, start, conditions, 1e-6, 0.004);
  std::vector<double> last(3, 1.0);
  for (const double rtol : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const History all = history(scene, start, conditions, rtol, longest_step(conditions, 10.0));
    const std::vector<double> errors{error(all.Hc, truth.Hc), error(all.Hm, truth.Hm), error(all.P, truth.P)};
    BOOST_TEST_MESSAGE(what << ", rtol " << rtol << ": Hc off by " << errors[0] << ", Hm " << errors[1]
                            << ", P at a point " << errors[2] << " in " << all.report.steps << " steps of "
                            << cycles_per_step(all.report) << " cycles (reference " << truth.report.steps << " steps)");
    // If the steps of both tolerances have the longest allowed size, the errors differ only by chance.
    for (std::size_t k = 0; k < errors.size(); ++k) BOOST_TEST(errors[k] <= 1.1 * last[k]);
    BOOST_TEST(cycles_per_step(all.report) <= 2.0);
    if (rtol == 1e-4) BOOST_TEST((errors[0] <= 3e-3 && errors[1] <= 3e-3 && errors[2] <= 3e-3));
    last = errors;
  }
  for (const double least : last) BOOST_TEST(least <= 3e-4);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_error_falls_with_the_tolerance) {
  check_order("load ramp", ramp);
  check_order("stop and start", stop);
  check_order("bump", {.on_1 = bump});
}

BOOST_AUTO_TEST_CASE(two_cycles_a_step_at_most) {
  for (const int cells : {96, 192}) {
    const steady::Scene scene = marching_scene(cells);
    const steady::Solution start = steady::solve(scene);
    for (const Conditions& conditions : {ramp, stop, Conditions{.on_1 = bump}}) {
      const MarchReport report = march(scene, start, conditions, {.end = 1.0}, {});
      BOOST_TEST_MESSAGE(cells + 1 << "^2: " << report.steps << " steps of " << cycles_per_step(report)
                                   << " cycles (at most 2)");
      BOOST_TEST((report.end == MarchEnd::end_time));
      BOOST_TEST(cycles_per_step(report) <= 2.0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
