// Gaussian filters: a wave with the length of the cut-off is halved, and the form of a roller is not changed.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "surface/gaussian_filter.hpp"

BOOST_AUTO_TEST_SUITE(test_surface_gaussian_filter)

using namespace ehl::surface;

namespace {

constexpr double pi = std::numbers::pi;

// The remaining amplitude of cos(2 pi x/length) at x = 0, the middle of a trace with unequal distances.
double left_of(double length, double cut_off) {
  std::vector<double> x, z;
  for (int k = -400; k <= 400; ++k) x.push_back(0.02 * k + 0.004 * std::sin(1.7 * k));
  for (const double at : x) z.push_back(std::cos(2.0 * pi * at / length));
  const std::vector<double> filtered = long_waves(x, z, cut_off);
  return filtered[400];
}

}  // namespace

// source: ISO 16610-31, second order: (1 + pi b^2) exp(-pi b^2), b = 0.7309 cut-off/wavelength.
BOOST_AUTO_TEST_CASE(a_wave_of_the_cut_off_keeps_half_of_its_height) {
  BOOST_TEST(std::abs(left_of(1.0, 1.0) - 0.5) < 1e-3);
  for (const double ratio : {0.5, 2.0}) {
    const double b = 0.7309 * ratio, wanted = (1.0 + pi * b * b) * std::exp(-pi * b * b);
    BOOST_TEST_MESSAGE("cut-off over wavelength " << ratio << ": " << left_of(1.0, ratio) << ", wanted " << wanted);
    BOOST_TEST(std::abs(left_of(1.0, ratio) - wanted) < 2e-3);
  }
}

BOOST_AUTO_TEST_CASE(parabolas_pass_to_their_ends) {
  std::vector<double> x, z;
  for (int k = 0; k <= 200; ++k) x.push_back(0.01 * k + 0.003 * std::cos(0.9 * k));
  for (const double at : x) z.push_back(3.0 - 2.0 * at + 40.0 * at * at);
  const std::vector<double> filtered = long_waves(x, z, 0.3);
  double apart = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) apart = std::max(apart, std::abs(filtered[k] - z[k]));
  BOOST_TEST_MESSAGE("largest change of a parabola " << apart);
  BOOST_TEST(apart < 1e-9);
}

// source: ISO 16610-61, exp(-pi (0.4697 cut-off/wavelength)^2) in every direction.
BOOST_AUTO_TEST_CASE(a_map_keeps_half_of_a_wave_in_every_direction) {
  constexpr int n = 121;
  constexpr double dx = 0.5, dy = 0.4, length = 6.0;
  for (const double angle : {0.0, 45.0, 90.0}) {
    const double c = std::cos(angle * pi / 180.0), s = std::sin(angle * pi / 180.0);
    Heights heights{n, n, std::vector<double>(n * n)};
    for (int l = 0; l < n; ++l)
      for (int k = 0; k < n; ++k)
        heights(k, l) = std::cos(2.0 * pi * (c * dx * (k - n / 2) + s * dy * (l - n / 2)) / length);
    const double half = long_waves(heights, dx, dy, length)(n / 2, n / 2);
    const double quarter = long_waves(heights, dx, dy, length * std::sqrt(2.0))(n / 2, n / 2);
    BOOST_TEST_MESSAGE(angle << " degrees: " << half << ", " << quarter);
    BOOST_TEST(std::abs(half - 0.5) < 1e-6);
    BOOST_TEST(std::abs(quarter - 0.25) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(a_constant_map_stays_at_its_edges) {
  const Heights ones{20, 15, std::vector<double>(300, 1.0)};
  const Heights filtered = long_waves(ones, 1.0, 2.0, 7.0);
  for (const double z : filtered.values) BOOST_TEST(std::abs(z - 1.0) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
