// Norms, sums and extremes of a field.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "core/norms.hpp"
#include "support/random.hpp"

BOOST_AUTO_TEST_SUITE(test_core_norms)

using namespace ehl::core;
using ehl::tests::Random;
using ehl::tests::random_field;

namespace {
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
const Grid grid{23, 38, -1, 1, -1, 1};
}  // namespace

BOOST_AUTO_TEST_CASE(sums_and_mean_squares_take_the_interior_alone) {
  Random random(1);
  Field f = random_field(grid, random, -1.0, 1.0);
  long double sum = 0.0L;
  long double squares = 0.0L;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j) {
      sum += f(i, j);
      squares += static_cast<long double>(f(i, j)) * f(i, j);
    }
  const auto points = static_cast<long double>((grid.nx - 1) * (grid.ny - 1));
  const auto rms = static_cast<double>(std::sqrt(squares / points));
  const double sum_error = std::abs(interior_sum(f) - static_cast<double>(sum));
  const double rms_error = std::abs(root_mean_square(f) - rms);
  BOOST_TEST_MESSAGE("sum " << sum_error << " (tolerance 1e-13), root mean square " << rms_error
                            << " (tolerance 1e-15)");
  BOOST_TEST(sum_error < 1e-13);
  BOOST_TEST(rms_error < 1e-15);
  // The values on the boundary have no effect.
  const double before = interior_sum(f);
  for (int i = 0; i <= grid.nx; ++i) f(i, 0) = f(i, grid.ny) = not_a_number;
  for (int j = 0; j <= grid.ny; ++j) f(0, j) = f(grid.nx, j) = not_a_number;
  BOOST_TEST(interior_sum(f) == before);
  BOOST_TEST(!std::isnan(root_mean_square(f)));
  f(5, 6) = not_a_number;
  BOOST_TEST(std::isnan(interior_sum(f)));
  BOOST_TEST(std::isnan(root_mean_square(f)));
}

BOOST_AUTO_TEST_CASE(largest_magnitudes_include_the_boundary_and_let_nan_through) {
  Random random(2);
  Field f = random_field(grid, random, -1.0, 1.0);
  Field g = f;
  f(grid.nx, grid.ny) = -3.0;
  BOOST_TEST(max_abs(f) == 3.0);
  g(0, 7) = f(0, 7) + 0.5;
  g(grid.nx, grid.ny) = -2.0;
  BOOST_TEST(max_abs_difference(f, g) == 1.0);
  BOOST_TEST(max_abs_difference(f, f) == 0.0);
  // A NaN is found anywhere, with larger numbers before and after it.
  for (const auto& [i, j] : {std::pair{0, 0}, {11, 20}, {grid.nx, grid.ny}}) {
    Field broken = f;
    broken(3, 3) = broken(20, 30) = 9.0;
    broken(i, j) = not_a_number;
    BOOST_TEST(std::isnan(max_abs(broken)));
    BOOST_TEST(std::isnan(max_abs_difference(broken, g)));
    BOOST_TEST(std::isnan(max_abs_difference(g, broken)));
  }
}

BOOST_AUTO_TEST_CASE(extremes_are_found_at_their_first_node) {
  Random random(3);
  Field f = random_field(grid, random, -1.0, 1.0);
  f(9, 4) = f(9, 30) = f(12, 1) = -5.0;
  f(0, 2) = f(grid.nx, grid.ny) = 6.0;
  const Location low = minimum(f);
  const Location high = maximum(f);
  BOOST_TEST((low.i == 9 && low.j == 4 && low.value == -5.0));
  BOOST_TEST((high.i == 0 && high.j == 2 && high.value == 6.0));
  f(0, 2) = 0.0;
  BOOST_TEST((maximum(f).i == grid.nx && maximum(f).j == grid.ny));
}

BOOST_AUTO_TEST_SUITE_END()
