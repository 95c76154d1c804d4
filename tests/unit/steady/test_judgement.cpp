// The judgement of a solution: error estimate, checks, interpolation, warnings.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "judgement/error_estimate.hpp"
#include "judgement/measures.hpp"
#include "judgement/stopping.hpp"
#include "steady/warnings.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_judgement)

using namespace ehl;
using namespace ehl::steady;
using namespace ehl::judgement;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const judgement::Tuning tuned;

std::vector<double> sequence(double limit, double error, double order, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(limit + error * std::exp2(-order * k));
  return values;
}

LastCycle good_cycle() {
  return {.before = {.Hc = 0.2001, .Hm = 0.1001, .residual = 1e-3, .load_error = 1e-5},
          .after = {.Hc = 0.2,
                    .Hm = 0.1,
                    .residual = 1e-4,
                    .load_error = 1e-6,
                    .least_P = 0.0,
                    .dry_violation = 0.0,
                    .flow_imbalance = 0.0,
                    .oil_imbalance = 0.0},
          .mesh_error_Hc = 0.02,
          .mesh_error_Hm = 0.03};
}

}  // namespace

// The safety factor for three and more levels is 1.25.
BOOST_AUTO_TEST_CASE(error_of_an_asymptotic_sequence_is_its_error) {
  for (const double order : {1.0, 2.0}) {
    const std::vector<double> values = sequence(0.2, 0.04, order, 4);
    const ErrorEstimate estimate = estimate_error(tuned, values, order);
    const double truth = std::abs(values.back() - 0.2) / values.back();
    BOOST_TEST_MESSAGE("order " << estimate.order << ", error " << estimate.relative_error << ", true " << truth);
    BOOST_TEST(std::abs(estimate.order - order) < 1e-10);
    BOOST_TEST(std::abs(estimate.relative_error / truth - 1.25) < 1e-10);
  }
}

// Changes of Hm of .02 and .002, and of Hc of .01 and .003, relative to 1: for Hm half of .02 counts,
// for Hc 1.25 .003/3 + .01/5.
BOOST_AUTO_TEST_CASE(changes_that_swing_beside_a_meniscus) {
  const std::vector<double> Hc{1.013, 1.003, 1.0}, Hm{1.018, 0.998, 1.0};
  const FilmErrors errors = errors_beside_meniscus(tuned, Hc, Hm);
  BOOST_TEST(std::abs(errors.Hm - 0.01) < 1e-12);
  BOOST_TEST(std::abs(errors.Hc - 0.00325) < 1e-12);
  // The safety factors for two levels are larger.
  const FilmErrors of_two = errors_beside_meniscus(tuned, std::span(Hc).last(2), std::span(Hm).last(2));
  BOOST_TEST(std::abs(of_two.Hm - 1.5 * 0.002) < 1e-12);
  BOOST_TEST(std::abs(of_two.Hc - (1.5 * 0.003 / 3.0 + 0.2 * 0.003)) < 1e-12);
  BOOST_TEST(std::isnan(errors_beside_meniscus(tuned, std::span(Hc).last(1), std::span(Hm).last(1)).Hc));
}

BOOST_AUTO_TEST_CASE(error_estimate_is_cautious_where_the_sequence_is_not_asymptotic) {
  // Observed order 4 with a second-order scheme: at most second order is assumed, and a change of at least an
  // eighth of the one before.
  const std::vector<double> too_good = sequence(0.2, 0.04, 4.0, 3);
  const double step = std::abs(too_good[2] - too_good[1]);
  BOOST_TEST(std::abs(estimate_error(tuned, too_good, 2.0).relative_error - 1.25 * 2.0 * step / 3.0 / too_good[2]) <
             1e-12);
  // Differences with alternating signs have no order; the error is at least the last difference.
  const std::vector<double> turning{0.20, 0.21, 0.205};
  BOOST_TEST(estimate_error(tuned, turning, 2.0).relative_error >= 0.005 / 0.205);
  BOOST_TEST(std::isnan(estimate_error(tuned, turning, 2.0).order));
  BOOST_TEST(std::isnan(estimate_error(tuned, std::vector<double>{0.2}, 2.0).relative_error));
  BOOST_TEST(estimate_error(tuned, std::vector<double>{0.2, 0.21}, 2.0).relative_error > 0.01 / 3.0 / 0.21);
}

