// The errors that a solution reports: estimates from sequences of levels, the minimum between the nodes, error bars.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "judgement/error_estimate.hpp"
#include "steady/error_bars.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_error_bars)

using namespace ehl;
using namespace ehl::steady;
using namespace ehl::judgement;
using boost::test_tools::tolerance;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const judgement::Tuning tuned;

/// The sequence limit + error 2^(-order k), k = 0, 1, ...
std::vector<double> sequence(double limit, double error, double order, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(limit + error * std::exp2(-order * k));
  return values;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(estimates)

// s |d| / (2^p - 1) / |v|: s = 1.5 for two values, 1.25 for three and more; p is the observed order,
// limited to [order/2, order].
BOOST_AUTO_TEST_CASE(by_hand) {
  const auto error = [](const std::vector<double>& values, double order) {
    return estimate_error(tuned, values, order).relative_error;
  };
  BOOST_TEST(error({0.5, 0.4}, 2.0) == 1.5 * 0.1 / 3.0 / 0.4, tolerance(1e-12));
  BOOST_TEST(error({0.5, 0.4}, 1.0) == 1.5 * 0.1 / 1.0 / 0.4, tolerance(1e-12));
  // Differences 0.3 and 0.1: p = log2(3), 2^p - 1 = 2.
  BOOST_TEST(error({0.8, 0.5, 0.4}, 2.0) == 1.25 * 0.1 / 2.0 / 0.4, tolerance(1e-12));
  BOOST_TEST(estimate_error(tuned, std::vector{0.8, 0.5, 0.4}, 2.0).order == std::log2(3.0), tolerance(1e-12));
  // Too fast, too slow, changing direction, constant.
  BOOST_TEST(error({1.5, 0.5, 0.4}, 2.0) == 1.25 * 0.125 / 3.0 / 0.4, tolerance(1e-12));
  BOOST_TEST(error({0.6, 0.5, 0.4}, 2.0) == 1.25 * 0.1 / 1.0 / 0.4, tolerance(1e-12));
  BOOST_TEST(error({0.6, 0.5, 0.4}, 1.0) == 1.25 * 0.1 / (std::sqrt(2.0) - 1.0) / 0.4, tolerance(1e-12));
  BOOST_TEST(error({0.3, 0.5, 0.4}, 2.0) == 1.25 * 0.1 / 1.0 / 0.4, tolerance(1e-12));
  BOOST_TEST(error({0.5, 0.4, 0.4}, 2.0) == 1.25 * 0.025 / 1.0 / 0.4, tolerance(1e-12));
  BOOST_TEST(error({0.4, 0.4, 0.4}, 2.0) == 0.0);
  // Only the last three values count; a rising film and one that becomes negative are judged by their magnitude.
  BOOST_TEST(error({7.0, 0.8, 0.5, 0.4}, 2.0) == 1.25 * 0.1 / 2.0 / 0.4, tolerance(1e-12));
  BOOST_TEST(error({0.3, 0.4}, 2.0) == 1.5 * 0.1 / 3.0 / 0.4, tolerance(1e-12));
  BOOST_TEST(error({-0.3, -0.4}, 2.0) == 1.5 * 0.1 / 3.0 / 0.4, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(too_few_values_and_a_floor) {
  for (const std::vector<double>& few : {std::vector<double>{}, std::vector<double>{0.4}}) {
    BOOST_TEST(std::isnan(estimate_error(tuned, few, 2.0).relative_error));
    BOOST_TEST(std::isnan(estimate_error(tuned, few, 2.0).order));
  }
  BOOST_TEST(std::isnan(estimate_error(tuned, std::vector{0.5, 0.4}, 2.0).order));
  BOOST_TEST(estimate_error(tuned, std::vector{0.5, 0.4}, 2.0, 0.2).relative_error == 0.2);
  BOOST_TEST(estimate_error(tuned, std::vector{0.5, 0.4}, 2.0, 0.1).relative_error == 0.125, tolerance(1e-12));
}

// 0.008^(2/3) = 0.04.
BOOST_AUTO_TEST_CASE(floor_of_the_first_order) {
  BOOST_TEST(first_order_floor(tuned, 0.01, 0.008) == 0.35 * 0.25, tolerance(1e-12));
  BOOST_TEST(first_order_floor(tuned, 0.02, 0.008) == 0.35 * 0.5, tolerance(1e-12));
  for (const double Hm : {0.0, -0.1, unknown}) BOOST_TEST(std::isinf(first_order_floor(tuned, 0.01, Hm)));
}

// h/Hm^(2/3) = 0.5 and 2.
BOOST_AUTO_TEST_CASE(one_grid_alone) {
  BOOST_TEST(error_of_one_grid(tuned, 0.02, 0.008, 2.0) == 0.85 * 0.25, tolerance(1e-12));
  BOOST_TEST(error_of_one_grid(tuned, 0.08, 0.008, 2.0) == 0.85 * 4.0, tolerance(1e-12));
  BOOST_TEST(error_of_one_grid(tuned, 0.02, 0.008, 1.0) == 0.35 * 0.5, tolerance(1e-12));
  BOOST_TEST(error_of_one_grid(tuned, 0.08, 0.008, 1.0) == 0.35 * 4.0, tolerance(1e-12));
  for (const double Hm : {0.0, -0.1, unknown}) BOOST_TEST(std::isinf(error_of_one_grid(tuned, 0.01, Hm, 2.0)));
}

BOOST_AUTO_TEST_CASE(extrapolation_is_exact_for_its_order) {
  for (const double order : {1.0, 2.0})
    for (const int count : {3, 5}) {
      const std::vector<double> values = sequence(0.2, 0.04, order, count);
      const Extrapolation result = extrapolate(values, order, 0.05);
      BOOST_TEST_MESSAGE("order " << order << ": " << result.value << " +- " << result.relative_error);
      BOOST_TEST(result.value == 0.2, tolerance(1e-12));
      // The remaining error is a twentieth of the correction.
      BOOST_TEST(result.relative_error == 0.05 * (values.back() - 0.2) / 0.2, tolerance(1e-10));
    }
}

// 0.8, 0.5, 0.4 with order 2: 0.4 - 0.1/3; one level before 0.5 - 0.3/3 = 0.4.
BOOST_AUTO_TEST_CASE(extrapolation_is_as_sure_as_it_is_steady) {
  const Extrapolation result = extrapolate(std::vector{0.8, 0.5, 0.4}, 2.0, 0.05);
  const double value = 0.4 - 0.1 / 3.0;
  BOOST_TEST(result.value == value, tolerance(1e-12));
  BOOST_TEST(result.relative_error == (0.4 - value) / value, tolerance(1e-12));
  const Extrapolation negative = extrapolate(std::vector{-0.8, -0.5, -0.4}, 2.0, 0.05);
  BOOST_TEST(negative.relative_error == (0.4 - value) / value, tolerance(1e-12));
  const Extrapolation two = extrapolate(std::vector{0.5, 0.4}, 2.0, 0.05);
  BOOST_TEST(std::isnan(two.value));
  BOOST_TEST(std::isnan(two.relative_error));
  // Extrapolated values with the opposite sign, or with an error as large as the value.
  BOOST_TEST(std::isnan(extrapolate(std::vector{0.8, 0.7, 0.1}, 2.0, 0.05).value));
  BOOST_TEST(std::isnan(extrapolate(std::vector{0.1, 0.9, 0.4}, 2.0, 0.05).value));
  BOOST_TEST(extrapolate(std::vector{0.8, 0.7, 0.5}, 2.0, 0.05).value == 0.5 - 0.2 / 3.0, tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(bars)

namespace {

LevelRow row(double Hc, double Hm, double Hm_fitted, double P_max, double P_rim = 0.0) {
  LevelRow result;
  result.Hc = Hc;
  result.Hm = Hm;
  result.Hm_fitted = Hm_fitted;
  result.P_max = P_max;
  result.P_rim = P_rim;
  result.mesh_error_Hc = 0.02;
  result.mesh_error_Hm = 0.05;
  return result;
}

Solution three_levels(double P_1, double P_2, double P_3) {
  Solution solution;
  solution.levels = {row(0.5, 0.32, 0.31, P_1), row(0.44, 0.27, 0.26, P_2), row(0.425, 0.2525, 0.25, P_3)};
  solution.verification.algebraic_error_Hc = 1e-3;
  solution.verification.algebraic_error_Hm = 2e-3;
  solution.domain_error_Hc = -0.004;
  return solution;
}

}  // namespace

BOOST_AUTO_TEST_CASE(parts_and_their_sums) {
  Solution solution = three_levels(1.0, 1.1, 1.15);
  solution.grid = {8, 10, -1.0, 1.0, -1.0, 1.0};
  solution.H = core::Field(solution.grid);
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 10; ++j)
      solution.H(i, j) = std::pow(solution.grid.X(i) - 0.3, 2.0) + 2.0 * std::pow(solution.grid.Y(j) + 0.15, 2.0);
  const ErrorBars bars = error_bars_of(Scene{}, solution);
  BOOST_TEST(bars.Hc.discretization == 0.02);
  BOOST_TEST(bars.Hc.algebraic == 1e-3);
  BOOST_TEST(bars.Hc.total() == 0.021, tolerance(1e-12));
  BOOST_TEST(bars.Hm.discretization == 0.05);
  BOOST_TEST(bars.Hm.algebraic == 2e-3);
  BOOST_TEST(bars.Hm.total() == 0.052, tolerance(1e-12));
  // The node is 0.0025 of 0.2525 above the minimum; this part belongs to the value at the node alone.
  BOOST_TEST(bars.Hm_fitted.discretization == 0.05 - 0.0025 / 0.2525, tolerance(1e-12));
  BOOST_TEST(bars.Hm_fitted.algebraic == 2e-3);
  BOOST_TEST(bars.Hm_fitted_value == 0.25);
  BOOST_TEST(bars.Hm_fitted_X == 0.3, tolerance(1e-12));
  BOOST_TEST(bars.Hm_fitted_Y == -0.15, tolerance(1e-12));
  BOOST_TEST(bars.domain == 0.004);
}

// Hc 0.5, 0.44, 0.425: second order around 0.42. Hm_fitted 0.31, 0.26, 0.25: 0.25 - 0.01/3, one level before 0.26 -
// 0.05/3. The algebraic error is multiplied by 4/3; for the first-order wedge by 2.
BOOST_AUTO_TEST_CASE(extrapolated_values) {
  const Solution solution = three_levels(1.0, 1.1, 1.15);
  const ErrorBars second = error_bars_of(Scene{}, solution);
  BOOST_TEST(second.Hc_extrapolated.value == 0.42, tolerance(1e-12));
  BOOST_TEST(second.Hc_extrapolated.error == 0.05 * 0.005 / 0.42 + 4.0 / 3.0 * 1e-3, tolerance(1e-10));
  const double Hm = 0.25 - 0.01 / 3.0;
  BOOST_TEST(second.Hm_extrapolated.value == Hm, tolerance(1e-12));
  // For a steady sequence, a fifth of the correction remains uncertain.
  Solution steady = solution;
  for (const std::size_t k : {0u, 1u, 2u})
    steady.levels[k].Hm_fitted = 0.24 + 0.16 * std::exp2(-2.0 * static_cast<double>(k));
  BOOST_TEST(error_bars_of(Scene{}, steady).Hm_extrapolated.error == 0.2 * 0.01 / 0.24 + 4.0 / 3.0 * 2e-3,
             tolerance(1e-10));
  BOOST_TEST(second.Hm_extrapolated.error == (Hm - (0.26 - 0.05 / 3.0)) / Hm + 4.0 / 3.0 * 2e-3, tolerance(1e-10));
  Scene scene;
  scene.wedge = reynolds::Wedge::upstream1;
  const ErrorBars first = error_bars_of(scene, solution);
  BOOST_TEST(first.Hc_extrapolated.value == 0.41, tolerance(1e-12));
  BOOST_TEST(first.Hc_extrapolated.error == (0.41 - 0.38) / 0.41 + 2.0 * 1e-3, tolerance(1e-10));
}

// Differences that fall by a factor of 0.7 or less are taken to be of first order at most. At a
// spike the differences grow.
BOOST_AUTO_TEST_CASE(largest_pressure) {
  const auto bars = [](double P_1, double P_2, double P_3) {
    return error_bars_of(Scene{}, three_levels(P_1, P_2, P_3));
  };
  BOOST_TEST(bars(1.0, 1.1, 1.15).P_max_converging);
  BOOST_TEST(bars(1.0, 1.1, 1.15).P_max == 1.25 * 0.05 / 1.15, tolerance(1e-12));
  BOOST_TEST(bars(1.0, 1.1, 1.11).P_max == 1.25 * 0.1 / std::exp2(2.5) / (std::exp2(1.5) - 1.0) / 1.11,
             tolerance(1e-10));
  BOOST_TEST(bars(1.0, 1.1, 1.169).P_max_converging);
  BOOST_TEST(bars(1.1, 1.0, 0.97).P_max_converging);
  for (const double last : {1.171, 1.3, 1.029}) {
    BOOST_TEST(!bars(1.0, 1.1, last).P_max_converging);
    BOOST_TEST(std::isnan(bars(1.0, 1.1, last).P_max));
  }
  // The pressure is constant if its changes are below 1e-5 of it.
  BOOST_TEST(bars(1.0, 1.0, 1.0 + 0.9e-5).P_max_converging);
  BOOST_TEST(!bars(1.0, 1.0, 1.0 + 1.1e-5).P_max_converging);
  BOOST_TEST(bars(2.0, 2.0, 2.0 + 1.8e-5).P_max_converging);
}

// A constant plateau and a spike next to it. If the spike has settled, it may rise by 1.25 times its last
// change, otherwise by four times.
BOOST_AUTO_TEST_CASE(a_spike_that_overtakes_the_plateau) {
  const auto bars = [](double P_1, double P_2, double P_3) {
    Solution solution = three_levels(1.02, 1.02, 1.02);
    solution.levels[0].P_rim = P_1;
    solution.levels[1].P_rim = P_2;
    solution.levels[2].P_rim = P_3;
    return error_bars_of(Scene{}, solution);
  };
  BOOST_TEST(bars(0.8, 0.8, 0.8).P_max == 0.0);
  BOOST_TEST(bars(0.7, 0.73, 0.76).P_max == 0.0);
  BOOST_TEST(!bars(0.7, 0.78, 0.87).P_max_converging);
  BOOST_TEST(std::isnan(bars(0.7, 0.78, 0.87).P_max));
  BOOST_TEST(bars(0.8, 0.96, 1.0).P_max == (1.0 + 1.25 * 0.04) / 1.02 - 1.0, tolerance(1e-10));
  BOOST_TEST(bars(0.9, 0.91, 0.915).P_max == 0.0);
}

// ln eta_bar = alpha_bar P for a Barus oil, 12.8 or 8 at P = 0.8. The pressure at the rim is that of the dry
// contact, or contains a spike.
BOOST_AUTO_TEST_CASE(a_spike_that_is_not_seen) {
  const auto bars = [](double alpha_bar, double P_rim) {
    Solution solution = three_levels(1.02, 1.02, 1.02);
    for (LevelRow& row : solution.levels) row.P_rim = P_rim;
    Scene scene;
    scene.viscosity = rheology::make_barus(alpha_bar, 1.0);
    return error_bars_of(scene, solution);
  };
  BOOST_TEST(bars(16.0, 0.82).spike_unseen);
  BOOST_TEST(!bars(16.0, 0.82).P_max_converging);
  BOOST_TEST(std::isnan(bars(16.0, 0.82).P_max));
  for (const auto& [alpha_bar, P_rim] : {std::pair(16.0, 0.88), {10.0, 0.82}}) {
    BOOST_TEST(!bars(alpha_bar, P_rim).spike_unseen);
    BOOST_TEST(bars(alpha_bar, P_rim).P_max == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(what_is_not_known) {
  Solution none;
  BOOST_TEST(std::isnan(error_bars_of(Scene{}, none).Hc.total()));
  BOOST_TEST(std::isnan(error_bars_of(Scene{}, none).domain));
  Solution two = three_levels(1.0, 1.1, 1.15);
  two.levels.pop_back();
  const ErrorBars bars = error_bars_of(Scene{}, two);
  BOOST_TEST(bars.Hc.discretization == 0.02);
  BOOST_TEST(std::isnan(bars.Hc_extrapolated.error));
  BOOST_TEST(std::isnan(bars.P_max));
  BOOST_TEST(!bars.P_max_converging);
  BOOST_TEST(std::isnan(bars.Hm_fitted_X));
  Solution no_cycles = three_levels(1.0, 1.1, 1.15);
  no_cycles.verification = {};
  BOOST_TEST(std::isnan(error_bars_of(Scene{}, no_cycles).Hc.total()));
}

// A row without an estimate gets that of its mesh size; h = 6/60, Hm = 0.125.
BOOST_AUTO_TEST_CASE(one_level) {
  Solution one = three_levels(1.0, 1.1, 1.15);
  one.levels = {row(0.5, 0.128, 0.125, 1.0)};
  one.levels.back().nx = 60;
  one.levels.back().mesh_error_Hc = one.levels.back().mesh_error_Hm = unknown;
  Scene scene;
  scene.grid = {120, 60, -4.5, 1.5, -1.0, 1.0};
  const ErrorBars second = error_bars_of(scene, one);
  BOOST_TEST(second.Hc.discretization == 0.85 * 0.16, tolerance(1e-12));
  BOOST_TEST(second.Hm.discretization == 0.85 * 0.16 + 0.003 / 0.128, tolerance(1e-12));
  BOOST_TEST(second.Hm_fitted.discretization == 0.85 * 0.16, tolerance(1e-12));
  BOOST_TEST(second.Hc.algebraic == 1e-3);
  scene.wedge = reynolds::Wedge::upstream1;
  BOOST_TEST(error_bars_of(scene, one).Hc.discretization == 0.35 * 0.4, tolerance(1e-12));
}

// If the domain error was not computed, the rough estimate from the far field is used (domain_error.hpp).
BOOST_AUTO_TEST_CASE(domain_by_the_rough_estimate) {
  Scene scene;
  scene.contact = steady::scales_of(20.0, 10.0);
  scene.lambda = 0.1;
  scene.grid = {64, 64, -4.5, 1.5, -3.0, 3.0};
  Solution solution = three_levels(1.0, 1.1, 1.15);
  solution.domain_error_Hc = unknown;
  const double domain = error_bars_of(scene, solution).domain;
  BOOST_TEST_MESSAGE("rough " << domain << " (a few percent)");
  BOOST_TEST(domain > 0.001);
  BOOST_TEST(domain < 0.2);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
