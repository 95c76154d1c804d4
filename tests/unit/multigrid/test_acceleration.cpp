// Combination of states (Krylov acceleration): exact for linear equations with few error components.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <utility>

#include "core/norms.hpp"
#include "multigrid/acceleration.hpp"
#include "unit/multigrid/circular_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_multigrid_acceleration)

using namespace ehl::tests;
namespace multigrid = ehl::multigrid;
using ehl::core::Field;
using ehl::core::Grid;

namespace {

/// Rigid bodies and epsilon = exp(steepness X). The state at the end solves the equations.
multigrid::Hierarchy solved(const Grid& grid, Random& random, double steepness = 0.0) {
  multigrid::Problem problem;
  problem.film.given_epsilon = [steepness](double X, double) { return std::exp(steepness * X); };
  problem.geometry.kernel.factor = 0.0;
  problem.cavitation = ehl::reynolds::Cavitation::none;
  problem.load.reset();
  multigrid::Parameters parameters;
  parameters.coarsest_cells = grid.nx;
  multigrid::Hierarchy hierarchy =
      multigrid::make_hierarchy(problem, parameters, {.method = ehl::mlmi::Method::fft}, ehl::core::Patch(grid), 1);
  multigrid::Level& level = hierarchy.finest();
  set_rough_state(hierarchy, level, random);
  level.f.fill(0.0);
  ehl::core::fill_ghosts(level.grid, level.P);
  multigrid::update_residual(hierarchy, level);
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j) level.f(i, j) = -level.r(i, j);
  return hierarchy;
}

}  // namespace

BOOST_AUTO_TEST_CASE(as_many_errors_as_states_are_taken_away) {
  const Grid grid{32, 24, -4.5, 1.5, -3, 3};
  Random random(5);
  multigrid::Hierarchy hierarchy = solved(grid, random);
  multigrid::Level& level = hierarchy.finest();
  const Field solution = level.P;
  const Field errors[] = {random_field(level.grid, random, -1.0, 1.0), random_field(level.grid, random, -1.0, 1.0)};
  const auto put = [&](double first, double second) {
    for (int i = 1; i < grid.nx; ++i)
      for (int j = 1; j < grid.ny; ++j)
        level.P(i, j) = solution(i, j) + first * errors[0](i, j) + second * errors[1](i, j);
    ehl::core::fill_ghosts(level.grid, level.P);
    multigrid::update_residual(hierarchy, level);
  };
  multigrid::Acceleration acceleration;
  multigrid::State combined;
  put(1.0, 0.3);
  BOOST_TEST(!acceleration.combine(hierarchy, 0, combined));
  acceleration.remember(hierarchy, 0);
  put(-0.9, 0.2);
  acceleration.remember(hierarchy, 0);
  put(0.8, 0.1);
  BOOST_TEST(acceleration.combine(hierarchy, 0, combined));
  const double error = ehl::core::max_abs_difference(combined.P, solution);
  BOOST_TEST_MESSAGE("error left " << error << " of 0.8 (at most 1e-11)");
  BOOST_TEST(error < 1e-11);
  acceleration.forget();
  BOOST_TEST(!acceleration.combine(hierarchy, 0, combined));
}

// With fewer states than error components, the changes r/coefficient at the nodes are minimised, and not r.
BOOST_AUTO_TEST_CASE(nodes_count_by_what_they_ask_for) {
  const Grid grid{32, 24, -4.5, 1.5, -3, 3};
  Random random(6);
  multigrid::Hierarchy hierarchy = solved(grid, random, 2.0);
  multigrid::Level& level = hierarchy.finest();
  const auto disturb = [&] {
    for (int i = 1; i < grid.nx; ++i)
      for (int j = 1; j < grid.ny; ++j) level.P(i, j) += random.between(-1.0, 1.0);
    ehl::core::fill_ghosts(level.grid, level.P);
    multigrid::update_residual(hierarchy, level);
    return std::pair(level.P, level.r);
  };
  multigrid::Acceleration acceleration;
  const auto [P1, r1] = disturb();
  acceleration.remember(hierarchy, 0);
  const auto [P, r] = disturb();
  double product = 0.0, square = 0.0;
  const double X = 0.5 / (grid.hx() * grid.hx()), Y = 0.5 / (grid.hy() * grid.hy());
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j) {
      const auto eps = [&](int k) { return std::exp(2.0 * grid.X(k)); };
      const double d = X * (eps(i - 1) + 2.0 * eps(i) + eps(i + 1)) + 4.0 * Y * eps(i);
      product -= r(i, j) / d * (r1(i, j) - r(i, j)) / d;
      square += (r1(i, j) - r(i, j)) / d * (r1(i, j) - r(i, j)) / d;
    }
  multigrid::State combined;
  BOOST_TEST(acceleration.combine(hierarchy, 0, combined));
  const double alpha = product / square;
  double worst = 0.0;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j)
      worst = std::max(worst, std::abs(combined.P(i, j) - P(i, j) - alpha * (P1(i, j) - P(i, j))));
  BOOST_TEST_MESSAGE("alpha " << alpha << ", off by " << worst << " (at most 1e-12)");
  BOOST_TEST(worst < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
