// Laws of asperity pressure against closed forms, the published table of Greenwood and Tripp, and Hertz.
#include <array>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/hypergeometric_1F1.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <numbers>

#include "asperities/gap_table.hpp"
#include "asperities/gauss_moments.hpp"
#include "asperities/laws.hpp"
#include "support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(test_asperity_laws)

using namespace ehl;
using asperities::gauss_moment;

namespace {

constexpr double pi = std::numbers::pi;

// F_n(l) by Kummer's function, without any quadrature: the parabolic cylinder function D_(-n-1).
double closed_form(double n, double l) {
  using boost::math::hypergeometric_1F1;
  const double x = 0.5 * l * l, a = 0.5 * (n + 1.0);
  const double even = hypergeometric_1F1(a, 0.5, x) / std::tgamma(a + 0.5);
  const double odd = -std::sqrt(2.0) * l * hypergeometric_1F1(a + 0.5, 1.5, x) / std::tgamma(a);
  return std::tgamma(n + 1.0) * std::pow(2.0, -a) * std::exp(-x) * (even + odd) / std::sqrt(2.0);
}

asperities::AsperityPressure law_of(const std::string& name, const asperities::LawParameters& parameters) {
  for (const asperities::Law& law : asperities::laws())
    if (law.name == name) {
      const auto made = law.curve(parameters);
      if (const auto* wrong = std::get_if<std::string>(&made)) throw std::runtime_error(*wrong);
      return {.curve = std::get<asperities::PressureCurve>(made)};
    }
  throw std::runtime_error(name);
}

double at(const asperities::AsperityPressure& law, double H) {
  double P = 0.0;
  asperities::pressure(law, {&H, 1}, {&P, 1});
  return P;
}
double slope_at(const asperities::AsperityPressure& law, double H) {
  double P = 0.0;
  asperities::pressure_slope(law, {&H, 1}, {&P, 1});
  return P;
}

const asperities::LawParameters steel{
    .sigma = 0.4e-6, .eta_beta_sigma = 0.05, .sigma_over_beta = 0.01, .E_prime = 226e9};

}  // namespace

BOOST_AUTO_TEST_CASE(moments_of_the_gaussian_distribution) {
  double worst = 0.0;
  for (const double n : {0.5, 1.0, 1.5, 2.0, 2.5})
    for (const double l : {-3.0, -1.0, -0.1, 0.0, 0.5, 1.0, 2.0, 2.5})
      worst = std::max(worst, std::abs(gauss_moment(n, l) / closed_form(n, l) - 1.0));
  BOOST_TEST_MESSAGE("F_n against Kummer's function: " << worst << " (tolerance 1e-10: the function cancels)");
  BOOST_TEST(worst < 1e-10);
  // F_0 is the complement of the error function; its tail has no cancellation.
  double tail = 0.0;
  for (const double l : {3.0, 6.0, 10.0})
    tail = std::max(tail, std::abs(gauss_moment(0.0, l) / (0.5 * std::erfc(l / std::sqrt(2.0))) - 1.0));
  BOOST_TEST_MESSAGE("F_0 against erfc up to l = 10: " << tail << " (tolerance 1e-11)");
  BOOST_TEST(tail < 1e-11);
  double slope = 0.0;
  for (const double l : {-2.0, 0.3, 3.0}) {
    const double step = 1e-4, difference = (gauss_moment(2.5, l + step) - gauss_moment(2.5, l - step)) / (2.0 * step);
    slope = std::max(slope, std::abs(difference / (-2.5 * gauss_moment(1.5, l)) - 1.0));
  }
  BOOST_TEST_MESSAGE("dF_5/2/dl = -(5/2) F_3/2: " << slope << " (tolerance 1e-6, of the difference)");
  BOOST_TEST(slope < 1e-6);
}

