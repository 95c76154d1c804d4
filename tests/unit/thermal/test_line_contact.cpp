// Heat of a line contact: bands on a moving half space, and a frozen film on its single line.
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "core/errors.hpp"
#include "thermal/source_convolution.hpp"
#include "unit/thermal/base_case.hpp"

BOOST_AUTO_TEST_SUITE(test_thermal_line_contact)

using namespace ehl::thermal;
using ehl::core::Field;
using ehl::core::line_grid;
using ehl::core::Patch;
using support::BaseCase, support::filled, support::settle;

namespace {

constexpr double pi = std::numbers::pi;

double uniform(double x) { return std::abs(x) <= 1.0 ? 1.0 : 0.0; }
double elliptic(double x) { return std::sqrt(std::max(0.0, 1.0 - x * x)); }

struct Hottest {
  double theta = 0.0, X = 0.0;  // in q0 sqrt(l/(pi rho c k u))
};
// 64 cells per diameter, each with the mean of the flux; the edges of the band are faces of cells.
Hottest hottest(double (*flux)(double), double Pe) {
  constexpr double h = 2.0 / 64;
  const Patch patch(line_grid(95, -1.5 + h / 2, 1.5 - h / 2));
  const Field q = filled(patch, [&](double x, double) {
    constexpr int points = 64;
    double sum = 0.0;
    for (int k = 0; k < points; ++k) sum += flux(x + h * ((k + 0.5) / points - 0.5)) / points;
    return sum;
  });
  Source source = make_source(patch, moving_source_table(patch.nx, 0, h, INFINITY, Pe), 1);
  Field theta(patch);
  std::visit([&](auto& sum) { sum.apply(q, theta); }, source);
  Hottest found;
  for (int i = 0; i <= patch.nx; ++i) {
    BOOST_REQUIRE(theta(i, 0) == theta(i, 1));
    BOOST_REQUIRE(theta(i, 2) == theta(i, 1));
    if (theta(i, 1) > found.theta) found = {theta(i, 1), patch.X(i)};
  }
  found.theta *= std::sqrt(pi * Pe);
  return found;
}

// P = sqrt(1 - X^2) and 370 nm everywhere; only conduction and shear.
Setup frozen(const Patch& patch) {
  Setup setup = BaseCase{}.setup(patch);
  setup.pressure_flow = false;
  setup.Pe = setup.compression = 0.0;
  return setup;
}
void settle_frozen(FilmTemperature& film, const Patch& patch) {
  film.take(filled(patch, [](double x, double) { return elliptic(x); }),
            filled(patch, [](double, double) { return BaseCase{}.H_of(370e-9); }));
  settle(film, 1e-10);
}

}  // namespace

// Carslaw and Jaeger: 2 sqrt 2 at the trailing edge of a uniform band, 2.18830667 at X = 0.652230 of an elliptic band.
BOOST_AUTO_TEST_CASE(bands_at_high_speed) {
  constexpr double Pe = 1e5, cell = 2.0 / 64;  // at this speed a body hardly conducts heat along X
  const Hottest of_elliptic = hottest(elliptic, Pe), of_uniform = hottest(uniform, Pe);
  const double off_elliptic = of_elliptic.theta / 2.18830667 - 1;
  const double off_uniform = of_uniform.theta / (2 * std::numbers::sqrt2) - 1;
  BOOST_TEST_MESSAGE("elliptic " << off_elliptic << " off at " << of_elliptic.X << "; uniform " << off_uniform
                                 << " off at " << of_uniform.X << " (tolerance 5e-3, a cell)");
  BOOST_TEST(std::abs(off_elliptic) < 5e-3);
  BOOST_TEST(std::abs(of_elliptic.X - 0.652230) < cell);
  BOOST_TEST(std::abs(off_uniform) < 5e-3);
  BOOST_TEST(std::abs(of_uniform.X - 1.0) < cell);
}

// The largest rise relative to that at high speed: the uniform band by two quadratures, the elliptic band by another
// quadrature of 1/pi int q exp(Pe s/2) K0(Pe |s|/2) dX'.
BOOST_AUTO_TEST_CASE(bands_at_any_speed) {
  struct Row {
    double Pe, uniform, elliptic;
  };
  for (const auto& [Pe, of_uniform, of_elliptic] : {Row{1, .8173, .8795},
                                                    {2, .8790, .9412},
                                                    {5, .9345, .9844},
                                                    {10, .9604, .9959},
                                                    {20, .9767, .9991},
                                                    {50, .9888, NAN},
                                                    {100, .9936, NAN}}) {
    const double flat = hottest(uniform, Pe).theta / (2 * std::numbers::sqrt2);
    const double round = hottest(elliptic, Pe).theta / 2.18830667;
    BOOST_TEST_MESSAGE("Pe = " << Pe << ": uniform " << flat << " (" << of_uniform << "), elliptic " << round << " ("
                               << of_elliptic << "), tolerance 5e-3");
    BOOST_TEST(std::abs(flat / of_uniform - 1) < 5e-3);
    if (!std::isnan(of_elliptic)) BOOST_TEST(std::abs(round / of_elliptic - 1) < 5e-3);
  }
}

