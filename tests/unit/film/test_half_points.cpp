// epsilon at half points: exact for an exponential viscosity, third order in the film; its derivatives.
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "film/half_points.hpp"
#include "support/random.hpp"

BOOST_AUTO_TEST_SUITE(test_half_points)

using ehl::film::AroundHalfPoint;

namespace {

/// Nodes of a Barus oil at the given pressures.
AroundHalfPoint<double> barus(double alpha_P0, double alpha_P1, std::array<double, 4> H = {1.0, 1.0, 1.0, 1.0}) {
  return {H, {1.0, 1.0}, {std::exp(-alpha_P0), std::exp(-alpha_P1)}, {alpha_P0, alpha_P1}};
}

/// The mean of e^-a for a linear change of a, by Simpson's rule with many intervals.
double mean_fluidity(double a0, double a1) {
  constexpr int steps = 2000;
  double sum = 0.0;
  for (int k = 0; k <= steps; ++k)
    sum += (k == 0 || k == steps ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) * std::exp(-(a0 + (a1 - a0) * k / steps));
  return sum / (3.0 * steps);
}

}  // namespace

// The flow of a Barus oil is exactly the difference of the reduced pressures: the mean fluidity over P.
BOOST_AUTO_TEST_CASE(the_logarithmic_mean_is_the_mean_of_an_exponential_fall) {
  double worst = 0.0;
  for (const double a0 : {0.0, 3.0, 12.0})
    for (const double d : {0.0, 1e-9, 0.005, 0.0099, 0.0101, 0.5, 4.0, -0.005, -2.0}) {
      const double exact = mean_fluidity(a0, a0 + d);
      worst = std::max(worst, std::abs(ehl::film::logarithmic_mean(barus(a0, a0 + d)) / exact - 1.0));
    }
  BOOST_TEST_MESSAGE("largest error " << worst << " (tolerance 2e-13: rounding of a difference of 0.01)");
  BOOST_TEST(worst < 2e-13);
}

BOOST_AUTO_TEST_CASE(a_film_of_third_degree_is_met_and_none_falls_below_half_the_mean) {
  const auto film = [](double x) { return 2.0 + x * (0.5 + x * (-0.3 + 0.1 * x)); };
  BOOST_TEST(std::abs(ehl::film::film_between(std::array{film(-1.5), film(-0.5), film(0.5), film(1.5)}) - 2.0) < 1e-14);
  BOOST_TEST(ehl::film::film_between(std::array{9.0, 0.1, 0.1, 9.0}) == 0.05);
  BOOST_TEST(ehl::film::film_between(std::array{0.5, -1.0, -1.0, 0.5}) == 0.0);
  // Next to a boundary: the mean of the two values.
  const double H = ehl::film::film_between(std::array{ehl::film::beyond_boundary(3.0, 2.0, 1.5), 3.0, 2.0, 1.5});
  BOOST_TEST(std::abs(H - 2.5) < 1e-15);
}

// The derivatives of the flux eps (P_1 - P_0) with respect to both pressures, compared with differences.
BOOST_AUTO_TEST_CASE(answers_are_the_slopes_of_the_flux_of_barus_oil) {
  constexpr double step = 1e-5;
  double worst = 0.0;
  for (const double a0 : {0.2, 5.0})
    for (const double d : {-3.0, -0.3, -0.005, 0.005, 0.3, 3.0}) {
      const auto flux = [](double x, double y) { return ehl::film::logarithmic_mean(barus(x, y)) * (y - x); };
      const double f = ehl::film::logarithmic_mean(barus(a0, a0 + d));
      const auto [before, behind] = ehl::film::answers(0.0, std::exp(-a0), std::exp(-a0 - d), a0, a0 + d);
      const double by_first = -(flux(a0 + step, a0 + d) - flux(a0 - step, a0 + d)) / (2.0 * step * f);
      const double by_second = (flux(a0, a0 + d + step) - flux(a0, a0 + d - step)) / (2.0 * step * f);
      worst = std::max({worst, std::abs(before - by_first), std::abs(behind - by_second)});
    }
  BOOST_TEST_MESSAGE("largest error " << worst << " (tolerance 1e-8: a difference over 1e-5)");
  BOOST_TEST(worst < 1e-8);
  // The bounded mean: below the bound, above it, and in the transition (|d| from 4.5 to 9.9).
  worst = 0.0;
  for (const double d : {-12.0, -8.0, -5.0, -1.0, -0.005, 0.005, 3.0, 5.0, 6.0, 8.0, 9.0, 12.0}) {
    constexpr double least = 0.4, a0 = 1.0;
    const auto flux = [](double x, double y) { return ehl::film::fluidity_between(barus(x, y), least) * (y - x); };
    const double f = ehl::film::fluidity_between(barus(a0, a0 + d), least);
    const auto [before, behind] =
        ehl::film::answers<ehl::film::LeastShare::follows>(least, std::exp(-a0), std::exp(-a0 - d), a0, a0 + d);
    const double by_first = -(flux(a0 + step, a0 + d) - flux(a0 - step, a0 + d)) / (2.0 * step * f);
    const double by_second = (flux(a0, a0 + d + step) - flux(a0, a0 + d - step)) / (2.0 * step * f);
    worst = std::max({worst, std::abs(before - by_first), std::abs(behind - by_second)});
  }
  BOOST_TEST_MESSAGE("of the bounded mean " << worst << " (tolerance 1e-8)");
  BOOST_TEST(worst < 1e-8);
  const auto nothing = ehl::film::answers(0.0, 0.0, 0.0, 800.0, 900.0);
  BOOST_TEST((nothing.before == 100.0 && nothing.behind == 0.0));
}

