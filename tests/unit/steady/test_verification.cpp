// The numbers behind "converged": at a solution, close to one, and in states that only resemble one.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "contact/groups.hpp"
#include "core/constants.hpp"
#include "core/norms.hpp"
#include "judgement/measures.hpp"
#include "judgement/stopping.hpp"
#include "judgement/verification.hpp"
#include "multigrid/cycles.hpp"
#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"
#include "support/text.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_verification)

using namespace ehl;
using namespace ehl::steady;
using namespace ehl::judgement;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const judgement::Tuning tuned;

// (20,10), Roelands z = 0.68, Dowson-Higginson, on cells that are 1.5 times as long as wide.
Scene scene_of(reynolds::Wedge wedge) {
  const contact::Groups groups = contact::from_moes(20.0, 10.0);
  const double p_h = contact::hertz_pressure(groups, 2.2e-8);
  Scene scene;
  scene.contact = steady::scales_of(groups.M, groups.L);
  scene.lambda = groups.lambda;
  scene.viscosity = rheology::make_roelands(2.2e-8, rheology::roelands_p0, 0.68, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  scene.grid = {64, 96, -4.5, 1.5, -3.0, 3.0};
  scene.wedge = wedge;
  scene.solver.tolerance = 1e-12;
  scene.solver.max_cycles = 60;
  return scene;
}

// Evaluates a pressure and H00 independently: film, coefficients and residual of a hierarchy without cycles.
Measures judged_anew(const Scene& scene, const core::Field& P, double H00) {
  const multigrid::Problem problem{
      .film = {.lambda = scene.lambda, .viscosity = scene.viscosity, .density = scene.density},
      .transport = scene.wedge};
  multigrid::Hierarchy hierarchy = multigrid::make_hierarchy(problem, scene.solver, scene.deformation, scene.grid, 1);
  multigrid::Level& level = hierarchy.finest();
  core::copy(P, level.P);
  hierarchy.H00 = H00;
  level.load = 2.0 * core::pi / 3.0;
  multigrid::update_film(hierarchy, level);
  return multigrid::measures_of(hierarchy, hierarchy.levels.size() - 1);
}

// Judges the state as the last of two cycles without any change.
std::string unmet(const Measures& state) {
  const std::string text = unmet_check(tuned, {state, state, 0.02, 0.02}, unknown);
  BOOST_TEST_MESSAGE(text);
  return text;
}

using support::contains;

}  // namespace

BOOST_AUTO_TEST_CASE(mass_is_conserved_where_the_equation_is_solved) {
  for (const reynolds::Wedge wedge : {reynolds::Wedge::upstream1, reynolds::Wedge::upstream2}) {
    const Scene scene = scene_of(wedge);
    const Solution solution = solve(scene);
    BOOST_TEST_REQUIRE(solution.converged);
    const Verification& checked = solution.verification;
    BOOST_TEST_MESSAGE("residual " << checked.residual << ", mass flow error " << checked.flow_imbalance
                                   << " around the contact (tolerance 1e-11), " << checked.flow_imbalance_whole
                                   << " in all (1e-9)");
    BOOST_TEST(checked.residual <= 1e-12);
    BOOST_TEST(std::abs(checked.flow_imbalance) < 1e-11);
    // In the inlet the flow in both directions is some hundred times the flow through the contact.
    BOOST_TEST(std::abs(checked.flow_imbalance_whole) < 1e-9);
    BOOST_TEST(checked.least_P == 0.0);
    BOOST_TEST(checked.dry_violation < 1e-10);
    BOOST_TEST(checked.Hm == solution.levels.back().Hm);
    BOOST_TEST(checked.residual == solution.levels.back().residual);
    // The film in the flow balance belongs to this pressure.
    const Measures anew = judged_anew(scene, solution.P, solution.H00);
    BOOST_TEST(std::abs(anew.flow_through / checked.flow_through - 1.0) < 1e-11);
    BOOST_TEST(std::abs(anew.flow_imbalance) < 1e-10);
  }
}

