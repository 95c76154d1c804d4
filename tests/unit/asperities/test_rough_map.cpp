// The table of a map: against the laws for Gaussian heights, against itself on half of the points, and its limits.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "asperities/flow_factors.hpp"
#include "asperities/rough_map.hpp"
#include "random_map.hpp"

BOOST_AUTO_TEST_SUITE(test_asperity_map)

using namespace ehl;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

surface::Heights gaussian(int n, double gamma, unsigned seed) {
  const double length = 128e-6;
  const asperities::Cell cell{n, n, length / n, length / n};
  return {n, n, support::random_heights(cell, 0.4e-6, 20e-6, 10e-6, 3.0, gamma, seed)};
}

asperities::MapResult of(const surface::Heights& z, bool error, int rows = 13) {
  return asperities::compute(z, 128e-6 / z.nx, 128e-6 / z.ny,
                             {.E_prime = 226e9, .hardness = infinity, .rows = rows, .error = error});
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_gaussian_map_follows_the_known_laws) {
  const auto result = of(gaussian(128, 1.0, 11), true);
  const double Sq = result.roughness.Sq;
  double phi = 0.0, least = 1e300, most = 0.0, gap_error = 0.0, before = 0.0;
  bool ordered = true;
  int compared = 0;
  for (const auto& row : result.rows) {
    BOOST_TEST(row.converged);
    const double l = row.gap / Sq;
    ordered = ordered && row.gap > before;
    before = row.gap;
    if (l > 2.0 && l < 6.0) {
      phi = std::max({phi, std::abs(row.phi_x - asperities::pressure_factor({1.0}, l)),
                      std::abs(row.phi_y - asperities::pressure_factor({1.0}, l))});
      ++compared;
    }
    const double relative = row.pressure / (0.5 * 226e9 * result.roughness.slope);
    if (relative > 0.003 && relative < 0.05) {
      least = std::min(least, row.area / relative);
      most = std::max(most, row.area / relative);
    }
    if (row.pressure > 0.0) gap_error = std::max(gap_error, row.error_gap / Sq);
    BOOST_TEST_MESSAGE("h/Sq " << l << ", p/(E* slope) " << relative << ", area " << row.area << ", phi_x " << row.phi_x
                               << ", phi_y " << row.phi_y << ", errors " << row.error_gap / Sq << ", "
                               << row.error_phi_x << "; " << row.iterations
                               << " iterations; Greenwood and Williamson p/p " << row.pressure_gw / row.pressure);
  }
  BOOST_TEST_MESSAGE("flow factors against Patir and Cheng, "
                     << compared << " gaps: " << phi << " (tolerance 0.1: one small map); area over p/(E* slope) "
                     << least << " to " << most
                     << " (1.6, Persson, to 2.51, Bush, Gibson and Thomas); gap on "
                        "half of the points "
                     << gap_error << " Sq (0.1)");
  BOOST_TEST(compared >= 3);
  BOOST_TEST(ordered);
  BOOST_TEST(phi < 0.1);
  BOOST_TEST(least > 1.5);
  BOOST_TEST(most < 2.6);
  BOOST_TEST(gap_error < 0.1);
}

BOOST_AUTO_TEST_SUITE_END()
