// What a mesh does not resolve: spikes and rough surfaces.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "rheology/laws.hpp"
#include "steady/error_bars.hpp"
#include "steady/relief.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_unresolved)

using namespace ehl;

// Two levels give no error of P_max; a spike that is visible, or may be hidden, then counts as unresolved.
BOOST_AUTO_TEST_CASE(a_spike_on_two_levels) {
  const auto unresolved = [](double alpha_bar, double P_rim) {
    steady::Solution solution;
    for (int k = 0; k < 2; ++k)
      solution.levels.push_back({.nx = 64 << k, .Hc = 0.4, .Hm = 0.2, .Hm_fitted = 0.2, .P_max = 1.02, .P_rim = P_rim});
    steady::Scene scene;
    scene.viscosity = rheology::make_barus(alpha_bar, 1.0);
    return steady::error_bars_of(scene, solution).spike_unresolved;
  };
  BOOST_TEST(unresolved(16.0, 0.82));
  BOOST_TEST(unresolved(10.0, 0.95));
  BOOST_TEST(!unresolved(10.0, 0.82));
}

// Waves as means over cells: with half of n cells per wave, 1 - cos^2(pi/n) of the variance is lost.
BOOST_AUTO_TEST_CASE(waves_that_half_the_cells_lose) {
  for (const int cells_per_wave : {8, 32}) {
    steady::Scene scene;
    scene.grid = {128, 128, -2.0, 2.0, -2.0, 2.0};
    const double k = 2.0 * std::numbers::pi * 32.0 / cells_per_wave;
    scene.surface = [k](const core::Patch& grid, core::Field& S) {
      const double half = 0.5 * k * grid.hx();
      for (int i = 0; i <= grid.nx; ++i)
        for (int j = 0; j <= grid.ny; ++j) S(i, j) = std::sin(half) / half * std::sin(k * grid.X(i));
    };
    const double lost = steady::relief_lost(scene), exact = std::pow(std::sin(std::numbers::pi / cells_per_wave), 2);
    BOOST_TEST_MESSAGE(cells_per_wave << " cells per wave: " << lost << ", exact " << exact);
    BOOST_TEST(std::abs(lost - exact) < 0.02);
    steady::ErrorBars bars;
    bars.P_max = 0.01;
    bars.P_max_converging = true;
    steady::leave_open_on_relief(scene, bars);
    BOOST_TEST(std::isnan(bars.P_max) == (cells_per_wave == 8));
    BOOST_TEST(bars.P_max_converging == (cells_per_wave == 32));
  }
}

BOOST_AUTO_TEST_SUITE_END()
