// The stresses that the material of a body meets: a Hertzian line contact that stands still while the body passes.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "effects/subsurface/history.hpp"

BOOST_AUTO_TEST_SUITE(test_stress_history)

using namespace ehl;
using namespace ehl::subsurface;

namespace {

struct Passed {
  double range = 0.0, depth = 0.0, mises = 0.0, uneven = 0.0, move = 0.0;
};

// A line contact with P = sqrt(1 - X^2) passes over a body by `step` cells between two samples.
Passed passed(int cells, double step) {
  const core::Grid grid = core::line_grid(cells, -4.0, 4.0);
  core::Field P(grid);
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) P(i, j) = std::sqrt(std::max(0.0, 1.0 - grid.X(i) * grid.X(i)));
  const Parameters parameters{.depth = 1.5, .planes = 31, .most_cells = cells, .kept = {sigma_mises, tau_max, tau_xz}};
  const StressField field = stress_below(grid, P, parameters, 1);
  History history(field.grid, field.depths, 0.0, 8.0);
  for (double moved = 0.0; moved <= 8.0; moved += step * grid.hx()) history.add(field, moved, 1);
  const Maximum range = history.largest(range_of_tau);
  Passed found{range.value, range.Z, history.largest(largest_mises).value, 0.0, history.longest_move()};
  // All material that the whole contact has passed has met the same.
  const core::Field section = history.section(range_of_tau);
  double low = 1.0, high = 0.0;
  for (int i = 0; i < history.grid().nodes_x(); ++i)
    if (history.grid().X(i) > -5.0 && history.grid().X(i) < -3.0)
      for (std::size_t plane = 0; plane < history.depths().size(); ++plane)
        if (history.depths()[plane] == range.Z) {
          low = std::min(low, section(i, static_cast<int>(plane)));
          high = std::max(high, section(i, static_cast<int>(plane)));
        }
  found.uneven = high - low;
  return found;
}

}  // namespace

// Below a Hertzian line contact tau_xz has the extremes +- p_h/4 at half a Hertz radius (Lundberg and Palmgren 1947;
// Johnson 1985, section 4.2); the largest von Mises stress is that of plane strain.
BOOST_AUTO_TEST_CASE(the_orthogonal_shear_stress_below_a_rolling_line_has_the_range_of_half_the_pressure) {
  const Passed coarse = passed(128, 1.0), fine = passed(256, 1.0);
  BOOST_TEST_MESSAGE("range " << coarse.range << ", " << fine.range << " (0.5), depth " << fine.depth << " (0.5), von "
                              << "Mises " << fine.mises << " (0.5577), uneven " << fine.uneven);
  BOOST_TEST(std::abs(fine.range - 0.5) < 2e-3);
  BOOST_TEST(std::abs(fine.range - 0.5) < 0.6 * std::abs(coarse.range - 0.5));
  BOOST_TEST(std::abs(fine.depth - 0.5) < 0.05);
  BOOST_TEST(std::abs(fine.mises - 0.5577) < 2e-3);
  BOOST_TEST(fine.uneven < 1e-6);
  BOOST_TEST(fine.move == 1.0, boost::test_tools::tolerance(1e-9));
}

// Samples at half a cell or at 1.3 cells, between the nodes, meet nearly the same.
BOOST_AUTO_TEST_CASE(samples_between_nodes_and_coarse_ones) {
  const Passed whole = passed(256, 1.0);
  for (const double step : {0.5, 1.3}) {
    const Passed other = passed(256, step);
    BOOST_TEST_MESSAGE(step << " cells between samples: range " << other.range << ", whole " << whole.range);
    BOOST_TEST(std::abs(other.range - whole.range) < 2e-3);
    BOOST_TEST(other.move == step, boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(kept_kernels_change_nothing) {
  for (const core::Grid& grid : {core::Grid{16, 12, -1.5, 1.5, -1.2, 1.2}, core::line_grid(32, -1.5, 1.5)}) {
    core::Field P(grid);
    for (int i = 0; i < grid.nodes_x(); ++i)
      for (int j = 0; j < grid.nodes_y(); ++j) P(i, j) = 1.0 + (grid.line ? 0.0 : 0.1 * j) + 0.3 * (i % 5);
    Kernels kernels;
    for (const double friction : {0.0, 0.1, -0.1}) {
      const Parameters parameters{.depth = 1.0, .planes = 5, .friction = friction};
      const StressField anew = stress_below(grid, P, parameters, 1);
      const StressField kept = stress_below(grid, P, parameters, 2, {}, &kernels);
      for (std::size_t q = 0; q < quantities; ++q)
        BOOST_TEST(core::max_abs_difference(anew.section[q], kept.section[q]) == 0.0);
      P(7, 1) += 0.5;
    }
  }
}

BOOST_AUTO_TEST_CASE(the_user_can_stop_it) {
  const core::Grid grid = core::Grid{32, 32, -1.5, 1.5, -1.5, 1.5};
  int told = 0;
  BOOST_CHECK_THROW(
      stress_below(grid, core::Field(grid), {.planes = 9}, 1, [&](int done) { return (told = done) < 3; }),
      core::Interrupted);
  BOOST_TEST(told == 3);
}

BOOST_AUTO_TEST_SUITE_END()
