// Restriction and prolongation: what they reproduce exactly, their orders, and that they are transposes of each other.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "core/norms.hpp"
#include "support/mirrored.hpp"
#include "transfer/transfer.hpp"

BOOST_AUTO_TEST_SUITE(test_transfer)

using ehl::core::coarsened;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using ehl::tests::Random;
namespace transfer = ehl::transfer;

namespace {

// hx != hy, and an odd number of coarse cells along x.
const Grid fine_grid{26, 16, -1.5, 1.0, -0.5, 1.5};

template <class Function>
Field sampled(const Patch& grid, Function f) {
  Field field(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) field(i, j) = f(grid.X(i), grid.Y(j));
  return field;
}

// All X^a Y^b with a, b <= degree and random coefficients.
struct Polynomial {
  int degree;
  std::array<std::array<double, 4>, 4> c{};
  Polynomial(int highest, Random& random) : degree(highest) {
    for (auto& row : c)
      for (double& value : row) value = random.between(-1.0, 1.0);
  }
  double operator()(double X, double Y) const {
    double sum = 0.0;
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; b <= degree; ++b)
        sum += c[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] * std::pow(X, a) * std::pow(Y, b);
    return sum;
  }
};

double smooth(double X, double Y) { return std::sin(2.0 * X + 0.3) * std::cos(1.5 * Y - 0.2); }

template <class Prolong, class Function>
double prolongation_error(const Patch& grid, Prolong prolong, Function f) {
  Field fine(grid);
  prolong(coarsened(grid), sampled(coarsened(grid), f), fine);
  return ehl::core::max_abs_difference(fine, sampled(grid, f));
}

const auto bilinear = [](const Patch&, const Field& coarse, Field& fine) {
  transfer::prolong_bilinear(coarse, fine, 1);
};
const auto bicubic = transfer::prolong_bicubic;

template <class Prolong>
void check_order(const char* what, Prolong prolong, double order, double constant) {
  std::array<double, 3> error{};
  double h = 0.0;
  for (int k = 0; k < 3; ++k) {
    const Grid grid{32 << k, 32 << k, -1, 1, -1, 1};
    error[static_cast<std::size_t>(k)] = prolongation_error(grid, prolong, smooth);
    h = coarsened(grid).hx();
  }
  const double slope = std::log2(error[1] / error[2]);
  const double ratio = error[2] / (constant * std::pow(h, order));
  BOOST_TEST_MESSAGE(what << ": errors " << error[0] << ' ' << error[1] << ' ' << error[2] << ", order " << slope
                          << " (wanted " << order << " +- 0.1), largest over that of the theory " << ratio
                          << " (0.9 to 1.05)");
  BOOST_TEST(std::abs(slope - order) < 0.1);
  BOOST_TEST((ratio > 0.9 && ratio < 1.05));
}

}  // namespace

BOOST_AUTO_TEST_CASE(injection_takes_every_second_node) {
  Random random(1);
  const Field fine = ehl::tests::random_field(fine_grid, random, -1.0, 1.0);
  Field coarse(coarsened(fine_grid));
  transfer::restrict_injection(fine, coarse);
  for (int I = 0; I < coarse.nodes_x(); ++I)
    for (int J = 0; J < coarse.nodes_y(); ++J) BOOST_TEST(coarse(I, J) == fine(2 * I, 2 * J));
}

BOOST_AUTO_TEST_CASE(full_weighting_keeps_bilinear_functions_and_lifts_curved_ones) {
  Random random(2);
  const Polynomial f(1, random);
  const Grid grid = coarsened(fine_grid);
  Field coarse(grid);
  transfer::restrict_full_weighting(grid, sampled(fine_grid, f), coarse);
  const double error = ehl::core::max_abs_difference(coarse, sampled(grid, f));
  BOOST_TEST_MESSAGE("full weighting of a bilinear function: " << error << " (tolerance 1e-15)");
  BOOST_TEST(error < 1e-15);
  // A curved function is increased by h^2/4 times its second derivatives: 6 along x, 4 along y.
  const auto curved = [](double X, double Y) { return 3.0 * X * X + 2.0 * Y * Y; };
  const double rise = (6.0 * fine_grid.hx() * fine_grid.hx() + 4.0 * fine_grid.hy() * fine_grid.hy()) / 4.0;
  transfer::restrict_full_weighting(grid, sampled(fine_grid, curved), coarse);
  for (int I = 1; I < grid.nx; ++I)
    for (int J = 1; J < grid.ny; ++J) BOOST_TEST(std::abs(coarse(I, J) - curved(grid.X(I), grid.Y(J)) - rise) < 1e-14);
  Field ones(fine_grid);
  ones.fill(0.3);
  transfer::restrict_full_weighting(grid, ones, coarse);
  Field expected(grid);
  expected.fill(0.3);
  BOOST_TEST(ehl::core::max_abs_difference(coarse, expected) < 1e-16);
}

