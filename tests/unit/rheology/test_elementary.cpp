// exp, expm1 and log1p compared with long double, over the whole range of doubles.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "rheology/elementary.hpp"

BOOST_AUTO_TEST_SUITE(test_rheology_elementary)

using namespace ehl::rheology;
namespace core = ehl::core;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double one(const std::function<Lanes(Lanes)>& f, double x) { return f(broadcast(x))[0]; }

// The error in units of the last place of a double of this size, including subnormal numbers.
double error_in_ulp(double computed, long double exact) {
  if (std::isinf(computed) && exact > std::numeric_limits<double>::max()) return 0.0;
  const double rounded = static_cast<double>(exact);
  const double step = std::nextafter(std::abs(rounded), infinity) - std::abs(rounded);
  return static_cast<double>(std::abs(static_cast<long double>(computed) - exact) / step);
}

struct Worst {
  double error = 0.0;
  double at = 0.0;
};

Worst worst_error(const std::vector<double>& points, const std::function<Lanes(Lanes)>& f,
                  const std::function<long double(long double)>& exact) {
  Worst worst;
  for (const double x : points) {
    const double error = error_in_ulp(one(f, x), exact(static_cast<long double>(x)));
    if (!(error <= worst.error)) worst = {error, x};
  }
  return worst;
}

// Points between a and b with practically random last bits.
std::vector<double> spread(double a, double b, int count) {
  std::vector<double> points;
  for (int k = 0; k <= count; ++k) points.push_back(a + (b - a) * (k + 0.5 * std::sin(12.9898 * k)) / count);
  return points;
}

// Both signs of 10^-300 ... 10^limit, dense in the logarithm.
std::vector<double> sizes(double smallest_exponent, double largest_exponent, int count) {
  std::vector<double> points;
  for (const double e : spread(smallest_exponent, largest_exponent, count)) points.push_back(std::pow(10.0, e));
  return points;
}

void report(const char* what, const Worst& worst) {
  BOOST_TEST_MESSAGE(what << ": largest error " << worst.error << " ulp at " << worst.at << " (tolerance 2)");
  BOOST_TEST(worst.error <= 2.0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(exponential_within_two_ulp) {
  const auto f = [](Lanes x) { return exp(x); };
  const auto exact = [](long double x) { return std::exp(x); };
  report("exp on [-708, 709.7]", worst_error(spread(-708.0, 709.7, 300000), f, exact));
  report("exp on [-1, 1]", worst_error(spread(-1.0, 1.0, 100000), f, exact));
  report("exp of tiny arguments", worst_error(sizes(-300.0, -1.0, 20000), f, exact));
  report("exp where the result is subnormal", worst_error(spread(-746.0, -708.0, 20000), f, exact));
}

BOOST_AUTO_TEST_CASE(expm1_within_two_ulp) {
  const auto f = [](Lanes x) { return expm1(x); };
  const auto exact = [](long double x) { return std::expm1(x); };
  report("expm1 on [-70, 709.7]", worst_error(spread(-70.0, 709.7, 200000), f, exact));
  report("expm1 on [-2, 2]", worst_error(spread(-2.0, 2.0, 200000), f, exact));
  report("expm1 of tiny arguments", worst_error(sizes(-300.0, -1.0, 20000), f, exact));
}

BOOST_AUTO_TEST_CASE(log1p_within_two_ulp) {
  const auto f = [](Lanes x) { return log1p(x); };
  const auto exact = [](long double x) { return std::log1p(x); };
  report("log1p on (-1, 30]", worst_error(spread(-0.999999, 30.0, 300000), f, exact));
  report("log1p on [-0.5, 1]", worst_error(spread(-0.5, 1.0, 200000), f, exact));
  report("log1p of any size", worst_error(sizes(-300.0, 308.0, 50000), f, exact));
}

BOOST_AUTO_TEST_CASE(special_values) {
  const auto e = [](Lanes x) { return exp(x); };
  const auto e1 = [](Lanes x) { return expm1(x); };
  const auto l1 = [](Lanes x) { return log1p(x); };
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();

  BOOST_TEST(one(e, 0.0) == 1.0);
  BOOST_TEST(one(e, -0.0) == 1.0);
  BOOST_TEST(one(e, infinity) == infinity);
  BOOST_TEST(one(e, 709.79) == infinity);
  BOOST_TEST(one(e, 1e300) == infinity);
  BOOST_TEST(one(e, -infinity) == 0.0);
  BOOST_TEST(one(e, -745.2) == 0.0);
  BOOST_TEST(one(e, -1e300) == 0.0);
  BOOST_TEST(one(e, -745.0) == std::numeric_limits<double>::denorm_min());
  BOOST_TEST(std::isnan(one(e, not_a_number)));

  BOOST_TEST(one(e1, 0.0) == 0.0);
  BOOST_TEST(one(e1, infinity) == infinity);
  BOOST_TEST(one(e1, -infinity) == -1.0);
  BOOST_TEST(std::isnan(one(e1, not_a_number)));

  BOOST_TEST(one(l1, 0.0) == 0.0);
  BOOST_TEST(one(l1, infinity) == infinity);
  BOOST_TEST(one(l1, -1.0) == -infinity);
  BOOST_TEST(std::isnan(one(l1, -1.0000001)));
  BOOST_TEST(std::isnan(one(l1, -infinity)));
  BOOST_TEST(std::isnan(one(l1, not_a_number)));
}

BOOST_AUTO_TEST_CASE(lanes_do_not_mix) {
  const std::function<Lanes(Lanes)> functions[] = {[](Lanes x) { return exp(x); }, [](Lanes x) { return expm1(x); },
                                                   [](Lanes x) { return log1p(x); }};
  for (const auto& f : functions) {
    Lanes x{};
    for (int k = 0; k < core::lanes; ++k) x[k] = 0.37 * std::pow(7.0, k);
    x[core::lanes - 1] = std::numeric_limits<double>::quiet_NaN();
    const Lanes y = f(x);
    for (int k = 0; k + 1 < core::lanes; ++k) BOOST_TEST(y[k] == one(f, x[k]));
    BOOST_TEST(std::isnan(y[core::lanes - 1]));
  }
}

BOOST_AUTO_TEST_SUITE_END()