// The ratio of the logarithmic mean to the arithmetic mean is tanh(d/2)/(d/2): 0.6 at d = 3.03, 0.2 at d = 9.999.
BOOST_AUTO_TEST_CASE(a_bounded_one_is_the_logarithmic_mean_down_to_its_bound_and_goes_over_without_a_kink) {
  const auto mean = [](double d) { return 0.5 * (std::exp(-1.0) + std::exp(-1.0 - d)); };
  const auto between = [](double d) { return ehl::film::fluidity_between(barus(1.0, 1.0 + d), 0.4); };
  for (const double d : {-3.0, 0.3, 3.0}) BOOST_TEST(between(d) == ehl::film::logarithmic_mean(barus(1.0, 1.0 + d)));
  for (const double d : {-10.1, 10.1, 12.0, 300.0}) BOOST_TEST(std::abs(between(d) / (0.4 * mean(d)) - 1.0) < 1e-14);
  for (const double d : {-10.1, 10.1}) {
    const auto [before, behind] = ehl::film::answers(0.4, std::exp(-6.0), std::exp(-6.0 - d), 6.0, 6.0 + d);
    BOOST_TEST((before == 1.0 && behind == 1.0));
  }
  // The transition has neither a jump nor a kink: over d = 0.01, the slope of the ratio changes by no more than its
  // curvature of 0.25 implies.
  double kink = 0.0;
  const auto share = [&](double d) { return between(d) / mean(d); };
  for (double d = 0.01; d < 14.0; d += 0.01)
    kink = std::max(kink, std::abs(share(d + 0.01) - 2.0 * share(d) + share(d - 0.01)) / 0.01);
  BOOST_TEST_MESSAGE("largest change of slope " << kink << " (allowed 2.5e-3; of the bound alone 0.07)");
  BOOST_TEST(kink < 2.5e-3);
}

BOOST_AUTO_TEST_CASE(the_change_of_epsilon_is_its_slope) {
  ehl::tests::Random random(3);
  double worst = 0.0;
  for (int trial = 0; trial < 200; ++trial) {
    AroundHalfPoint<double> at{}, change{};
    const double spread = trial % 2 == 0 ? 0.004 : 3.0;
    // One bound far above the ratios of this spread, and one above most of them.
    const ehl::film::Between how{2.0, trial % 3 == 0 ? 0.99 : 0.4};
    for (double& H : at.H) H = trial % 5 == 0 ? random.between(0.01, 3.0) : random.between(0.8, 1.2);
    for (double& dH : change.H) dH = random.between(-0.3, 0.3);
    for (std::size_t k = 0; k < 2; ++k) {
      at.rho_bar[k] = random.between(1.0, 1.3);
      at.log_viscosity[k] = random.between(0.0, spread);
      change.rho_bar[k] = random.between(-0.1, 0.1);
      change.log_viscosity[k] = random.between(-1.0, 1.0);
    }
    const auto moved = [&](double share) {
      AroundHalfPoint<double> there = at;
      for (std::size_t k = 0; k < 4; ++k) there.H[k] += share * change.H[k];
      for (std::size_t k = 0; k < 2; ++k) {
        there.rho_bar[k] += share * change.rho_bar[k];
        there.log_viscosity[k] += share * change.log_viscosity[k];
        there.fluidity[k] = std::exp(-there.log_viscosity[k]);
      }
      return there;
    };
    constexpr double step = 1e-5;
    const double slope =
        (ehl::film::epsilon_between(moved(step), how) - ehl::film::epsilon_between(moved(-step), how)) / (2.0 * step);
    worst = std::max(worst, std::abs(ehl::film::epsilon_change(moved(0.0), change, how) - slope) /
                                ehl::film::epsilon_between(moved(0.0), how));
  }
  BOOST_TEST_MESSAGE("largest error " << worst << " of epsilon (tolerance 1e-7: a difference over 1e-5)");
  BOOST_TEST(worst < 1e-7);
}

BOOST_AUTO_TEST_SUITE_END()
