// Dry contacts of coated bodies compared with an independent solution: the integral equation of a ball, solved in wave
// numbers without any influence coefficient; and with the textbook limits of thin layers.
#include <Eigen/Dense>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "dry/solve.hpp"
#include "kernel/cell_quadrature.hpp"
#include "kernel/kernel.hpp"

BOOST_AUTO_TEST_SUITE(test_coated)

using namespace ehl;
using kernel::Coating;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double load = 2.0 * pi / 3.0;

struct Ball {
  double a, P_centre, approach;
};

// Contact of a ball with radius a, with the kernel factor [1/r and what the coating adds]. The transform of the
// pressure is the integral of phi(s) cos(k s) over 0 < s < a, and phi, even in s, solves
//   (1 + D) phi(s) + (1/pi) integral of M(s - u) phi(u) over |u| < a = (approach - s^2)/(pi^2 factor),   phi(a) = 0,
// D = share R(infinity), M(x) = share integral of [R(k t) - R(infinity)] cos(k x) dk. The load is 2 pi times the
// integral of phi over 0 < s < a, and P(0) that of -phi'/s. (Green and Collins; Sneddon, Mixed Boundary Value Problems,
// 1966)
class IntegralEquation {
 public:
  IntegralEquation(const Coating& coating, double factor) : coating_(coating), factor_(factor) {
    using Panel = kernel::GaussRule<6>;
    constexpr double width = 0.25;
    for (int panel = 0; panel < 120; ++panel)
      for (std::size_t k = 0; k < Panel::node.size(); ++k) {
        const double q = width * (panel + 0.5 + Panel::node[k]);
        const double above = kernel::response(coating, q) - kernel::local_response(coating);
        waves_.push_back({q / coating.thickness, coating.share * above * width * Panel::weight[k] / coating.thickness});
      }
  }

  // phi as the values at Gauss' points s_k a of the half axis, and the load.
  struct Solution {
    Eigen::VectorXd phi;
    double load, approach;
  };
  Solution of_radius(double a) const {
    const int n = static_cast<int>(Rule::abscissa().size());
    Eigen::MatrixXd A(n + 1, n + 1);
    Eigen::VectorXd b(n + 1);
    const double local = coating_.share * kernel::local_response(coating_);
    for (int i = 0; i <= n; ++i) {  // the last point is the edge, where phi = 0
      const double s = i < n ? a * point(i) : a;
      for (int j = 0; j < n; ++j) {
        const double u = a * point(j);
        A(i, j) = a * weight(j) / pi * (M(s - u) + M(s + u)) + (i == j ? 1.0 + local : 0.0);
      }
      A(i, n) = -1.0 / (pi * pi * factor_);  // the approach
      b[i] = -s * s / (pi * pi * factor_);
    }
    const Eigen::VectorXd x = A.fullPivLu().solve(b);
    Solution solution{x.head(n), 0.0, x[n]};
    for (int j = 0; j < n; ++j) solution.load += 2.0 * pi * a * weight(j) * x[j];
    return solution;
  }
  // The contact under the load, by the secant method.
  Ball under_load() const {
    double before = 0.9, a = 1.0, load_before = of_radius(before).load;
    for (int k = 0; k < 20 && std::abs(a - before) > 1e-13; ++k) {
      const double now = of_radius(a).load;
      const double next = a - (now - load) * (a - before) / (now - load_before);
      before = a;
      load_before = now;
      a = next;
    }
    return {a, centre(of_radius(a), a), of_radius(a).approach};
  }

 private:
  using Rule = boost::math::quadrature::gauss<double, 40>;  // half of its points are the even part
  static double point(int k) { return Rule::abscissa()[static_cast<std::size_t>(k)]; }
  static double weight(int k) { return Rule::weights()[static_cast<std::size_t>(k)]; }

  double M(double x) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += wave.weight * std::cos(wave.k * x);
    return sum;
  }
  // P(0) = -integral of phi'/s: phi is even, and its polynomial in s^2 through the points gives phi'/s.
  static double centre(const Solution& solution, double a) {
    const int n = static_cast<int>(solution.phi.size());
    Eigen::MatrixXd powers(n, 10);
    for (int i = 0; i < n; ++i)
      for (int p = 0; p < 10; ++p) powers(i, p) = std::cos(2 * p * std::acos(point(i)));  // Chebyshev's, even
    const Eigen::VectorXd c = powers.colPivHouseholderQr().solve(solution.phi);
    double sum = 0.0;  // d T_2p(x)/dx = 2p U_2p-1(x)
    for (int i = 0; i < n; ++i)
      for (int p = 1; p < 10; ++p) {
        const double angle = std::acos(point(i));
        sum -= weight(i) * c[p] * 2 * p * std::sin(2 * p * angle) / std::sin(angle) / point(i);
      }
    return sum / a;
  }

  struct Wave {
    double k, weight;
  };
  Coating coating_;
  double factor_;
  std::vector<Wave> waves_;  ///< quadrature of M
};

