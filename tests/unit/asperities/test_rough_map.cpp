// The table of a map: against the laws for Gaussian heights, against itself on half of the points, and its limits.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "asperities/flow_factors.hpp"
#include "asperities/gap_table.hpp"
#include "asperities/rough_map.hpp"
#include "random_map.hpp"
#include "support/temporary_folder.hpp"

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

// A table with all columns reads back as a law and as factors that pass through its rows.
BOOST_AUTO_TEST_CASE(the_table_of_a_map_is_a_law) {
  const auto result = of(gaussian(32, 1.0, 3), true, 5);
  std::ostringstream text;
  text.precision(17);
  const char* between = "";
  for (const auto& column : asperities::map_columns()) {
    text << between << column.name << " [" << column.unit << "]";
    between = ",";
  }
  for (const auto& row : result.rows) {
    between = "\n";
    for (const auto& column : asperities::map_columns()) {
      text << between << column.of(row);
      between = ",";
    }
  }
  const support::TemporaryFolder folder;
  const auto read = asperities::read_gap_table(folder.write("map.csv", text.str()));
  BOOST_REQUIRE(std::holds_alternative<asperities::GapTable>(read));
  const auto& table = std::get<asperities::GapTable>(read);
  BOOST_TEST(table.touching() == 5U);
  BOOST_TEST(table.gap.size() == 8U);
  const auto factors = asperities::flow_factors(table, 1.0);
  double worst = 0.0;
  for (const auto& row : result.rows) {
    std::vector<double> out(1);
    asperities::phi_x(factors, std::vector<double>{row.gap}, out);
    worst = std::max(worst, std::abs(out[0] - row.phi_x));
  }
  BOOST_TEST_MESSAGE("phi_x at the rows: " << worst << " (tolerance 1e-12)");
  BOOST_TEST(worst < 1e-12);
}

// Nothing may depend on the number of threads.
BOOST_AUTO_TEST_CASE(two_threads_give_the_same_bits) {
  const auto z = gaussian(32, 1.0, 5);
  std::vector<double> numbers[2];
  for (const int threads : {1, 2})
    for (const auto& row :
         asperities::compute(z, 4e-6, 4e-6, {.E_prime = 226e9, .hardness = 5e9, .rows = 4, .threads = threads}).rows)
      numbers[threads - 1].insert(numbers[threads - 1].end(), {row.gap, row.film, row.area, row.phi_x, row.phi_y});
  BOOST_TEST(numbers[0].size() >= 15U);
  BOOST_TEST((numbers[0] == numbers[1]));
}

BOOST_AUTO_TEST_SUITE_END()
