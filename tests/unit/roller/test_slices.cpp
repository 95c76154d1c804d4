// A roller divided into slices, compared with closed forms.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "contact/ellipse.hpp"
#include "effects/roller/slices.hpp"

using namespace ehl::roller;
using boost::test_tools::tolerance;

namespace {

constexpr double slice = 1.0 / 4000.0;  // of the length: the accuracy of a length

Profile flat(double length) {
  return {.shape = Profile::Shape::straight, .length = length, .end_length = 0.0, .end_radius = 1.0};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_roller_slices)

// Under p = sqrt(1 - x^2) on a strip from -l/2 to l/2, H/(a^2/R) = (1/2 pi) int int p/r. For l much larger than 1 this
// is (1/2 pi) int p 2 ln(l/|x|) dx, and by parts int sqrt(1 - x^2) ln|x| dx = -(pi/2)(ln 2 + 1/2). Here the exact
// integral over y, 2 asinh(l/(2 |x|)), is summed over x.
BOOST_AUTO_TEST_CASE(approach_of_a_line_contact) {
  for (const double length : {20.0, 100.0, 1000.0}) {
    constexpr int parts = 100000;
    double sum = 0.0;
    for (int k = 0; k < parts; ++k) {
      const double x = (k + 0.5) / parts;
      sum += 2.0 * std::sqrt(1.0 - x * x) * 2.0 * std::asinh(0.5 * length / x) / parts;
    }
    BOOST_TEST(ehl::contact::roller_contact(length).approach == sum / (2.0 * M_PI), tolerance(2e-4));
  }
}

BOOST_AUTO_TEST_CASE(straight_roller_bears_everywhere) {
  const Bearing found = bearing(flat(40.0));
  BOOST_TEST(found.length == 40.0, tolerance(1e-12));
  BOOST_TEST(found.heaviest == 1.0, tolerance(1e-12));
  BOOST_TEST(found.at_ends == 1.0, tolerance(1e-12));
}

// The Hertz ellipse with the same load: a^3 = (3/2) F R/E' for the circle, a^2 = (8/pi) F R/(E' length) for the line.
BOOST_AUTO_TEST_CASE(half_width_of_a_crown) {
  for (const double length : {20.0, 40.0, 160.0})
    for (const double radius : {5.0, 10.0, 20.0, 50.0, 200.0}) {
      Profile profile = flat(length);
      profile.shape = Profile::Shape::crowned;
      profile.crown_radius = radius;
      const Bearing found = bearing(profile);
      if (found.length > 0.95 * length || found.length < 0.1 * length) continue;
      const double circle = std::cbrt(1.5 * M_PI / 8.0 * length);
      const double hertz = circle * ehl::contact::ellipse(1.0 / radius).a;
      BOOST_TEST_MESSAGE("length " << length << ", crown " << radius << ": " << found.widest << " of " << hertz);
      BOOST_TEST(found.widest > 0.97 * hertz);
      BOOST_TEST(found.widest < 1.12 * hertz);
    }
}

// A crown with radius r carries load up to sqrt(2 r d) on both sides at the approach d: (4/3) d sqrt(2 r d) = c length.
BOOST_AUTO_TEST_CASE(crown) {
  for (const double radius : {1.0, 10.0, 50.0}) {
    Profile profile = flat(60.0);
    profile.shape = Profile::Shape::crowned;
    profile.crown_radius = radius;
    const double mean = ehl::contact::roller_contact(60.0).approach;
    const double approach = std::pow(0.75 * mean * 60.0 / std::sqrt(2.0 * radius), 2.0 / 3.0);
    const Bearing found = bearing(profile);
    BOOST_TEST(found.length == 2.0 * std::sqrt(2.0 * radius * approach), tolerance(4.0 * slice * 60.0 / found.length));
    BOOST_TEST(found.heaviest == approach / mean, tolerance(1e-4));
    BOOST_TEST(found.at_ends == 0.0);
    // A tilt moves the lowest point of the crown by radius times tilt, and changes nothing else.
    profile.tilt = 3.0 / radius;
    BOOST_TEST(bearing(profile).length == found.length, tolerance(4.0 * slice * 60.0 / found.length));
    BOOST_TEST(bearing(profile).heaviest == found.heaviest, tolerance(1e-3));
  }
}

// A straight roller that touches with one end: the load is on a wedge, tilt l^2/2 = c length.
BOOST_AUTO_TEST_CASE(wedge) {
  for (const double tilt : {0.5, -5.0}) {
    Profile profile = flat(60.0);
    profile.tilt = tilt;
    const double mean = ehl::contact::roller_contact(60.0).approach,
                 length = std::sqrt(2.0 * mean * 60.0 / std::abs(tilt));
    const Bearing found = bearing(profile);
    BOOST_TEST(found.length == length, tolerance(4.0 * slice * 60.0 / length));
    BOOST_TEST(found.heaviest == std::abs(tilt) * length / mean, tolerance(4.0 * slice * 60.0 / length));
  }
}

BOOST_AUTO_TEST_SUITE_END()
