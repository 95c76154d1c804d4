// The adapter of the integrator in case of failures: unsolved stages, failed error tests, exceptions.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "transient/ida.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_ida_failures)

using namespace ehl::transient;
using End = StepReport::End;

namespace {

// y' = -y, solved exactly: y_p' + cj c = -(y_p + c).
StageResult solve_exactly(const Stage& stage, std::span<double> correction) {
  correction[0] = -(stage.y_predicted[0] + stage.yp_predicted[0]) / (1.0 + stage.cj);
  return {.solved = true, .cycles = 1};
}

DaeProblem decay() {
  DaeProblem problem;
  problem.size = 1;
  problem.solve = solve_exactly;
  problem.weights = [](double, std::span<const double>, std::span<double> w) { w[0] = 1e5; };
  return problem;
}

const std::vector<double> one{1.0}, minus_one{-1.0};

struct Failure {
  std::string reason;
  int calls = 0;  ///< calls of the solution of a stage in the step that failed
};

/// Takes ten successful steps, then steps with this solution of the stages until one fails.
Failure failure_of(const std::function<StageResult(int call, const Stage&, std::span<double>)>& solve) {
  DaeProblem problem = decay();
  int calls = 0;
  bool broken = false;
  problem.solve = [&](const Stage& stage, std::span<double> correction) {
    return broken ? solve(++calls, stage, correction) : solve_exactly(stage, correction);
  };
  Ida ida(problem, {}, 0.0, one, minus_one);
  for (int k = 0; k < 10; ++k) ida.step(5.0);
  broken = true;
  StepReport step;
  for (int k = 0; k < 100 && step.end != End::failed; ++k) {
    calls = 0;
    step = ida.step(5.0);
  }
  BOOST_TEST((step.end == End::failed));
  BOOST_TEST_MESSAGE(step.reason << ", after " << calls << " attempts (allowed 30)");
  BOOST_TEST(calls <= 30);
  return {step.reason, calls};
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_unsolved_stage_makes_the_step_shorter) {
  DaeProblem problem = decay();
  std::vector<double> lengths;  // T of each attempt in the step that begins at `from`
  double from = 0.0;
  int fail = -1;
  problem.solve = [&](const Stage& stage, std::span<double> correction) {
    lengths.push_back(stage.T - from);
    if (fail-- == 0) return StageResult{.solved = false, .cycles = 7};
    return solve_exactly(stage, correction);
  };
  Ida ida(problem, {}, 0.0, one, minus_one);
  for (int k = 0; k < 20; ++k) from = ida.step(5.0).T;
  lengths.clear();
  fail = 0;
  const StepReport step = ida.step(5.0);
  BOOST_REQUIRE((step.end == End::accepted));
  BOOST_REQUIRE(lengths.size() == 2U + static_cast<std::size_t>(step.rejected));
  BOOST_TEST_MESSAGE("attempts of length " << lengths[0] << " and " << lengths[1] << "; " << step.not_solved
                                           << " not solved, " << step.cycles << " cycles");
  BOOST_TEST(lengths[1] < 0.5 * lengths[0]);
  BOOST_TEST(std::abs(step.length - lengths.back()) < 1e-14);
  BOOST_TEST(step.not_solved == 1);
  BOOST_TEST(step.cycles == 8 + step.rejected);
  BOOST_TEST(std::abs(ida.y()[0] - std::exp(-step.T)) < 1e-3);
  // The failure is counted once.
  const StepReport next = ida.step(5.0);
  BOOST_TEST(next.not_solved == 0);
  BOOST_TEST(next.cycles == 1 + next.rejected);
}

BOOST_AUTO_TEST_CASE(failures_end_with_a_reason) {
  const Failure unsolved =
      failure_of([](int, const Stage&, std::span<double>) { return StageResult{.solved = false, .cycles = 1}; });
  BOOST_TEST(unsolved.reason.find("did not converge") != std::string::npos);
  BOOST_TEST(unsolved.calls >= 5);
  const Failure wild = failure_of([](int call, const Stage&, std::span<double> correction) {
    correction[0] = call % 2 == 0 ? 1.0 : -1.0;
    return StageResult{};
  });
  BOOST_TEST(wild.reason.find("error test") != std::string::npos);
  const Failure mixed = failure_of([](int call, const Stage&, std::span<double> correction) {
    correction[0] = 1.0;
    return StageResult{.solved = call % 2 == 0, .cycles = 1};
  });
  BOOST_TEST(!mixed.reason.empty());
  const Failure not_a_number = failure_of([](int, const Stage&, std::span<double> correction) {
    correction[0] = std::numeric_limits<double>::quiet_NaN();
    return StageResult{};
  });
  BOOST_TEST(!not_a_number.reason.empty());
}

BOOST_AUTO_TEST_CASE(no_step_is_shorter_than_the_shortest) {
  DaeProblem problem = decay();
  double shortest = 1.0;
  problem.solve = [&](const Stage& stage, std::span<double>) {
    shortest = std::min(shortest, stage.T);
    return StageResult{.solved = false};
  };
  Ida ida(problem, {.first = 0.1, .shortest = 0.01}, 0.0, one, minus_one);
  const StepReport step = ida.step(5.0);
  BOOST_TEST_MESSAGE("shortest attempt " << shortest << " (allowed 0.01): " << step.reason);
  BOOST_TEST((step.end == End::failed));
  BOOST_TEST(!step.reason.empty());
  BOOST_TEST(shortest >= 0.01 * (1.0 - 1e-12));
}

BOOST_AUTO_TEST_CASE(weights_that_are_not_positive_are_told) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const struct {
    double bad;
    int good;
  } cases[] = {{0.0, 0}, {-1.0, 3}, {std::numeric_limits<double>::quiet_NaN(), 3}, {infinity, 3}};
  for (const auto& [bad, good] : cases) {
    DaeProblem problem = decay();
    int calls = 0;
    problem.weights = [&calls, bad = bad, good = good](double, std::span<const double>, std::span<double> w) {
      w[0] = calls++ < good ? 1e5 : bad;
    };
    Ida ida(problem, {}, 0.0, one, minus_one);
    StepReport step;
    for (int k = 0; k < 10 && step.end != End::failed; ++k) step = ida.step(5.0);
    BOOST_TEST_MESSAGE("weight " << bad << " after " << good << ": " << step.reason);
    BOOST_TEST((step.end == End::failed));
    BOOST_TEST(!step.reason.empty());
  }
}

