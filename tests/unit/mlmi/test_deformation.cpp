// The direct sum compared with the half-space under a Hertz pressure, and the Fourier sum with the direct sum.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/norms.hpp"
#include "mlmi/deformation.hpp"
#include "mlmi/even_convolution.hpp"
#include "unit/mlmi/pressures.hpp"

BOOST_AUTO_TEST_SUITE(test_deformation)

namespace mlmi = ehl::mlmi;
using ehl::core::Field;
using ehl::core::Grid;
using mlmi::Method;

using ehl::tests::deformation;

namespace {

double hertz(double X, double Y) { return std::sqrt(std::max(0.0, 1.0 - X * X - Y * Y)); }

}  // namespace

BOOST_AUTO_TEST_CASE(direct_sum_converges_to_the_hertz_deformation) {
  // (2/pi^2) K*sqrt(1-r^2) = 1 - r^2/2 inside the circle. At the edge the pressure has an infinite slope, which
  // limits the order to 3/2, with a constant that depends on the position of the nodes. The mean over the circle
  // and four grids smooths this.
  double mean[4];
  for (int k = 0; k < 4; ++k) {
    const int n = 32 << k;
    const Grid grid{n, n, -1.5, 1.5, -1.5, 1.5};
    const Field w = deformation(grid, ehl::tests::sampled(grid, hertz), {.method = Method::direct});
    double sum = 0.0;
    int points = 0;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        const double r2 = grid.X(i) * grid.X(i) + grid.Y(j) * grid.Y(j);
        if (r2 > 1.0) continue;
        sum += std::pow(w(i, j) - (1.0 - 0.5 * r2), 2);
        ++points;
      }
    mean[k] = std::sqrt(sum / points);
    BOOST_TEST_MESSAGE("n = " << n << ": mean square error inside the circle " << mean[k]);
  }
  const double order = std::log2(mean[0] / mean[3]) / 3.0;
  BOOST_TEST_MESSAGE("order " << order << " (at least 1.5), on the finest grid at most 5e-5");
  BOOST_TEST(order > 1.5);
  BOOST_TEST(mean[3] < 5e-5);
}

BOOST_AUTO_TEST_CASE(fourier_is_the_direct_sum) {
  for (const Grid& grid : {Grid{32, 32, -3, 3, -3, 3}, Grid{48, 20, -4, 2, -1.5, 1.5}, Grid{17, 33, -2, 2, -3, 3}}) {
    const Field P = ehl::tests::rough(grid);
    const Field truth = deformation(grid, P, {.method = Method::direct});
    const Field w = deformation(grid, P, {.method = Method::fft});
    const double error = ehl::core::max_abs_difference(w, truth) / ehl::core::max_abs(truth);
    BOOST_TEST_MESSAGE(grid.nx << " x " << grid.ny << ": FFT - direct " << error << " (tolerance 1e-13)");
    BOOST_TEST(error < 1e-13);
  }
}

// Any number of points, odd and even half lengths, kernels that are not smooth.
BOOST_AUTO_TEST_CASE(an_even_convolution_is_the_direct_sum) {
  for (const std::size_t points : {1, 2, 3, 4, 5, 6, 7, 10, 33, 101, 510, 513, 1000, 1025}) {
    std::vector<double> K(points), u(points), w(points), truth(points);
    for (std::size_t k = 0; k < points; ++k) {
      K[k] = k % 3 == 1 ? 2.0 : -std::log(0.3 + static_cast<double>(k));
      u[k] = std::sin(7.0 * static_cast<double>(k * k) + 1.0);
    }
    double largest = 0.0, error = 0.0;
    mlmi::EvenConvolution convolution(K);
    for (int time = 0; time < 2; ++time) convolution.apply(u, w);  // nothing remains of the first transform
    for (std::size_t i = 0; i < points; ++i) {
      for (std::size_t k = 0; k < points; ++k) truth[i] += K[i > k ? i - k : k - i] * u[k];
      largest = std::max(largest, std::abs(truth[i]));
      error = std::max(error, std::abs(w[i] - truth[i]));
    }
    BOOST_TEST_MESSAGE(points << " points: " << error / largest << " (tolerance 1e-13)");
    BOOST_TEST(error <= 1e-13 * largest);
  }
}

// -(1/pi) integral of sqrt(1 - s^2) ln|X - s| ds = 1/4 + ln(2)/2 - X^2/2 inside, equal on all lines.
BOOST_AUTO_TEST_CASE(a_line_contact_deforms_as_hertz_said) {
  const Grid grid = ehl::core::line_grid(2048, -4.0, 2.0);
  Field P(grid), w(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) P(i, j) = hertz(grid.X(i), 0.0);
  for (const Method method : {Method::mlmi, Method::fft, Method::direct}) {
    mlmi::Deformation(grid, {.method = method}, 1, ehl::kernel::half_plane(1.0 / ehl::core::pi)).evaluate(P, w);
    double worst = 0.0;
    for (int i = 0; i <= grid.nx; ++i) {
      const double X = grid.X(i);
      if (std::abs(X) < 1.0)
        worst = std::max(worst, std::abs(w(i, 1) - (0.25 + 0.5 * std::numbers::ln2 - 0.5 * X * X)));
      BOOST_TEST_REQUIRE((w(i, 0) == w(i, 1) && w(i, 2) == w(i, 1)));
    }
    BOOST_TEST_MESSAGE("largest error " << worst << " (tolerance 2e-4)");  // the edge limits the order to 3/2
    BOOST_TEST(worst < 2e-4);
  }
}

BOOST_AUTO_TEST_CASE(multilevel_sums_along_a_line_are_the_direct_sum) {
  const Grid grid = ehl::core::line_grid(512, -4.0, 2.0);
  Field P(grid), truth(grid), w(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) P(i, j) = hertz(grid.X(i), 0.0) + (i % 3 == 0 ? 0.1 : 0.0);
  mlmi::Deformation(grid, {.method = Method::direct}, 1, ehl::kernel::half_plane(1.0)).evaluate(P, truth);
  for (const auto& [order, tolerance] : {std::pair{4, 1e-4}, {6, 1e-5}, {8, 2e-6}}) {
    const mlmi::Parameters parameters{.order = order, .patch_along = 12, .coarsenings = 3};
    mlmi::Deformation(grid, parameters, 1, ehl::kernel::half_plane(1.0)).evaluate(P, w);
    const double error = ehl::core::max_abs_difference(w, truth) / ehl::core::max_abs(truth);
    BOOST_TEST_MESSAGE("order " << order << ": " << error << " (tolerance " << tolerance << ")");
    BOOST_TEST(error < tolerance);
  }
}

BOOST_AUTO_TEST_SUITE_END()
