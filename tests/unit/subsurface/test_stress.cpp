// The stress field below a contact: the sum, Hertz's stresses, and equilibrium.
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/norms.hpp"
#include "effects/subsurface/plane_sum.hpp"
#include "effects/subsurface/stress.hpp"

BOOST_AUTO_TEST_SUITE(test_subsurface)

using namespace ehl;
using namespace ehl::subsurface;

namespace {

constexpr double pi = std::numbers::pi;

core::Field hertz(const core::Grid& grid) {
  core::Field P(grid);
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j)
      P(i, j) = std::sqrt(std::max(0.0, 1.0 - grid.X(i) * grid.X(i) - grid.Y(j) * grid.Y(j)));
  return P;
}

core::Grid square(int cells, double half) { return {cells, cells, -half, half, -half, half}; }

// Reference: Johnson, Contact Mechanics (1985), eqs. (3.45): on the axis, in p_h and a.
double hertz_sigma_z(double z) { return -1.0 / (1.0 + z * z); }
double hertz_sigma_r(double z, double nu) {
  const double angle = z == 0.0 ? 0.0 : z * std::atan(1.0 / z);
  return -(1.0 + nu) * (1.0 - angle) + 0.5 / (1.0 + z * z);
}

// The stresses of one pressure in any plane.
class Planes {
 public:
  Planes(const core::Grid& grid, const core::Field& P, const Body& body)
      : grid_(grid), body_(body), sum_(grid, P), work_(sum_), kernel_work_(grid) {}
  void evaluate(double z, StressFields& stress) {
    stress.fill(core::Field(grid_));
    sum_.evaluate(PlaneKernel(grid_, body_.nu, z, body_.friction != 0.0, kernel_work_), body_.friction, work_, stress);
  }

 private:
  core::Grid grid_;
  Body body_;
  PlaneSum sum_;
  PlaneSum::Work work_;
  PlaneKernel::Work kernel_work_;
};

// The largest error of the stresses on the axis down to a depth of 2.
double error_on_axis(int cells, double nu) {
  const core::Grid grid = square(cells, 1.25);
  const core::Field P = hertz(grid);
  Planes sum(grid, P, {.nu = nu});
  StressFields stress;
  double error = 0.0;
  for (const double z : {0.0, 0.1, 0.25, 0.5, 1.0, 2.0}) {
    sum.evaluate(z, stress);
    const int c = cells / 2;
    error = std::max({error, std::abs(stress[zz](c, c) - hertz_sigma_z(z)),
                      std::abs(stress[xx](c, c) - hertz_sigma_r(z, nu)),
                      std::abs(stress[yy](c, c) - hertz_sigma_r(z, nu))});
  }
  return error;
}

core::Field uneven(const core::Grid& grid) {
  core::Field P(grid);
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) P(i, j) = 1.0 + 0.5 * std::sin(1.0 + 3.7 * i + 0.9 * j * j);
  return P;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_planes_by_transform_are_the_direct_sum) {
  const core::Grid grid{17, 10, -1.2, 0.7, -0.4, 0.9};
  const core::Field P = uneven(grid);
  constexpr double tolerance = 1e-13;
  for (const double friction : {0.0, -0.3}) {
    const Body body{.nu = 0.21, .friction = friction};
    Planes sum(grid, P, body);
    StressFields stress;
    double largest = 0.0;
    for (const double z : {0.0, 0.05, 0.8}) {
      sum.evaluate(z, stress);
      for (int i = 0; i < grid.nodes_x(); ++i)
        for (int j = 0; j < grid.nodes_y(); ++j) {
          const Stress truth = stress_at(grid, P, body, grid.X(i), grid.Y(j), z);
          for (std::size_t c = 0; c < components; ++c)
            largest = std::max(largest, std::abs(stress[c](i, j) - truth[c]));
        }
    }
    BOOST_TEST_MESSAGE("friction " << friction << ": largest difference " << largest << " (" << tolerance << ")");
    BOOST_TEST(largest < tolerance);
  }
}

