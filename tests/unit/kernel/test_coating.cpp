// Coated bodies: the response against the equations of elasticity solved for a layer and the body below, the tables
// against quadrature, and the influence coefficients against the limits of thin and thick coatings.
#include <Eigen/Dense>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "kernel/kernel.hpp"

BOOST_AUTO_TEST_SUITE(test_coating)

using namespace ehl;
using kernel::Coating;
using kernel::SmoothPart;

namespace {

// Soft, stiff, incompressible, and the largest ratios allowed.
const std::vector<Coating> coatings{{{10.0, 0.2}, {1.0, 0.3}, 1.0, 0.5},    {{2.0, 0.3}, {1.0, 0.3}, 1.0, 0.5},
                                    {{0.1, 0.3}, {1.0, 0.25}, 1.0, 1.0},    {{0.01, 0.5}, {1.0, 0.3}, 1.0, 0.7},
                                    {{1000.0, 0.1}, {1.0, 0.45}, 1.0, 0.9}, {{0.001, 0.45}, {1.0, 0.3}, 1.0, 0.5}};

// Airy's function f(z) cos(k x) with f = (A + B z) exp(-k z) + (C + D z) exp(k (z - t)): derivatives by z up to the
// third, of the four parts, for k = 1.
Eigen::Matrix4d parts_at(double z, double t) {
  Eigen::Matrix4d f;  // row: part; column: derivative
  const double down = std::exp(-z), up = std::exp(z - t);
  f << down, -down, down, -down,                                 //
      z * down, (1 - z) * down, (z - 2) * down, (3 - z) * down,  //
      up, up, up, up,                                            //
      z * up, (1 + z) * up, (2 + z) * up, (3 + z) * up;
  return f;
}
// Displacements in plane strain, u_x = U sin x and u_z = W cos x, of Airy's function with these derivatives.
double U(const kernel::Material& m, const Eigen::Vector4d& f) {
  return (1.0 + m.nu) / m.E * ((1.0 - m.nu) * f[2] + m.nu * f[0]);
}
double W(const kernel::Material& m, const Eigen::Vector4d& f) {
  return (1.0 + m.nu) / m.E * ((1.0 - m.nu) * f[3] - (2.0 - m.nu) * f[1]);
}

// The response by the six conditions at the surface (pressure 1, no shear) and the interface (stresses, displacements).
double response_by_equations(const Coating& c, double t) {
  const Eigen::Matrix4d top = parts_at(0.0, t), bottom = parts_at(t, t), below = parts_at(0.0, 0.0);
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  for (int n = 0; n < 4; ++n) {
    const Eigen::Vector4d f = bottom.row(n);
    A.col(n) << top(n, 0), top(n, 1), f[0], f[1], U(c.coating, f), W(c.coating, f);
  }
  for (int n = 0; n < 2; ++n) {
    const Eigen::Vector4d f = below.row(n);
    A.col(4 + n) << 0.0, 0.0, -f[0], -f[1], -U(c.body, f), -W(c.body, f);
  }
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
  b[0] = 1.0;
  const Eigen::Matrix<double, 6, 1> x = A.fullPivLu().solve(b);
  const Eigen::Vector4d f = top.transpose() * x.head<4>();
  return W(c.coating, f) * c.body.E / (2.0 * (1.0 - c.body.nu * c.body.nu)) - 1.0;
}

// The smooth part by quadrature on panels far shorter than anything in the integrand.
double transform_of_response(const Coating& c, bool plane, double r) {
  const double local = kernel::local_response(c);
  double sum = 0.0;
  for (double q = 0.0; q < 34.0;) {
    const double next = std::min(34.0, q + std::min(1.0 / std::max(r, 2.0), 1e-4 + 0.3 * q));
    sum += boost::math::quadrature::gauss<double, 20>::integrate(
        [&](double k) {
          const double R = kernel::response(c, k);
          return plane ? (R + local * std::expm1(-k)) * std::cos(k * r) / k
                       : (R - local) * boost::math::cyl_bessel_j(0, k * r);
        },
        q, next);
    q = next;
  }
  return c.share * (plane ? sum + 0.5 * local * std::log1p(r * r) : sum);
}

double smooth_by_quadrature(const Coating& c, bool plane, double r) {
  return transform_of_response(c, plane, r) - (plane ? transform_of_response(c, plane, 1.0) : 0.0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_response_solves_the_equations_of_elasticity) {
  double worst = 0.0;
  for (const Coating& c : coatings)
    for (const double q : {0.01, 0.1, 0.5, 1.0, 2.0, 5.0, 12.0}) {
      const double exact = response_by_equations(c, q), scale = std::abs(kernel::local_response(c));
      worst = std::max(worst, std::abs(kernel::response(c, q) - exact) / scale);
    }
  BOOST_TEST_MESSAGE("largest error " << worst << " of R(infinity) (tolerance 1e-10)");
  BOOST_TEST(worst < 1e-10);
  for (const Coating& c : coatings) {
    BOOST_TEST(std::abs(kernel::response(c, 0.0)) < 1e-10);
    BOOST_TEST(std::abs(kernel::response(c, 30.0) / kernel::local_response(c) - 1.0) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_table_is_the_transform_of_the_response) {
  for (const bool plane : {false, true}) {
    double worst = 0.0;
    for (const Coating& c : coatings) {
      const SmoothPart smooth(c, plane);
      for (const double r : {0.0, 0.013, 0.377, 1.234, 3.3, 15.1, 61.0, 433.0, 2010.0})
        worst = std::max(worst, std::abs(smooth(r) - smooth_by_quadrature(c, plane, r)) *
                                    (plane ? 1.0 : std::max(r, 1.0)) / std::abs(smooth.local()));
    }
    BOOST_TEST_MESSAGE((plane ? "lines" : "points") << ": largest error " << worst << " (tolerance 1e-10)");
    BOOST_TEST(worst < 1e-10);
  }
}

// A load on a line is a row of point loads: 2 K_line(x), up to a constant, is the integral of K_point over y.
BOOST_AUTO_TEST_CASE(line_loads_are_rows_of_point_loads) {
  for (const Coating& c : {coatings[0], coatings[2], coatings[3]}) {
    const kernel::Kernel points{.coatings = {SmoothPart(c, false)}};
    const kernel::Kernel lines{.plane = true, .coatings = {SmoothPart(c, true)}};
    double worst = 0.0;
    const auto of_row = [&](double x) {
      double sum = 0.0;
      for (int panel = -56; panel < 56; ++panel)  // y = x sinh(s)
        sum += boost::math::quadrature::gauss<double, 20>::integrate(
            [&](double s) { return kernel::by_coatings(points, x * std::cosh(s)) * x * std::cosh(s); }, 0.25 * panel,
            0.25 * (panel + 1));
      return 0.5 * sum;
    };
    for (const double x : {0.3, 0.7, 4.0, 20.0})
      worst = std::max(worst, std::abs(of_row(x) - of_row(1.0) - kernel::by_coatings(lines, x)) /
                                  std::abs(lines.coatings[0].local()));
    BOOST_TEST_MESSAGE("modulus ratio " << c.coating.E << ": " << worst << " (tolerance 1e-8)");
    BOOST_TEST(worst < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(influence_coefficients_are_integrals_over_cells) {
  const double hx = 0.3, hy = 0.45;
  for (const double thickness : {0.003, 0.05, 0.4, 6.0})
    for (Coating c : {coatings[0], coatings[3]}) {
      c.thickness = thickness;
      const kernel::Kernel kernel{.coatings = {SmoothPart(c, false)}};
      const auto table = kernel::influence_table(kernel, 40, 30, hx, hy);
      const auto fine = kernel::influence_table(kernel, 121, 91, hx / 3.0, hy / 3.0);
      double worst = 0.0;
      for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {0, 2}, {3, 1}, {7, 5}, {18, 0}, {40, 30}}) {
        double sum = 0.0;
        for (int k = -1; k <= 1; ++k)
          for (int l = -1; l <= 1; ++l) sum += fine(3 * i + k, 3 * j + l);
        worst = std::max(worst, std::abs(sum / table(i, j) - 1.0));
        BOOST_TEST(std::abs(kernel::influence(kernel, -i, j, hx, hy) / table(i, j) - 1.0) < 1e-13);
      }
      BOOST_TEST_MESSAGE("thickness " << thickness << ": nine small cells differ by " << worst << " (tolerance 1e-9)");
      BOOST_TEST(worst < 1e-9);
    }
}

// In the limits of thickness the differences fall in proportion to it, and to its inverse.
BOOST_AUTO_TEST_CASE(thin_and_thick_coatings_are_half_spaces) {
  for (Coating c : {coatings[0], coatings[2]}) {
    const auto ratio = [&](double thickness, double of) {
      c.thickness = thickness;
      const kernel::Kernel kernel{.coatings = {SmoothPart(c, false)}};
      return kernel::influence(kernel, 1, 2, 0.1, 0.1) / kernel::influence(1, 2, 0.1, 0.1) / of - 1.0;
    };
    const double thin = ratio(1e-5, 1.0), thinner = ratio(1e-6, 1.0);
    const double local = 1.0 + c.share * kernel::local_response(c), thick = ratio(1e4, local),
                 thicker = ratio(1e5, local);
    BOOST_TEST_MESSAGE("thin " << thin << ", " << thinner << ", thick " << thick << ", " << thicker);
    BOOST_TEST((std::abs(thinner) < 1e-8 && std::abs(thicker) < 1e-5));
    BOOST_TEST((std::abs(thinner / thin) < 0.11 && std::abs(thicker / thick - 0.1) < 0.01));
  }
}

BOOST_AUTO_TEST_SUITE_END()