BOOST_AUTO_TEST_CASE(exceptions_pass_through_the_library) {
  // An exception from each of the three functions, in the first step and in a later one.
  for (const int calls_before : {0, 5})
    for (const std::string where : {"solve", "weights", "event"}) {
      DaeProblem problem = decay();
      int calls = 0;
      const auto perhaps_throw = [&](const char* here) {
        if (here == where && calls++ >= calls_before) throw std::runtime_error("mine, from " + where);
      };
      problem.solve = [&](const Stage& stage, std::span<double> correction) {
        perhaps_throw("solve");
        return solve_exactly(stage, correction);
      };
      problem.weights = [&](double, std::span<const double>, std::span<double> w) {
        perhaps_throw("weights");
        w[0] = 1e5;
      };
      problem.event = [&](double, std::span<const double> y) {
        perhaps_throw("event");
        return y[0] - 0.01;
      };
      Ida ida(problem, {}, 0.0, one, minus_one);
      std::string caught;
      try {
        for (int k = 0; k < 20; ++k) ida.step(5.0);
      } catch (const std::runtime_error& error) {
        caught = error.what();
      }
      BOOST_TEST_MESSAGE("after " << calls_before << " calls: " << caught);
      BOOST_TEST(caught == "mine, from " + where);
    }
}

BOOST_AUTO_TEST_SUITE_END()
