// Limits of starved contacts: thin layers pass unchanged through circular and elliptic contacts, with and without shear
// thinning; the pressure is then that of the dry contact.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "contact/groups.hpp"
#include "dry/solve.hpp"
#include "effects/friction/friction.hpp"
#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_starved_limits)

using namespace ehl;
using std::numbers::pi;

namespace {

steady::Scene scene_of(double M, double L, const core::Grid& grid, double H_oil) {
  steady::Scene scene = tests::roelands_scene(M, L, grid);
  scene.deformation.method = mlmi::Method::fft;
  scene.solver.tolerance = 1e-9;
  scene.supply = [H_oil](double) { return H_oil; };
  return scene;
}

// An isoviscous, incompressible oil, for which there are closed forms.
steady::Scene plain_scene(const contact::Ellipse& shape, const core::Grid& grid, double H_oil) {
  steady::Scene scene = scene_of(20, 0, grid, H_oil);
  scene.viscosity = rheology::Isoviscous{};
  scene.density = rheology::Incompressible{};
  scene.contact = steady::scales_of(scene.contact.M, scene.contact.L, shape);
  scene.lambda = contact::from_moes(20, 0, shape).lambda;
  return scene;
}

// The mean of |P - P_dry| relative to the mean of P; both solutions are discrete.
double distance_from_dry(const steady::Solution& solution) {
  const core::Patch grid(solution.grid);
  const dry::Solution dry = dry::solve({grid, dry::smooth_gap(grid), 2.0 * pi / 3.0, {}, {}, 1});
  double sum = 0.0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) sum += std::abs(solution.P(i, j) - dry.P(i, j));
  return sum * grid.hx() * grid.hy() / (2.0 * pi / 3.0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(thin_layers_go_through_and_the_pressure_is_dry) {
  double before = 1.0, lost_before = 1.0;
  for (const double H_oil : {0.1, 0.05, 0.025}) {
    const steady::Scene scene = scene_of(20, 10, {96, 96, -2.0, 2.0, -2.0, 2.0}, H_oil);
    const steady::Solution solution = steady::solve(scene);
    const double off = steady::carried_at_centre(scene, solution) / H_oil - 1.0;
    const double distance = distance_from_dry(solution);
    BOOST_TEST_MESSAGE("H_oil = " << H_oil << ": rho H_c/H_oil - 1 = " << off << ", mean of |P - P_dry| " << distance
                                  << ", " << distance / before << " of the one before, oil "
                                  << solution.oil.imbalance());
    BOOST_TEST(solution.converged);
    BOOST_TEST(std::abs(off) < lost_before);
    BOOST_TEST(distance < 0.75 * before);
    BOOST_TEST(std::abs(solution.oil.imbalance()) <= 1e-8);
    before = distance;
    lost_before = std::abs(off);
  }
  BOOST_TEST(lost_before <= 2e-3);
  BOOST_TEST(before <= 0.01);
}

// Q^-2 increases by 2 pi/(lambda kappa^2) on y = 0.
BOOST_AUTO_TEST_CASE(side_flow_of_thin_layers_in_ellipses) {
  for (const double ratio : {0.3, 3.0}) {
    const contact::Ellipse shape = contact::ellipse(ratio);
    const double half = 2.25 * shape.kappa;
    const core::Grid grid{96, 96, -3.0, 1.5, -half, half};
    constexpr double H_oil = 0.02;
    const steady::Scene scene = plain_scene(shape, grid, H_oil);
    const steady::Solution solution = steady::solve(scene);
    const double grows = 2.0 * pi / (scene.lambda * shape.kappa * shape.kappa);
    const double formula = 1.0 / std::sqrt(1.0 + H_oil * H_oil * grows);
    const double behind = solution.Q(grid.nx - 1, grid.ny / 2) / H_oil;
    BOOST_TEST_MESSAGE("R_x/R_y = " << ratio << ", kappa = " << shape.kappa << ": lost behind it " << 1.0 - behind
                                    << ", closed form " << 1.0 - formula << " (allowed 2 %), oil "
                                    << solution.oil.imbalance());
    BOOST_TEST(solution.converged);
    BOOST_TEST(std::abs((1.0 - behind) / (1.0 - formula) - 1.0) <= 0.02);
  }
}

// Transverse to the sliding direction, an Eyring oil flows with the viscosity eta asinh(S)/S, S = k/H, so the side flow
// increases by S/asinh S. The shear stress is asinh(S)/k over the Hertz circle.
BOOST_AUTO_TEST_CASE(side_flow_and_friction_of_layers_thinned_by_shear) {
  constexpr double H_oil = 0.02, slip = 1e-3;  // eta_0 (u1 - u2) R/(a^2 p_h)
  double lost[2]{}, formula[2]{};
  for (const bool thinned : {false, true}) {
    steady::Scene scene = plain_scene({}, {96, 96, -3.0, 1.5, -2.25, 2.25}, H_oil);
    const double k = 3.0 * H_oil, S = thinned ? 3.0 : 0.0;
    if (thinned) scene.thinning = rheology::ShearThinning{rheology::Eyring{}, k};
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST(solution.converged);
    const double faster = thinned ? S / std::asinh(S) : 1.0;
    lost[thinned] = 1.0 - solution.Q(solution.grid.nx - 1, solution.grid.ny / 2) / H_oil;
    formula[thinned] = 1.0 - 1.0 / std::sqrt(1.0 + H_oil * H_oil * 2.0 * pi * faster / scene.lambda);
    const friction::Friction found =
        friction::friction_of({solution.grid, solution.P, solution.H, scene.viscosity, scene.thinning},
                              {.stress = slip, .slope = 0.01, .cavitated = friction::Cavitated::none});
    const double mu = slip / H_oil / faster * pi / (2.0 * pi / 3.0);
    BOOST_TEST_MESSAGE((thinned ? "Eyring" : "Newtonian")
                       << ": lost behind it " << lost[thinned] << ", closed form " << formula[thinned]
                       << " (allowed 1.5 %); mu " << found.sliding << ", of the Hertz circle " << mu
                       << " (allowed 2 %: a rim of one cell)");
    BOOST_TEST(std::abs(lost[thinned] / formula[thinned] - 1.0) <= 0.015);
    BOOST_TEST(std::abs(found.sliding / mu - 1.0) <= 0.02);
  }
  BOOST_TEST(std::abs(lost[1] / lost[0] / (formula[1] / formula[0]) - 1.0) <= 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
