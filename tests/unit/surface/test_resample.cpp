// Maps on meshes: exact means of polynomials, the amplitude of a wave, its motion, and the variance lost.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "core/norms.hpp"
#include "surface/resample.hpp"

BOOST_AUTO_TEST_SUITE(test_surface_resample)

using namespace ehl;
using namespace ehl::surface;

namespace {

constexpr double pi = std::numbers::pi;

/// A map with its centre at (X, Y) and gap = function of the coordinates.
template <class Function>
HeightMap map_of(int nx, int ny, double dx, double dy, double X, double Y, Function function) {
  HeightMap map{
      .gap = {nx, ny, std::vector<double>(static_cast<std::size_t>(nx * ny))}, .dx = dx, .dy = dy, .X = X, .Y = Y};
  for (int l = 0; l < ny; ++l)
    for (int k = 0; k < nx; ++k)
      map.gap(k, l) = function(X - 0.5 * map.length_x() + k * dx, Y - 0.5 * map.length_y() + l * dy);
  return map;
}

core::Field on_mesh(const HeightMap& map, const core::Patch& grid, double distance = 0.0) {
  core::Field S(grid);
  add_average(map, grid, distance, S);
  return S;
}

double sinc(double x) { return std::sin(x) / x; }

/// The factor of a wave with n points under Keys' cubic convolution: the transform of its kernel, by Simpson's rule.
double factor_of_keys(double n) {
  const auto kernel = [](double u) {
    return u < 1.0 ? 1.0 - 2.5 * u * u + 1.5 * u * u * u : 2.0 - 4.0 * u + 2.5 * u * u - 0.5 * u * u * u;
  };
  constexpr int steps = 4000;
  double sum = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const double u = 2.0 * k / steps;
    const double weight = k == 0 || k == steps ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0);
    sum += weight * kernel(u) * std::cos(2.0 * pi * u / n);
  }
  return 2.0 * sum * (2.0 / steps) / 3.0;
}

}  // namespace

// The mean of p over a cell is p + h^2/24 (p_XX + p_YY) for a polynomial of degree two in each variable without its
// highest term. It must be exact inside the map, on finer, coarser and much coarser meshes, hx != hy.
BOOST_AUTO_TEST_CASE(means_of_polynomials_are_exact) {
  const auto p = [](double X, double Y) { return 0.3 + 0.7 * X - 0.2 * Y + 1.1 * X * X - 0.6 * X * Y + 0.4 * Y * Y; };
  const HeightMap map = map_of(90, 70, 0.037, 0.051, 0.11, -0.23, p);
  for (const int n : {4, 16, 64, 256}) {
    const core::Grid grid{n, 2 * n, -0.9, 0.9, -0.8, 0.8};
    const core::Field S = on_mesh(map, grid);
    const double more = (2.2 * grid.hx() * grid.hx() + 0.8 * grid.hy() * grid.hy()) / 24.0;
    double worst = 0.0;
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) worst = std::max(worst, std::abs(S(i, j) - p(grid.X(i), grid.Y(j)) - more));
    BOOST_TEST_MESSAGE(n << " cells, hx/dx = " << grid.hx() / map.dx << ": largest error " << worst
                         << " (allowed 2e-13)");
    BOOST_TEST(worst < 2e-13);
  }
}

// A wave with n points per length on a mesh of size h: the amplitude factor is that of Keys times
// that of the mean over a cell.
BOOST_AUTO_TEST_CASE(a_wave_keeps_its_factor) {
  constexpr double wave = 0.5;
  for (const double cells : {20.0, 4.0, 2.5, 0.8}) {
    const double h = wave / cells;
    const core::Grid grid{24, 16, -12 * h, 12 * h, -8 * h, 8 * h};
    const double dx = wave / 10.0;  // ten points per wave
    const auto points = static_cast<int>(30.0 * h / dx) + 40;
    const HeightMap map =
        map_of(points, points, dx, dx, 0.0, 0.0, [&](double X, double) { return std::cos(2.0 * pi * X / wave); });
    const core::Field S = on_mesh(map, grid);
    // The convolution also creates waves of 9 and 11 points' length, together of the order (1/10)^3.
    const double factor = factor_of_keys(10.0) * sinc(pi / cells);
    double sum = 0.0, squares = 0.0, worst = 0.0;
    for (int i = 0; i <= grid.nx; ++i) {
      const double exact = std::cos(2.0 * pi * grid.X(i) / wave);
      sum += S(i, 8) * exact;
      squares += exact * exact;
      worst = std::max(worst, std::abs(S(i, 8) - factor * exact));
    }
    BOOST_TEST_MESSAGE(cells << " cells to a wave: " << sum / squares << " of the amplitude left, exact " << factor
                             << ", worst node " << worst);
    BOOST_TEST(std::abs(sum / squares - factor) < 2e-3);
    BOOST_TEST(worst < 5e-3);
  }
}

