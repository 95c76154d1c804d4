// Curves through tables, and the pressure coefficients of the laws.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "rheology/pressure_coefficient.hpp"

BOOST_AUTO_TEST_SUITE(test_rheology_table)

using namespace ehl::rheology;

namespace {

constexpr double p_h = 1e9;

double log_eta_at(const ViscosityLaw& law, double P) {
  double out = 0.0;
  log_viscosity(law, {&P, 1}, {&out, 1});
  return out;
}

// A table of the law with steps of `step` GPa up to 3 GPa.
TabulatedViscosity tabulated(const ViscosityLaw& law, double step) {
  std::vector<double> p, eta;
  for (int k = 0; k * step < 3.0 + 0.5 * step; ++k) {
    p.push_back(k * step * 1e9);
    eta.push_back(0.1 * std::exp(log_eta_at(law, k * step)));
  }
  return make_tabulated_viscosity(p, eta, p_h);
}

double worst_gap(const ViscosityLaw& a, const ViscosityLaw& b, double from, double to) {
  double worst = 0.0;
  for (int k = 0; k <= 1000; ++k) {
    const double P = from + (to - from) * k / 1000.0;
    worst = std::max(worst, std::abs(log_eta_at(a, P) - log_eta_at(b, P)));
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_table_of_barus_is_barus) {
  const Barus barus{20.0};
  const TabulatedViscosity table = tabulated(barus, 0.25);
  // ln eta is a straight line, which the curve reproduces to the rounding of exp and log in the table.
  const double gap = worst_gap(barus, table, -0.05, 5.0);
  BOOST_TEST_MESSAGE("largest gap of ln eta " << gap << " (tolerance 1e-12)");
  BOOST_TEST(gap < 1e-12);
  BOOST_TEST(log_eta_at(table, 0.0) == 0.0);
  BOOST_TEST(log_eta_at(table, 0.5) == table.curve->y[2]);
}

BOOST_AUTO_TEST_CASE(a_table_of_roelands_converges_to_it) {
  const Roelands roelands = make_roelands(1.7e-8, roelands_p0, 0.6, p_h);
  double before = 0.0;
  for (const double step : {0.1, 0.05, 0.025}) {
    const double gap = worst_gap(roelands, tabulated(roelands, step), 0.3, 2.7);
    BOOST_TEST_MESSAGE("step " << step << " GPa: gap of ln eta " << gap << ", factor " << before / gap);
    // Slopes by harmonic means are of second order and values of third order, at least a factor of 6 per halving.
    if (before > 0.0) BOOST_TEST(before / gap > 6.0);
    before = gap;
  }
  BOOST_TEST(before < 1e-3);
}

BOOST_AUTO_TEST_CASE(a_curve_stays_between_its_points) {
  // Steps and plateaus on which a spline would oscillate.
  const std::vector<double> x{0.0, 0.1, 0.2, 1.0, 1.05, 2.0, 3.0}, y{0.0, 1.0, 1.001, 1.002, 9.0, 9.01, 9.5};
  const Curve curve = monotone_curve(x, y);
  double previous = 0.0, least_slope = 1e9, worst = 0.0;
  std::size_t k = 0;
  for (int n = 1; n < 3000; ++n) {
    const double at = 1e-3 * n, here = value(curve, at);
    while (at > x[k + 1]) ++k;
    BOOST_REQUIRE(here >= y[k]);
    BOOST_REQUIRE(here <= y[k + 1]);
    BOOST_REQUIRE(here >= previous);
    previous = here;
    least_slope = std::min(least_slope, slope(curve, at));
    if (n % 50 == 0) continue;  // at a point of the table the second derivative jumps
    worst = std::max(worst, std::abs((value(curve, at + 1e-6) - value(curve, at - 1e-6)) / 2e-6 - slope(curve, at)));
  }
  BOOST_TEST_MESSAGE("least slope " << least_slope << "; slope against difference " << worst << " (tolerance 1e-4)");
  BOOST_TEST(least_slope >= 0.0);
  BOOST_TEST(worst < 1e-4);
  for (std::size_t point = 0; point < x.size(); ++point) BOOST_TEST(value(curve, x[point]) == y[point]);
  // Outside the table the curve is linear.
  BOOST_TEST(value(curve, 5.0) == 9.5 + 2.0 * slope(curve, 3.0));
  BOOST_TEST(value(curve, -1.0) == -slope(curve, 0.0));
  BOOST_TEST(std::isnan(value(curve, std::nan(""))));
}

BOOST_AUTO_TEST_CASE(coefficients_of_barus_are_alpha) {
  for (const double alpha_bar : {0.01, 13.42, 700.0}) {
    const PressureCoefficients found = pressure_coefficients(Barus{alpha_bar});
    const double star = found.alpha_star / alpha_bar - 1.0, film = found.alpha_film / alpha_bar - 1.0;
    BOOST_TEST_MESSAGE("alpha_bar = " << alpha_bar << ": alpha* " << star << ", alpha_film " << film
                                      << " off (tolerance 1e-12)");
    BOOST_TEST(std::abs(star) < 1e-12);
    BOOST_TEST(std::abs(film) < 1e-12);
  }
  BOOST_TEST(pressure_coefficients(Isoviscous{}).alpha_star == 0.0);
  BOOST_TEST(pressure_coefficients(Barus{0.0}).alpha_film == 0.0);
}

BOOST_AUTO_TEST_CASE(coefficients_of_roelands_at_z_one_half_in_closed_form) {
  // With s = (1 + p/p0)^(1/2) and A = alpha p0/z: int_1^S 2 p0 s e^(-A(s - 1)) ds.
  const double alpha = 1.7e-8, z = 0.5, A = alpha * roelands_p0 / z;
  const auto integral = [&](double S) {
    return 2.0 * roelands_p0 * (1.0 / A + 1.0 / (A * A) - std::exp(-A * (S - 1.0)) * (S / A + 1.0 / (A * A)));
  };
  const double alpha_star = 1.0 / (2.0 * roelands_p0 * (1.0 / A + 1.0 / (A * A)));
  const double S = std::sqrt(1.0 + 3.0 / (alpha_star * roelands_p0));
  const double alpha_film = (1.0 - std::exp(-3.0)) / integral(S);
  const PressureCoefficients found = pressure_coefficients(make_roelands(alpha, roelands_p0, z, p_h));
  const double star = found.alpha_star / p_h / alpha_star - 1.0, film = found.alpha_film / p_h / alpha_film - 1.0;
  BOOST_TEST_MESSAGE("alpha* " << alpha_star << ", alpha_film " << alpha_film << " 1/Pa, off by " << star << " and "
                               << film << " (tolerance 1e-12)");
  BOOST_TEST(std::abs(star) < 1e-12);
  BOOST_TEST(std::abs(film) < 1e-12);
  // z = 1 is Barus' law.
  const PressureCoefficients at_one = pressure_coefficients(make_roelands(alpha, roelands_p0, 1.0, p_h));
  BOOST_TEST(std::abs(at_one.alpha_star / (alpha * p_h) - 1.0) < 1e-12);
  BOOST_TEST(std::abs(at_one.alpha_film / (alpha * p_h) - 1.0) < 1e-12);
}

BOOST_AUTO_TEST_CASE(the_scale_does_not_matter) {
  const ViscosityLaw law = make_doolittle({4.71, 0.6568, 1.192e9, 11.74, 0.0156}, 1.0);
  const double in_pascals = pressure_coefficients(law).alpha_star;
  for (const double scale : {1e6, 1e9, 5e9}) {
    const double scaled = pressure_coefficients(rescaled(law, scale)).alpha_star / scale;
    BOOST_TEST(std::abs(scaled / in_pascals - 1.0) < 1e-11);
  }
  BOOST_TEST(pressure_coefficients(rescaled(law, 0.0)).alpha_star == 0.0);
}

BOOST_AUTO_TEST_CASE(squalane_has_the_known_coefficient) {
  // For squalane at 40 C, alpha* is 18 1/GPa and the viscosity 15.6 mPa s.
  const double alpha_star =
      pressure_coefficients(make_doolittle({4.71, 0.6568, 1.192e9, 11.74, 0.0156}, 1.0)).alpha_star;
  BOOST_TEST_MESSAGE("alpha* = " << 1e9 * alpha_star << " 1/GPa, known 18");
  BOOST_TEST(std::abs(1e9 * alpha_star - 18.0) < 0.5);
}

BOOST_AUTO_TEST_CASE(a_table_gives_the_coefficient_of_its_law) {
  const Roelands law = make_roelands(1.7e-8, roelands_p0, 0.6, p_h);
  const PressureCoefficients exact = pressure_coefficients(law);
  const PressureCoefficients coarse = pressure_coefficients(tabulated(law, 0.05));
  const PressureCoefficients fine = pressure_coefficients(tabulated(law, 0.0125));
  BOOST_TEST_MESSAGE("alpha* of tables: " << coarse.alpha_star / exact.alpha_star - 1.0 << " and "
                                          << fine.alpha_star / exact.alpha_star - 1.0 << " off");
  BOOST_TEST(std::abs(coarse.alpha_star / exact.alpha_star - 1.0) < 5e-3);
  BOOST_TEST(std::abs(fine.alpha_star / exact.alpha_star - 1.0) < 2e-4);
}

BOOST_AUTO_TEST_SUITE_END()
