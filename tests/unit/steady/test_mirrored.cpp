// Solutions computed on one half of a symmetric domain, compared with those on the whole domain.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/norms.hpp"
#include "judgement/fitted_minimum.hpp"
#include "steady/solve.hpp"
#include "support/mirrored.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_mirrored)

using namespace ehl;

namespace {

steady::Scene contact_scene(double M, double L, const core::Grid& grid) {
  steady::Scene scene = tests::roelands_scene(M, L, grid);
  scene.solver.tolerance = 1e-9;
  return scene;
}

void compare(steady::Scene scene, const char* what, double tolerance) {
  const steady::Solution half = steady::solve(scene);
  scene.use_symmetry = false;
  const steady::Solution whole = steady::solve(scene);
  BOOST_TEST((half.converged && whole.converged));
  BOOST_TEST((half.grid == scene.grid));
  BOOST_TEST(half.method == whole.method);
  BOOST_REQUIRE(half.levels.size() == whole.levels.size());
  BOOST_REQUIRE((half.P.nodes_y() == whole.P.nodes_y() && half.H.nodes_y() == whole.H.nodes_y()));
  const double P = core::max_abs_difference(half.P, whole.P);
  const double H = core::max_abs_difference(half.H, whole.H);
  BOOST_TEST_MESSAGE(what << ": difference of P " << P << ", of H " << H << " (tolerance " << tolerance << ")");
  BOOST_TEST(P < tolerance);
  BOOST_TEST(H < tolerance);
  for (std::size_t k = 0; k < half.levels.size(); ++k) {
    const steady::LevelRow& a = half.levels[k];
    const steady::LevelRow& b = whole.levels[k];
    BOOST_TEST((a.nx == b.nx && a.ny == b.ny && a.cycles == b.cycles));
    BOOST_TEST(std::abs(a.Hc / b.Hc - 1.0) < tolerance);
    BOOST_TEST(std::abs(a.Hm / b.Hm - 1.0) < tolerance);
    BOOST_TEST(std::abs(a.Hm_fitted / b.Hm_fitted - 1.0) < tolerance);
    BOOST_TEST(std::abs(a.work_units / b.work_units - 1.0) < 1e-12);
  }
  // The preconditioner contains the image terms too, so the number of iterations is the same up to rounding.
  BOOST_REQUIRE(half.newton.size() == whole.newton.size());
  for (std::size_t k = 0; k < half.newton.size(); ++k)
    BOOST_TEST(std::abs(half.newton[k].linear_iterations - whole.newton[k].linear_iterations) <= 1);
  BOOST_TEST(std::abs(half.verification.flow_imbalance - whole.verification.flow_imbalance) < 1e-8);
}

}  // namespace

BOOST_AUTO_TEST_CASE(full_multigrid_on_the_half) {
  compare(contact_scene(50, 10, {128, 128, -4.5, 1.5, -3, 3}), "(50,10)", 1e-10);
  // 80/64 of the width: the axis is on a line of only the first coarse grid of the film evaluation.
  compare(contact_scene(20, 5, {64, 80, -4.5, 1.5, -3.75, 3.75}), "(20,5), 64 x 80", 1e-10);
}

BOOST_AUTO_TEST_CASE(newton_and_load_continuation_on_the_half) {
  steady::Scene scene = contact_scene(80, 10, {64, 64, -2.5, 1.5, -2, 2});
  scene.polish = steady::Polish::always;
  compare(scene, "Newton after the cycles", 1e-10);
  scene.polish = steady::Polish::fallback;
  scene.continuation.path = steady::ContinuationParameters::Path::load;
  compare(scene, "load continuation", 1e-8);
}

BOOST_AUTO_TEST_CASE(a_domain_without_an_axis_on_its_grids_is_computed_whole) {
  steady::Scene scene = contact_scene(20, 5, {64, 66, -4.5, 1.5, -3, 3});
  const steady::Solution one = steady::solve(scene);
  scene.use_symmetry = false;
  const steady::Solution two = steady::solve(scene);
  BOOST_TEST((one.converged && two.converged));
  BOOST_TEST(core::max_abs_difference(one.P, two.P) == 0.0);
  scene = contact_scene(20, 5, {64, 64, -4.5, 1.5, -3, 2.8});
  BOOST_TEST(steady::solve(scene).converged);
}

BOOST_AUTO_TEST_CASE(a_minimum_on_the_axis_is_fitted_through_its_images) {
  const core::Grid grid{16, 16, -1, 1, -1, 1};
  core::Field film(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) film(i, j) = 1.0 + std::pow(grid.X(i) - 0.03, 2) + 0.3 * std::pow(grid.Y(j), 2);
  const judgement::FittedMinimum all = judgement::fitted_minimum(grid, film, 8, 8);
  const judgement::FittedMinimum one =
      judgement::fitted_minimum(core::lower_half(grid), tests::half_of(grid, film), 8, 8);
  BOOST_TEST_MESSAGE("fitted at X = " << one.X << ", Y = " << one.Y << ", value - 1 = " << one.value - 1.0);
  BOOST_TEST(std::abs(one.X - 0.03) < 1e-12);
  BOOST_TEST(std::abs(one.value - 1.0) < 1e-12);
  BOOST_TEST((std::abs(one.X - all.X) < 1e-14 && std::abs(one.Y - all.Y) < 1e-14));
}

BOOST_AUTO_TEST_SUITE_END()