// Errors of opposite sign cancel in a change below 2^-4.5 of the one before: it counts as a quarter of it, with
// order 1.
BOOST_AUTO_TEST_CASE(a_small_change_may_be_a_difference_of_errors) {
  const auto error = [](const std::vector<double>& values) {
    return estimate_error(tuned, values, 2.0).relative_error;
  };
  BOOST_TEST(std::abs(error({0.9, 0.5, 0.48}) - 1.25 * 0.05 / 3.0 / 0.48) < 1e-12);
  BOOST_TEST(std::abs(error({0.9, 0.5, 0.49}) - 1.25 * 0.1 / 1.0 / 0.49) < 1e-12);
  BOOST_TEST(std::abs(error({0.9, 0.5, 0.5}) - 1.25 * 0.1 / 1.0 / 0.5) < 1e-12);
}

BOOST_AUTO_TEST_CASE(an_oil_content_below_zero_is_no_solution) {
  Measures now = good_cycle().after;
  BOOST_TEST(unmet_oil(tuned, now).empty());  // of a contact without a content
  now.least_content = -1e-13;
  BOOST_TEST(unmet_oil(tuned, now).empty());
  now.least_content = -6.7e-4;
  BOOST_TEST(unmet_oil(tuned, now).find("oil content is negative at its lowest, Q = -6.70e-04") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_good_last_cycle_passes) {
  BOOST_TEST(unmet_check(tuned, good_cycle(), unknown).empty());
  BOOST_TEST(unmet_check(tuned, good_cycle(), 1e-3).empty());
}

BOOST_AUTO_TEST_CASE(each_check_can_fail) {
  const auto fails = [](auto spoil, double tolerance, const char* word) {
    LastCycle cycle = good_cycle();
    spoil(cycle);
    const std::string message = unmet_check(tuned, cycle, tolerance);
    BOOST_TEST_MESSAGE(message);
    BOOST_TEST(message.find(word) != std::string::npos);
  };
  fails([](LastCycle& c) { c.after.Hm = -1e-3; }, unknown, "negative");
  fails([](LastCycle& c) { c.after.Hm = unknown; }, unknown, "not finite");
  fails([](LastCycle&) {}, 1e-5, "residual");
  fails([](LastCycle& c) { c.after.residual = unknown; }, 1e-3, "residual");
  fails([](LastCycle& c) { c.after.load_error = 1.0; }, 1e-3, "load");
  fails([](LastCycle& c) { c.mesh_error_Hc = unknown; }, unknown, "residual");
  fails([](LastCycle& c) { c.after.residual = 0.5; }, unknown, "residual");
  fails([](LastCycle& c) { c.after.load_error = 0.01; }, unknown, "load");
  fails([](LastCycle& c) { c.before.Hc = 0.25; }, unknown, "Hc");
  fails([](LastCycle& c) { c.before.Hm = 0.15; }, unknown, "Hm");
  fails([](LastCycle& c) { c.after.least_P = -1e-9; }, unknown, "pressure is negative");
  fails([](LastCycle& c) { c.after.least_P = -1e-9; }, 1e-3, "pressure is negative");
  fails([](LastCycle& c) { c.after.dry_violation = 0.021; }, unknown, "complementarity");
  fails([](LastCycle& c) { c.after.dry_violation = unknown; }, 1e-3, "complementarity");
  // The limit is a quarter of the discretization error of Hc, 0.02; a quarter of 0.05 if that error is larger or
  // unknown; but at least 1e-4.
  fails([](LastCycle& c) { c.after.flow_imbalance = -0.0051; }, unknown, "mass");
  fails([](LastCycle& c) { c.after.flow_imbalance = 0.0051; }, 1e-3, "mass");
  fails([](LastCycle& c) { c.after.flow_imbalance = unknown; }, unknown, "mass");
  const auto passes = [](auto spoil, double tolerance) {
    LastCycle cycle = good_cycle();
    spoil(cycle);
    BOOST_TEST(unmet_check(tuned, cycle, tolerance).empty());
  };
  passes([](LastCycle& c) { c.after.flow_imbalance = 0.0049; }, unknown);
  passes([](LastCycle& c) { c.after.dry_violation = 0.019; }, unknown);
  passes(
      [](LastCycle& c) {
        c.after.flow_imbalance = 0.0124;
        c.mesh_error_Hc = unknown;
      },
      1e-3);
  passes(
      [](LastCycle& c) {
        c.after.flow_imbalance = 9e-5;
        c.mesh_error_Hc = 1e-6;
      },
      1e-3);
  // A cycle that hardly reduces the residual means a large remaining change.
  fails([](LastCycle& c) { c.before.residual = 1.05e-4; }, unknown, "Hc");
}

BOOST_AUTO_TEST_CASE(value_between_nodes_is_exact_for_cubics) {
  const core::Grid grid{8, 10, -2.0, 1.0, -1.5, 1.5};
  const auto cubic = [](double X, double Y) { return 1.0 + X * X * X - 2.0 * X * Y * Y + Y * Y * Y; };
  core::Field field(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) field(i, j) = cubic(grid.X(i), grid.Y(j));
  for (const double X : {-2.0, -1.9, 0.0, 0.31, 1.0})
    for (const double Y : {-1.5, -0.7, 0.0, 1.45})
      BOOST_TEST(std::abs(value_at(grid, field, X, Y) - cubic(X, Y)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(warnings_name_what_is_wrong) {
  Solution solution;
  solution.grid = {16, 16, -4.5, 1.5, -3.0, 3.0};
  solution.P = core::Field(solution.grid);
  solution.P(8, 8) = 1.0;
  solution.levels.push_back({.mesh_error_Hc = 0.01, .mesh_error_Hm = 0.02});
  solution.error_bars.Hc.discretization = 0.01;
  solution.error_bars.Hm.discretization = 0.02;
  const Scene scene;
  BOOST_TEST(warnings_of(scene, solution).empty());
  const auto warned = [&](const char* word) {
    const core::Warnings warnings = warnings_of(scene, solution);
    return warnings.size() == 1 && warnings[0].text.find(word) != std::string::npos;
  };
  solution.error_bars.Hm.discretization = 0.3;
  BOOST_TEST(warned("does not resolve"));
  // 0.3 becomes 0.075 after one halving of the mesh for second order, and after two for first order.
  solution.levels.back().nx = 96;
  BOOST_TEST(warned("192 would bring"));
  Scene first_order;
  first_order.wedge = reynolds::Wedge::upstream1;
  BOOST_TEST(warnings_of(first_order, solution)[0].text.find("384 would bring") != std::string::npos);
  BOOST_TEST(cells_that_resolve(256, 0.0999, reynolds::Wedge::upstream2) == 256);
  BOOST_TEST(cells_that_resolve(256, 0.41, reynolds::Wedge::upstream2) == 1024);
  BOOST_TEST(cells_that_resolve(256, 180.0, reynolds::Wedge::upstream2) == 1024);
  solution.error_bars.Hm.discretization = 1.2;
  BOOST_TEST(warned("at least 384 would bring"));
  BOOST_TEST(warned("of Hm 120 %"));
  solution.levels.back() = {.nx = 128, .mesh_error_Hc = unknown, .mesh_error_Hm = unknown};
  BOOST_TEST(warned("single level; use at least 256 cells"));
  solution.levels.back().Hm_fitted = -1e-4;
  BOOST_TEST(warned("between the nodes and is negative"));
  solution.levels.back().Hm_fitted = 1e-2;
  solution.levels.back() = {.mesh_error_Hc = 0.01, .mesh_error_Hm = 0.02};
  solution.error_bars.Hm.discretization = 0.02;
  solution.domain_error_Hc = 0.03;
  BOOST_TEST(warned("too short"));
  solution.domain_error_Hc = 0.001;
  solution.P(15, 8) = 0.01;
  BOOST_TEST(warned("outlet"));
  solution.P(15, 8) = 0.0;
  solution.P(8, 1) = 0.01;
  BOOST_TEST(warned("narrow"));
}

BOOST_AUTO_TEST_SUITE_END()
