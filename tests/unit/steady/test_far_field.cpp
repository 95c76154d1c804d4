// Contacts on domains with the far field in closed form: they must agree with a contact on an unbounded domain.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "contact/groups.hpp"
#include "core/norms.hpp"
#include "reynolds/far_field.hpp"
#include "steady/domain_error.hpp"
#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_far_field)

using namespace ehl;

namespace {

steady::Solution solved(const steady::Scene& scene) {
  steady::Solution solution = steady::solve(scene, {});
  BOOST_TEST_REQUIRE(solution.converged, solution.failed_check);
  return solution;
}

steady::Scene closed_scene(double M, double L, const core::Grid& grid) {
  steady::Scene scene = tests::roelands_scene(M, L, grid);
  if (!(L > 0.0)) {
    scene.viscosity = rheology::Isoviscous{};
    scene.density = rheology::Incompressible{};
  }
  scene.far_field = true;
  scene.solver.tolerance = 1e-8;
  return scene;
}

void require_close(double a, double b, double allowed, const char* what) {
  BOOST_TEST_MESSAGE(what << ": " << a << " and " << b << ", apart by " << std::abs(a / b - 1.0));
  BOOST_TEST(std::abs(a / b - 1.0) < allowed, what);
}

}  // namespace

// Domains of half the size with the same mesh size.
BOOST_AUTO_TEST_CASE(half_of_a_domain_gives_the_same_film) {
  struct Case {
    double M, L;
    core::Grid small, large;
    double allowed;
  };
  const Case cases[] = {
      {2, 0, {128, 168, -12, 6, -12, 12}, {256, 336, -24, 12, -24, 24}, 2e-3},
      {5, 5, {64, 84, -4, 2, -4, 4}, {128, 168, -8, 4, -8, 8}, 2e-3},
      {20, 10, {128, 128, -3, 1.5, -2.25, 2.25}, {256, 256, -6, 3, -4.5, 4.5}, 2.5e-3},
      {100, 10, {128, 128, -2.5, 1.5, -2, 2}, {256, 256, -5, 3, -4, 4}, 2e-3},
  };
  for (const Case& c : cases) {
    BOOST_TEST_MESSAGE("M = " << c.M << ", L = " << c.L);
    const steady::Solution small = solved(closed_scene(c.M, c.L, c.small));
    const steady::Solution large = solved(closed_scene(c.M, c.L, c.large));
    require_close(small.levels.back().Hc, large.levels.back().Hc, c.allowed, "Hc");
    require_close(small.levels.back().Hm_fitted, large.levels.back().Hm_fitted, 1.5 * c.allowed, "Hm");
  }
}

// The default domain of a deck, and half of it. For an ellipse with R_x/R_y = 0.2 at 45 degrees, the boundary contains
// all directions of its far field.
BOOST_AUTO_TEST_CASE(half_of_the_domain_that_is_chosen_gives_the_same_film) {
  struct Case {
    double M, L;
    int cells;
  };
  const double error = steady::Tuning{}.error_of_closed_domain;
  constexpr double allowed = 2e-3;
  for (const auto& [M, L, cells] :
       {Case{2, 0, 128}, Case{5, 5, 128}, Case{20, 10, 128}, Case{100, 10, 256}, Case{1000, 10, 512}}) {
    const steady::ContactScales scales = steady::scales_of(M, L);
    const double X_b = steady::chosen_outlet({}, scales, error), X_a = steady::chosen_inlet({}, scales, X_b, error);
    const double Y = steady::chosen_half_width({}, X_a, X_b, {}, true);
    const double h = (X_b - X_a) / cells;
    // Half of the domain in cells of the same size, with the necessary length downstream of the contact.
    int nx = 64;
    while (0.5 * X_a + nx * h < std::max(1.2, 0.5 * X_b)) nx += 32;
    const core::Grid all{cells, 5 * cells / 4, X_a, X_b, -Y, Y};
    const core::Grid half{nx, 5 * cells / 8, 0.5 * X_a, 0.5 * X_a + nx * h, -0.5 * Y, 0.5 * Y};
    const auto films = [&, M = M, L = L](const core::Grid& grid) {
      steady::Scene scene = closed_scene(M, L, grid);
      scene.wedge = reynolds::Wedge::upstream3;
      scene.face = reynolds::Face::logmean_bounded;
      return solved(scene).levels.back();
    };
    BOOST_TEST_MESSAGE("M = " << M << ", L = " << L << ", X from " << X_a << " to " << X_b << ", Y to " << Y);
    const multigrid::LevelRow small = films(half), large = films(all);
    require_close(small.Hc, large.Hc, allowed, "Hc");
    require_close(small.Hm_fitted, large.Hm_fitted, allowed, "Hm");
  }
}

BOOST_AUTO_TEST_CASE(likewise_beside_an_ellipse_aslant) {
  const contact::Groups groups = contact::from_moes(20, 10, contact::ellipse(0.2, 45.0));
  const auto scene_on = [&](const core::Grid& grid) {
    steady::Scene scene = closed_scene(20, 10, grid);
    scene.lambda = groups.lambda;
    scene.contact = steady::scales_of(groups.M, groups.L, groups.shape);
    return scene;
  };
  const steady::Solution small = solved(scene_on({192, 192, -6, 3, -4.5, 4.5}));
  const steady::Solution large = solved(scene_on({384, 384, -12, 6, -9, 9}));
  require_close(small.levels.back().Hc, large.levels.back().Hc, 2e-3, "Hc");
}

