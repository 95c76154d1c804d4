// Flash temperatures of a moving half space compared with closed forms: the moving line source (Carslaw and Jaeger), a
// body at rest (the elastic kernel, the uniform circle), and any speed in between.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/field.hpp"
#include "kernel/influence.hpp"
#include "thermal/moving_source.hpp"
#include "thermal/source_convolution.hpp"

BOOST_AUTO_TEST_SUITE(test_thermal_moving_source)

using namespace ehl::thermal;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;

namespace {

constexpr double pi = std::numbers::pi;
using Flux = std::function<double(double, double)>;

double uniform_circle(double x, double y) { return x * x + y * y <= 1 ? 1.0 : 0.0; }
double hertz_circle(double x, double y) { return std::sqrt(std::max(0.0, 1 - x * x - y * y)); }

// The mean of the flux over each cell, from points inside it.
Field sampled(const Patch& patch, const Flux& flux) {
  constexpr int points = 8;
  Field q(patch);
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j)
      for (int a = 0; a < points; ++a)
        for (int b = 0; b < points; ++b)
          q(i, j) += flux(patch.X(i) + patch.hx() * ((a + 0.5) / points - 0.5),
                          patch.Y(j) + patch.hy() * ((b + 0.5) / points - 0.5)) /
                     (points * points);
  return q;
}

