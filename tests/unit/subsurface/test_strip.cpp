// The stresses of plane strain below a line contact.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "effects/subsurface/stress.hpp"
#include "effects/subsurface/strip.hpp"

BOOST_AUTO_TEST_SUITE(test_strip_stress)

using namespace ehl;
using namespace ehl::subsurface;

namespace {

core::Field hertz(const core::Grid& grid) {
  core::Field P(grid);
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) P(i, j) = std::sqrt(std::max(0.0, 1.0 - grid.X(i) * grid.X(i)));
  return P;
}

// Reference: McEwen (1949); Johnson, Contact Mechanics (1985), eqs. (4.49). in: z > 0; lengths in a, stresses in p_h.
Stress mc_ewen(double x, double z, double nu) {
  const double b = 1.0 - x * x + z * z, root = std::sqrt(b * b + 4.0 * x * x * z * z);
  const double m = std::sqrt(0.5 * (root + b));
  const double n = std::copysign(std::sqrt(std::max(0.0, 0.5 * (root - b))), x);
  const double share = (z * z + n * n) / (m * m + n * n);
  Stress s{};
  s[xx] = -(m * (1.0 + share) - 2.0 * z);
  s[zz] = -m * (1.0 - share);
  s[yy] = nu * (s[xx] + s[zz]);
  s[xz] = -n * (m * m - z * z) / (m * m + n * n);
  return s;
}

double error_below_hertz(int cells) {
  const core::Grid grid = core::line_grid(cells, -1.25, 1.25);
  const core::Field P = hertz(grid);
  StressFields stress;
  for (core::Field& component : stress) component = core::Field(grid);
  double error = 0.0;
  for (const double z : {0.2, 0.5, 0.8, 2.0}) {
    stress_of_line(StripKernel(grid, 0.28, z), grid, P, 0.0, stress);
    for (int i = 0; i <= cells; i += cells / 20) {
      const Stress truth = mc_ewen(grid.X(i), z, 0.28);
      for (std::size_t k = 0; k < components; ++k) error = std::max(error, std::abs(stress[k](i, 1) - truth[k]));
    }
  }
  return error;
}

}  // namespace

// The difference caused by its ends is the reciprocal of its length.
BOOST_AUTO_TEST_CASE(a_strip_is_a_very_long_patch) {
  constexpr double half_x = 0.03, half_y = 1e6, nu = 0.31, tolerance = 2e-8;
  double difference = 0.0;
  for (const double x : {-2.0, -0.03, 0.0, 0.01, 0.4})
    for (const double z : {0.01, 0.2, 3.0}) {
      const Stress normal = normal_strip(x, z, half_x, nu), shear = shear_strip(x, z, half_x, nu);
      const Stress of_patch = normal_patch(x, 0.0, z, half_x, half_y, nu);
      const Stress of_shear = shear_patch(x, 0.0, z, half_x, half_y, nu);
      for (std::size_t k = 0; k < components; ++k)
        difference = std::max({difference, std::abs(normal[k] - of_patch[k]), std::abs(shear[k] - of_shear[k])});
    }
  BOOST_TEST_MESSAGE("largest difference " << difference << " (" << tolerance << ")");
  BOOST_TEST(difference < tolerance);
}

BOOST_AUTO_TEST_CASE(all_of_the_field_below_hertz_line_contact) {
  const double coarse = error_below_hertz(80), middle = error_below_hertz(160), fine = error_below_hertz(320);
  const double order = 0.5 * std::log2(coarse / fine);
  BOOST_TEST_MESSAGE("errors of 80, 160, 320 cells over 2.5 a " << coarse << " " << middle << " " << fine << ", order "
                                                                << order);
  // As below a sphere, the sampled edge limits the order to 1.5.
  BOOST_TEST(order > 1.4);
  BOOST_TEST(fine < 1e-3);
}

// On the axis tau_max = z - z^2/sqrt(1 + z^2): 0.3003 at 0.7862.
BOOST_AUTO_TEST_CASE(the_largest_shear_of_hertz_line_contact) {
  const StressField field = stress_below(core::line_grid(256, -1.5, 1.5), hertz(core::line_grid(256, -1.5, 1.5)),
                                         {.depth = 2.0, .planes = 61}, 2);
  BOOST_TEST_MESSAGE("on " << field.grid.nx << " cells: tau_max " << field.shear.value << " at (" << field.shear.X
                           << ", " << field.shear.Z << "), mises " << field.mises.value << " at " << field.mises.Z);
  BOOST_TEST(field.grid.nx == 128);
  BOOST_TEST(std::abs(field.shear.value - 0.30028) < 3e-4);
  BOOST_TEST(std::abs(field.shear.Z - 0.7862) < 2e-3);
  BOOST_TEST(std::abs(field.shear.X) < 1e-10);
  // Compared with the closed form on the axis, nu = 0.3.
  BOOST_TEST(std::abs(field.mises.value - mises(mc_ewen(0.0, field.mises.Z, 0.3))) < 5e-4);
  BOOST_TEST(field.warnings.empty());
  BOOST_TEST((field.section_Y == 0.0 && field.shear.Y == 0.0));
}

// q = P adds sigma_xx = -2 x at the surface inside the contact (Johnson, section 7.1); with constant loads on cells
// the error is of first order.
BOOST_AUTO_TEST_CASE(friction_on_hertz_line_contact) {
  double error[2] = {};
  for (int k = 0; k < 2; ++k) {
    const core::Grid grid = core::line_grid(200 << k, -1.25, 1.25);
    StressFields with, without;
    for (std::size_t c = 0; c < components; ++c) with[c] = without[c] = core::Field(grid);
    stress_of_line(StripKernel(grid, 0.3, 0.0), grid, hertz(grid), 0.5, with);
    stress_of_line(StripKernel(grid, 0.3, 0.0), grid, hertz(grid), 0.0, without);
    for (int i = 0; i <= grid.nx; ++i)
      if (const double X = grid.X(i); std::abs(X) < 0.6)
        error[k] = std::max(error[k], std::abs(with[xx](i, 1) - without[xx](i, 1) + X));
  }
  BOOST_TEST_MESSAGE("errors of 200, 400 cells " << error[0] << " " << error[1]);
  BOOST_TEST(error[1] < 0.006);
  BOOST_TEST(error[1] < 0.6 * error[0]);
}

BOOST_AUTO_TEST_CASE(threads_change_nothing_below_a_line) {
  const core::Grid grid = core::line_grid(64, -2.0, 1.5);
  const Parameters parameters{.depth = 1.0, .planes = 7, .friction = 0.1};
  const StressField one = stress_below(grid, hertz(grid), parameters, 1);
  const StressField three = stress_below(grid, hertz(grid), parameters, 3);
  BOOST_TEST(one.mises.value == three.mises.value);
  for (int i = 0; i <= grid.nx; ++i) BOOST_TEST(one.section[tau_xz](i, 5) == three.section[tau_xz](i, 5));
}

BOOST_AUTO_TEST_SUITE_END()