// The reported error of the domain must contain the change for a domain of twice the size, without being far larger. A
// rule in M and L alone could not satisfy both.
BOOST_AUTO_TEST_CASE(the_bar_of_the_domain_holds) {
  struct Case {
    double M, L, ratio, angle, size;
  };
  for (const auto& [M, L, ratio, angle, size] : {Case{2, 0, 1, 0, 1}, Case{5, 5, 1, 0, 0.5}, Case{20, 10, 1, 0, 1},
                                                 Case{20, 10, 0.2, 45, 1}, Case{10, 5, 5, 0, 1}}) {
    const contact::Groups groups = contact::from_moes(M, L, contact::ellipse(ratio, angle));
    const double error = steady::Tuning{}.error_of_closed_domain;
    const steady::ContactScales scales = steady::scales_of(M, L, groups.shape);
    const double X_b = size * steady::chosen_outlet({}, scales, error);
    const double X_a = size * steady::chosen_inlet({}, scales, X_b / size, error);
    const double Y = steady::chosen_half_width({}, X_a, X_b, groups.shape, true);
    const int ny = 2 * static_cast<int>(std::lround(2.0 * Y / (X_b - X_a) * 16)) * 4;
    const auto found = [&, M = M, L = L](int larger) {
      const double by = larger;
      steady::Scene scene = closed_scene(M, L, {128 * larger, ny * larger, by * X_a, by * X_b, -by * Y, by * Y});
      scene.lambda = groups.lambda;
      scene.contact = steady::scales_of(groups.M, groups.L, groups.shape);
      scene.wedge = reynolds::Wedge::upstream3;
      scene.face = reynolds::Face::logmean_bounded;
      scene.adjoint_errors = larger == 1;
      return solved(scene);
    };
    const steady::Solution here = found(1);
    const steady::LevelRow large = found(2).levels.back(), own = here.levels.back();
    const double change = std::max(std::abs(own.Hc / large.Hc - 1.0), std::abs(own.Hm_fitted / large.Hm_fitted - 1.0));
    constexpr double most = 25.0;
    BOOST_TEST_MESSAGE("(" << M << ", " << L << "), R_x/R_y = " << ratio << ", angle " << angle << ": bar "
                           << here.error_bars.domain << ", change " << change << " (within, and " << most
                           << " times smaller at most)");
    BOOST_TEST(change < here.error_bars.domain);
    BOOST_TEST(here.error_bars.domain < most * change);
  }
}

// For rigid bodies and Reynolds' rupture condition, M^2 H = 35.53 +- 0.01 (Moes' H).
BOOST_AUTO_TEST_CASE(the_film_of_a_light_load_is_the_rigid_limit) {
  const steady::Solution solution = solved(closed_scene(1, 0, {256, 336, -40, 20, -40, 40}));
  const double H = contact::H_to_moes_units(solution.error_bars.Hc_extrapolated.value, 1, {});
  require_close(H, 35.53, 3e-3, "M^2 Hc and the rigid limit");
}

// Half of the domain with two threads gives the same result as the whole domain with one thread.
BOOST_AUTO_TEST_CASE(one_half_and_two_threads_do_the_same) {
  steady::Scene scene = closed_scene(20, 10, {128, 128, -3, 1.5, -2.25, 2.25});
  const steady::Solution half = solved(scene);
  scene.threads = 2;
  const steady::Solution threaded = solved(scene);
  BOOST_TEST(half.levels.back().Hc == threaded.levels.back().Hc);
  BOOST_TEST(half.levels.back().Hm == threaded.levels.back().Hm);
  scene.use_symmetry = false;
  const steady::Solution whole = solved(scene);
  require_close(half.levels.back().Hc, whole.levels.back().Hc, 1e-9, "half and whole");
}

// The cycles satisfy these conditions approximately, Newton's method exactly: the pressure on the boundary is that of
// the closed form for the film there, and the regions inside and outside the domain together carry the load.
BOOST_AUTO_TEST_CASE(newton_returns_a_state_that_closes) {
  steady::Scene scene = closed_scene(5, 5, {64, 64, -6, 3, -4.5, 4.5});
  scene.solver.tolerance = 1e-4;
  scene.polish = steady::Polish::always;
  const steady::Solution solution = solved(scene);
  BOOST_TEST_REQUIRE(solution.newton.size() > 0U);
  const contact::Groups groups = contact::from_moes(5, 5);
  const core::Grid& grid = solution.grid;
  const reynolds::FarField far({.gap = contact::gap(groups.shape),
                                .lambda = scene.lambda,
                                .deformation = contact::elastic_factor(groups.shape) * contact::load(groups.shape),
                                .viscosity = scene.viscosity,
                                .domain = grid});
  double apart = 0.0;
  double rim = 0.0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) {
      const bool at_x = i == 0 || i == grid.nx;
      const bool at_y = j == 0 || j == grid.ny;
      if (!at_x && !at_y) continue;
      const double P = solution.P(i, j);
      rim += grid.hx() * grid.hy() * (at_x && at_y ? 0.25 : 0.5) * P;
      apart = std::max(apart, std::abs(P - far.P(grid.X(i), grid.Y(j), solution.H(i, j))));
    }
  const double load =
      grid.hx() * grid.hy() * core::interior_sum(solution.P) + rim + far.load_outside({.H00 = solution.H00});
  BOOST_TEST_MESSAGE("boundary off by " << apart << ", load by " << load / contact::load(groups.shape) - 1.0
                                        << " (allowed 1e-10); outside " << far.load_outside({.H00 = solution.H00}));
  BOOST_TEST(apart < 1e-10);
  BOOST_TEST(std::abs(load / contact::load(groups.shape) - 1.0) < 1e-10);
}

BOOST_AUTO_TEST_SUITE_END()