BOOST_AUTO_TEST_CASE(full_weighting_is_the_transpose_of_bilinear_interpolation) {
  // For every pair of an interior coarse node and a fine node, the restriction weight is exactly a quarter
  // of the prolongation weight.
  const Grid fine{12, 8, 0, 1, 0, 1};
  const Grid coarse = coarsened(fine);
  double largest = 0.0;
  double sum = 0.0;
  for (int I = 1; I < coarse.nx; ++I)
    for (int J = 1; J < coarse.ny; ++J) {
      Field unit(coarse);
      unit(I, J) = 1.0;
      Field up(fine);
      transfer::prolong_bilinear(unit, up, 1);
      for (int i = 0; i <= fine.nx; ++i)
        for (int j = 0; j <= fine.ny; ++j) {
          Field fine_unit(fine);
          fine_unit(i, j) = 1.0;
          Field down(coarse);
          transfer::restrict_full_weighting(coarse, fine_unit, down);
          largest = std::max(largest, std::abs(down(I, J) - up(i, j) / 4.0));
          sum += down(I, J);
        }
    }
  BOOST_TEST_MESSAGE("largest difference " << largest << " (exactly 0), sum of the weights " << sum);
  BOOST_TEST(largest == 0.0);
  BOOST_TEST(sum == (coarse.nx - 1) * (coarse.ny - 1));
}

BOOST_AUTO_TEST_CASE(bilinear_interpolation_is_exact_for_bilinear_functions_and_of_order_2) {
  Random random(3);
  const double error = prolongation_error(fine_grid, bilinear, Polynomial(1, random));
  BOOST_TEST_MESSAGE("bilinear function: " << error << " (tolerance 1e-15)");
  BOOST_TEST(error < 1e-15);
  BOOST_TEST(prolongation_error(fine_grid, bilinear, Polynomial(2, random)) > 1e-3);
  // Midway between nodes at a distance h, the error is h^2/8 of both second derivatives, 4 f and 2.25 f.
  check_order("bilinear", bilinear, 2.0, (4.0 + 2.25) / 8.0);
}

BOOST_AUTO_TEST_CASE(bilinear_interpolation_has_the_same_bits_with_two_threads) {
  Random random(4);
  const Field coarse = ehl::tests::random_field(coarsened(fine_grid), random, -1.0, 1.0);
  Field one(fine_grid);
  Field two(fine_grid);
  transfer::prolong_bilinear(coarse, one, 1);
  transfer::prolong_bilinear(coarse, two, 2);
  for (int i = 0; i <= fine_grid.nx; ++i) BOOST_TEST(std::ranges::equal(one.station(i), two.station(i)));
}

BOOST_AUTO_TEST_CASE(bicubic_interpolation_is_exact_for_bicubic_functions_and_of_order_4) {
  Random random(5);
  const double error = prolongation_error(fine_grid, bicubic, Polynomial(3, random));
  BOOST_TEST_MESSAGE("bicubic function, boundary included: " << error << " (tolerance 1e-13)");
  BOOST_TEST(error < 1e-13);
  const double smallest = prolongation_error(Grid{6, 6, -1, 1, -1, 1}, bicubic, Polynomial(3, random));
  BOOST_TEST_MESSAGE("four nodes each way, the fewest allowed: " << smallest);
  BOOST_TEST(smallest < 1e-13);
  // Next to the boundary the error is largest: (1/2)(1/2)(3/2)(5/2)/24 h^4 = 5/128 of a fourth derivative, compared
  // with 3/128 inside. The largest values are 16 f along x and 1.5^4 f along y.
  std::array<double, 3> edge{};
  for (int k = 0; k < 3; ++k) {
    const Grid grid{32 << k, 32 << k, -1, 1, -1, 1};
    edge[static_cast<std::size_t>(k)] =
        prolongation_error(grid, bicubic, [](double X, double) { return std::pow(X, 4); });
    const double theory = 5.0 / 128.0 * 24.0 * std::pow(coarsened(grid).hx(), 4);
    BOOST_TEST_MESSAGE("X^4 on " << grid.nx << " cells: " << edge[static_cast<std::size_t>(k)] << ", theory " << theory
                                 << " (to 1e-6)");
    BOOST_TEST(std::abs(edge[static_cast<std::size_t>(k)] / theory - 1.0) < 1e-6);
  }
  // Away from the boundary, the largest error for the smooth function is 3/128 of both fourth derivatives.
  const auto interior_error = [](int n) {
    const Grid grid{n, n, -1, 1, -1, 1};
    Field fine(grid);
    transfer::prolong_bicubic(coarsened(grid), sampled(coarsened(grid), smooth), fine);
    double largest = 0.0;
    for (int i = 4; i <= n - 4; ++i)
      for (int j = 4; j <= n - 4; ++j) largest = std::max(largest, std::abs(fine(i, j) - smooth(grid.X(i), grid.Y(j))));
    return largest;
  };
  const double slope = std::log2(interior_error(64) / interior_error(128));
  const double constant = interior_error(128) / std::pow(4.0 / 128.0, 4) / (3.0 / 128.0 * (16.0 + 5.0625));
  BOOST_TEST_MESSAGE("bicubic, inside: order " << slope << " (4 +- 0.1), constant over theory " << constant
                                               << " (0.9 to 1.05)");
  BOOST_TEST(std::abs(slope - 4.0) < 0.1);
  BOOST_TEST((constant > 0.9 && constant < 1.05));
}

