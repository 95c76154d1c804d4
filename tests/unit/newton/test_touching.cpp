// Touching surfaces by Newton's method: discrete values of an independent program, exact limits and balances.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "core/norms.hpp"
#include "judgement/measures.hpp"
#include "multigrid/cycles.hpp"
#include "newton/equations.hpp"
#include "newton/solve.hpp"
#include "support/random.hpp"
#include "unit/newton/newton_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_touching)

using namespace ehl;
using namespace ehl::tests;

namespace {

constexpr core::Grid square(int n) { return {n, n, -2.5, 1.5, -2.0, 2.0}; }

struct Found {
  multigrid::Hierarchy hierarchy;
  newton::Result result{};
  const multigrid::Level& level() const { return hierarchy.levels.back(); }
  double load_of(const core::Field& P) const {
    return level().grid.hx() * level().grid.hy() * core::interior_sum(level().grid, P);
  }
  double share() const { return load_of(level().touching->P_c) / level().load; }
};

/// The contact with a boundary film, from the film without one, or from the dry contact below a thick boundary film.
Found solved(multigrid::Problem problem, const core::Patch& grid, multigrid::BoundaryFilm film, bool from_dry) {
  Found apart{newton_hierarchy(problem, grid, 1)};
  problem.boundary_film = film;
  Found found{newton_hierarchy(problem, grid, 1)};
  const std::size_t l = found.hierarchy.levels.size() - 1;
  multigrid::State start{core::Field(grid), -1.0 + film.H_b, core::Field(grid)};
  if (from_dry) {
    for (int i = 1; i < grid.nx; ++i)
      for (int j = 1; j <= grid.last_line(); ++j) {
        start.P_c(i, j) = std::sqrt(std::max(0.0, 1.0 - grid.X(i) * grid.X(i) - grid.Y(j) * grid.Y(j)));
        start.P(i, j) = 1e-3 * start.P_c(i, j);
      }
  } else {
    multigrid::start_from_hertz(apart.hierarchy, l, -0.78, 0);
    BOOST_REQUIRE(newton::solve(apart.hierarchy, l).converged);
    start = multigrid::state_of(apart.hierarchy, l);
  }
  multigrid::start_from_state(found.hierarchy, l, start);
  found.result = newton::solve(found.hierarchy, l);
  return found;
}

void check_contact(const Found& found, double H_b) {
  const multigrid::Level& level = found.level();
  double in_contact = 0.0, elsewhere = 0.0;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) {
      const double gap = level.H(i, j) - H_b;
      if (level.touching->P_c(i, j) > 0.0)
        in_contact = std::max(in_contact, std::abs(gap));
      else
        elsewhere = std::max(elsewhere, -gap);
    }
  const double load = std::abs(found.load_of(level.touching->total) / level.load - 1.0);
  std::printf("  |H - H_b| in contact %.1e, H_b - H elsewhere %.1e (1e-12); load %.1e (1e-10)\n", in_contact, elsewhere,
              load);
  BOOST_TEST(in_contact < 1e-12);
  BOOST_TEST(elsewhere < 1e-12);
  BOOST_TEST(load < 1e-10);
}

}  // namespace

