// A ball and a roller on their races: radii, speeds, loads.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

#include "core/constants.hpp"
#include "machines/bearing.hpp"

using namespace ehl::machines;
using ehl::core::pi;
using ehl::core::unknown;

namespace {

void check(const char* what, double computed, double expected, double tolerance = 1e-14) {
  const double error = std::abs(computed - expected) / std::max(1.0, std::abs(expected));
  BOOST_TEST_MESSAGE(what << " = " << computed << ", expected " << expected << ", difference " << error);
  BOOST_TEST(error <= tolerance, what << " = " << computed << ", expected " << expected);
}

// 6206: ball 9.525 mm, pitch circle 46 mm. In mm, so that the digits are those of a hand calculation.
const Bearing inner{9.525, 46.0};
const Bearing outer{9.525, 46.0, 0.0, Race::outer};

}  // namespace

BOOST_AUTO_TEST_SUITE(test_bearing_gear)

// By hand, with 30 digits of `bc`:
//   gamma = 9.525/46 = 0.2070652173913043478
//   inner race (46 - 9.525)/2 = 18.2375, R_x = 9.525 (1 - gamma)/2 = 3.7763519021739130435
//   outer race 27.7625,                  R_x = 9.525 (1 + gamma)/2 = 5.7486480978260869565
//   R_y = 9.525 * 0.52/(2*0.52 - 1) = 123.825; R_x/R_y = 0.030497491
BOOST_AUTO_TEST_CASE(radii_of_6206) {
  check("gamma", gamma(inner), 0.2070652173913043478);
  check("inner race", race_radius(inner), 18.2375);
  check("outer race", race_radius(outer), 27.7625);
  check("R_x inner", radius_along(inner), 3.7763519021739130435);
  check("R_x outer", radius_along(outer), 5.7486480978260869565);
  check("R_y", radius_across(9.525, 0.52), 123.825);
}

// The principal curvatures of ball and race, with a contact angle: gamma = 9.525 cos(40)/46.
BOOST_AUTO_TEST_CASE(radii_with_a_contact_angle) {
  const double cosine = std::cos(40.0 * pi / 180.0);
  const Bearing angular{9.525, 46.0, 40.0, Race::inner};
  // The normal at the contact meets the bearing axis; its length is the radius of the race.
  const double distance = 0.5 * (46.0 - 9.525 * cosine);
  check("race", race_radius(angular), distance / cosine);
  check("R_x", 1.0 / radius_along(angular), 2.0 / 9.525 + cosine / distance);
}

// By hand: 3000/min inside: cage 3000 (1 - gamma)/2 = 1189.4021739130435/min,
//   u = pi/120 * 0.046 m * (1 - gamma^2) * 3000 = 3.4579277706541630475 m/s.
BOOST_AUTO_TEST_CASE(speeds_of_6206) {
  const Turning turning = complete({3000.0, 0.0, unknown}, gamma(inner));
  check("cage", turning.cage, 1189.4021739130434783);
  const Bearing in_metres{9.525e-3, 46e-3};
  check("u", rolling_speed(in_metres, turning), 3.4579277706541630475);
}

// A ball rolls on both races at the same speed, whichever ring turns; any two of the three speeds determine the third.
BOOST_AUTO_TEST_CASE(pure_rolling) {
  const double g = gamma(inner);
  for (const auto& [n_i, n_o] : {std::pair{3000.0, 0.0}, {0.0, 1200.0}, {500.0, -700.0}, {-800.0, -900.0}}) {
    const Turning all = complete({n_i, n_o, unknown}, g);
    const double u = rolling_speed(inner, all);
    check("both races", rolling_speed(outer, all), u, 1e-13);
    check("inner from cage and outer", complete({unknown, n_o, all.cage}, g).inner, n_i, 1e-13);
    check("outer from cage and inner", complete({n_i, unknown, all.cage}, g).outer, n_o, 1e-13);
    // Relative to the cage, the ball spins with u divided by its radius, and its point at the outer race moves with
    // that ring: the speeds of the rings at the contacts are the cage speed plus or minus the spin.
    const double at_inner = pi / 60.0 * n_i * (46.0 - 9.525), at_outer = pi / 60.0 * n_o * (46.0 + 9.525);
    check("centre of the ball", 0.5 * (at_inner + at_outer), pi / 60.0 * all.cage * 46.0, 1e-13);
    check("u", u, std::abs(at_inner - pi / 60.0 * all.cage * (46.0 - 9.525)), 1e-13);
  }
}