// A pressure that carries the load but is not the solution: the solution shifted by one cell downstream.
BOOST_AUTO_TEST_CASE(a_wrong_pressure_that_keeps_the_load_loses_mass) {
  const Scene scene = scene_of(reynolds::Wedge::upstream2);
  const Solution solution = solve(scene);
  core::Field P(scene.grid);
  for (int i = 2; i < scene.grid.nx; ++i)
    for (int j = 1; j < scene.grid.ny; ++j) P(i, j) = solution.P(i - 1, j);
  const Measures state = judged_anew(scene, P, solution.H00);
  BOOST_TEST_MESSAGE("load error " << state.load_error << ", residual " << state.residual << ", mass flow error "
                                   << state.flow_imbalance << " (allowed 5e-3)");
  BOOST_TEST(state.load_error < 1e-3);
  BOOST_TEST(std::abs(state.flow_imbalance) > 5e-3);
  Measures quiet = state;  // as if the average residual and the load were satisfied
  quiet.residual = 1e-3;
  quiet.load_error = 0.0;
  quiet.dry_violation = 0.0;
  BOOST_TEST(contains(unmet(quiet), "mass is not conserved"));
}

BOOST_AUTO_TEST_CASE(complementarity_is_checked_on_both_sides) {
  const Scene scene = scene_of(reynolds::Wedge::upstream2);
  const Solution solution = solve(scene);
  const core::Grid& grid = scene.grid;
  const Measures good = judged_anew(scene, solution.P, solution.H00);
  BOOST_TEST(unmet(good).empty());

  // A hole without pressure in the middle of the contact: a cavitation residual.
  core::Field hole;
  hole = solution.P;
  const int i = static_cast<int>(std::lround(-grid.X_a / grid.hx()));
  hole(i, grid.ny / 2) = 0.0;
  const Measures dry = judged_anew(scene, hole, solution.H00);
  BOOST_TEST_MESSAGE("dry violation " << dry.dry_violation << " at a solution " << good.dry_violation);
  BOOST_TEST(good.dry_violation < 1e-10);
  BOOST_TEST(dry.dry_violation > 0.1);
  Measures seen = good;
  seen.dry_violation = dry.dry_violation;
  BOOST_TEST(contains(unmet(seen), "complementarity"));

  // Negative pressure downstream of the exit.
  core::Field suction;
  suction = solution.P;
  suction(grid.nx - 4, grid.ny / 2) = -1e-6;
  const Measures negative = judged_anew(scene, suction, solution.H00);
  BOOST_TEST(negative.least_P == -1e-6);
  seen = good;
  seen.least_P = negative.least_P;
  BOOST_TEST(contains(unmet(seen), "pressure is negative"));
}

BOOST_AUTO_TEST_CASE(verification_says_what_was_checked) {
  LastCycle cycle;
  cycle.before = {.Hc = 0.202, .Hm = 0.104, .residual = 1e-3};
  cycle.after = {.Hc = 0.200, .Hm = 0.100, .residual = 5e-4, .Hm_X = 0.3, .largest_residual = 0.02};
  const Verification checked = verification_of(tuned, cycle);
  // The residual was halved, so the remaining change equals the last change.
  BOOST_TEST(checked.change_Hc == 0.01, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(checked.algebraic_error_Hc == 0.01, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(checked.algebraic_error_Hm == 0.04, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(checked.Hm_X == 0.3);
  BOOST_TEST(checked.largest_residual == 0.02);
  BOOST_TEST(std::isnan(Verification{}.residual));
}

// Reference: on 1024 cells this contact has P_max = 1.273, at its spike.
BOOST_AUTO_TEST_CASE(a_spike_below_the_plateau_of_a_coarse_grid) {
  Scene scene = tests::roelands_scene(71, 13, {256, 256, -4.5, 1.5, -3.0, 3.0});
  const double p_h = contact::from_moes(71, 13).alpha_bar / 1e-8;
  scene.viscosity = rheology::make_barus(1e-8, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  scene.wedge = reynolds::Wedge::upstream2;
  scene.face = reynolds::Face::mean;
  const Solution solution = solve(scene);
  BOOST_TEST_REQUIRE(solution.converged);
  const double P_max = solution.levels.back().P_max;
  BOOST_TEST_MESSAGE("P_max " << P_max << " +- " << solution.error_bars.P_max);
  BOOST_TEST(P_max < 1.05);
  BOOST_TEST(!(P_max * (1.0 + solution.error_bars.P_max) < 1.273));
}

BOOST_AUTO_TEST_SUITE_END()