// Table 1 of Greenwood and Tripp (1970), five decimals; the fit is that of many programs, 4.4086e-5 (4 - l)^6.804.
BOOST_AUTO_TEST_CASE(published_values_of_F_5_2) {
  const std::array<std::array<double, 2>, 8> table{{{0.0, 0.61664},
                                                    {0.5, 0.24040},
                                                    {1.0, 0.08056},
                                                    {1.5, 0.02286},
                                                    {2.0, 0.00542},
                                                    {2.5, 0.00106},
                                                    {3.0, 0.00017},
                                                    {3.5, 0.00002}}};
  double worst = 0.0, fit = 0.0;
  for (const auto& [l, F] : table) {
    worst = std::max(worst, std::abs(gauss_moment(2.5, l) - F));
    if (l > 0.0 && l < 2.1)
      fit = std::max(fit, std::abs(4.4086e-5 * std::pow(4.0 - l, 6.804) / gauss_moment(2.5, l) - 1.0));
  }
  BOOST_TEST_MESSAGE("F_5/2 against the published table: " << worst
                                                           << " (tolerance 6e-6: its decimals); the fit is off by "
                                                           << fit << " between 0.5 and 2 (tolerance 0.1)");
  BOOST_TEST(worst < 6e-6);
  BOOST_TEST(fit < 0.1);
}

// Greenwood and Tripp summed pair by pair: paraboloids of radius beta whose axes are r apart meet like a sphere of
// radius beta/2 on a plane, with the indentation s - d - r^2/(4 beta), and Hertz' force in E' is
// F = (2/3) E' sqrt(R) delta^(3/2), as in contact/groups: a^3 = 3 F R/(2 E'), delta = a^2/R.
BOOST_AUTO_TEST_CASE(pairs_of_hertzian_asperities_give_greenwood_and_tripp) {
  const double sigma = steel.sigma, beta = sigma / steel.sigma_over_beta, eta = steel.eta_beta_sigma / (beta * sigma);
  const auto law = law_of("greenwood-tripp", steel);
  const auto single = law_of("greenwood-williamson", steel);
  const auto hertz = [&](double R, double delta) {
    return delta > 0.0 ? 2.0 / 3.0 * steel.E_prime * std::sqrt(R) * std::pow(delta, 1.5) : 0.0;
  };
  double worst = 0.0;
  for (const double l : {0.5, 1.5, 2.5}) {
    double pairs = 0.0, plane = 0.0;
    const int n = 4000;
    for (int k = 0; k < n; ++k) {  // heights s, of the sum of two, in sigma
      const double s = l + 8.0 * (k + 0.5) / n, weight = 8.0 / n * std::exp(-0.5 * s * s) / std::sqrt(2.0 * pi);
      plane += weight * hertz(beta, (s - l) * sigma);
      for (int m = 0; m < 200; ++m) {  // t = r^2/(4 beta), 2 pi r dr = 4 pi beta dt
        const double t = (s - l) * sigma * (m + 0.5) / 200;
        pairs += weight * 4.0 * pi * beta * (s - l) * sigma / 200 * hertz(0.5 * beta, (s - l) * sigma - t);
      }
    }
    worst = std::max({worst, std::abs(eta * eta * pairs / at(law, l * sigma) - 1.0),
                      std::abs(eta * plane / at(single, l * sigma) - 1.0)});
  }
  BOOST_TEST_MESSAGE("sums over Hertzian asperities: " << worst << " (tolerance 1e-3, of the sums)");
  BOOST_TEST(worst < 1e-3);
  // The light limit: area over pressure of asperities on a plane, A = pi a^2 = pi R delta each.
  const double area = asperities::area_greenwood_williamson(steel.eta_beta_sigma, 1.0);
  BOOST_TEST(std::abs(area / (pi * steel.eta_beta_sigma *
                              (std::exp(-0.5) / std::sqrt(2.0 * pi) - 0.5 * std::erfc(1.0 / std::sqrt(2.0)))) -
                      1.0) < 1e-10);
}

