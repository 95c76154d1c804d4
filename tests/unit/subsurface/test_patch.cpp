// The closed forms below one rectangle, compared with quadrature of point loads and with mechanics.
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "effects/subsurface/patch.hpp"

BOOST_AUTO_TEST_SUITE(test_patch_stress)

using namespace ehl::subsurface;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double nu = 0.28;
constexpr double half_x = 0.7, half_y = 0.4;

struct Point {
  double x, y, z;
};
const std::vector<Point> points = {{0.0, 0.0, 0.6},  {0.7, 0.4, 0.5},  {0.3, -0.2, 0.45}, {1.3, 0.5, 0.4},
                                   {-0.9, 1.1, 0.9}, {-2.0, 0.0, 0.3}, {0.0, 3.0, 1.7},   {4.0, -3.0, 2.0}};

// Boussinesq's point load P = 1 along z. source: Johnson, Contact Mechanics (1985), eq. (3.20).
Stress boussinesq(double x, double y, double z) {
  const double rr = x * x + y * y, R = std::sqrt(rr + z * z);
  const double R3 = R * R * R, R5 = R3 * R * R;
  const double c = 1.0 - 2.0 * nu;
  Stress s{};
  s[xx] = c / rr * ((1.0 - z / R) * (x * x - y * y) / rr + z * y * y / R3) - 3.0 * z * x * x / R5;
  s[yy] = c / rr * ((1.0 - z / R) * (y * y - x * x) / rr + z * x * x / R3) - 3.0 * z * y * y / R5;
  s[zz] = -3.0 * z * z * z / R5;
  s[xy] = c / rr * ((1.0 - z / R) * 2.0 * x * y / rr - x * y * z / R3) - 3.0 * x * y * z / R5;
  s[xz] = -3.0 * x * z * z / R5;
  s[yz] = -3.0 * y * z * z / R5;
  for (double& value : s) value /= 2.0 * pi;
  return s;
}

// Cerruti's point load Q = 1 along x. source: Johnson, eq. (3.76).
Stress cerruti(double x, double y, double z) {
  const double R = std::sqrt(x * x + y * y + z * z);
  const double R2 = R * R, R3 = R2 * R, R5 = R3 * R2, m = R + z, c = 1.0 - 2.0 * nu;
  Stress s{};
  s[xx] = -3.0 * x * x * x / R5 +
          c * (x / R3 - 3.0 * x / (R * m * m) + x * x * x / (R3 * m * m) + 2.0 * x * x * x / (R2 * m * m * m));
  s[yy] = -3.0 * x * y * y / R5 +
          c * (x / R3 - x / (R * m * m) + x * y * y / (R3 * m * m) + 2.0 * x * y * y / (R2 * m * m * m));
  s[zz] = -3.0 * x * z * z / R5;
  s[xy] =
      -3.0 * x * x * y / R5 + c * (-y / (R * m * m) + x * x * y / (R3 * m * m) + 2.0 * x * x * y / (R2 * m * m * m));
  s[xz] = -3.0 * x * x * z / R5;
  s[yz] = -3.0 * x * y * z / R5;
  for (double& value : s) value /= 2.0 * pi;
  return s;
}

// Integral over the rectangle by Gauss' rule with 5 points on 24 x 24 pieces.
Stress integrated(const std::function<Stress(double, double, double)>& point_load, const Point& p) {
  constexpr std::array<double, 5> at{-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
                                     0.9061798459386640};
  constexpr std::array<double, 5> weight{0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                                         0.2369268850561891};
  constexpr int pieces = 24;
  Stress sum{};
  for (int a = 0; a < pieces; ++a)
    for (int b = 0; b < pieces; ++b)
      for (std::size_t k = 0; k < 5; ++k)
        for (std::size_t l = 0; l < 5; ++l) {
          const double xi = half_x * ((2.0 * a + 1.0 + at[k]) / pieces - 1.0);
          const double yi = half_y * ((2.0 * b + 1.0 + at[l]) / pieces - 1.0);
          const Stress s = point_load(p.x - xi, p.y - yi, p.z);
          const double w = weight[k] * weight[l] * half_x * half_y / (pieces * pieces);
          for (std::size_t c = 0; c < components; ++c) sum[c] += w * s[c];
        }
  return sum;
}