BOOST_AUTO_TEST_CASE(a_uniform_patch_of_many_cells_is_one_of_the_closed_form) {
  const core::Grid grid{30, 24, -1.5, 1.5, -1.2, 1.2};
  core::Field P(grid);
  for (int i = 8; i <= 19; ++i)
    for (int j = 9; j <= 14; ++j) P(i, j) = 2.0;
  const double half_x = 6.0 * grid.hx(), half_y = 3.0 * grid.hy();
  const double x = 0.5 * (grid.X(8) + grid.X(19)), y = 0.5 * (grid.Y(9) + grid.Y(14));
  const Body body{.nu = 0.3, .friction = 0.25};
  Planes sum(grid, P, body);
  StressFields stress;
  double largest = 0.0;
  for (const double z : {0.0, 0.3, 2.0}) {
    sum.evaluate(z, stress);
    for (int i = 0; i < grid.nodes_x(); ++i)
      for (int j = 0; j < grid.nodes_y(); ++j) {
        const Stress n = normal_patch(grid.X(i) - x, grid.Y(j) - y, z, half_x, half_y, body.nu);
        const Stress q = shear_patch(grid.X(i) - x, grid.Y(j) - y, z, half_x, half_y, body.nu);
        for (std::size_t c = 0; c < components; ++c)
          largest = std::max(largest, std::abs(stress[c](i, j) - 2.0 * (n[c] + body.friction * q[c])));
      }
  }
  BOOST_TEST_MESSAGE("largest difference " << largest << " (1e-13)");
  BOOST_TEST(largest < 1e-13);
}

BOOST_AUTO_TEST_CASE(hertz_on_the_axis) {
  for (const double nu : {0.0, 0.3}) {
    double error[3] = {};
    for (int k = 0; k < 3; ++k) error[k] = error_on_axis(40 << k, nu);
    const double order = std::log2(error[0] / error[2]) / 2.0;
    BOOST_TEST_MESSAGE("nu " << nu << ": errors of 40, 80, 160 cells over 2.5 a: " << error[0] << " " << error[1] << " "
                             << error[2] << " p_h; order " << order);
    // The sampled ellipse has a square root at its edge, which limits the order to 1.5, for a sum with odd powers of h.
    BOOST_TEST(order > 1.4);
    BOOST_TEST(error[2] < 0.001);
  }
}

BOOST_AUTO_TEST_CASE(hertz_maxima) {
  const core::Grid grid = square(128, 1.5);
  const StressField field = stress_below(grid, hertz(grid), {.depth = 1.5, .planes = 31}, 2);
  const double tolerance = 0.005;
  BOOST_TEST_MESSAGE("tau_max " << field.shear.value << " at depth " << field.shear.Z << " (0.3100 at 0.4809), mises "
                                << field.mises.value << " at " << field.mises.Z << " (0.6200)");
  BOOST_TEST(std::abs(field.shear.value / 0.3100 - 1.0) < tolerance);
  BOOST_TEST(std::abs(field.shear.Z / 0.4809 - 1.0) < tolerance);
  BOOST_TEST(std::abs(field.mises.value / 0.6200 - 1.0) < tolerance);
  BOOST_TEST(std::abs(field.mises.Z / 0.4809 - 1.0) < tolerance);
  BOOST_TEST(std::hypot(field.shear.X, field.shear.Y) + std::hypot(field.mises.X, field.mises.Y) < 1e-6);
  BOOST_TEST(field.warnings.empty());
}

BOOST_AUTO_TEST_CASE(hertz_surface_outside_the_contact) {
  // sigma_r = (1 - 2 nu)/(3 r^2) from the edge outwards.
  constexpr double nu = 0.3;
  const core::Grid grid = square(512, 1.5);
  const core::Field P = hertz(grid);
  const int edge = static_cast<int>(std::ceil((1.0 - grid.X_a) / grid.hx()));
  for (const int i : {edge, edge + 8, edge + 40}) {
    const double X = grid.X(i);
    const double sigma = X * X * stress_at(grid, P, {.nu = nu}, X, 0.0, 0.0)[xx];
    BOOST_TEST_MESSAGE("r = " << X << ": r^2 sigma_r = " << sigma << " (0.13333 +- 0.5 %)");
    BOOST_TEST(std::abs(sigma / ((1.0 - 2.0 * nu) / 3.0) - 1.0) < 0.005);
  }
}

