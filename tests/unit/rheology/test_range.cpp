// The pressure limits of the laws: on both sides of every limit, with the numbers in the warning.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "rheology/range.hpp"

BOOST_AUTO_TEST_SUITE(test_rheology_range)

using namespace ehl::rheology;

namespace {

constexpr double alpha = 2.2e-8;

std::vector<std::string> found(const ViscosityLaw& law, const Loading& loading) {
  const std::vector<std::string> texts = with_names(out_of_range(law, Incompressible{}, loading));
  for (const std::string& text : texts) BOOST_TEST_MESSAGE(text);
  return texts;
}

bool one_says(const std::vector<std::string>& texts, const std::string& part) {
  return texts.size() == 1 && texts[0].find(part) != std::string::npos;
}

// ln(eta/eta0) of Roelands' law.
double roelands(double p, double z) { return alpha * 1.96e8 / z * (std::pow(1.0 + p / 1.96e8, z) - 1.0); }

// The pressure at which Roelands' law has a given ln(eta/eta0).
double pressure_of(double log_eta, double z) {
  return 1.96e8 * (std::pow(1.0 + log_eta * z / (alpha * 1.96e8), 1.0 / z) - 1.0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(barus_ends_at_half_a_gigapascal) {
  const double p_h = 0.4e9;
  const Barus law = make_barus(alpha, p_h);
  BOOST_TEST(found(law, {.P_max = 0.499e9 / p_h, .p_h = p_h}).empty());
  const auto beyond = found(law, {.P_max = 0.501e9 / p_h, .p_h = p_h});
  BOOST_TEST(one_says(beyond, "p_max = 0.501 GPa"));
  BOOST_TEST(one_says(beyond, "alpha_bar P = 11"));
  BOOST_TEST(one_says(beyond, "0.5 GPa"));
  // Without a pressure scale the viscosity decides: ln(eta/eta0) = alpha_bar P.
  BOOST_TEST(found(Barus{8.0}, {.P_max = 9.99 / 8.0}).empty());
  BOOST_TEST(one_says(found(Barus{8.0}, {.P_max = 10.01 / 8.0}), "P = 1.25 p_h ln(eta/eta0) = 10"));
}

// Roelands' z = alpha p0/(ln eta0 + 9.67) is 0.0426 for water, below what the key allows: the advice is a table.
BOOST_AUTO_TEST_CASE(advice_that_would_be_refused_is_not_given) {
  const double p_h = 0.6e9;
  BOOST_TEST(one_says(found(make_barus(6e-10, p_h), {.P_max = 1.0, .p_h = p_h, .eta0 = 1e-3}), "viscosity = table"));
  BOOST_TEST(one_says(found(make_barus(7.5e-10, p_h), {.P_max = 1.0, .p_h = p_h, .eta0 = 1e-3}), "= roelands"));
}

BOOST_AUTO_TEST_CASE(roelands_ends_at_a_glass) {
  const double z = 0.68;
  const double p_h = 1e9;
  const Roelands law = make_roelands(alpha, 1.96e8, z, p_h);
  // An oil of 0.1 Pa s is a glass of 1e12 Pa s at ln(1e13) = 29.93; without eta0, 30 is used.
  const double glass = pressure_of(std::log(1e13), z);
  BOOST_TEST_MESSAGE("glass at " << glass << " Pa, where ln(eta/eta0) is " << roelands(glass, z));
  BOOST_TEST(one_says(found(law, {.P_max = 1.001 * glass / p_h, .p_h = p_h, .eta0 = 0.1}), "is a glass"));
  BOOST_TEST(one_says(found(law, {.P_max = 0.999 * glass / p_h, .p_h = p_h, .eta0 = 0.1}), "extrapolated"));
  const double assumed = pressure_of(30.0, z);
  BOOST_TEST(one_says(found(law, {.P_max = 1.001 * assumed / p_h, .p_h = p_h}), "an eta0 of 0.1"));
  BOOST_TEST(one_says(found(law, {.P_max = 0.999 * assumed / p_h, .p_h = p_h}), "extrapolated"));
  // A thick oil becomes a glass below 2 GPa: eta0 = 1000 Pa s at ln(1e9) = 20.7.
  BOOST_TEST(one_says(found(law, {.P_max = 1.001e-9 * pressure_of(std::log(1e9), z), .p_h = p_h, .eta0 = 1000.0}),
                      "eta0 = 1e+03"));
}

BOOST_AUTO_TEST_CASE(pressures_nobody_measured_at_are_named) {
  const double p_h = 1e9;
  const Roelands law = make_roelands(alpha, 1.96e8, 0.68, p_h);
  BOOST_TEST(found(law, {.P_max = 1.99, .p_h = p_h, .eta0 = 0.1}).empty());
  const auto beyond = found(law, {.P_max = 2.01, .p_h = p_h, .eta0 = 0.1});
  BOOST_TEST(one_says(beyond, "p_max = 2.01 GPa"));
  BOOST_TEST(one_says(beyond, "alpha_bar P = 44.2"));

  const auto density = [&](double P_max) {
    return with_names(out_of_range(Isoviscous{}, make_dowson_higginson(p_h), {.P_max = P_max, .p_h = p_h}));
  };
  BOOST_TEST(density(1.99).empty());
  BOOST_TEST(one_says(density(2.01), "rho/rho0 = 1.26"));
  // At the limit the law is 5 % below Tait's equation.
  const double tait = 1.0 / (1.0 - std::log(1.0 + 2.0 / 1.3 * 12.0) / 12.0);
  const double law_at_limit = (5.9 + 1.34 * 20.0) / (5.9 + 20.0);
  BOOST_TEST_MESSAGE("Tait " << tait << ", Dowson and Higginson " << law_at_limit << " at 2 GPa");
  BOOST_TEST(std::abs(tait / law_at_limit - 1.05) < 0.005);
}

BOOST_AUTO_TEST_CASE(laws_without_pressure_have_no_range) {
  BOOST_TEST(out_of_range(Isoviscous{}, Incompressible{}, {.P_max = 5.0, .p_h = 5e9, .eta0 = 1.0}).empty());
}

BOOST_AUTO_TEST_SUITE_END()