Stress normal(double x, double y, double z) { return normal_patch(x, y, z, half_x, half_y, nu); }
Stress shear(double x, double y, double z) { return shear_patch(x, y, z, half_x, half_y, nu); }

// The derivative along an axis, by a central difference of sixth order.
double derivative(const std::function<double(double, double, double)>& f, const Point& p, int axis) {
  constexpr double step = 0.01;
  const auto at = [&](int k) {
    const double d = k * step;
    return f(p.x + (axis == 0 ? d : 0.0), p.y + (axis == 1 ? d : 0.0), p.z + (axis == 2 ? d : 0.0));
  };
  return (45.0 * (at(1) - at(-1)) - 9.0 * (at(2) - at(-2)) + (at(3) - at(-3))) / (60.0 * step);
}

double largest_divergence(Stress (*field)(double, double, double)) {
  constexpr int rows[3][3] = {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
  double largest = 0.0;
  for (const Point& p : points)
    for (const auto& row : rows) {
      double sum = 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        const auto component = static_cast<std::size_t>(row[axis]);
        sum += derivative([&](double x, double y, double z) { return field(x, y, z)[component]; }, p, axis);
      }
      largest = std::max(largest, std::abs(sum));
    }
  return largest;
}

// Beltrami and Michell: without body forces the trace is harmonic.
double largest_laplacian_of_trace(Stress (*field)(double, double, double)) {
  const auto trace = [&](double x, double y, double z) {
    const Stress s = field(x, y, z);
    return s[xx] + s[yy] + s[zz];
  };
  double largest = 0.0;
  for (const Point& p : points) {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      sum += derivative([&](double x, double y, double z) { return derivative(trace, {x, y, z}, axis); }, p, axis);
    largest = std::max(largest, std::abs(sum));
  }
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_loads_against_quadrature_of_the_point_loads) {
  // The tolerance is that of rounding, to which the quadrature is exact at a depth of 0.3.
  constexpr double tolerance = 1e-13;
  double of_normal = 0.0, of_shear = 0.0;
  for (const Point& p : points) {
    const Stress n = integrated(boussinesq, p), q = integrated(cerruti, p);
    for (std::size_t c = 0; c < components; ++c) {
      of_normal = std::max(of_normal, std::abs(normal(p.x, p.y, p.z)[c] - n[c]));
      of_shear = std::max(of_shear, std::abs(shear(p.x, p.y, p.z)[c] - q[c]));
    }
  }
  BOOST_TEST_MESSAGE("largest difference, pressure " << of_normal << ", shear " << of_shear << ", tolerance "
                                                     << tolerance);
  BOOST_TEST(of_normal < tolerance);
  BOOST_TEST(of_shear < tolerance);
}

