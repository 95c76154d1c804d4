// The hottest oil under a pressure spike that the mesh does not resolve.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "effects/heat/solve.hpp"
#include "steady/solve.hpp"
#include "unit/heat/heated_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_heat_spike)

using namespace ehl;
using support::BaseCase;

// Pure rolling: the pressure spike heats the oil by compression, increasingly on finer grids. On 128 cells only the
// heat of the inlet is visible, on all levels.
BOOST_AUTO_TEST_CASE(no_error_bar_of_the_film_under_an_unresolved_spike) {
  BaseCase base;
  base.srr = 0.0;
  const core::Grid grid = support::square(128);
  thermal::Setup setup = base.setup(grid);
  setup.thinning.reset();
  const steady::Scene scene = support::scene_of(base, setup, grid);
  const steady::Solution cold = steady::solve(scene);
  BOOST_TEST_REQUIRE(cold.converged, cold.failed_check);
  const heat::Solution warm = heat::solve(scene, setup, {}, cold, {});
  BOOST_TEST_REQUIRE(warm.film.converged, warm.film.failed_check);
  BOOST_TEST_MESSAGE("film " << base.T0 * warm.in_film.theta << " K, error " << warm.in_film.error);
  BOOST_TEST(base.T0 * warm.in_film.theta < 2.0);
  BOOST_TEST(warm.spike_unresolved);
  BOOST_TEST(std::isnan(warm.in_film.error));
  BOOST_TEST(std::isfinite(warm.on_1.error));
}

BOOST_AUTO_TEST_SUITE_END()
