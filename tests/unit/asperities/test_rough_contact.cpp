// The contact of a wavy cell against the exact solutions of Westergaard, Johnson, Greenwood and Higginson; and the
// contact of a Gaussian surface against what is known of its limits.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "asperities/rough_contact.hpp"
#include "asperities/roughness_numbers.hpp"
#include "random_map.hpp"

BOOST_AUTO_TEST_SUITE(test_asperity_contact)

using namespace ehl;
using asperities::Cell;
using asperities::CellContact;
using asperities::RoughCell;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double E_prime = 226e9, length = 100e-6, height = 0.2e-6;  // of the waves

// Heights at the points; a wave of the length `length`, of which the cell holds a half, so mirrored a whole one.
template <class Shape>
RoughCell wavy(int nx, int ny, Shape shape) {
  RoughCell rough{{nx, ny, 0.5 * length / nx, 0.5 * length / ny}, std::vector<double>(), E_prime, infinity, 1};
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) rough.z.push_back(height * shape(pi * (i + 0.5) / nx, pi * (j + 0.5) / ny));
  return rough;
}

CellContact pressed(const RoughCell& rough, double p, const std::vector<double>& start = {}) {
  CellContact contact = solve(rough, p, start, 1e-8, 2000);
  BOOST_TEST_MESSAGE(contact.iterations << " iterations, error " << contact.error);
  BOOST_TEST(contact.converged);
  return contact;
}

}  // namespace

// z = height cos(2 pi x/length), full contact at p* = pi E* height/length. With x = p/p*, the half width a is
// sin^2(pi a/length) = x, the pressure in the middle 2 p/sqrt(x), and the distance of the mean planes
// height (1 - x + x ln x). (Westergaard 1939; the distance follows from the elastic energy.)
BOOST_AUTO_TEST_CASE(a_wave_along_one_axis_is_westergaards) {
  const double full = pi * 0.5 * E_prime * height / length;
  for (const double x : {0.1, 0.5, 0.9}) {
    double errors[2][3];
    for (const int refined : {0, 1}) {
      const int n = 128 << refined;
      const CellContact contact = pressed(wavy(n, 2, [](double X, double) { return std::cos(X); }), x * full);
      errors[refined][0] = contact.area / (2.0 / pi * std::asin(std::sqrt(x))) - 1.0;
      errors[refined][1] = contact.p[0] / (2.0 * x * full / std::sqrt(x)) - 1.0;
      errors[refined][2] = contact.separation / (height * (1.0 - x + x * std::log(x))) - 1.0;
    }
    BOOST_TEST_MESSAGE("p/p* = " << x << ": errors on 128 and 256 points: area " << errors[0][0] << ", " << errors[1][0]
                                 << " (tolerance two points, then " << 0.02 << "), largest pressure " << errors[0][1]
                                 << ", " << errors[1][1] << " (1e-2), separation " << errors[0][2] << ", "
                                 << errors[1][2] << " (1e-2)");
    BOOST_TEST(std::abs(errors[1][0]) < 0.02);
    BOOST_TEST(std::abs(errors[1][1]) < 1e-2);
    BOOST_TEST(std::abs(errors[1][2]) < 1e-2);
  }
}