BOOST_AUTO_TEST_CASE(curves_are_smooth_monotone_and_capped) {
  auto law = law_of("greenwood-tripp", steel);
  double curve = 0.0;
  for (double l = -3.9; l < 8.0; l += 0.137) {
    const double exact = 16.0 * std::sqrt(2.0) * pi / 15.0 * 0.05 * 0.05 * 0.1 * 113e9 * gauss_moment(2.5, l);
    curve = std::max(curve, std::abs(at(law, l * steel.sigma) / exact - 1.0));
  }
  BOOST_TEST_MESSAGE("curve between its points: " << curve << " (tolerance 1e-7)");
  BOOST_TEST(curve < 1e-7);
  law.hardness = 0.5 * at(law, 0.0);
  law.gap_scale = 2e-6;
  law.p_h = 1e9;
  double slope = 0.0, before = 1e300;
  bool falls = true;
  for (double H = -0.1; H < 1.5; H += 0.0173) {
    const double step = 1e-6, difference = (at(law, H + step) - at(law, H - step)) / (2.0 * step);
    slope = std::max(slope, std::abs(difference - slope_at(law, H)) / std::abs(slope_at(law, H)));
    falls = falls && at(law, H) < before;
    before = at(law, H);
  }
  BOOST_TEST_MESSAGE("dP/dH with a cap, against differences: " << slope << " (tolerance 1e-5)");
  BOOST_TEST(slope < 1e-5);
  BOOST_TEST(falls);
  BOOST_TEST(at(law, -5.0) * law.p_h <= law.hardness);
  BOOST_TEST(at(law, -5.0) * law.p_h > 0.999 * law.hardness);
  BOOST_TEST(slope_at(law, -5.0) <= 0.0);
}

BOOST_AUTO_TEST_CASE(tables_of_gaps_and_pressures) {
  const support::TemporaryFolder folder;
  folder.write("p.csv", "gap [nm],pressure [MPa],film\n1000,0,1\n400,10,1\n100,1000,1\n800,1e-1,1\n");
  const std::string path = (folder / "p.csv");
  const auto law = law_of("table", {.table = path});
  BOOST_TEST(std::abs(at(law, 400e-9) / 10e6 - 1.0) < 1e-12);
  BOOST_TEST(std::abs(at(law, 100e-9) / 1e9 - 1.0) < 1e-12);
  // An exponential stays one, also outside the points.
  folder.write("e.csv", "gap [um],pressure [Pa]\n0,1e9\n0.1,1e8\n0.2,1e7\n");
  const auto exponential = law_of("table", {.table = (folder / "e.csv")});
  for (const double h : {-0.05e-6, 0.03e-6, 0.5e-6})
    BOOST_TEST(std::abs(at(exponential, h) / (1e9 * std::pow(10.0, -1e7 * h)) - 1.0) < 1e-9);
  const auto wrong = [&](const std::string& text) {
    folder.write("w.csv", text);
    const auto read = asperities::read_gap_table((folder / "w.csv"));
    const auto* message = std::get_if<std::string>(&read);
    return message == nullptr ? "" : message->substr(message->find("w.csv") + 5);
  };
  BOOST_TEST(wrong("gap [nm],pressure [MPa]\n1,5\n2,6\n3,1\n") ==
             ":3: the pressure must fall with the gap, and 6e+06 Pa at 2e-09 m is not below 5e+06 Pa at 1e-09 m");
  BOOST_TEST(wrong("gap [nm],pressure [MPa]\n1,5\n1,4\n3,1\n") == ":3: the gap 1e-09 m stands twice");
  BOOST_TEST(wrong("gap [nm],pressure [MPa]\n1,5\n2,-4\n3,1\n") == ":3: the pressure must be a finite number >= 0");
  BOOST_TEST(wrong("gap [nm],pressure [MPa]\n1,5\n2,4\n3,0\n") ==
             ": 2 rows with a pressure > 0 are too few: at least 3");
  BOOST_TEST(wrong("gap [nm],pressure [MPa],phi_x\n1,5,1\n2,4,1\n3,1,1\n") ==
             ": the columns phi_x and phi_y must both be there, or neither");
}

BOOST_AUTO_TEST_SUITE_END()
