// A film sheared by sliding and by pressure flow, compared with closed forms for Eyring's law, with the power law, and
// with prescribed stresses integrated by Simpson's rule.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "rheology/thinned_by_flow.hpp"

BOOST_AUTO_TEST_SUITE(test_rheology_flow_thinning)

using namespace ehl::rheology;
using ehl::core::broadcast;

namespace {

struct Ratios {
  double along, across, stress;
};
// Rates S and flows Q in tau_c/eta: k_m = 1, H fluidity = 1.
Ratios at(const ShearLaw& law, double S, double Q_x, double Q_y) {
  const FlowThinned found =
      thinned_by_flow({.law = law, .k_m = 1.0, .sliding = S}, broadcast(1.0), broadcast(Q_x), broadcast(Q_y));
  return {found.along[0], found.across[0], found.stress[0]};
}
double off(double value, double exact) { return std::abs(value / exact - 1.0); }

// F(tau), by bisection of tau = rate eta/eta_0.
double rate_of(const ShearLaw& law, double tau) {
  double low = 0.0, high = 1.0;
  while (high * thinned(law, high).across < tau) high *= 2.0;
  for (int n = 0; n < 100; ++n) {
    const double middle = 0.5 * (low + high);
    (middle * thinned(law, middle).across < tau ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

struct Moments {
  double mean_x = 0, mean_y = 0, Q_x = 0, Q_y = 0;
};
Moments moments(const ShearLaw& law, double t_x, double t_y, double g_x, double g_y) {
  constexpr int n = 400;
  Moments sum;
  for (int k = 0; k <= n; ++k) {
    const double weight = (k == 0 || k == n ? 1.0 : (k % 2 ? 4.0 : 2.0)) / (3.0 * n), s = double(k) / n - 0.5;
    const double x = t_x + s * g_x, y = t_y + s * g_y, tau = std::hypot(x, y);
    const double secant = tau > 0.0 ? weight * rate_of(law, tau) / tau : weight;
    sum.mean_x += secant * x;
    sum.mean_y += secant * y;
    sum.Q_x += s * secant * x;
    sum.Q_y += s * secant * y;
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(eyring_closed_form) {
  // sinh(t + s g) integrated: with sliding along the flow, and without sliding.
  for (const double t : {0.0, 0.3, 3.0, 10.0})
    for (const double g : {0.1, 1.0, 6.0, 15.0}) {
      const double S = std::sinh(t) * std::sinh(g / 2) / (g / 2);
      const double Q = std::cosh(t) * (std::cosh(g / 2) / g - 2 * std::sinh(g / 2) / (g * g));
      const Ratios found = at(Eyring{}, S, Q, 0.0);
      const double along = 12 * Q / g / std::hypot(1.0, S);
      BOOST_TEST_MESSAGE("t = " << t << ", g = " << g << ": mobility over that of sliding alone " << found.along
                                << ", exact " << along << ", off " << off(found.along, along)
                                << " (tolerance 1e-6, or 5e-5 where the stress turns by 15 tau_c: eight points)");
      const double tolerance = g > 10.0 ? 5e-5 : 1e-6;
      BOOST_TEST(off(found.along, along) < tolerance);
      if (t > 0.0) BOOST_TEST(off(found.stress, t / std::asinh(S)) < tolerance);
    }
}

BOOST_AUTO_TEST_CASE(newtonian_limits) {
  const std::vector<ShearLaw> laws{Eyring{}, Carreau{0.4}, Carreau{1.0}};
  for (const ShearLaw& law : laws)
    for (const double Q : {0.0, 1e-9, 1e-5, 1e-4}) {
      const Ratios found = at(law, 0.0, Q, 0.5 * Q);
      for (const double ratio : {found.along, found.across, found.stress}) BOOST_TEST(std::abs(ratio - 1) < 2e-7);
    }
  const Ratios linear = at(Carreau{1.0}, 7.0, 30.0, 50.0);
  for (const double ratio : {linear.along, linear.across, linear.stress}) BOOST_TEST(std::abs(ratio - 1) < 1e-12);
}

BOOST_AUTO_TEST_CASE(power_law_of_a_plane_flow) {
  // Far above tau_c the law is rate = tau^(1/n): Q = 2 g^(1/n) (1/2)^(2 + 1/n)/(2 + 1/n).
  const double n = 0.4, g = 200.0, m = 1.0 / n;
  const double Q = 2 * std::pow(g, m) * std::pow(0.5, 2 + m) / (2 + m);
  const Ratios found = at(Carreau{n}, 0.0, Q, 0.0);
  BOOST_TEST_MESSAGE("mobility " << found.along << ", power law " << 12 * Q / g);
  BOOST_TEST(off(found.along, 12 * Q / g) < 2e-3);  // in the middle of the film the stress is below tau_c
}

BOOST_AUTO_TEST_CASE(stresses_in_any_direction) {
  const std::vector<ShearLaw> laws{Eyring{}, Carreau{0.5}};
  for (const ShearLaw& law : laws)
    for (const auto& [t, g_x, g_y] : {std::array{0.0, 3.0, 4.0}, {2.0, 0.0, 6.0}, {2.0, 3.0, 4.0}, {6.0, 5.0, -8.0}}) {
      double low = -20.0, high = 20.0;  // no sliding in the transverse direction
      for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (moments(law, t, middle, g_x, g_y).mean_y < 0.0 ? low : high) = middle;
      }
      const Moments exact = moments(law, t, low, g_x, g_y);
      const Ratios found = at(law, exact.mean_x, exact.Q_x, exact.Q_y);
      const Thinned alone = thinned(law, exact.mean_x);
      const double along = 12 * exact.Q_x / g_x * alone.along, across = 12 * exact.Q_y / g_y * alone.across;
      BOOST_TEST_MESSAGE("t = " << t << ", g = " << g_x << ", " << g_y << ": along " << found.along << " (" << along
                                << "), across " << found.across << " (" << across << "), stress " << found.stress);
      if (g_x > 0.0) BOOST_TEST(off(found.along, along) < 1e-5);
      BOOST_TEST(off(found.across, across) < 1e-5);
      if (t > 0.0) BOOST_TEST(off(found.stress, t / (exact.mean_x * alone.across)) < 1e-5);
    }
}

BOOST_AUTO_TEST_SUITE_END()