// By hand, for 9 balls with one in the load direction: Z/sum cos^(5/2) over 0, +-40, +-80 degrees = 9/(1 + 1.0272234 +
// 0.0251307) = 4.3852080236186246584; with exponent 10/9 for rollers, cos^(19/9): 4.1113737886246557631.
BOOST_AUTO_TEST_CASE(largest_load) {
  const auto factor = [](int Z, double n) { return Z * element_loads({1.0, Z, 0.0, n}).front(); };
  check("9 balls", factor(9, exponent_of_balls), 4.3852080236186246584, 1e-13);
  check("9 rollers", factor(9, exponent_of_rollers), 4.1113737886246557631, 1e-13);
  // For many elements: Stribeck's integral, 2 pi divided by that of cos^(n+1) from -pi/2 to pi/2, which is sqrt(pi)
  // Gamma(n/2 + 1)/Gamma(n/2 + 3/2).
  for (const double n : {exponent_of_balls, exponent_of_rollers}) {
    const double integral = std::sqrt(pi) * std::tgamma(0.5 * n + 1.0) / std::tgamma(0.5 * n + 1.5);
    check("many", factor(100000, n), 2.0 * pi / integral, 1e-9);
  }
  check("many balls", factor(100000, exponent_of_balls), 4.370, 2e-4);
  check("many rollers", factor(100000, exponent_of_rollers), 4.08, 2e-3);  // published for an exponent of 1.11
}

// Wherever the balls are, their loads balance the radial load and correspond to one displacement of the ring.
BOOST_AUTO_TEST_CASE(equilibrium) {
  for (const int Z : {3, 4, 8, 9, 14})
    for (double azimuth = -180.0; azimuth <= 180.0; azimuth += 7.5)
      for (const double n : {exponent_of_balls, exponent_of_rollers}) {
        const std::vector<double> Q = element_loads({800.0, Z, azimuth, n});
        double along = 0.0, across = 0.0;
        for (int j = 0; j < Z; ++j) {
          const double psi = azimuth * pi / 180.0 + 2.0 * pi * j / Z;
          along += Q[static_cast<std::size_t>(j)] * std::cos(psi);
          across += Q[static_cast<std::size_t>(j)] * std::sin(psi);
          BOOST_TEST(Q[static_cast<std::size_t>(j)] >= 0.0);
        }
        check("along", along, 800.0, 1e-13);
        check("across", across / 800.0, 0.0, 1e-13);
      }
  // Four balls at 45 degrees: two carry F_r/(2 cos 45) each.
  check("two of four", element_loads({1.0, 4, 45.0}).front(), std::sqrt(0.5), 1e-14);
  // One ball in the load direction between two at right angles to it, which a rigid ring does not load.
  check("one of four", element_loads({1.0, 4, 0.0}).front(), 1.0, 1e-14);
}

// The balls within the half circle in the load direction carry, except those at its ends; by hand.
BOOST_AUTO_TEST_CASE(how_many_carry) {
  const auto loaded = [](int Z, double azimuth) {
    int count = 0;
    for (const double Q : element_loads({1000.0, Z, azimuth})) count += Q > 0.0;
    return count;
  };
  BOOST_TEST(loaded(3, 0.0) == 1);   // 0; +-120 are on the other half
  BOOST_TEST(loaded(3, 60.0) == 2);  // +-60
  BOOST_TEST(loaded(4, 0.0) == 1);   // 0; not +-90
  BOOST_TEST(loaded(8, 0.0) == 3);   // 0, +-45
  BOOST_TEST(loaded(8, 22.5) == 4);  // +-22.5, +-67.5
  BOOST_TEST(loaded(9, 0.0) == 5);   // 0, +-40, +-80
  BOOST_TEST(loaded(12, 0.0) == 5);  // 0, +-30, +-60
  BOOST_TEST(loaded(12, 90.0) == 5);
  BOOST_TEST(loaded(1000, 0.0) == 499);
  BOOST_TEST(element_loads({1000.0, 8, 90.0}).front() == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
