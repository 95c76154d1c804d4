// Measured maps: the plane that is removed, the taper, symmetry.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "support/random.hpp"
#include "surface/height_map.hpp"

BOOST_AUTO_TEST_SUITE(test_surface_height_map)

using namespace ehl::surface;

namespace {

constexpr double pi = std::numbers::pi;

template <class Function>
Heights heights_of(int nx, int ny, Function function) {
  Heights heights{nx, ny, std::vector<double>(static_cast<std::size_t>(nx * ny))};
  for (int l = 0; l < ny; ++l)
    for (int k = 0; k < nx; ++k) heights(k, l) = function(k, l);
  return heights;
}

double largest(const Heights& heights) {
  double value = 0.0;
  for (const double z : heights.values) value = std::max(value, std::abs(z));
  return value;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_plane_is_taken_away_to_the_last_bit_of_it) {
  // Odd and even numbers of points, so that the centre is a point in one case and not in the other.
  Heights plane = heights_of(31, 18, [](int k, int l) { return 7.0 + 0.25 * (k - 15) - 0.5 * (l - 8.5); });
  const Plane taken = level(plane);
  BOOST_TEST_MESSAGE("mean " << taken.mean << ", slopes " << taken.slope_x << ", " << taken.slope_y << "; left "
                             << largest(plane));
  BOOST_TEST(std::abs(taken.mean - 7.0) < 1e-13);
  BOOST_TEST(std::abs(taken.slope_x - 0.25) < 1e-14);
  BOOST_TEST(std::abs(taken.slope_y + 0.5) < 1e-14);
  BOOST_TEST(largest(plane) < 1e-13);
}

BOOST_AUTO_TEST_CASE(what_is_left_is_orthogonal_to_every_plane) {
  ehl::tests::Random random(7);
  Heights heights = heights_of(24, 37, [&](int, int) { return random.between(-1.0, 3.0); });
  level(heights);
  double sum = 0.0, with_x = 0.0, with_y = 0.0;
  for (int l = 0; l < heights.ny; ++l)
    for (int k = 0; k < heights.nx; ++k) {
      sum += heights(k, l);
      with_x += k * heights(k, l);
      with_y += l * heights(k, l);
    }
  BOOST_TEST_MESSAGE("moments " << sum << ", " << with_x << ", " << with_y << " (allowed 1e-9)");
  BOOST_TEST(std::abs(sum) < 1e-9);
  BOOST_TEST(std::abs(with_x) < 1e-9);
  BOOST_TEST(std::abs(with_y) < 1e-9);
  // A second levelling removes nothing.
  const Heights once = heights;
  level(heights);
  double apart = 0.0;
  for (std::size_t n = 0; n < once.values.size(); ++n)
    apart = std::max(apart, std::abs(once.values[n] - heights.values[n]));
  BOOST_TEST(apart < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_taper_ends_at_zero_and_leaves_the_inside_alone) {
  // 41 x 21 points with a quarter of each side tapered: ten steps along x and five along y.
  Heights ones = heights_of(41, 21, [](int, int) { return 1.0; });
  taper(ones, 0.25);
  double worst = 0.0;
  for (int l = 0; l < 21; ++l)
    for (int k = 0; k < 41; ++k) {
      const double sx = std::min({k, 40 - k, 10}) / 10.0;
      const double sy = std::min({l, 20 - l, 5}) / 5.0;
      const double wanted = std::pow(std::sin(0.5 * pi * sx), 2) * std::pow(std::sin(0.5 * pi * sy), 2);
      worst = std::max(worst, std::abs(ones(k, l) - wanted));
    }
  BOOST_TEST_MESSAGE("largest error of the window " << worst);
  BOOST_TEST(worst < 1e-15);
  BOOST_TEST(ones(0, 10) == 0.0);
  BOOST_TEST(ones(20, 10) == 1.0);
  Heights untouched = heights_of(9, 9, [](int k, int l) { return k + 2.0 * l; });
  const Heights before = untouched;
  taper(untouched, 0.0);
  BOOST_TEST((untouched.values == before.values));
}

BOOST_AUTO_TEST_CASE(root_of_the_mean_square_of_a_wave) {
  // Over whole waves the mean square of a cosine is a^2/2.
  const Heights wave = heights_of(64, 16, [](int k, int) { return 3.0 * std::cos(2.0 * pi * k / 16.0); });
  BOOST_TEST(std::abs(rms(wave) - 3.0 / std::numbers::sqrt2) < 1e-14);
}

BOOST_AUTO_TEST_CASE(symmetry_of_a_map) {
  const auto bowl = [](int, int l) { return (l - 9.5) * (l - 9.5); };
  BOOST_TEST(symmetric(HeightMap{.gap = heights_of(12, 20, bowl), .dx = 0.1, .dy = 0.1}));
  BOOST_TEST(!symmetric(HeightMap{.gap = heights_of(12, 20, bowl), .dx = 0.1, .dy = 0.1, .Y = 0.05}));
  const auto skew = [&](int k, int l) { return bowl(k, l) + 1e-6 * l; };
  BOOST_TEST(!symmetric(HeightMap{.gap = heights_of(12, 20, skew), .dx = 0.1, .dy = 0.1}));
}

BOOST_AUTO_TEST_SUITE_END()