dry::Solution solved(const Coating& coating, double factor, int cells, double half, mlmi::Method method) {
  const core::Patch grid = core::lower_half({cells, cells, -half, half, -half, half});
  return dry::solve({.grid = grid,
                     .gap = dry::smooth_gap(grid),
                     .load = load,
                     .deformation = {.method = method},
                     .parameters = {.tolerance = 1e-10},
                     .kernel = {.factor = factor, .coatings = {kernel::SmoothPart(coating, false)}}});
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_coated_ball_is_that_of_the_integral_equation) {
  // A coating of the body's material: the equation gives Hertz.
  const Ball hertz = IntegralEquation({{1, 0.3}, {1, 0.3}, 0.5, 0.5}, kernel::circular_factor).under_load();
  BOOST_TEST_MESSAGE("Hertz: a " << hertz.a << ", P(0) " << hertz.P_centre << ", approach " << hertz.approach);
  BOOST_TEST(
      (std::abs(hertz.a - 1) < 1e-12 && std::abs(hertz.P_centre - 1) < 1e-9 && std::abs(hertz.approach - 1) < 1e-12));
  for (const Coating& c : {Coating{{10.0, 0.2}, {1.0, 0.3}, 0.3, 0.5},
                           {{2.0, 0.2}, {1.0, 0.3}, 0.1, 0.5},
                           {{0.1, 0.3}, {1.0, 0.3}, 0.2, 0.5},
                           {{0.1, 0.49}, {1.0, 0.3}, 1.0, 0.5},
                           {{0.05, 0.5}, {1.0, 0.3}, 0.3, 1.0}}) {
    const Ball exact = IntegralEquation(c, kernel::circular_factor).under_load();
    double errors[2][2];
    for (int k = 0; k < 2; ++k) {
      const dry::Solution s = solved(c, kernel::circular_factor, 64 << k, 1.5 * exact.a, mlmi::Method::fft);
      errors[k][0] = s.P(32 << k, 32 << k) / exact.P_centre - 1.0;
      errors[k][1] = -s.H00 / exact.approach - 1.0;
    }
    BOOST_TEST_MESSAGE("E " << c.coating.E << ", nu " << c.coating.nu << ", t " << c.thickness << ": a " << exact.a
                            << ", P(0) " << exact.P_centre << ", approach " << exact.approach
                            << "; errors on 64 and 128 cells: P(0) " << errors[0][0] << ", " << errors[1][0]
                            << ", approach " << errors[0][1] << ", " << errors[1][1]
                            << " (tolerance on 128: 1e-3 and 3e-4)");
    BOOST_TEST(std::abs(errors[1][0]) < 1e-3);
    BOOST_TEST(std::abs(errors[1][1]) < 3e-4);
  }
}

// A ball on a thin layer on a nearly rigid body, in closed form: F = (16/9) E sqrt(R) d^(3/2) [1 + 1.133 x + 1.497 x^2
// + 1.469 x^3 + 0.755 x^4], x = sqrt(R d)/t, for an incompressible bonded layer and small x: the next term is of the
// size of x^5. source: Garcia and Garcia, Biophys. J. 114 (2018) 2923; the older series of Dimitriadis et al. (2002)
// has the same first term and smaller ones after it.
BOOST_AUTO_TEST_CASE(a_thin_incompressible_layer_follows_the_published_series) {
  for (const double thickness : {8.0, 4.0, 2.0}) {
    const Coating c{{1.0, 0.5}, {1000.0, 0.3}, thickness, 1.0};
    // Lengths in a, gaps in a^2/R: with E' of the layer, factor (1 + R(infinity)) = 2/pi^2, F = 16/9 E sqrt(R) d^(3/2)
    // is load = (2 pi/3) approach^(3/2), and x = sqrt(approach)/t.
    const double factor = kernel::circular_factor / (1.0 + kernel::local_response(c));
    const dry::Solution s = solved(c, factor, 128, 1.4, mlmi::Method::fft);
    const double d = -s.H00, x = std::sqrt(d) / thickness;
    const double series = 1.0 + x * (1.133 + x * (1.497 + x * (1.469 + x * 0.755)));
    const double off = load * d * std::sqrt(d) * series / load - 1.0;
    BOOST_TEST_MESSAGE("x = " << x << ": load of the series over that of the contact, less 1: " << off << " (tolerance "
                              << 0.002 + std::pow(x, 5) << ", with 0.002 for mesh and body)");
    BOOST_TEST(std::abs(off) < 0.002 + std::pow(x, 5));
  }
}

BOOST_AUTO_TEST_SUITE_END()
