// As the speed decreases, the pressure of the lubricated contact tends to that of the dry contact.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "contact/groups.hpp"
#include "dry/solve.hpp"
#include "steady/solve.hpp"

BOOST_AUTO_TEST_SUITE(test_dry_limit)

using namespace ehl;

namespace {

constexpr double load = 2.0 * std::numbers::pi / 3.0;
constexpr double alpha = 2.2e-8;  // 1/Pa
constexpr int cells = 256;

// Thin films need a fine mesh, light loads a long inlet.
core::Grid grid_for(double M) {
  if (M < 200.0) return {cells, cells, -4.5, 1.5, -3.0, 3.0};
  return {cells, cells, -2.5, 1.5, -2.0, 2.0};
}

core::Field lubricated(double M, double L) {
  const contact::Groups groups = contact::from_moes(M, L);
  const double p_h = groups.alpha_bar / alpha;
  steady::Scene scene;
  scene.contact = steady::scales_of(M, L);
  scene.lambda = groups.lambda;
  scene.viscosity = rheology::make_roelands(alpha, rheology::roelands_p0, 0.68, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  scene.grid = grid_for(M);
  const steady::Solution solution = steady::solve(scene);
  BOOST_TEST_REQUIRE(solution.converged);
  return solution.P;
}

// Mean of |P - P_dry| in units of the mean pressure.
double distance(const core::Patch& grid, const core::Field& P, const core::Field& dry) {
  double sum = 0.0;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) sum += std::abs(P(i, j) - dry(i, j));
  return sum * grid.hx() * grid.hy() / load;
}

core::Field dry_pressure(const core::Grid& grid) {
  const ehl::core::Patch half = core::lower_half(grid);
  const dry::Solution solution = dry::solve({half, dry::smooth_gap(half), load, {}, {}, 1});
  BOOST_TEST_REQUIRE(solution.converged);
  return solution.P;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_pressure_tends_to_the_dry_one_as_the_speed_falls) {
  // For a given load and given bodies, L is proportional to M^(-1/3), because both depend on the speed.
  struct Path {
    double L;
    bool one_contact;
  };
  for (const Path& path : {Path{10.0, true}, {20.0, true}, {5.0, false}, {10.0, false}}) {
    double before = 1.0;
    for (const double M : {20.0, 100.0, 500.0, 2500.0}) {
      const double L = path.one_contact ? path.L * std::cbrt(20.0 / M) : path.L;
      const core::Grid grid = grid_for(M);
      const double now = distance(grid, lubricated(M, L), dry_pressure(grid));
      BOOST_TEST_MESSAGE("M " << M << ", L " << L << ": mean of |P - P_dry| " << now << " of the mean of P, "
                              << now / before << " of the one before");
      BOOST_TEST(now < before);
      before = now;
      if (M == 2500.0) BOOST_TEST(now < 0.015);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
