// Cams against flat tappets, and the dry impact.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "core/constants.hpp"
#include "machines/cam.hpp"
#include "machines/impact.hpp"

using namespace ehl::machines;

namespace {

constexpr double pi = ehl::core::pi, omega = 100.0, half_lift = 5e-3, base = 20e-3;

double lift(double phi) { return half_lift * (1.0 - std::cos(phi)); }

// An eccentric disc from a table of its lift: s = e (1 - cos phi).
Cam eccentric(int rows) {
  std::vector<double> angles, lifts;
  for (int k = 0; k <= rows; ++k) {
    angles.push_back(2.0 * pi * k / rows);
    lifts.push_back(lift(angles.back()));
  }
  lifts.back() = lifts.front();
  return {.base_radius = base,
          .lift = periodic_spline(angles, lifts),
          .spring_force = 300.0,
          .spring_stiffness = 2e4,
          .mass = 0.4};
}

// The largest error of s" relative to e.
double error_of(const Cam& cam) {
  double worst = 0.0;
  for (int k = 0; k < 1000; ++k) {
    const double phi = 0.00628 * k;
    worst = std::max(worst, std::abs(state_at(cam, phi, omega).second / half_lift - std::cos(phi)));
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_cam_impact)

// An eccentric disc is a circle: R = r_b + e everywhere; u1 = omega R, u2 = omega e cos(phi), and the load is that of
// spring and inertia.
BOOST_AUTO_TEST_CASE(an_eccentric_disc_is_a_circle) {
  const Cam cam = eccentric(360);
  double worst = 0.0;
  for (const double phi : {0.0, 0.7, pi / 2, 3.0, pi, 4.4, 6.2, 8.0, -1.0}) {
    const CamState state = state_at(cam, phi, omega);
    const double e = half_lift * std::cos(phi), load = 300.0 + 2e4 * lift(phi) + 0.4 * omega * omega * e;
    worst = std::max({worst, std::abs(state.lift / half_lift - lift(phi) / half_lift),
                      std::abs(state.R / (base + half_lift) - 1.0),
                      std::abs(state.u2 - omega * e) / (omega * half_lift), std::abs(state.load / load - 1.0)});
    BOOST_TEST(state.u1 == omega * state.R);
  }
  // The spline's error of s" is h^2/12 of e.
  const double allowed = 1.01 * std::pow(pi / 180.0, 2) / 12.0;
  BOOST_TEST_MESSAGE("largest difference " << worst << " (allowed " << allowed << ")");
  BOOST_TEST(worst <= allowed);
}

BOOST_AUTO_TEST_CASE(the_curvature_is_of_second_order) {
  const double coarse = error_of(eccentric(90)), fine = error_of(eccentric(180)), order = std::log2(coarse / fine);
  const double estimate = error_of_second(eccentric(180)) / half_lift;
  BOOST_TEST_MESSAGE("errors of s\" " << coarse << ", " << fine << ": order " << order << " (1.9 to 2.1); estimated "
                                      << estimate << " (within a tenth)");
  BOOST_TEST((order >= 1.9 && order <= 2.1));
  BOOST_TEST(std::abs(estimate / fine - 1.0) <= 0.1);
}

// A lift (1 - x^2)^3 over a part of the revolution: s' and s" vanish at both ends, and outside is the base circle.
BOOST_AUTO_TEST_CASE(outside_of_its_table_is_the_base_circle) {
  const double end = 75.0 * pi / 180.0;
  std::vector<double> angles, lifts;
  for (int k = -75; k <= 75; ++k) {
    angles.push_back(k * pi / 180.0);
    lifts.push_back(half_lift * std::pow(1.0 - k * k / 5625.0, 3));
  }
  const Cam cam{.base_radius = base, .lift = clamped_spline(angles, lifts), .spring_force = 100.0};
  for (const double phi : {pi, -pi, 1.01 * end, -1.01 * end}) {
    BOOST_TEST(state_at(cam, phi, omega).R == base);
    BOOST_TEST(state_at(cam, phi, omega).load == 100.0);
  }
  double worst = 0.0;
  for (const double phi : {-1.2, -0.5, 0.0, 0.013, 0.9, 2.0 * pi + 0.3}) {
    const double turned = phi > 4.0 ? phi - 2.0 * pi : phi, x = turned / end, w = 1.0 - x * x;
    const double second = half_lift / (end * end) * 6.0 * w * (5.0 * x * x - 1.0);
    worst = std::max(worst, std::abs(state_at(cam, phi, omega).second - second) / half_lift);
  }
  BOOST_TEST_MESSAGE("largest difference of s\" " << worst << " of the half lift (allowed 5e-3)");
  BOOST_TEST(worst <= 5e-3);  // h^2/12 s"" = h^2/12 * 30 * 24/end^4 at the ends
}

// A ball of radius R on a plane: F = (2/3) E' sqrt(R) delta^(3/2), so delta = 1/((2/3) E' sqrt(R))^(2/3) under 1 N. The
// motion under this force is integrated in small steps.
BOOST_AUTO_TEST_CASE(dry_impact_by_integration) {
  const double m = 0.0329, v = 0.1, k = 2.0 / 3.0 * 226e9 * std::sqrt(0.01);
  const DryImpact impact = dry_impact(m, v, std::pow(k, -2.0 / 3.0));
  double x = 0.0, speed = v, t = 0.0, farthest = 0.0, load = 0.0;
  const double dt = impact.duration / 200000.0;
  const auto acceleration = [&](double at) { return at > 0.0 ? -k * std::pow(at, 1.5) / m : 0.0; };
  while (x >= 0.0) {  // leapfrog
    speed += 0.5 * dt * acceleration(x);
    x += dt * speed;
    speed += 0.5 * dt * acceleration(x);
    t += dt;
    farthest = std::max(farthest, x);
    load = std::max(load, -m * acceleration(x));
  }
  const double errors[] = {impact.approach / farthest - 1.0, impact.load / load - 1.0, impact.duration / t - 1.0,
                           0.5 * m * v * v / (0.4 * impact.load * impact.approach) - 1.0};
  BOOST_TEST_MESSAGE("load " << impact.load << " N, approach " << impact.approach << " m, duration " << impact.duration
                             << " s, " << impact.duration * v / impact.approach << " approach/velocity (2.9432)");
  BOOST_TEST(std::abs(impact.duration * v / impact.approach - 2.9432) < 1e-4);
  for (const double error : errors) BOOST_TEST(std::abs(error) <= 1e-5, "off by " << error << " (allowed 1e-5)");
}

BOOST_AUTO_TEST_SUITE_END()
