// Least squares for straight lines, whose errors are known in closed form, and for a curve.
#include "tables/least_squares.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/errors.hpp"

using namespace ehl::program;

BOOST_AUTO_TEST_SUITE(test_program_least_squares)

// y = a: the mean, and sigma/sqrt(N).
BOOST_AUTO_TEST_CASE(a_constant_is_the_mean) {
  const std::vector<Measurement> measured{{1.0}, {2.0}, {4.0}, {5.0}};
  const Model model = [](const auto& sets) {
    std::vector<std::vector<double>> values;
    for (const auto& p : sets) values.push_back(std::vector<double>(4, p[0]));
    return values;
  };
  const Fit fit = least_squares(model, measured, {1.0});
  BOOST_TEST(fit.settled);
  BOOST_TEST(std::abs(fit.parameters[0] - 3.0) < 0.05 * 0.91);  // the iteration stops at a twentieth of the error
  // s = sqrt(10/3), s/sqrt(4) = 0.9129; the slope in the logarithm is a difference over 5 %, which makes it inexact.
  BOOST_TEST(std::abs(fit.errors[0] * fit.parameters[0] / 0.912871 - 1) < 0.04);
  BOOST_TEST(std::abs(fit.deviation - std::sqrt(2.5)) < 1e-2);
  // With known errors of 1, sigma/sqrt(4) = 0.5; the scatter may increase this.
  std::vector<Measurement> certain = measured;
  for (Measurement& one : certain) one.sigma = 10.0;
  BOOST_TEST(std::abs(least_squares(model, certain, {1.0}).errors[0] * 3.0 / 5.0 - 1) < 0.04);
}

// An Eyring curve far from the start: the fit finds both constants and their correlation.
BOOST_AUTO_TEST_CASE(a_curve_of_two_constants) {
  const std::vector<double> x{0.01, 0.03, 0.1, 0.3, 1.0, 2.0};
  const auto curve = [&](double a, double b, double at) { return a * std::asinh(at / b); };
  std::vector<Measurement> measured;
  for (const double at : x) measured.push_back({curve(0.01, 0.05, at)});
  const Model model = [&](const auto& sets) {
    std::vector<std::vector<double>> values;
    for (const auto& p : sets) {
      values.emplace_back();
      for (const double at : x) values.back().push_back(curve(p[0], p[1], at));
    }
    return values;
  };
  const Fit fit = least_squares(model, measured, {0.04, 0.01});
  BOOST_TEST_MESSAGE(fit.parameters[0] << " " << fit.parameters[1] << " in " << fit.rounds << " rounds");
  BOOST_TEST(fit.settled);
  BOOST_TEST(std::abs(fit.parameters[0] / 0.01 - 1) < 2e-3);
  BOOST_TEST(std::abs(fit.parameters[1] / 0.05 - 1) < 5e-3);
  BOOST_TEST(fit.correlation[0][1] > 0.5);
  BOOST_CHECK_THROW(least_squares(
                        [&](const auto& sets) {
                          return model({sets.size(), {NAN, 1.0}});
                        },
                        measured, {1, 1}),
                    ehl::core::SolverError);
}

BOOST_AUTO_TEST_SUITE_END()
