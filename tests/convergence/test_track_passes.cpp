// Repeated passes over one track: discrete solutions of an independent program, the closed form for
// thin layers, oil balance.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "steady/passes.hpp"
#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_track_passes)

using namespace ehl;

namespace {

steady::Scene scene_of(double M, double L, const core::Grid& grid, double H_oil, int passes) {
  steady::Scene scene = tests::roelands_scene(M, L, grid);
  scene.deformation.method = mlmi::Method::fft;
  scene.supply = [H_oil](double) { return H_oil; };
  scene.passes.number = passes;
  return scene;
}

}  // namespace

// An independent semismooth Newton solver: (50, 10), 64 x 64 cells; the first layer equals the flooded film.
BOOST_AUTO_TEST_CASE(discrete_solutions_of_another_program) {
  constexpr double Q_ff = 0.25075;  // rho_bar H at the centre of the flooded contact, for r = 1
  const steady::Solution solution = steady::solve(scene_of(50, 10, {64, 64, -2.5, 1.5, -2.0, 2.0}, Q_ff, 4));
  const double factors[] = {0.7905, 0.6693, 0.5965, 0.5470};
  BOOST_TEST_REQUIRE(solution.passes.size() == 4U);
  for (const steady::Pass& pass : solution.passes) {
    BOOST_TEST_MESSAGE("pass " << pass.number << ": r = " << pass.supply_ratio << ", factor " << pass.factor
                               << " (elsewhere " << factors[pass.number - 1] << "), left " << pass.left
                               << ", imbalance " << pass.imbalance << ", aside " << pass.aside << ", " << pass.steps
                               << " steps");
    BOOST_TEST(!pass.chatters);
    BOOST_TEST(std::abs(pass.imbalance) <= 1e-6);
    BOOST_TEST(std::abs(pass.factor - factors[pass.number - 1]) <= 1e-3);
  }
}

// On y = 0 each pass increases Q^-2 of an isoviscous, incompressible oil by 2 pi/lambda. After some
// passes, Q decreases as n^-1/2.
BOOST_AUTO_TEST_CASE(thin_layers_decay) {
  constexpr int passes = 100;
  constexpr double H_oil = 0.04;
  steady::Scene scene = scene_of(20, 0, {96, 96, -3.0, 1.5, -2.25, 2.25}, H_oil, passes);
  scene.viscosity = rheology::Isoviscous{};
  scene.density = rheology::Incompressible{};
  const steady::Solution solution = steady::solve(scene);
  BOOST_TEST_MESSAGE(solution.failed_check);
  double worst = 0.0;
  int steps = 0, chattering = 0;
  for (const steady::Pass& pass : solution.passes) {
    const double formula = 1.0 / std::sqrt(1.0 / (H_oil * H_oil) + 2.0 * pass.number * std::numbers::pi / scene.lambda);
    steps += pass.steps;
    worst = std::max(worst, std::abs(pass.left / formula - 1.0));
    if (pass.number % 10 == 0 || pass.chatters)
      BOOST_TEST_MESSAGE("pass " << pass.number << ": left " << pass.left << ", closed form " << formula << ", off by "
                                 << pass.left / formula - 1.0 << ", imbalance " << pass.imbalance << ", " << pass.steps
                                 << " steps");
    chattering += pass.first_order > 0 ? 1 : 0;
    BOOST_TEST(!pass.chatters);
    BOOST_TEST(std::abs(pass.imbalance) <= 1e-7);
  }
  BOOST_TEST_MESSAGE("off by " << worst << " at most (allowed 0.01), " << steps << " steps, " << chattering
                               << " passes with nodes of first order, in " << solution.seconds << " s");
  BOOST_TEST(worst <= 0.01);
}

// The errors of all passes accumulate, and the levels of the last pass do not show those of the earlier passes. The
// error bar of the last film must include them. The reference is the same track on 256 cells.
BOOST_AUTO_TEST_CASE(bars_contain_the_error_of_earlier_passes) {
  constexpr double H_oil = 0.2507, Hc_on_256_cells = 0.06930;
  const steady::Solution solution = steady::solve(scene_of(50, 10, {128, 128, -2.5, 1.5, -2.0, 2.0}, H_oil, 20));
  BOOST_TEST_REQUIRE(solution.converged);
  const double off = std::abs(solution.levels.back().Hc / Hc_on_256_cells - 1.0);
  const double bar = solution.error_bars.Hc.total(), of_last_pass = solution.levels.back().mesh_error_Hc;
  BOOST_TEST_MESSAGE("Hc is off by " << off << ", bar " << bar << ", of the last pass alone " << of_last_pass);
  BOOST_TEST(off > of_last_pass);
  BOOST_TEST(off <= bar);
}

BOOST_AUTO_TEST_SUITE_END()
