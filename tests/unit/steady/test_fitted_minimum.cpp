// The minimum film between the nodes.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "core/norms.hpp"
#include "judgement/fitted_minimum.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_fitted_minimum)

using namespace ehl;
using namespace ehl::judgement;
using boost::test_tools::tolerance;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding = 1e-14;

core::Field film(const core::Grid& grid, const std::function<double(double, double)>& H) {
  core::Field field(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) field(i, j) = H(grid.X(i), grid.Y(j));
  return field;
}

/// 9 x 11 nodes, hx = 0.25, hy = 0.2.
constexpr core::Grid small_grid{8, 10, -1.0, 1.0, -1.0, 1.0};

}  // namespace

// An oblique valley with its minimum between the nodes is reproduced exactly.
BOOST_AUTO_TEST_CASE(exact_for_a_paraboloid) {
  for (const double X : {0.03, -0.11})
    for (const double Y : {0.46, -0.32}) {
      const auto H = [&](double x, double y) {
        const double u = x - X;
        const double v = y - Y;
        return 0.7 + 2.0 * u * u - 1.3 * u * v + 0.9 * v * v;
      };
      const core::Field field = film(small_grid, H);
      const core::Location node = core::minimum(field);
      const FittedMinimum fitted = fitted_minimum(small_grid, field, node.i, node.j);
      BOOST_TEST(fitted.value == 0.7, tolerance(1e-12));
      BOOST_TEST(fitted.X == X, tolerance(1e-11));
      BOOST_TEST(fitted.Y == Y, tolerance(1e-11));
      BOOST_TEST(node.value > 0.7 + 1e-4);
    }
}

// A film with all derivatives and its minimum at 36 places between the nodes: the largest error decreases with the
// fifth power of the mesh size, that of the node with the second. The weights of the nodes give the same value.
BOOST_AUTO_TEST_CASE(fifth_order_for_a_smooth_film) {
  double before = 0.0;
  for (const int n : {8, 16, 32, 64}) {
    const core::Grid grid{n, n, -1.0, 1.0, -1.0, 1.0};
    const double h = grid.hx();
    double largest = 0.0;
    double of_node = 0.0;
    for (int k = 0; k < 36; ++k) {
      const double X = h * (0.05 + k % 6 / 6.0);
      const double Y = h * (0.05 + k / 6 / 6.0);
      const core::Field field = film(grid, [&](double x, double y) {
        const double u = x - X;
        const double v = y - Y;
        return 1.0 + (std::exp(u) - 1.0 - u) + 2.0 * (std::exp(-v) - 1.0 + v) + 0.3 * u * v + 0.2 * u * u * v;
      });
      const core::Location node = core::minimum(field);
      const double value = fitted_minimum(grid, field, node.i, node.j).value;
      largest = std::max(largest, std::abs(value - 1.0));
      double weighted = 0.0;
      for (const auto& [i, j, weight] : weights_of_fitted_minimum(grid, field, node.i, node.j))
        weighted += weight * field(i, j);
      BOOST_TEST(weighted == value, tolerance(1e-13));
      of_node = std::max(of_node, node.value - 1.0);
    }
    const double h5 = h * h * h * h * h;
    BOOST_TEST_MESSAGE(n << " cells: error " << largest << " = " << largest / h5 << " h^5 (allowed 0.045), before over "
                         << "this " << before / largest << " (at least 25); of the node " << of_node / (h * h)
                         << " h^2");
    BOOST_TEST(largest < 0.045 * h5);
    if (before > 0.0) BOOST_TEST(before / largest > 25.0);
    before = largest;
  }
}

