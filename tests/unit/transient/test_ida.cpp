// The adapter of the integrator alone, with a small system that has an exact solution.
//
//   y1' = -y2,   y2 = y1^2,   y3' = -20 (y3 - sin T) + cos T:   y1 = 1/(1 + T),  y2 = y1^2,  y3 = sin T
//
// Every stage is solved in closed form, so that only the adapter and the integrator cause errors.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "transient/ida.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_ida)

using namespace ehl::transient;
using End = StepReport::End;

namespace {

constexpr double stiffness = 20.0;
constexpr double pi = std::numbers::pi;

std::vector<double> exact(double T) { return {1.0 / (1.0 + T), 1.0 / ((1.0 + T) * (1.0 + T)), std::sin(T)}; }
std::vector<double> slope(double T) {
  const double y = 1.0 / (1.0 + T);
  return {-y * y, -2.0 * y * y * y, std::cos(T)};
}

// y1: c^2 + (2 y1 + cj) c + y1^2 + y1' = 0 for the correction c, its small root without cancellation; y3 is linear.
StageResult solve_exactly(const Stage& stage, std::span<double> correction) {
  const double y1 = stage.y_predicted[0];
  const double b = 2.0 * y1 + stage.cj;
  const double q = y1 * y1 + stage.yp_predicted[0];
  correction[0] = -2.0 * q / (b + std::sqrt(b * b - 4.0 * q));
  correction[1] = (y1 + correction[0]) * (y1 + correction[0]) - stage.y_predicted[1];
  const double force = -stiffness * (stage.y_predicted[2] - std::sin(stage.T)) + std::cos(stage.T);
  correction[2] = (force - stage.yp_predicted[2]) / (stage.cj + stiffness);
  return {.solved = true, .cycles = 2};
}

DaeProblem problem_with(double rtol) {
  DaeProblem problem;
  problem.size = 3;
  problem.solve = solve_exactly;
  problem.weights = [rtol](double, std::span<const double> y, std::span<double> w) {
    for (std::size_t k = 0; k < y.size(); ++k) w[k] = 1.0 / (rtol * (std::abs(y[k]) + 0.1));
  };
  return problem;
}

double error_at(double T, std::span<const double> y) {
  double error = 0.0;
  for (std::size_t k = 0; k < y.size(); ++k) error = std::max(error, std::abs(y[k] - exact(T)[k]));
  return error;
}

struct Run {
  double error = 0.0;  ///< largest error over all steps
  int steps = 0, highest_order = 0;
  double longest = 0.0, first = 0.0;
};

Run run(double rtol, const StepLimits& limits) {
  const DaeProblem problem = problem_with(rtol);
  Ida ida(problem, limits, 0.0, exact(0.0), slope(0.0));
  Run all;
  StepReport step;
  while (step.end == End::accepted) {
    const double before = step.T;
    step = ida.step(5.0);
    BOOST_REQUIRE((step.end == End::accepted || step.end == End::at_stop));
    BOOST_TEST(step.T > before);
    BOOST_TEST(std::abs(step.length - (step.T - before)) < 1e-13);
    BOOST_TEST(step.cycles == 2 * (1 + step.rejected));
    if (all.steps++ == 0) all.first = step.length;
    all.error = std::max(all.error, error_at(step.T, ida.y()));
    all.highest_order = std::max(all.highest_order, step.order);
    all.longest = std::max(all.longest, step.length);
  }
  BOOST_TEST(step.T == 5.0);
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(error_follows_the_tolerance) {
  double before = 1.0;
  double first = 0.0;
  double last = 0.0;
  for (const double rtol : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    const Run all = run(rtol, {});
    BOOST_TEST_MESSAGE("rtol " << rtol << ": error " << all.error << " in " << all.steps << " steps, order "
                               << all.highest_order << " (allowed 5 rtol)");
    BOOST_TEST(all.error <= 5.0 * rtol);
    BOOST_TEST(all.error < before);
    before = last = all.error;
    if (first == 0.0) first = all.error;
  }
  BOOST_TEST_MESSAGE("from the first to the last the error falls by " << first / last << " (1e5 would be ideal; 1e4)");
  BOOST_TEST(first / last >= 1e4);
}

BOOST_AUTO_TEST_CASE(limits_of_order_and_step_are_kept) {
  const Run free = run(1e-5, {});
  const Run first_order = run(1e-5, {.max_order = 1});
  const Run second_order = run(1e-5, {.max_order = 2});
  BOOST_TEST_MESSAGE(first_order.steps << ", " << second_order.steps << " and " << free.steps
                                       << " steps at orders up to 1, 2 and " << free.highest_order);
  BOOST_TEST(first_order.highest_order == 1);
  BOOST_TEST(second_order.highest_order == 2);
  BOOST_TEST(free.highest_order > 2);
  BOOST_TEST(first_order.steps > 5 * free.steps);
  const Run limited = run(1e-3, {.first = 1e-5, .longest = 0.01});
  BOOST_TEST_MESSAGE("first step " << limited.first << ", longest " << limited.longest << " (allowed 1e-5, 0.01)");
  BOOST_TEST(limited.first <= 1e-5 * (1.0 + 1e-9));
  BOOST_TEST(limited.longest <= 0.01 * (1.0 + 1e-9));
  BOOST_TEST(limited.longest > 0.009);
}

BOOST_AUTO_TEST_CASE(steps_end_exactly_at_every_stop) {
  const DaeProblem problem = problem_with(1e-5);
  Ida ida(problem, {}, 0.0, exact(0.0), slope(0.0));
  for (const double stop : {0.1, 0.1 + 1e-6, 1.0 / 3.0, 2.0, 2.0 + 1e-10}) {
    StepReport step;
    do {
      step = ida.step(stop);
      BOOST_TEST(step.T <= stop);
    } while (step.end == End::accepted);
    BOOST_TEST_MESSAGE("stop at " << stop << ": off by " << step.T - stop << ", error " << error_at(stop, ida.y())
                                  << " (allowed 0 and 5e-5: 5 rtol)");
    BOOST_TEST((step.end == End::at_stop));
    BOOST_TEST(step.T == stop);
    BOOST_TEST(error_at(stop, ida.y()) <= 5e-5);
    // y' of the differential unknowns is consistent with y.
    BOOST_TEST(std::abs(ida.yp()[0] + ida.y()[0] * ida.y()[0]) <= 1e-4);
  }
  const StepReport behind = ida.step(1.0);
  BOOST_TEST_MESSAGE("a stop behind: " << behind.reason);
  BOOST_TEST((behind.end == End::failed));
  BOOST_TEST(!behind.reason.empty());
}

BOOST_AUTO_TEST_CASE(events_are_found_from_above_only) {
  // sin T passes 1/2 upwards at pi/6, and downwards at 5 pi/6.
  DaeProblem problem = problem_with(1e-9);
  problem.event = [](double, std::span<const double> y) { return y[2] - 0.5; };
  Ida ida(problem, {}, 0.0, exact(0.0), slope(0.0));
  StepReport step;
  while (step.end == End::accepted) step = ida.step(5.0);
  const double error = std::abs(step.T - 5.0 * pi / 6.0);
  BOOST_TEST((step.end == End::at_event));
  BOOST_TEST_MESSAGE("event at " << step.T << ", off by " << error << "; sin T there off by "
                                 << std::abs(ida.y()[2] - 0.5) << " (allowed 1e-6)");
  BOOST_TEST(error <= 1e-6);
  BOOST_TEST(std::abs(ida.y()[2] - 0.5) <= 1e-6);
  BOOST_TEST(error_at(step.T, ida.y()) <= 1e-6);
  // The integration continues after the event.
  step = ida.step(5.0);
  BOOST_TEST((step.end == End::accepted));
  BOOST_TEST(step.T > 5.0 * pi / 6.0);
}

BOOST_AUTO_TEST_CASE(a_restart_begins_anew) {
  const DaeProblem problem = problem_with(1e-6);
  Ida ida(problem, {}, 0.0, exact(0.0), slope(0.0));
  StepReport step;
  while (step.end == End::accepted) step = ida.step(3.0);
  BOOST_TEST(step.order > 1);
  // Back to T = 1, where the exact solution is known.
  ida.restart(1.0, exact(1.0), slope(1.0), 1e-4);
  BOOST_TEST(ida.y()[0] == 0.5);
  step = ida.step(4.0);
  BOOST_TEST_MESSAGE("first step behind the restart: to " << step.T << " of length " << step.length << ", order "
                                                          << step.order);
  BOOST_TEST(step.order == 1);
  BOOST_TEST(std::abs(step.length - 1e-4) <= 1e-12);
  BOOST_TEST((step.rejected == 0 && step.not_solved == 0));
  double error = 0.0;
  while (step.end == End::accepted) {
    step = ida.step(4.0);
    BOOST_TEST(step.rejected >= 0);
    error = std::max(error, error_at(step.T, ida.y()));
  }
  BOOST_TEST_MESSAGE("error behind the restart " << error << " (allowed 5 rtol)");
  BOOST_TEST((step.end == End::at_stop));
  BOOST_TEST(error <= 5e-6);
}

BOOST_AUTO_TEST_CASE(interpolation_within_the_last_step) {
  const DaeProblem problem = problem_with(1e-7);
  Ida ida(problem, {}, 0.0, exact(0.0), slope(0.0));
  StepReport step;
  while (step.T < 1.0) step = ida.step(5.0);
  std::vector<double> y(3);
  double error = 0.0;
  for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const double T = step.T - share * step.length;
    ida.interpolate(T, y);
    error = std::max(error, error_at(T, y));
  }
  BOOST_TEST_MESSAGE("error within a step of " << step.length << ": " << error << " (allowed 5 rtol)");
  BOOST_TEST(error <= 5e-7);
  ida.interpolate(step.T, y);
  BOOST_TEST(std::abs(y[0] - ida.y()[0]) <= 1e-15);
  BOOST_CHECK_THROW(ida.interpolate(step.T + 1e-6 * step.length, y), std::logic_error);
  BOOST_CHECK_THROW(ida.interpolate(step.T - 1.1 * step.length, y), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
