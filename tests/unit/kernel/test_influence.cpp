// Influence coefficients compared with the closed form in quadruple precision, with adaptive quadrature, and
// with analytical properties.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "kernel/influence.hpp"

BOOST_AUTO_TEST_SUITE(test_kernel)

namespace {
using Quad = boost::multiprecision::cpp_bin_float_quad;
namespace kernel = ehl::kernel;

// y asinh(x/|y|) + x asinh(y/|x|) is odd in x and in y, so the four corners may lie in any quadrant.
Quad antiderivative(Quad x, Quad y) { return y * asinh(x / abs(y)) + x * asinh(y / abs(x)); }

Quad exact(int d_x, int d_y, double hx, double hy) {
  const Quad half = 0.5, x1 = (d_x - half) * hx, x2 = (d_x + half) * hx, y1 = (d_y - half) * hy, y2 = (d_y + half) * hy;
  return antiderivative(x2, y2) - antiderivative(x1, y2) - antiderivative(x2, y1) + antiderivative(x1, y1);
}

Quad exact_distributed(int d_x, int d_y, double hx, double hy) {
  return exact(d_x, d_y, hx, hy) - (exact(d_x + 1, d_y, hx, hy) + exact(d_x - 1, d_y, hx, hy) +
                                    exact(d_x, d_y + 1, hx, hy) + exact(d_x, d_y - 1, hx, hy)) /
                                       4;
}

double relative(double value, Quad truth) { return static_cast<double>(abs((value - truth) / truth)); }

double simpson(const std::function<double(double)>& f, double a, double b, double fa, double fm, double fb,
               double tol) {
  const double m = 0.5 * (a + b), l = f(0.5 * (a + m)), r = f(0.5 * (m + b));
  const double whole = (b - a) / 6 * (fa + 4 * fm + fb);
  const double halves = (b - a) / 12 * (fa + 4 * l + 2 * fm + 4 * r + fb);
  if (std::abs(halves - whole) < 15 * tol) return halves + (halves - whole) / 15;
  return simpson(f, a, m, fa, l, fm, tol / 2) + simpson(f, m, b, fm, r, fb, tol / 2);
}

double adaptive(const std::function<double(double)>& f, double a, double b) {
  return simpson(f, a, b, f(a), f(0.5 * (a + b)), f(b), 1e-13);
}

const int offsets[][2] = {{0, 0},       {1, 0},    {0, 1},    {1, 1},      {2, 0},   {3, 5},    {5, 3},
                          {6, 0},       {0, 6},    {7, 1},    {9, 20},     {31, 8},  {32, 0},   {33, 2},
                          {0, 100},     {90, 90},  {160, 0},  {161, 40},   {7, 511}, {1024, 3}, {2, 1024},
                          {1500, 1500}, {4000, 0}, {1, 4096}, {5000, 4000}};
const double cells[][2] = {{1.0, 1.0}, {6.0 / 512, 6.0 / 512}, {0.01, 0.013}, {0.02, 0.005}, {0.25, 1.0}};
}  // namespace

BOOST_AUTO_TEST_CASE(influence_agrees_with_quadruple_precision_near_and_far) {
  double worst = 0.0;
  for (const auto& cell : cells)
    for (const auto& d : offsets)
      worst = std::max(worst,
                       relative(kernel::influence(d[0], d[1], cell[0], cell[1]), exact(d[0], d[1], cell[0], cell[1])));
  BOOST_TEST_MESSAGE("largest relative error of K: " << worst << " (tolerance 1e-14: some ten rounding errors)");
  BOOST_TEST(worst < 1e-14);
}

BOOST_AUTO_TEST_CASE(influence_agrees_with_quadrature) {
  // The reference above uses the same antiderivative as the code; this one is independent.
  double worst = 0.0;
  for (const auto& d : {std::pair{1, 0}, {0, 1}, {1, 1}, {3, 2}, {8, 5}}) {
    const double hx = 0.7, hy = 1.1;
    const double truth = adaptive(
        [&](double x) {
          return adaptive([&](double y) { return 1.0 / std::hypot(x, y); }, (d.second - 0.5) * hy,
                          (d.second + 0.5) * hy);
        },
        (d.first - 0.5) * hx, (d.first + 0.5) * hx);
    worst = std::max(worst, std::abs(kernel::influence(d.first, d.second, hx, hy) / truth - 1.0));
  }
  BOOST_TEST_MESSAGE("largest relative deviation from quadrature: " << worst << " (tolerance 1e-11: the quadrature's)");
  BOOST_TEST(worst < 1e-11);
}