BOOST_AUTO_TEST_CASE(hertz_shear_at_the_surface) {
  // Inside the contact, q = P adds sigma_xx = -(pi/8)(4 + nu) x (Hamilton 1983; Johnson, section 7.1). The constant
  // load of a cell neglects its slope: first order, at the surface only.
  constexpr double nu = 0.3;
  double error[3] = {};
  for (int k = 0; k < 3; ++k) {
    const core::Grid grid = square(80 << k, 1.25);
    const core::Field P = hertz(grid);
    const double with = stress_at(grid, P, {.nu = nu, .friction = 1.0}, 0.5, 0.0, 0.0)[xx];
    const double without = stress_at(grid, P, {.nu = nu}, 0.5, 0.0, 0.0)[xx];
    error[k] = std::abs(with - without + pi / 8.0 * (4.0 + nu) * 0.5);
  }
  const double order = std::log2(error[0] / error[2]) / 2.0;
  BOOST_TEST_MESSAGE("errors of 80, 160, 320 cells over 2.5 a " << error[0] << " " << error[1] << " " << error[2]
                                                                << " of 0.844, order " << order);
  BOOST_TEST((order > 0.9 && error[2] < 0.005 * 0.844));
}

BOOST_AUTO_TEST_CASE(every_plane_carries_the_load) {
  // Outside r = L, a point load has the share (z/L)^3 of its sigma_zz, and a shear load 3 z/(2 L) of its tau_xz.
  const core::Grid grid = square(160, 10.0);
  const core::Field P = hertz(grid);
  double load = 0.0;
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (const double p : P.station(i)) load += p;
  Planes sum(grid, P, {.nu = 0.3, .friction = 0.4});
  StressFields stress;
  for (const double z : {0.0, 0.2, 0.8}) {
    sum.evaluate(z, stress);
    double normal = 0.0, shear = 0.0;
    for (int i = 0; i < grid.nodes_x(); ++i)
      for (int j = 0; j < grid.nodes_y(); ++j) {
        normal -= stress[zz](i, j);
        shear -= stress[xz](i, j);
      }
    const double tolerance = 1e-12 + 2.0 * std::pow(z / 10.0, 3.0);
    BOOST_TEST_MESSAGE("depth " << z << ": carries " << normal / load << " of the load (1 +- " << tolerance << "), "
                                << shear / load << " along x (0.4)");
    BOOST_TEST(std::abs(normal / load - 1.0) < tolerance);
    BOOST_TEST((shear / load < 0.4 + 1e-12 && shear / load > 0.4 * (1.0 - 1.5 * z / 10.0) - 1e-12));
  }
}