BOOST_AUTO_TEST_CASE(jacobian_products_are_the_slope_of_the_residual) {
  Random random(7);
  multigrid::Problem problem = newton_problem(50, 10);
  problem.boundary_film = multigrid::BoundaryFilm{.H_b = 0.15, .hardness = 0.6};
  multigrid::Hierarchy hierarchy = newton_hierarchy(problem, core::Grid{32, 24, -3.0, 1.5, -2.0, 2.0}, 1);
  const std::size_t l = hierarchy.levels.size() - 1;
  multigrid::start_from_hertz(hierarchy, l, -0.6, 0);
  newton::Equations equations(hierarchy, l);
  std::vector<double> u(equations.size()), plus(u.size()), minus(u.size()), v(u.size()), Jv(u.size());
  const std::size_t nodes = equations.nodes();
  for (std::size_t k = 0; k < nodes; ++k) {
    u[k] = random.chance(0.3) ? -0.05 : random.between(0.1, 0.9);
    u[nodes + k] = random.between(-0.3, 0.9);
  }
  u.back() = 0.4;  // far from closed, so that only w decides where the surfaces touch
  equations.set_state(u);
  std::vector<double> scratch(u.size());
  equations.unknowns(scratch);
  equations.linearize(u);
  for (double& x : v) x = random.between(-1.0, 1.0);
  equations.jacobian(v, Jv);
  const double step = 1e-6;
  std::vector<double> moved(u);
  for (std::size_t k = 0; k < u.size(); ++k) moved[k] = u[k] + step * v[k];
  equations.residual(moved, plus);
  for (std::size_t k = 0; k < u.size(); ++k) moved[k] = u[k] - step * v[k];
  equations.residual(moved, minus);
  double worst = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < u.size(); ++k) {
    const bool identity = k >= nodes && k < 2 * nodes && u[k] < 0.0;
    const double slope = identity ? v[k] : (plus[k] - minus[k]) / (2.0 * step);
    worst = std::max(worst, std::abs(slope - Jv[k]));
    largest = std::max(largest, std::abs(slope));
  }
  std::printf("  largest difference from the slope %.1e of %.2g (1e-6)\n", worst, largest);
  BOOST_TEST(worst < 1e-6 * largest);
}

// Values of an independent program with the same discretisation.
BOOST_AUTO_TEST_CASE(shares_of_a_smooth_contact) {
  const std::pair<double, double> values[] = {{0.125, 0.0}, {0.13, 0.00029235}, {0.14, 0.00638889}, {0.16, 0.05096225}};
  for (const auto& [H_b, share] : values) {
    const Found found = solved(newton_problem(50, 10), core::lower_half(square(64)), {.H_b = H_b}, false);
    BOOST_TEST_REQUIRE(found.result.converged, found.result.reason);
    std::printf("H_b %.3f: share %.8f, expected %.8f (1e-7), H00 %.8f, %zu steps\n", H_b, found.share(), share,
                found.hierarchy.H00, found.result.steps.size());
    BOOST_TEST(std::abs(found.share() - share) < 1e-7);
    check_contact(found, H_b);
  }
}

BOOST_AUTO_TEST_CASE(slow_speeds_give_the_dry_contact) {
  constexpr double H_b = 0.1;
  const std::pair<double, double> values[] = {{0.1, 0.2186}, {0.01, 0.1949}, {0.001, 0.1929}};
  for (const auto& [speed, over_speed] : values) {
    multigrid::Problem problem = newton_problem(50, 10);
    problem.film.lambda *= speed;
    const Found found = solved(problem, core::lower_half(square(64)), {.H_b = H_b}, true);
    BOOST_TEST_REQUIRE(found.result.converged, found.result.reason);
    std::printf("speed %.3f: (1 - share)/speed %.4f, expected %.4f (1e-4), H00 - H_b %.6f, %zu steps\n", speed,
                (1.0 - found.share()) / speed, over_speed, found.hierarchy.H00 - H_b, found.result.steps.size());
    BOOST_TEST(std::abs((1.0 - found.share()) / speed - over_speed) < 1e-4);
    check_contact(found, H_b);
  }
}

// Waves on a standing surface: with few cells per wave more of the load is carried by contact.
BOOST_AUTO_TEST_CASE(shares_of_a_wavy_contact) {
  const std::pair<int, double> values[] = {{32, 0.579}, {48, 0.355}};
  for (const auto& [cells, share] : values) {
    multigrid::Problem problem = newton_problem(20, 10);
    problem.film.lambda *= 0.2;
    problem.surface = [](const core::Patch& grid, core::Field& S) {
      for (int i = 0; i <= grid.nx; ++i)
        for (int j = 0; j <= grid.ny; ++j)
          S(i, j) = 0.4 * std::cos(2.0 * core::pi * grid.X(i)) * std::cos(2.0 * core::pi * grid.Y(j));
    };
    const Found found = solved(problem, core::lower_half(square(cells)), {.H_b = 0.06}, true);
    BOOST_TEST_REQUIRE(found.result.converged, found.result.reason);
    std::printf("%d cells: share %.4f, expected %.3f (5e-4), %zu steps\n", cells, found.share(), share,
                found.result.steps.size());
    BOOST_TEST(std::abs(found.share() - share) < 5e-4);
    check_contact(found, 0.06);
  }
}

BOOST_AUTO_TEST_SUITE_END()
