// Choices of the program: domain, grid, first loads; and the damping that the cycles find by themselves.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "contact/groups.hpp"
#include "multigrid/cycles.hpp"
#include "multigrid/start.hpp"
#include "newton/solve.hpp"
#include "reference/circular_contact.hpp"
#include "rheology/laws.hpp"
#include "steady/continuation.hpp"
#include "steady/domain_error.hpp"
#include "steady/newton_fallback.hpp"
#include "steady/resolution.hpp"
#include "unit/newton/newton_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_choices)

using namespace ehl;
using boost::test_tools::tolerance;

namespace {

steady::Scene scene_of(double M, double L, const core::Grid& grid) {
  const contact::Groups groups = contact::from_moes(M, L);
  const double p_h = groups.alpha_bar / 2.2e-8;
  steady::Scene scene;
  scene.contact = steady::scales_of(M, L);
  scene.lambda = groups.lambda;
  scene.grid = grid;
  scene.viscosity = rheology::make_roelands(2.2e-8, rheology::roelands_p0, 0.68, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  return scene;
}

double log_viscosity(const rheology::ViscosityLaw& law, double P) {
  double value = 0.0;
  rheology::log_viscosity(law, {&P, 1}, {&value, 1});
  return value;
}

double density(const rheology::DensityLaw& law, double P) {
  double value = 0.0;
  rheology::density(law, {&P, 1}, {&value, 1});
  return value;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(choices)

// The far field of rigid bodies, P = -(lambda/5) X/(r^2/2)^2 upstream of 0, integrated outside the rectangle in rings
// by Simpson's rule. At M = 0.1 the contact is rigid: q = 2, and the term of the inlet is known.
BOOST_AUTO_TEST_CASE(load_outside_the_domain) {
  const core::Grid grid{64, 64, -40.0, 2.0, -15.0, 15.0};
  const steady::Scene scene = scene_of(0.1, 0.0, grid);
  constexpr int directions = 4000;
  double outside = 0.0;
  for (int k = 0; k <= directions; ++k) {
    const double theta = std::numbers::pi * (static_cast<double>(k) / directions - 0.5);
    const double at_inlet = 40.0 / std::cos(theta);
    const double at_side = 15.0 / std::abs(std::sin(theta));
    const double R = std::min(at_inlet, at_side);
    const double weight = k == 0 || k == directions ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    // the integral of (lambda/5) r cos/(r^4/4) r dr from R to infinity
    outside += weight * 0.8 * scene.lambda * std::cos(theta) / R;
  }
  outside *= std::numbers::pi / directions / 3.0;
  const double inlet = 0.5 * 10.0 * 4.0 / 3.0 * scene.lambda / (40.0 * 40.0 * 40.0);
  const double expected = 2.0 * outside / (2.0 * std::numbers::pi / 3.0) + inlet;
  BOOST_TEST_MESSAGE("cut off " << steady::rough_domain_error(scene) << ", by quadrature " << expected);
  BOOST_TEST(steady::rough_domain_error(scene) == expected, tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(inlet_and_outlet) {
  BOOST_TEST(steady::chosen_inlet({}, steady::scales_of(50, 10), 1.5) == -4.5);    // the domain of the paper
  BOOST_TEST(steady::chosen_inlet({}, steady::scales_of(1000, 10), 1.5) == -2.5);  // a short inlet at high load
  BOOST_TEST(steady::chosen_outlet({}, steady::scales_of(50, 10)) == 1.5);
  BOOST_TEST(steady::chosen_outlet({}, steady::scales_of(2, 0)) == 3.0);
  double before = 0.0;
  for (const double M : {3000.0, 300.0, 100.0, 50.0, 30.0, 20.0, 10.0, 7.0, 5.0, 3.0, 2.0, 1.0, 0.3}) {
    const double X_b = steady::chosen_outlet({}, steady::scales_of(M, 5));
    const double X_a = steady::chosen_inlet({}, steady::scales_of(M, 5), X_b);
    BOOST_TEST(X_a <= before);  // a lighter load never has a shorter inlet
    BOOST_TEST(X_a >= -200.0);
    // (0,0) is a node of 256 cells.
    const double cell = (X_b - X_a) / 256.0;
    BOOST_TEST(std::abs(X_a / cell - std::round(X_a / cell)) < 1e-9);
    before = X_a;
    // The accuracy that the choice of the domain promises, on a domain half as wide as long, as
    // far as 200 radii permit it.
    const steady::Scene scene = scene_of(M, 5, {64, 64, X_a, X_b, -0.5 * (X_b - X_a), 0.5 * (X_b - X_a)});
    if (M > 3.0) BOOST_TEST(steady::rough_domain_error(scene) <= 0.026);
  }
}

// Compared with the continuum limits of the reference solutions.
BOOST_AUTO_TEST_CASE(expected_film) {
  for (const reference::CircularLimit& limit : reference::circular_limits) {
    if (limit.fluid == reference::Fluid::barus) continue;
    const double expected = steady::scales_of(limit.M, limit.L).least_film;
    BOOST_TEST_MESSAGE("(" << limit.M << "," << limit.L << ") expected " << expected << ", reference " << limit.Hm);
    BOOST_TEST(expected / limit.Hm < 1.25);
    BOOST_TEST(expected / limit.Hm > 0.8);
  }
}

BOOST_AUTO_TEST_CASE(cells) {
  using reynolds::Wedge;
  const double step = steady::resolving_step({}, steady::scales_of(1000, 10), Wedge::upstream2);
  BOOST_TEST(step < steady::resolving_step({}, steady::scales_of(200, 10), Wedge::upstream2));
  BOOST_TEST(steady::resolving_step({}, steady::scales_of(1000, 10), Wedge::upstream1) < step);
  BOOST_TEST(steady::resolving_cells(4.0 / 300.0, 4.0, 256, 1024) == 512);
  BOOST_TEST(steady::resolving_cells(4.0 / 256.0, 4.0, 256, 1024) == 256);
  BOOST_TEST(steady::resolving_cells(1e-6, 4.0, 256, 1024) == 1024);
  BOOST_TEST(steady::resolving_cells(1e-6, 4.0, 384, 1000) == 768);
}

// Only the load changes: the oil at a given pressure in pascals, the speed and the bodies stay the same.
BOOST_AUTO_TEST_CASE(another_load) {
  const steady::Scene scene = scene_of(800, 12, {64, 64, -2.5, 1.5, -2.0, 2.0});
  const steady::Scene light = steady::under_load(scene, 100);
  const double p_h_ratio = 0.5;  // the cube root of one eighth
  BOOST_TEST(light.lambda == contact::from_moes(100, 12).lambda, tolerance(1e-14));
  BOOST_TEST(light.contact.M == 100.0);
  BOOST_TEST(light.contact.L == 12.0);
  for (const double P : {0.1, 0.7, 1.3}) {
    BOOST_TEST(log_viscosity(light.viscosity, P / p_h_ratio) == log_viscosity(scene.viscosity, P), tolerance(1e-13));
    BOOST_TEST(density(light.density, P / p_h_ratio) == density(scene.density, P), tolerance(1e-14));
  }
  const rheology::ViscosityLaw barus = rheology::rescaled(rheology::make_barus(2e-8, 1e9), 0.25);
  BOOST_TEST(log_viscosity(barus, 1.0) == 5.0, tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()

namespace {

multigrid::Hierarchy hierarchy_with(double times_the_weights) {
  const steady::Scene scene = scene_of(50, 10, {64, 64, -4.5, 1.5, -3.0, 3.0});
  multigrid::Parameters parameters;
  for (double* weight : {&parameters.relaxation.weight_distributed, &parameters.relaxation.weight_single,
                         &parameters.relaxation.weight_single_steep})
    *weight *= times_the_weights;
  return multigrid::make_hierarchy(
      {.film = {.lambda = scene.lambda, .viscosity = scene.viscosity, .density = scene.density}}, parameters,
      scene.deformation, scene.grid, 1);
}

struct Grids {
  multigrid::Hierarchy hierarchy = hierarchy_with(1.0);
  std::size_t finest = hierarchy.levels.size() - 1;

  Grids() { multigrid::start_from_hertz(hierarchy, finest, -0.75, 10); }
};

multigrid::CyclesResult cycles_to(multigrid::Hierarchy& hierarchy, double residual, int most) {
  const multigrid::CycleObserver nobody = [](int, const judgement::Measures&) {
    return multigrid::DiscretizationError{};
  };
  return multigrid::run_cycles(hierarchy, hierarchy.levels.size() - 1,
                               {.aim = judgement::Aim::residual, .most = most, .tolerance = residual}, {}, nobody);
}

}  // namespace

BOOST_FIXTURE_TEST_SUITE(cautious_cycles, Grids)

BOOST_AUTO_TEST_CASE(end_when_the_criterion_is_met) {
  const multigrid::CyclesResult result = cycles_to(hierarchy, 1e-8, 30);
  BOOST_TEST((result.end == multigrid::CyclesEnd::converged));
  BOOST_TEST(result.unmet.empty());
  BOOST_TEST(result.cycles < 15);
  BOOST_TEST(multigrid::measures_of(hierarchy, finest).residual < 1e-8);
  // An easy contact needs no damping.
  BOOST_TEST(result.damping.all == 1.0);
  BOOST_TEST(result.damping.steep == 1.0);
}

BOOST_AUTO_TEST_CASE(end_at_the_limit_and_where_nothing_helps) {
  const multigrid::CyclesResult limited = cycles_to(hierarchy, 0.0, 2);
  BOOST_TEST((limited.end == multigrid::CyclesEnd::limit));
  BOOST_TEST(limited.cycles == 2);
  BOOST_TEST(limited.unmet.find("residual") != std::string::npos);
  // At the level of rounding errors the residual does not fall any more.
  const multigrid::CyclesResult stalled = cycles_to(hierarchy, 0.0, 300);
  BOOST_TEST((stalled.end == multigrid::CyclesEnd::stalled));
  BOOST_TEST(stalled.cycles < 60);
}

// (1000,10) on 32 x 32 cells: the solution of the equations has a negative film.
BOOST_AUTO_TEST_CASE(end_where_the_mesh_has_no_solution) {
  multigrid::Hierarchy coarse = tests::newton_hierarchy(1000, 10, core::Grid{32, 32, -4.5, 1.5, -3.0, 3.0}, 1);
  multigrid::start_from_hertz(coarse, 0, tests::first_H00(1000, 10), 0);
  BOOST_REQUIRE(newton::solve(coarse, 0).equations_met);
  const multigrid::CycleObserver nobody = [](int, const judgement::Measures&) {
    return multigrid::DiscretizationError{};
  };
  const multigrid::CyclesResult none = multigrid::run_cycles(coarse, 0, {.planned = 1, .most = 9}, {}, nobody);
  BOOST_TEST((none.end == multigrid::CyclesEnd::no_solution));
  BOOST_TEST(none.cycles == 1);
  // Newton's method finds the same, so no other strategy is tried.
  const steady::Solution by_newton =
      steady::solve_by_newton(scene_of(1000, 10, {32, 32, -4.5, 1.5, -3.0, 3.0}), {.cells = 32}, {});
  BOOST_TEST((by_newton.end == multigrid::CyclesEnd::no_solution));
  BOOST_TEST(!by_newton.converged);
}

// With weights that are far too large, the cycles increase the damping and reach the same solution. If the weights are
// only slightly too large, the Krylov acceleration suffices.
BOOST_AUTO_TEST_CASE(too_large_weights_are_lowered) {
  multigrid::Hierarchy hasty = hierarchy_with(2.0);
  multigrid::start_from_state(hasty, finest, multigrid::state_of(hierarchy, finest));
  const multigrid::CyclesResult result = cycles_to(hasty, 1e-8, 60);
  BOOST_TEST_MESSAGE("damping " << result.damping.all << " and " << result.damping.steep << " after " << result.cycles
                                << " cycles");
  BOOST_TEST((result.end == multigrid::CyclesEnd::converged));
  BOOST_TEST(result.damping.all < 1.0);
  BOOST_TEST(hasty.H00 == -0.7864794, tolerance(2e-2));  // reference; z and alpha differ slightly
}

// If no damping helps, the end is reported and the state is finite.
BOOST_AUTO_TEST_CASE(divergence_is_an_answer) {
  multigrid::Hierarchy wild = hierarchy_with(30.0);
  multigrid::start_from_state(wild, finest, multigrid::state_of(hierarchy, finest));
  const core::Field start = wild.finest().P;
  const multigrid::CyclesResult result = cycles_to(wild, 1e-8, 60);
  BOOST_TEST((result.end == multigrid::CyclesEnd::diverged));
  BOOST_TEST(!result.unmet.empty());
  BOOST_TEST(result.cycles < 60);
  for (int i = 0; i <= 64; ++i)
    for (int j = 0; j <= 64; ++j) BOOST_REQUIRE(wild.finest().P(i, j) == start(i, j));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