struct Rise {
  double largest = 0.0, mean = 0.0, centre = 0.0;
};
// in: cells per diameter.
Rise rise(const Flux& flux, double Pe, int cells, bool half = false) {
  const Grid grid{cells * 3 / 2, cells * 3 / 2, -1.5, 1.5, -1.5, 1.5};
  const Patch patch = half ? ehl::core::lower_half(grid) : Patch(grid);
  const Field q = sampled(patch, flux);
  SourceConvolution convolution(patch, moving_source_table(grid.nx, grid.ny, grid.hx(), grid.hy(), Pe), 2);
  Field theta(patch);
  convolution.apply(q, theta);
  Rise found;
  double area = 0.0;
  const Field inside = sampled(patch, uniform_circle);
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) {
      found.largest = std::max(found.largest, theta(i, j));
      found.mean += patch.lines(j) * inside(i, j) * theta(i, j);
      area += patch.lines(j) * inside(i, j);
    }
  found.mean /= area;
  found.centre = theta(patch.nx / 2, grid.ny / 2);
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(at_rest_it_is_the_elastic_kernel) {
  for (const double ratio : {1.0, 2.0}) {
    const double hx = 0.05, hy = hx * ratio;
    const SourceTable table = moving_source_table(20, 30, hx, hy, 0.0);
    double worst = 0.0;
    for (int i = -20; i <= 20; ++i)
      for (int j = 0; j <= 30; ++j)
        worst = std::max(worst, std::abs(table(i, j) * 2 * pi / ehl::kernel::influence(i, j, hx, hy) - 1));
    BOOST_TEST_MESSAGE("hy/hx = " << ratio << ": Love's cell " << worst << " off (tolerance 1e-5)");
    BOOST_TEST(worst < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(the_table_against_the_kernel_far_from_the_cell) {
  // At a distance of a few cells, the cell acts as a point source at its centre; Pe h << 1.
  const double h = 0.01;
  for (const double Pe : {0.5, 5.0, 20.0}) {
    const SourceTable table = moving_source_table(100, 100, h, h, Pe);
    double worst = 0.0;
    for (const auto& [i, j] : {std::pair{100, 0}, {60, 30}, {40, 80}, {-5, 12}, {-30, 3}, {90, 20}}) {
      const double x = i * h, y = j * h, r = std::hypot(x, y);
      worst = std::max(worst, std::abs(table(i, j) / (h * h * std::exp(-0.5 * Pe * (r - x)) / (2 * pi * r)) - 1));
    }
    BOOST_TEST_MESSAGE("Pe = " << Pe << ": " << worst << " off (tolerance 4e-3: the size of the cell)");
    BOOST_TEST(worst < 4e-3);
  }
}

BOOST_AUTO_TEST_CASE(fast_it_is_lines) {
  // A strip as wide as the table: its sum along Y is Carslaw and Jaeger's cell, 2 [sqrt(m + 1/2) - sqrt(m - 1/2)].
  const double h = 0.05;
  for (const double Pe : {1e4, 1e5}) {
    const SourceTable table = moving_source_table(40, 20, h, h, Pe);
    double worst = 0.0;
    for (int m = 0; m <= 40; ++m) {
      double sum = table(m, 0);
      for (int j = 1; j <= 20; ++j) sum += 2 * table(m, j);
      const double lines = 2 * std::sqrt(h / (pi * Pe)) * (std::sqrt(m + 0.5) - (m == 0 ? 0.0 : std::sqrt(m - 0.5)));
      worst = std::max(worst, std::abs(sum / lines - 1));
    }
    BOOST_TEST_MESSAGE("Pe = " << Pe << ": lines " << worst << " off (tolerance 4/(Pe h))");
    BOOST_TEST(worst < 4 / (Pe * h));
  }
}

BOOST_AUTO_TEST_CASE(flash_temperatures_of_lines) {
  // In q0 sqrt(l/(pi rho c k u)): uniform flux 2 sqrt 2 at the trailing edge, mean 4 sqrt 2/3; q0 sqrt(1 - X^2):
  // 2.18830667 at X = 0.652230, centre 1.74803837, mean 1.50849447.
  for (const int cells : {32, 64, 128}) {
    const double h = 2.0 / cells;
    const std::vector<double> w = line_weights(cells, h, 1 / pi);
    const auto temperature = [&](int i, const auto& q) {
      double sum = 0.0;
      for (int m = 0; m <= i; ++m) sum += w[static_cast<std::size_t>(m)] * q(-1 + (i - m) * h);
      return sum;
    };
    const auto hertz = [](double x) { return std::sqrt(std::max(0.0, 1 - x * x)); };
    double most = 0.0, mean = 0.0;
    for (int i = 0; i <= cells; ++i) {
      most = std::max(most, temperature(i, hertz));
      mean += (i == 0 || i == cells ? 0.5 : 1.0) / cells * temperature(i, hertz);
    }
    const double off[] = {temperature(cells, [](double) { return 1.0; }) / (2 * std::numbers::sqrt2) - 1,
                          most / 2.18830667 - 1, temperature(cells / 2, hertz) / 1.74803837 - 1, mean / 1.50849447 - 1};
    BOOST_TEST_MESSAGE(cells << " cells: uniform " << off[0] << ", Hertz largest " << off[1] << ", centre " << off[2]
                             << ", mean " << off[3] << " off (tolerance 5e-3 at 64)");
    if (cells >= 64)
      for (const double e : off) BOOST_TEST(std::abs(e) < 5e-3);
  }
}

// Reference: 1/pi int exp(Pe s/2) K0(Pe |s|/2) dx' by quadrature, confirmed by a source that passes (two programs).
BOOST_AUTO_TEST_CASE(an_endless_strip_at_any_speed) {
  constexpr double speeds[] = {1, 2, 5, 10, 20, 50, 100};
  constexpr double largest[] = {1.304172, 0.991850, 0.666883, 0.484640, 0.348500, 0.223137, 0.158561};
  constexpr double centre[] = {1.213119, 0.863916, 0.528005, 0.365445, 0.255411, 0.160369, 0.113119};
  constexpr int n = 500;  // cells on either side of the middle one
  for (std::size_t k = 0; k < std::size(speeds); ++k) {
    const SourceTable table = moving_source_table(2 * n, 0, 2.0 / (2 * n + 1), INFINITY, speeds[k]);
    double most = 0.0, middle = 0.0;
    for (int i = -n; i <= n; ++i) {
      double theta = 0.0;
      for (int m = -n; m <= n; ++m) theta += table(i - m, 0);
      most = std::max(most, theta);
      if (i == 0) middle = theta;
    }
    BOOST_TEST_MESSAGE("Pe = " << speeds[k] << ": largest " << most / largest[k] - 1 << ", centre "
                               << middle / centre[k] - 1 << " off (tolerances 1e-4, 1e-5)");
    BOOST_TEST(std::abs(most / largest[k] - 1) < 1e-4);
    BOOST_TEST(std::abs(middle / centre[k] - 1) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(a_circle_at_rest) {
  // Uniform flux: q a/k at the centre, mean 8/(3 pi).
  const Rise found = rise(uniform_circle, 0.0, 64);
  BOOST_TEST_MESSAGE("centre " << found.centre - 1 << ", mean " << found.mean / (8 / (3 * pi)) - 1
                               << " off (tolerance 5e-3)");
  BOOST_TEST(std::abs(found.centre - 1) < 5e-3);
  BOOST_TEST(std::abs(found.mean / (8 / (3 * pi)) - 1) < 5e-3);
}

BOOST_AUTO_TEST_CASE(circles_at_any_speed) {
  // The largest rise relative to that of the line source, 2.18830667 and 2 sqrt 2 in q0 sqrt(a/(pi rho c k u)).
  constexpr double speeds[] = {2, 5, 10, 20, 50, 100};
  constexpr double hertz[] = {0.670, 0.825, 0.905, 0.951, 0.980, 0.990};
  constexpr double uniform[] = {0.649, 0.808, 0.897, 0.948, 0.977, 0.988};
  for (std::size_t k = 0; k < 6; ++k) {
    const double unit = 1 / std::sqrt(pi * speeds[k]);
    const double round = rise(hertz_circle, speeds[k], 64).largest / (2.18830667 * unit);
    const double flat = rise(uniform_circle, speeds[k], 64).largest / (2 * std::numbers::sqrt2 * unit);
    BOOST_TEST_MESSAGE("Pe = " << speeds[k] << ": Hertz " << round << " (" << hertz[k] << "), uniform " << flat << " ("
                               << uniform[k] << "), tolerance 5e-3");
    BOOST_TEST(std::abs(round / hertz[k] - 1) < 5e-3);
    BOOST_TEST(std::abs(flat / uniform[k] - 1) < 5e-3);
  }
}

BOOST_AUTO_TEST_CASE(any_number_of_threads_and_one_half) {
  const Grid grid{24, 32, -1.5, 1.5, -1.5, 1.5};
  const SourceTable table = moving_source_table(grid.nx, grid.ny, grid.hx(), grid.hy(), 7.0);
  const Patch half = ehl::core::lower_half(grid);
  const Field q = sampled(grid, hertz_circle), q_half = sampled(half, hertz_circle);
  Field one(grid), three(grid), of_half(half);
  SourceConvolution(grid, table, 1).apply(q, one);
  SourceConvolution(grid, table, 3).apply(q, three);
  SourceConvolution(half, table, 2).apply(q_half, of_half);
  double direct_gap = 0.0, half_gap = 0.0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) {
      BOOST_REQUIRE(one(i, j) == three(i, j));
      if (j <= half.ny) half_gap = std::max(half_gap, std::abs(of_half(i, j) - one(i, j)));
      double sum = 0.0;
      for (int k = 0; k <= grid.nx; ++k)
        for (int l = 0; l <= grid.ny; ++l) sum += table(i - k, j - l) * q(k, l);
      direct_gap = std::max(direct_gap, std::abs(sum - one(i, j)));
    }
  BOOST_TEST_MESSAGE("direct sum " << direct_gap << ", one half " << half_gap << " off (tolerance 1e-13)");
  BOOST_TEST(direct_gap < 1e-13);
  BOOST_TEST(half_gap < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