BOOST_AUTO_TEST_CASE(the_vertical_stress_below_a_corner_is_newmarks) {
  // Newmark 1935, as in handbooks of foundation engineering.
  for (const double z : {0.1, 0.7, 3.0}) {
    const double a = 2.0 * half_x, b = 2.0 * half_y, R = std::sqrt(a * a + b * b + z * z);
    const double truth =
        -(std::atan(a * b / (z * R)) + a * b * z / R * (1.0 / (a * a + z * z) + 1.0 / (b * b + z * z))) / (2.0 * pi);
    const double error = std::abs(normal(half_x, half_y, z)[zz] - truth);
    BOOST_TEST_MESSAGE("depth " << z << ": sigma_zz " << truth << ", error " << error << " (1e-14)");
    BOOST_TEST(error < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(the_surface_carries_the_load_and_nothing_else) {
  constexpr double tolerance = 1e-13;
  for (const auto& [x, y, load] : {std::array{0.1, 0.2, 1.0}, {-0.6, -0.35, 1.0}, {0.8, 0.1, 0.0}, {-1.0, -2.0, 0.0}}) {
    const Stress n = normal(x, y, 0.0), q = shear(x, y, 0.0);
    BOOST_TEST(std::abs(n[zz] + load) < tolerance);
    BOOST_TEST(std::abs(n[xz]) + std::abs(n[yz]) < tolerance);
    BOOST_TEST(std::abs(q[xz] + load) < tolerance);
    BOOST_TEST(std::abs(q[zz]) + std::abs(q[yz]) < tolerance);
    // At the surface sigma_xx + sigma_yy = -(1 + 2 nu) p, because the surface strains are those of plane strain.
    BOOST_TEST(std::abs(n[xx] + n[yy] + (1.0 + 2.0 * nu) * load) < tolerance);
  }
}

BOOST_AUTO_TEST_CASE(the_stresses_are_in_equilibrium_and_compatible) {
  // The error of the differences is (0.01/0.3)^6, plus the rounding divided by the step, for
  // the Laplacian by its square.
  using Field = Stress (*)(double, double, double);
  for (const auto& [field, load] : {std::pair<Field, const char*>{normal, "pressure"}, {shear, "shear"}}) {
    const double divergence = largest_divergence(field), laplacian = largest_laplacian_of_trace(field);
    BOOST_TEST_MESSAGE(load << ": div " << divergence << " (1e-8), Laplacian of the trace " << laplacian << " (1e-6)");
    BOOST_TEST(divergence < 1e-8);
    BOOST_TEST(laplacian < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(far_away_nothing_is_lost_to_rounding) {
  // At a distance of a hundred patches, the patch acts as a point load, with an error of (size/distance)^2.
  constexpr double area = 4.0 * half_x * half_y;
  double largest = 0.0;
  for (const Point& p : {Point{70.0, 0.1, 5.0}, Point{-60.0, 40.0, 3.0}, Point{-0.1, -80.0, 10.0}}) {
    const Stress n = boussinesq(p.x, p.y, p.z), q = cerruti(p.x, p.y, p.z);
    for (const auto component : {xx, yy, zz, xy, xz, yz}) {
      const auto c = static_cast<std::size_t>(component);
      largest = std::max(largest, std::abs(normal(p.x, p.y, p.z)[c] / area - n[c]) / std::abs(n[xx]));
      largest =
          std::max(largest, std::abs(shear(p.x, p.y, p.z)[c] / area - q[c]) / (std::abs(q[xx]) + std::abs(q[xy])));
    }
  }
  BOOST_TEST_MESSAGE("largest difference " << largest << " of the largest component, tolerance 1e-3");
  BOOST_TEST(largest < 1e-3);
}

BOOST_AUTO_TEST_CASE(the_equivalent_stresses) {
  constexpr double tolerance = 1e-14;
  BOOST_TEST(std::abs(mises({1.0, 2.0, 4.0, 0.0, 0.0, 0.0}) - std::sqrt(7.0)) < tolerance);
  BOOST_TEST(std::abs(largest_shear({1.0, 2.0, 4.0, 0.0, 0.0, 0.0}) - 1.5) < tolerance);
  BOOST_TEST(std::abs(mises({0.0, 0.0, 0.0, 0.3, 0.0, 0.0}) - 0.3 * std::sqrt(3.0)) < tolerance);
  BOOST_TEST(std::abs(largest_shear({0.0, 0.0, 0.0, 0.0, 0.3, 0.0}) - 0.3) < tolerance);
  BOOST_TEST(largest_shear({-2.0, -2.0, -2.0, 0.0, 0.0, 0.0}) == 0.0);
  // diag(3, 1, -2) rotated by 0.4 about z and 0.9 about x: both results are independent of the axes.
  const double c = std::cos(0.4), s = std::sin(0.4), C = std::cos(0.9), S = std::sin(0.9);
  const double a = 3.0 * c * c + s * s, b = 3.0 * s * s + c * c, ab = 2.0 * c * s;
  const Stress turned{a, b * C * C - 2.0 * S * S, b * S * S - 2.0 * C * C, ab * C, ab * S, (b + 2.0) * S * C};
  BOOST_TEST_MESSAGE("turned: " << mises(turned) - std::sqrt(19.0) << ", " << largest_shear(turned) - 2.5);
  BOOST_TEST(std::abs(mises(turned) - std::sqrt(19.0)) < tolerance);
  BOOST_TEST(std::abs(largest_shear(turned) - 2.5) < tolerance);
}

BOOST_AUTO_TEST_SUITE_END()
