// Error bars of a solution with adjoint error estimates.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "steady/error_bars.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_weighted_bars)

using namespace ehl;
using namespace ehl::steady;
using boost::test_tools::tolerance;

namespace {

Solution three_levels() {
  Solution solution;
  for (const double Hc : {0.5, 0.44, 0.425}) solution.levels.push_back({.Hc = Hc, .Hm = 0.2525, .P_max = 1.0});
  solution.levels[2].mesh_error_Hc = solution.levels[2].mesh_error_Hm = 1.0;
  for (const std::size_t k : {0u, 1u, 2u}) solution.levels[k].Hm_fitted = k == 0 ? 0.31 : k == 1 ? 0.26 : 0.25;
  solution.verification.algebraic_error_Hc = 1e-3;
  solution.verification.algebraic_error_Hm = 2e-3;
  return solution;
}

}  // namespace

// The parts of the adjoint estimate are slightly larger than the change between the levels for Hc, and smaller for Hm.
// The cycles leave an error, of which a part is scattered.
BOOST_AUTO_TEST_CASE(by_weights) {
  Solution solution = three_levels();
  const adjoint::PredictedChange parts{-0.03, -0.07, 0.003, -0.002, 0.01, 0.0005};
  solution.adjoint.emplace();
  solution.adjoint->Hc = solution.adjoint->Hm = parts;
  LevelRow& below = solution.levels[1];
  const LevelRow& last = solution.levels[2];
  below.Hc = last.Hc * 1.097;
  below.Hm_fitted = last.Hm_fitted * 1.127;
  solution.levels[2].nx = 60;
  Scene scene;
  scene.grid = {60, 60, -4.0, 2.0, -3.0, 3.0};
  scene.far_field = true;
  solution.levels[0].Hc = 0.6;
  const ErrorBars bars = error_bars_of(scene, solution);
  const double correction = -0.097 / 3.0 + 0.07 * (1.0 / 3.0 - 1.0 / 7.0);
  const double terms = std::sqrt(0.01 * 0.01 + 0.01 * 0.01 + 0.001 * 0.001);
  BOOST_TEST(bars.Hc.discretization == -correction + 0.55 * terms, tolerance(1e-10));
  BOOST_TEST(bars.Hc.algebraic == 1e-3 + 0.002 + 0.001, tolerance(1e-10));
  const double all = 0.03 / 3.0 + 0.07 / 7.0 + 0.003 / 3.0;
  // For Hm the correction is the largest part.
  const double of_Hm = -0.127 / 3.0 + 0.07 * (1.0 / 3.0 - 1.0 / 7.0);
  BOOST_TEST(bars.Hm_fitted.discretization == -of_Hm + 0.03 / 4.0, tolerance(1e-10));
  const double value = last.Hc * (1.0 + correction);
  BOOST_TEST(bars.Hc_extrapolated.value == value, tolerance(1e-10));
  // Steps of 6/60 in zones of 0.25^(2/3).
  const double next = 2.0 * 0.1 / std::pow(0.25, 2.0 / 3.0);
  const double unsure = next * (0.033 / 3.0 + 0.07 / 7.0) + 4.0 / 3.0 * bars.Hc.algebraic;
  BOOST_TEST(bars.Hc_extrapolated.error == unsure, tolerance(1e-10));
  BOOST_TEST(bars.domain == 0.0025, tolerance(1e-10));
  BOOST_TEST(bars.Hm_extrapolated.value == last.Hm_fitted * (1.0 + of_Hm), tolerance(1e-10));
  BOOST_TEST(bars.Hm_extrapolated.error == 0.6 * all + 0.03 / 3.0 + 4.0 / 3.0 * bars.Hm_fitted.algebraic,
             tolerance(1e-10));
}

// If the changes of Hc have one sign and decrease, the levels alone give the extrapolated value.
BOOST_AUTO_TEST_CASE(extrapolated_where_the_changes_fall) {
  for (const double first : {0.5, 0.448, 0.43}) {
    Solution solution = three_levels();
    solution.levels[0].Hc = first;
    const Estimate by_levels = error_bars_of(Scene{}, solution).Hc_extrapolated;
    solution.adjoint.emplace();
    solution.adjoint->Hc = {.poiseuille = -0.02, .wedge = -0.01};
    const ErrorBars bars = error_bars_of(Scene{}, solution);
    BOOST_TEST((bars.Hc_extrapolated.value == by_levels.value) == (first < 0.455));
    if (first < 0.455) BOOST_TEST(bars.Hc_extrapolated.error == by_levels.error);
  }
}

// The terms cancel, and the levels show no change: the terms then count, for Hc as if they were independent.
BOOST_AUTO_TEST_CASE(by_weights_that_cancel) {
  Solution solution = three_levels();
  solution.adjoint.emplace();
  solution.adjoint->Hc = solution.adjoint->Hm = {.poiseuille = 0.03, .wedge = -0.07, .film = 0.04};
  solution.levels[1].Hc = solution.levels[2].Hc;
  solution.levels[1].Hm_fitted = solution.levels[2].Hm_fitted;
  const ErrorBars bars = error_bars_of(Scene{}, solution);
  const double correction = 0.07 * (1.0 / 3.0 - 1.0 / 7.0);
  const double terms = std::sqrt(0.01 * 0.01 + 0.04 * 0.04 / 9.0 + 0.01 * 0.01);
  BOOST_TEST(bars.Hc.discretization == correction + 0.55 * terms, tolerance(1e-10));
  BOOST_TEST(bars.Hm_fitted.discretization == 0.07 / 3.0 + 0.01, tolerance(1e-10));
  // The levels give 0.018 minus the distance of the node from the minimum; three times that
  // limits the adjoint estimate.
  solution.levels[2].mesh_error_Hm = 0.018;
  const double of_node = 0.0025 / 0.2525;
  BOOST_TEST(error_bars_of(Scene{}, solution).Hm_fitted.discretization == 3.0 * (0.018 - of_node), tolerance(1e-10));
}

BOOST_AUTO_TEST_SUITE_END()