BOOST_AUTO_TEST_CASE(the_field_of_an_uneven_pressure_is_in_equilibrium) {
  // Central differences along the nodes and between planes: the remainder of div sigma decreases with h^2.
  double left[3] = {};
  for (int k = 0; k < 3; ++k) {
    const core::Grid grid = square(24 << k, 1.2);
    core::Field P = hertz(grid);
    for (int i = 0; i < grid.nodes_x(); ++i)
      for (int j = 0; j < grid.nodes_y(); ++j) P(i, j) *= 1.0 + 0.3 * grid.X(i) - 0.5 * grid.Y(j);
    const double h = grid.hx(), z = 0.6;
    Planes sum(grid, P, {.nu = 0.25, .friction = 0.2});
    std::vector<StressFields> planes(3);
    for (int plane = 0; plane < 3; ++plane) sum.evaluate(z + (plane - 1) * h, planes[static_cast<std::size_t>(plane)]);
    const StressFields& s = planes[1];
    for (int i = 1; i < grid.nx; ++i)
      for (int j = 1; j < grid.ny; ++j)
        for (const auto& [x, y, along_z] : {std::array{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}) {
          const double divergence = s[x](i + 1, j) - s[x](i - 1, j) + s[y](i, j + 1) - s[y](i, j - 1) +
                                    planes[2][along_z](i, j) - planes[0][along_z](i, j);
          left[k] = std::max(left[k], std::abs(divergence) / (2.0 * h));
        }
  }
  const double order = std::log2(left[0] / left[2]) / 2.0;
  BOOST_TEST_MESSAGE("largest div sigma of 24, 48, 96 cells: " << left[0] << " " << left[1] << " " << left[2]
                                                               << " p_h/a, order " << order);
  BOOST_TEST((order > 1.8 && left[2] < 2e-3));
}

BOOST_AUTO_TEST_CASE(threads_and_what_is_kept_change_nothing) {
  const core::Grid grid = square(32, 1.5);
  const core::Field P = hertz(grid);
  const Parameters parameters{.depth = 1.0, .planes = 7, .friction = 0.1};
  const StressField one = stress_below(grid, P, parameters, 1);
  const StressField three = stress_below(grid, P, parameters, 3);
  Parameters more = parameters;
  more.kept = {tau_xz};
  const StressField other = stress_below(grid, P, more, 1);
  BOOST_TEST((one.mises.value == three.mises.value && one.mises.value == other.mises.value));
  BOOST_TEST((one.kept.size() == 2 && other.kept.size() == 1 && other.kept[0].quantity == tau_xz));
  for (std::size_t k = 0; k < 7; ++k)
    BOOST_TEST(core::max_abs_difference(one.kept[1].planes[k], three.kept[1].planes[k]) == 0.0);
  // The section is the line y = 0 of the volume.
  BOOST_TEST(one.section_Y == 0.0);
  for (int i = 0; i <= grid.nx; ++i) BOOST_TEST(one.section[sigma_mises](i, 4) == one.kept[0].planes[4](i, 16));
  BOOST_TEST((one.depths.front() == 0.0 && one.depths.back() == 1.0));
}

BOOST_AUTO_TEST_CASE(a_coarser_grid_keeps_the_load_and_nearly_the_maximum) {
  const core::Grid grid = square(256, 1.5);
  const core::Field P = hertz(grid);
  const Parameters parameters{.depth = 1.0, .planes = 15, .most_cells = 64};
  const core::Grid coarse = stress_grid(grid, parameters);
  BOOST_TEST((coarse.nx == 64 && coarse.ny == 64));
  const StressField field = stress_below(grid, P, parameters, 1);
  BOOST_TEST_MESSAGE("64 of 256 cells: mises " << field.mises.value << " (0.6200 +- 0.5 %)");
  BOOST_TEST(std::abs(field.mises.value / 0.62 - 1.0) < 0.005);
  // The part that alternates from node to node disappears without changing the load.
  core::Field uneven_P = P;
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) uneven_P(i, j) *= (i + j) % 2 == 0 ? 1.5 : 0.5;
  const double alternating = stress_below(grid, uneven_P, parameters, 1).mises.value;
  BOOST_TEST_MESSAGE("with every second node half: " << alternating);
  BOOST_TEST(std::abs(alternating / field.mises.value - 1.0) < 1e-4);
  // An odd number of cells ends the halving.
  BOOST_TEST(stress_grid(core::Grid{96, 50, -1.0, 1.0, -0.5, 0.5}, {.most_cells = 10}).nx == 48);
  // Half of a mirrored domain is not halved again in the plane.
  BOOST_TEST(stress_grid(core::lower_half(grid), parameters).ny == 64);
}

BOOST_AUTO_TEST_CASE(a_depth_that_misses_the_maximum_is_told) {
  const core::Grid grid = square(32, 1.5);
  const StressField field = stress_below(grid, hertz(grid), {.depth = 0.3, .planes = 5}, 1);
  BOOST_TEST(field.warnings.size() == 2);
}

// Near the surface the stresses follow the pressure of each cell, so no parabola is fitted.
BOOST_AUTO_TEST_CASE(the_largest_value_near_the_surface_is_that_of_a_node) {
  const core::Grid grid = square(64, 1.5);
  core::Field P = hertz(grid);
  P(44, 33) += 2.0;
  const Maximum shear = stress_below(grid, P, {}, 1).shear;
  BOOST_TEST((shear.Z < 2.0 * grid.hx() && shear.value == shear.on_node));
}

BOOST_AUTO_TEST_SUITE_END()