// z = height cos(2 pi x/length) cos(2 pi y/length), full contact at p* = sqrt(2) pi E* height/length. Light loads: two
// Hertzian contacts per cell, area pi (3 p/(8 pi p*))^(2/3). Near full contact the open area is (3/(2 pi)) (1 - p/p*).
// (Johnson, Greenwood and Higginson 1985, Int. J. Mech. Sci. 27, 383)
BOOST_AUTO_TEST_CASE(waves_along_both_axes_have_their_two_limits) {
  const double full = std::sqrt(2.0) * pi * 0.5 * E_prime * height / length;
  const RoughCell rough = wavy(128, 128, [](double X, double Y) { return std::cos(X) * std::cos(Y); });
  const CellContact light = pressed(rough, 0.005 * full), heavy = pressed(rough, 0.97 * full);
  const double hertz = pi * std::pow(3.0 * 0.005 / (8.0 * pi), 2.0 / 3.0), open = 1.5 / pi * 0.03;
  BOOST_TEST_MESSAGE("area at p/p* = 0.005: " << light.area << ", Hertz " << hertz
                                              << " (tolerance 5 %); open area at 0.97: " << 1.0 - heavy.area
                                              << ", exact " << open << " (tolerance 15 %)");
  BOOST_TEST(std::abs(light.area / hertz - 1.0) < 0.05);
  BOOST_TEST(std::abs((1.0 - heavy.area) / open - 1.0) < 0.15);
  const CellContact closed = pressed(rough, 1.05 * full);
  BOOST_TEST_MESSAGE("above p*: area " << closed.area << ", separation over height " << closed.separation / height);
  BOOST_TEST(closed.area == 1.0);
  BOOST_TEST(std::abs(closed.separation) < 1e-7 * height);
}

// The mean pressure is minus the derivative of the elastic energy with respect to the separation, on any surface.
BOOST_AUTO_TEST_CASE(a_gaussian_surface_keeps_energy_load_and_conditions) {
  const Cell cell{128, 128, 1e-6, 1e-6};
  RoughCell rough{cell, support::random_heights(cell, 0.3e-6, 64e-6, 8e-6, 3.6, 1.0, 7), E_prime, infinity, 1};
  const auto numbers = asperities::roughness_numbers(cell, rough.z);
  const double unit = 0.5 * E_prime * numbers.slope;
  const auto energy = [&](const CellContact& contact) {  // (1/2) p u per area, u = gap - separation + z
    double sum = 0.0;
    for (std::size_t n = 0; n < contact.p.size(); ++n)
      sum += 0.5 * contact.p[n] * (contact.gap[n] - contact.separation + rough.z[n]);
    return sum / static_cast<double>(contact.p.size());
  };
  const CellContact lower = pressed(rough, 0.0099 * unit), at = pressed(rough, 0.01 * unit, lower.p),
                    upper = pressed(rough, 0.0101 * unit, at.p);
  const double p = -(energy(upper) - energy(lower)) / (upper.separation - lower.separation);
  BOOST_TEST_MESSAGE("-dU/dh over the mean pressure: " << p / (0.01 * unit) << " (tolerance 1e-3)");
  BOOST_TEST(std::abs(p / (0.01 * unit) - 1.0) < 1e-3);
  // At light loads the area is from sqrt(8/pi) (Persson) to sqrt(2 pi) (Bush, Gibson and Thomas) times p/(E* slope).
  const double share = at.area / 0.01;
  BOOST_TEST_MESSAGE("area over p/(E* slope): " << share << " (1.6 to 2.51)");
  BOOST_TEST((share > 1.59 && share < 2.51));
  // The hardness bounds the pressure, the yielded points overlap, and the load is kept.
  rough.hardness = 0.3 * unit;
  const CellContact yielded = pressed(rough, 0.05 * unit);
  double mean = 0.0, most = 0.0;
  for (const double one : yielded.p) {
    mean += one / static_cast<double>(yielded.p.size());
    most = std::max(most, one);
  }
  BOOST_TEST_MESSAGE("with a hardness: mean pressure " << mean / (0.05 * unit) << ", largest over hardness "
                                                       << most / rough.hardness << ", yielded " << yielded.yielded);
  BOOST_TEST(std::abs(mean / (0.05 * unit) - 1.0) < 1e-10);
  BOOST_TEST(most <= rough.hardness);
  BOOST_TEST(yielded.yielded > 0.0);
  BOOST_TEST(yielded.film > yielded.separation);
  // All of the load at the hardness: the area is the mean pressure over it.
  rough.hardness = 0.02 * unit;
  const CellContact soft = pressed(rough, 0.002 * unit);
  BOOST_TEST_MESSAGE("soft: area over p/hardness " << soft.area / 0.1 << " (1 to 1.3)");
  BOOST_TEST((soft.area > 0.0999 && soft.area < 0.13));
}

BOOST_AUTO_TEST_SUITE_END()