// Heat and surface temperatures agree: k theta = 1/pi int q exp(Pe s/2) K0(Pe |s|/2) dX', by quadrature, with q linear
// between the nodes, and q_0 (X_a/X)^3 upstream of the first node.
BOOST_AUTO_TEST_CASE(surfaces_of_a_frozen_film) {
  const Patch patch(line_grid(256, -1.5, 1.5));
  Setup setup = frozen(patch);
  setup.body_1.Pe = 3.0;
  setup.body_2.Pe = 0.5;
  FilmTemperature film(setup);
  settle_frozen(film, patch);
  const auto rise = [&](const Field& q, const Body& body, int i) {
    const auto kernel = [&](double s) {
      const double z = 0.5 * body.Pe * std::abs(s);
      if (s > 0.0 && z > 100.0) return std::sqrt(pi / (2.0 * z)) * (1.0 - 1.0 / (8.0 * z));
      return std::exp(0.5 * body.Pe * s) * boost::math::cyl_bessel_k(0, z);
    };
    double sum = 0.0;
    for (int k = 0; k < patch.nx; ++k)
      sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          [&](double t) { return kernel((i - k - t) * patch.hx()) * ((1 - t) * q(k, 1) + t * q(k + 1, 1)); }, 0.0, 1.0,
          8, 1e-8);
    const double length = -patch.X(0);  // X = -length/u
    sum += q(0, 1) * length / patch.hx() *
           boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
               [&](double u) { return u * kernel(patch.X(i) + length / u); }, 1e-12, 1.0, 8, 1e-8);
    return body.resistance * patch.hx() * sum / pi;
  };
  double worst_1 = 0.0, worst_2 = 0.0, most_1 = 0.0, most_2 = 0.0;
  for (int i = 32; i <= patch.nx; i += 16) {
    const double theta_1 = film.theta(i, 1, setup.intervals), theta_2 = film.theta(i, 1, 0);
    most_1 = std::max(most_1, theta_1);
    most_2 = std::max(most_2, theta_2);
    worst_1 = std::max(worst_1, std::abs(theta_1 - rise(film.q_1(), setup.body_1, i)));
    worst_2 = std::max(worst_2, std::abs(theta_2 - rise(film.q_2(), setup.body_2, i)));
  }
  BOOST_TEST_MESSAGE("surface 1 " << worst_1 / most_1 << ", surface 2 " << worst_2 / most_2
                                  << " of the largest off (tolerance 2e-3)");
  BOOST_TEST(worst_1 < 2e-3 * most_1);
  BOOST_TEST(worst_2 < 2e-3 * most_2);
  BOOST_TEST(std::abs(film.balance().defect) < 1e-8);
}

BOOST_AUTO_TEST_CASE(begun_from_a_coarser_grid) {
  // Starting from the converged temperature at every second node, a sweep changes less than from an isothermal film.
  const Patch fine(line_grid(128, -1.5, 1.5)), coarse = ehl::core::coarsened(fine);
  FilmTemperature below(frozen(coarse)), film(frozen(fine)), cold(frozen(fine));
  settle_frozen(below, coarse);
  film.start_from(below);
  for (int i = 0; i <= coarse.nx; ++i)
    for (int k = 0; k <= 16; ++k) BOOST_REQUIRE(film.theta(2 * i, 1, k) == below.theta(i, 1, k));
  const Field P = filled(fine, [](double x, double) { return elliptic(x); });
  const Field H = filled(fine, [](double, double) { return BaseCase{}.H_of(370e-9); });
  film.take(P, H);
  cold.take(P, H);
  const double change = film.sweep(), of_cold = cold.sweep();
  BOOST_TEST_MESSAGE("changes by " << change / of_cold << " of a cold film (limit 0.1)");
  BOOST_TEST(change < 0.1 * of_cold);
}

BOOST_AUTO_TEST_CASE(a_surface_at_rest_is_refused) {
  const Patch patch(line_grid(64, -1.5, 1.5));
  for (Body Setup::*body : {&Setup::body_1, &Setup::body_2}) {
    Setup setup = frozen(patch);
    (setup.*body).Pe = 0.0;
    BOOST_CHECK_THROW(FilmTemperature{setup}, ehl::core::InputError);
    (setup.*body).resistance = 0.0;  // held at its temperature
    BOOST_CHECK_NO_THROW(FilmTemperature{setup});
  }
}

BOOST_AUTO_TEST_SUITE_END()