BOOST_AUTO_TEST_CASE(a_map_moves_with_its_surface_smoothly) {
  const HeightMap map = map_of(40, 30, 0.05, 0.04, -0.2, 0.1, [](double X, double Y) {
    return std::exp(-20.0 * (X + 0.2) * (X + 0.2) - 20.0 * (Y - 0.1) * (Y - 0.1));
  });
  const core::Grid grid{64, 48, -2.0, 2.0, -1.5, 1.5};
  // If the map is moved by whole cells, the field is shifted; if it leaves the domain, nothing remains.
  const core::Field before = on_mesh(map, grid);
  const core::Field after = on_mesh(map, grid, 8 * grid.hx());
  double apart = 0.0;
  for (int i = 8; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) apart = std::max(apart, std::abs(after(i, j) - before(i - 8, j)));
  BOOST_TEST(apart < 1e-15);
  BOOST_TEST(core::max_abs(on_mesh(map, grid, 10.0)) == 0.0);
  BOOST_TEST(core::max_abs(on_mesh(map, grid, -1e6)) == 0.0);
  // Two continuous derivatives with respect to the distance: at a point of the map the second difference jumps by O(e).
  const auto at = [&](double distance) { return on_mesh(map, grid, distance)(30, 24); };
  const auto second = [&](double distance, double e) {
    return (at(distance + e) - 2.0 * at(distance) + at(distance - e)) / (e * e);
  };
  double jump = 0.0, largest = 0.0;
  for (int k = 0; k < 400; ++k) {
    const double d = -0.5 + 0.0025 * k;
    jump = std::max(jump, std::abs(second(d + 0.0025, 1e-4) - second(d, 1e-4)));
    largest = std::max(largest, std::abs(second(d, 1e-4)));
  }
  BOOST_TEST_MESSAGE("second derivative up to " << largest << ", from step to step of 0.0025 it changes by " << jump);
  BOOST_TEST(jump < 0.1 * largest);
}

// Two waves, whole numbers of them on a map with negligible edges: the lost share of the variance
// follows from the factors.
BOOST_AUTO_TEST_CASE(lost_variance_of_two_waves) {
  constexpr double dx = 0.01;
  constexpr int points = 1600;
  const auto waves = [](double X, double) {
    return 1.0 * std::cos(2.0 * pi * X / 0.4) + 0.5 * std::cos(2.0 * pi * X / 0.05);
  };
  const HeightMap map = map_of(points, 12, dx, 10.0, 0.0, 0.0, waves);
  const core::Grid grid{64, 16, -1.5, 1.5, -1e-3, 1e-3};  // hx = 0.046875: the short wave is hardly longer than a cell
  const double a = factor_of_keys(40.0) * sinc(pi * grid.hx() / 0.4);
  const double b = factor_of_keys(5.0) * sinc(pi * grid.hx() / 0.05);
  const double exact = 1.0 - (a * a + 0.25 * b * b) / 1.25;
  const Resolution left = resolution(map, grid);
  BOOST_TEST_MESSAGE("variance lost " << left.variance_lost << ", exact " << exact << "; shortest wave "
                                      << left.shortest_wave_X << ", " << left.shortest_wave_Y);
  // The ends of the map, where the means fade to zero, are hx/length = 3e-3 of it.
  BOOST_TEST(std::abs(left.variance_lost - exact) < 4e-3);
  BOOST_TEST(left.shortest_wave_X == 2.0 * grid.hx());
  BOOST_TEST(left.shortest_wave_Y == 20.0);  // the points of the map are farther apart
  const core::Grid fine{1024, 16, -1.5, 1.5, -1e-3, 1e-3};
  BOOST_TEST_MESSAGE("on a fine mesh " << resolution(map, fine).variance_lost);
  BOOST_TEST(resolution(map, fine).variance_lost < 0.02);
}

BOOST_AUTO_TEST_CASE(the_lower_half_is_that_of_the_whole) {
  const HeightMap map =
      map_of(40, 30, 0.1, 0.1, 0.0, 0.0, [](double X, double Y) { return std::sin(3.0 * X) * Y * Y; });
  const core::Grid grid{32, 32, -2.5, 1.5, -2.0, 2.0};
  const core::Field whole = on_mesh(map, grid);
  const core::Field half = on_mesh(map, core::lower_half(grid));
  double apart = 0.0;
  for (int i = 0; i <= 32; ++i)
    for (int j = 0; j <= 16; ++j) apart = std::max(apart, std::abs(whole(i, j) - half(i, j)));
  BOOST_TEST(apart < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
