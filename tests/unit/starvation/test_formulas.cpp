// Formulas for starved films, compared with their limits and closed forms; the layer that the next pass receives.
#include <boost/math/special_functions/bessel.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "effects/starvation/formulas.hpp"
#include "steady/passes.hpp"

BOOST_AUTO_TEST_SUITE(test_starvation_formulas)

using namespace ehl;
using std::numbers::pi;

namespace {

// The modified Struve function of order 0, by its series.
double struve_l0(double x) {
  double term = 2.0 * x / pi, sum = 0.0;
  for (int k = 1; k < 200; ++k) {
    sum += term;
    term *= x * x / ((2.0 * k + 1.0) * (2.0 * k + 1.0));
  }
  return sum;
}

double lost(const rheology::ViscosityLaw& law, const contact::Ellipse& shape = {}) {
  return starvation::lost_by_pass(shape, 1.0, law, rheology::Incompressible{});
}

}  // namespace

// The side flow: 2 pi for an isoviscous oil, 2 pi (I_0 - L_0)(alpha_bar) for a Barus oil, divided
// by kappa^2 for an ellipse.
BOOST_AUTO_TEST_CASE(thin_layers_lose_by_side_flow) {
  BOOST_TEST(std::abs(lost(rheology::Isoviscous{}) - 2.0 * pi) <= 1e-12);
  for (const double alpha_bar : {0.5, 3.0, 10.0}) {
    const double exact = 2.0 * pi * (boost::math::cyl_bessel_i(0, alpha_bar) - struve_l0(alpha_bar));
    const double found = lost(rheology::Barus{alpha_bar});
    BOOST_TEST_MESSAGE("alpha_bar = " << alpha_bar << ": " << found << ", exact " << exact << " (allowed 1e-3)");
    BOOST_TEST(std::abs(found / exact - 1.0) <= 1e-3);  // 400 intervals; the error is h^2 at the ends, where eta varies
  }
  const contact::Ellipse wide = contact::ellipse(0.2);
  BOOST_TEST(std::abs(lost(rheology::Isoviscous{}, wide) * wide.kappa * wide.kappa - 2.0 * pi) <= 1e-12);
  BOOST_TEST(std::isnan(lost(rheology::Isoviscous{}, contact::ellipse(0.2, 30.0))));
}

BOOST_AUTO_TEST_CASE(factors_and_their_limits) {
  BOOST_TEST(std::abs(starvation::by_supply(1.0, 3.0) - std::pow(0.5, 1.0 / 3.0)) <= 1e-15);
  BOOST_TEST(std::abs(starvation::by_supply(0.01, 3.0) / 0.01 - 1.0) <= 1e-6);
  BOOST_TEST(std::abs(starvation::by_supply(100.0, 3.0) - 1.0) <= 1e-6);
  double r = 1.3;  // repeated for each pass
  for (int pass = 0; pass < 5; ++pass) r = starvation::by_supply(r, 2.7);
  BOOST_TEST(std::abs(starvation::by_passes(1.3, 2.7, 5) - r) <= 1e-14);
  BOOST_TEST(std::abs(starvation::gamma_of(0.7, starvation::by_supply(0.7, 3.4)) - 3.4) <= 1e-9);
  BOOST_TEST(std::isnan(starvation::gamma_of(0.1, 0.0999)));
  // A reference value for (50, 10) on 128 x 128 cells.
  BOOST_TEST(std::abs(starvation::by_meniscus(1.25, 0.219) - 0.624) <= 2e-3);
  BOOST_TEST(starvation::by_meniscus(3.0, 0.219) == 1.0);
}

// Levelling conserves the oil, and the shares follow the rule.
BOOST_AUTO_TEST_CASE(the_layer_of_the_next_pass) {
  const std::vector<double> left{1.0, 0.25, 0.75, 3.0, 1.0}, fresh(5, 2.0);
  BOOST_TEST(steady::next_layer({}, left, fresh) == left);
  const std::vector<double> half = steady::next_layer({.returning = 0.5, .renewed = 0.25}, left, fresh);
  for (std::size_t j = 0; j < left.size(); ++j) BOOST_TEST(half[j] == 0.5 * left[j] + 0.5);
  const std::vector<double> level = steady::next_layer({.levelled = 0.6}, left, fresh);
  const auto oil = [](const std::vector<double>& h) { return 0.5 * h[0] + h[1] + h[2] + h[3] + 0.5 * h[4]; };
  BOOST_TEST(std::abs(oil(level) - oil(left)) <= 1e-15);
  BOOST_TEST(std::abs((level[3] - level[1]) - 0.4 * (left[3] - left[1])) <= 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
