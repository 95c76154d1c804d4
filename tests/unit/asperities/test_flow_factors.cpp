// Flow factors of Patir and Cheng: the published coefficients fit together, and the small-roughness theory fits them.
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "asperities/flow_factors.hpp"
#include "asperities/roughness_numbers.hpp"

BOOST_AUTO_TEST_SUITE(test_asperity_flow_factors)

using namespace ehl;
using asperities::PatirCheng;

namespace {
constexpr std::array<double, 7> published{1.0 / 9.0, 1.0 / 6.0, 1.0 / 3.0, 1.0, 3.0, 6.0, 9.0};
}

// Both branches of Phi_s were fitted to the same numbers, so a wrong digit in one of 35 coefficients shows at l = 5.
BOOST_AUTO_TEST_CASE(the_branches_of_the_shear_factor_meet) {
  double worst = 0.0;
  for (const double gamma : published) {
    const double below = asperities::shear_factor({gamma}, 5.0), above = asperities::shear_factor({gamma}, 5.0 + 1e-12);
    worst = std::max(worst, std::abs(below / above - 1.0));
  }
  BOOST_TEST_MESSAGE("jump of Phi_s at l = 5: " << worst << " (tolerance 1e-3, of three digits)");
  BOOST_TEST(worst < 1e-3);
}

// C and r as smooth functions of gamma that others fitted to the same table: C = 0.89679 - 0.26591 ln gamma and
// r = 0.43006 - 0.10828 gamma + 0.23821 gamma^2 up to gamma = 1, C = -0.10667 + 0.1075 gamma and r = 1.5 above.
BOOST_AUTO_TEST_CASE(the_pressure_factor_follows_a_fit_of_others) {
  double worst = 0.0;
  for (const double gamma : published)
    for (const double l : {1.0, 2.0, 3.0, 5.0}) {
      const double fit = gamma <= 1.0 ? 1.0 - (0.89679 - 0.26591 * std::log(gamma)) *
                                                  std::exp(-(0.43006 + gamma * (-0.10828 + 0.23821 * gamma)) * l)
                                      : 1.0 + (-0.10667 + 0.1075 * gamma) * std::pow(l, -1.5);
      worst = std::max(worst, std::abs(asperities::pressure_factor({gamma}, l) - fit));
    }
  BOOST_TEST_MESSAGE("phi_x against the fit of others: " << worst << " (tolerance 0.02: its own residual)");
  BOOST_TEST(worst < 0.02);
}

// Isotropic roughness, small against the gap: 1 - (3/2)/l^2, exact to second order; Patir and Cheng's numbers are means
// of simulations.
BOOST_AUTO_TEST_CASE(isotropic_factor_follows_the_theory_of_small_roughness) {
  double worst = 0.0;
  for (const double l : {3.0, 4.0, 5.0, 6.0})
    worst = std::max(
        worst, std::abs(asperities::pressure_factor({1.0}, l) - asperities::small_roughness_factor(1.0 / l, 0.5)));
  BOOST_TEST_MESSAGE("phi_x for gamma = 1 against 1 - 3/(2 l^2): " << worst << " (tolerance 0.015)");
  BOOST_TEST(worst < 0.015);
}

BOOST_AUTO_TEST_CASE(the_mean_gap_is_that_of_the_published_polynomial) {
  double worst = 0.0, slope = 0.0;
  for (double l = 0.0; l < 3.0; l += 0.1) {
    const double fit = std::exp(-0.6912 + 0.782 * l - 0.304 * l * l + 0.0401 * l * l * l);
    worst = std::max(worst, std::abs(asperities::contact_factor(l) - fit));
    const double difference = (asperities::mean_gap(l + 1e-5) - asperities::mean_gap(l - 1e-5)) / 2e-5;
    slope = std::max(slope, std::abs(difference - asperities::contact_factor(l)));
  }
  BOOST_TEST_MESSAGE("phi_c against Wu and Zheng's polynomial: " << worst << " (tolerance 0.004); dh_T/dh: " << slope
                                                                 << " (tolerance 1e-9)");
  BOOST_TEST(worst < 0.004);
  BOOST_TEST(slope < 1e-9);
}

BOOST_AUTO_TEST_CASE(factors_in_a_contact_and_their_slopes) {
  BOOST_TEST(asperities::wrong_gamma(9.0).empty());
  BOOST_TEST(asperities::wrong_gamma(1.0 / 9.0).empty());
  BOOST_TEST(asperities::wrong_gamma(12.0) ==
             "Peklenik's gamma must be from 1/9 to 9, the range of Patir and Cheng, and is 12");
  BOOST_TEST(!asperities::wrong_gamma(0.1).empty());
  const asperities::GapTable table{.gap = {1e-7, 2e-7, 4e-7, 1e-6},
                                   .pressure = {3, 2, 1, 0},
                                   .phi_x = {0.0, 0.3, 0.8, 0.95},
                                   .phi_y = {2.0, 1.5, 1.2, 1.05}};
  const std::vector<double> H{0.12, 0.31, 0.53, 0.77, 1.5};
  for (const asperities::FlowFactors& factors :
       {asperities::flow_factors(table, 1e-6),
        asperities::FlowFactors{.model = PatirCheng{2.0}, .gap_scale = 1e-6, .sigma = 1e-7}}) {
    std::vector<double> plus(H.size()), minus(H.size()), slope(H.size()), up(H), down(H);
    for (std::size_t k = 0; k < H.size(); ++k) {
      up[k] += 1e-6;
      down[k] -= 1e-6;
    }
    double worst = 0.0;
    const auto compare = [&](auto value, auto derivative) {
      value(factors, up, plus);
      value(factors, down, minus);
      derivative(factors, H, slope);
      for (std::size_t k = 0; k < H.size(); ++k)
        worst = std::max(worst, std::abs((plus[k] - minus[k]) / 2e-6 - slope[k]));
    };
    compare(asperities::phi_x, asperities::phi_x_slope);
    compare(asperities::phi_y, asperities::phi_y_slope);
    compare(asperities::phi_s, asperities::phi_s_slope);
    BOOST_TEST_MESSAGE("slopes of the factors against differences: " << worst << " (tolerance 1e-4)");
    BOOST_TEST(worst < 1e-4);
  }
  // The table passes through its points, and phi_y of Patir and Cheng is phi_x of the turned lay.
  std::vector<double> out(1);
  asperities::phi_x(asperities::flow_factors(table, 1e-6), std::vector<double>{0.4}, out);
  BOOST_TEST(std::abs(out[0] - 0.8) < 1e-12);
  asperities::phi_y({.model = PatirCheng{3.0}}, std::vector<double>{2.0}, out);
  BOOST_TEST(std::abs(out[0] - (1.0 - 1.18 * std::exp(-0.84))) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