BOOST_AUTO_TEST_CASE(the_lower_half_of_a_symmetric_domain_is_treated_as_the_whole) {
  using ehl::tests::difference_of_half;
  using ehl::tests::symmetric_field;
  const Grid fine{24, 32, -3, 1.5, -2, 2};
  const Grid coarse = coarsened(fine);
  const ehl::core::Patch half_fine = ehl::core::lower_half(fine);
  const Patch half_coarse = coarsened(half_fine);
  Random random(5);
  const auto down = symmetric_field(fine, random, -1.0, 1.0);
  const auto up = symmetric_field(coarse, random, -1.0, 1.0);
  const auto check = [](const char* what, const Grid& grid, const Field& whole, const Field& half) {
    const double difference = difference_of_half(grid, whole, half);
    BOOST_TEST_MESSAGE(what << ": difference " << difference << " (tolerance 1e-15)");
    BOOST_TEST(difference < 1e-15);
  };
  Field whole(coarse);
  Field half(half_coarse);
  transfer::restrict_injection(down.whole, whole);
  transfer::restrict_injection(down.half, half);
  check("injection", coarse, whole, half);
  transfer::restrict_full_weighting(coarse, down.whole, whole);
  transfer::restrict_full_weighting(half_coarse, down.half, half);
  check("full weighting", coarse, whole, half);
  Field finer(fine);
  Field finer_half(half_fine);
  transfer::prolong_bilinear(up.whole, finer, 1);
  transfer::prolong_bilinear(up.half, finer_half, 1);
  check("bilinear", fine, finer, finer_half);
  transfer::prolong_bicubic(coarse, up.whole, finer);
  transfer::prolong_bicubic(half_coarse, up.half, finer_half);
  check("bicubic", fine, finer, finer_half);
}

BOOST_AUTO_TEST_CASE(across_alone_stations_are_kept) {
  const Patch grid = coarsened_across(Patch(fine_grid));
  BOOST_TEST((grid.nx == fine_grid.nx && grid.ny == fine_grid.ny / 2 && grid.hy() == 2.0 * fine_grid.hy()));
  Random random(7);
  const Polynomial in_all(1, random);
  const Field coarse = sampled(grid, in_all);
  const Field fine = sampled(Patch(fine_grid), in_all);
  Field injected(grid), weighted(grid), back(fine_grid);
  transfer::restrict_injection(fine, injected);
  transfer::restrict_full_weighting(grid, fine, weighted);
  transfer::prolong_bilinear(coarse, back, 1);
  BOOST_TEST(ehl::core::max_abs_difference(injected, coarse) < 1e-14);
  BOOST_TEST(ehl::core::max_abs_difference(weighted, coarse) < 1e-14);
  BOOST_TEST(ehl::core::max_abs_difference(back, fine) < 1e-14);
  // A part that alternates along Y is averaged out, one that alternates along X is not.
  const auto wave = [](double X, double) { return std::cos(std::numbers::pi * (X - fine_grid.X_a) / fine_grid.hx()); };
  const auto rough = [](double, double Y) { return std::cos(std::numbers::pi * (Y - fine_grid.Y_a) / fine_grid.hy()); };
  transfer::restrict_full_weighting(grid, sampled(Patch(fine_grid), wave), weighted);
  BOOST_TEST(ehl::core::max_abs_difference(weighted, sampled(grid, wave)) < 1e-13);
  transfer::restrict_full_weighting(grid, sampled(Patch(fine_grid), rough), weighted);
  double largest = 0.0;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j) largest = std::max(largest, std::abs(weighted(i, j)));
  BOOST_TEST(largest < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