BOOST_AUTO_TEST_CASE(node_itself_where_there_is_no_paraboloid) {
  const auto is_node = [](const std::function<double(double, double)>& H, int i, int j) {
    const core::Field field = film(small_grid, H);
    const FittedMinimum fitted = fitted_minimum(small_grid, field, i, j);
    return fitted.value == field(i, j) && std::abs(fitted.X - small_grid.X(i)) < rounding &&
           std::abs(fitted.Y - small_grid.Y(j)) < rounding;
  };
  // Next to each of the four boundaries the paraboloid is used, on the boundaries it is not.
  const auto bowl = [](double X, double Y) {
    return [=](double x, double y) { return 1.0 + (x - X) * (x - X) + (y - Y) * (y - Y); };
  };
  BOOST_TEST(is_node(bowl(-0.95, 0.05), 0, 5));
  BOOST_TEST(is_node(bowl(0.95, 0.05), 8, 5));
  BOOST_TEST(is_node(bowl(0.05, -0.95), 4, 0));
  BOOST_TEST(is_node(bowl(0.05, 0.95), 4, 10));
  // The values beyond the sides have no effect.
  for (const double Y : {-0.95, 0.95}) {
    const int j = Y < 0.0 ? 0 : small_grid.ny;
    core::Field field = film(small_grid, bowl(0.05, Y));
    for (int i = 1; i <= small_grid.nx; ++i) {
      field.at_x(i)[-1] = bowl(0.05, Y)(small_grid.X(i), small_grid.Y(-1));
      field.at_x(i)[small_grid.ny + 1] = bowl(0.05, Y)(small_grid.X(i), small_grid.Y(small_grid.ny + 1));
    }
    BOOST_TEST(fitted_minimum(small_grid, field, 4, j).value == field(4, j));
  }
  BOOST_TEST(!is_node(bowl(-0.73, 0.05), 1, 5));
  BOOST_TEST(!is_node(bowl(0.73, 0.05), 7, 5));
  BOOST_TEST(!is_node(bowl(0.05, -0.79), 4, 1));
  BOOST_TEST(!is_node(bowl(0.05, 0.79), 4, 9));
  // A maximum, a saddle, a saddle with positive second differences along x and y, a valley without an end, a plane.
  BOOST_TEST(is_node([](double x, double y) { return 1.0 - (x - 0.05) * (x - 0.05) - y * y; }, 4, 5));
  BOOST_TEST(is_node([](double x, double y) { return 1.0 + (x - 0.05) * (x - 0.05) - y * y; }, 4, 5));
  BOOST_TEST(is_node([](double x, double y) { return 1.0 - (x - 0.05) * (x - 0.05) + y * y; }, 4, 5));
  BOOST_TEST(is_node([](double x, double y) { return 1.0 + (x - 0.05) * x + 3.0 * x * y + y * y; }, 4, 5));
  BOOST_TEST(is_node([](double x, double) { return 1.0 + (x - 0.05) * (x - 0.05); }, 4, 5));
  BOOST_TEST(is_node([](double x, double y) { return 1.0 + 0.1 * x + 0.1 * y; }, 4, 5));
  const FittedMinimum none = fitted_minimum(small_grid, film(small_grid, [](double, double) { return unknown; }), 4, 5);
  BOOST_TEST(std::isnan(none.value));
  BOOST_TEST(std::abs(none.X) < rounding);
}

// The minimum of the paraboloid lies some cells away along x or y, in either direction.
BOOST_AUTO_TEST_CASE(not_followed_far) {
  const auto followed = [](double cells_x, double cells_y) {
    const double X = 0.25 * cells_x;
    const double Y = 0.2 * cells_y;
    const core::Field field =
        film(small_grid, [&](double x, double y) { return 1.0 + (x - X) * (x - X) + (y - Y) * (y - Y); });
    return fitted_minimum(small_grid, field, 4, 5).value < 1.0 + 1e-9;
  };
  for (const double sign : {1.0, -1.0}) {
    BOOST_TEST(followed(2.45 * sign, 0.0));
    BOOST_TEST(followed(0.0, 2.45 * sign));
    BOOST_TEST(!followed(2.55 * sign, 0.0));
    BOOST_TEST(!followed(0.0, 2.55 * sign));
  }
}

BOOST_AUTO_TEST_SUITE_END()