BOOST_AUTO_TEST_CASE(self_influence_of_square_and_rectangle) {
  const double h = 0.03, hx = 0.02, hy = 0.05;
  const double square = 4.0 * h * std::log(1.0 + std::numbers::sqrt2);
  const double rectangle = 2.0 * (hx * std::asinh(hy / hx) + hy * std::asinh(hx / hy));
  BOOST_TEST(std::abs(kernel::influence(0, 0, h, h) / square - 1.0) < 1e-15 * 10);
  BOOST_TEST(std::abs(kernel::influence(0, 0, hx, hy) / rectangle - 1.0) < 1e-15 * 10);
}

BOOST_AUTO_TEST_CASE(cells_add_up_to_a_larger_cell) {
  // 3 x 3 cells of size h form one cell of size 3h.
  double sum = 0.0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) sum += kernel::influence(3 * 2 + i, 3 * 4 + j, 0.1, 0.15);
  BOOST_TEST(std::abs(sum / kernel::influence(2, 4, 0.3, 0.45) - 1.0) < 1e-14);
}

BOOST_AUTO_TEST_CASE(table_is_the_function_and_symmetric) {
  const double hx = 0.01, hy = 0.013;
  const auto fine = kernel::influence_table(200, 170, hx, hy);
  const auto strided = kernel::influence_table(60, 90, hx, hy, 4, 2);
  double worst = 0.0, asymmetry = 0.0;
  for (int i = 0; i <= 200; i += 3)
    for (int j = 0; j <= 170; ++j) {
      worst = std::max(worst, std::abs(fine(-i, j) / kernel::influence(i, -j, hx, hy) - 1.0));
      asymmetry = std::max(asymmetry, std::abs(fine(i, j) / kernel::influence(j, i, hy, hx) - 1.0));
    }
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 90; ++j)
      worst = std::max(worst, std::abs(strided(i, -j) / kernel::influence(4 * i, 2 * j, hx, hy) - 1.0));
  BOOST_TEST_MESSAGE("table against function: " << worst << ", x and y exchanged: " << asymmetry
                                                << " (tolerance 1e-14)");
  BOOST_TEST(worst < 1e-14);
  BOOST_TEST(asymmetry < 1e-14);
}

BOOST_AUTO_TEST_CASE(distributed_influence_keeps_its_digits_far_away) {
  double worst = 0.0, worst_rectangular = 0.0;
  for (const auto& d : offsets) {
    worst = std::max(worst, relative(kernel::distributed_influence(d[0], -d[1], 0.011, 0.011),
                                     exact_distributed(d[0], d[1], 0.011, 0.011)));
    const double hx = 0.01, hy = 0.013, r = std::max(hx, std::hypot(d[0] * hx, d[1] * hy));
    const Quad difference = kernel::distributed_influence(-d[0], d[1], hx, hy) - exact_distributed(d[0], d[1], hx, hy);
    worst_rectangular =
        std::max(worst_rectangular, std::abs(static_cast<double>(difference)) / (hx * hy * hy * hy / (r * r * r)));
  }
  BOOST_TEST_MESSAGE("largest relative error of Delta K: " << worst << ", hx != hy: " << worst_rectangular
                                                           << " (tolerance 1e-12)");
  BOOST_TEST(worst < 1e-12);
  BOOST_TEST(worst_rectangular < 1e-12);
}

BOOST_AUTO_TEST_CASE(distributed_influence_approaches_its_limit) {
  // Far away Delta K -> -h^2/4 Laplace(1/r) h^2 = -h^4/(4 r^3).
  const double h = 0.5, r = 3000 * h;
  const double limit = -h * h * h * h / (4.0 * r * r * r);
  BOOST_TEST(std::abs(kernel::distributed_influence(3000, 0, h, h) / limit - 1.0) < 1e-6);
}

// -(x ln|x| - x) at both ends of the cell.
BOOST_AUTO_TEST_CASE(the_logarithm_of_a_line_contact) {
  const double h = 0.03;
  const auto antiderivative = [](Quad x) { return x * log(abs(x)) - x; };
  const auto exact_line = [&](int d) {
    const Quad half = 0.5;
    return -(antiderivative((d + half) * h) - antiderivative((d - half) * h));
  };
  double worst = 0.0;
  const std::vector<double> table = kernel::line_influence_table(2000, h);
  for (const int d : {0, 1, 2, 5, 6, 7, 30, 2000}) {
    worst = std::max(worst, std::abs(static_cast<double>(kernel::line_influence(d, h) - exact_line(d))));
    BOOST_TEST(kernel::line_influence(-d, h) == table[static_cast<std::size_t>(d)]);
  }
  BOOST_TEST_MESSAGE("largest error " << worst << " (tolerance 1e-15)");
  BOOST_TEST(worst < 1e-15);
  // The second difference of -ln x is 1/x^2.
  BOOST_TEST(std::abs(kernel::distributed_line_influence(500, h) / (-0.5 * h / (500.0 * 500.0)) - 1.0) < 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()
