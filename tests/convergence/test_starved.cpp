// Starved contacts: discrete solutions of an independent program, the flooded limit, side flow of
// thin layers, oil balance.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "contact/ellipse.hpp"
#include "core/norms.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_starved)

using namespace ehl;
using reynolds::Face;
using reynolds::Wedge;

namespace {

constexpr double flooded = std::numeric_limits<double>::infinity();

steady::Scene scene_of(double M, double L, const core::Grid& grid, double H_oil, Wedge wedge = Wedge::upstream2) {
  steady::Scene scene = tests::roelands_scene(M, L, grid);
  scene.wedge = wedge;
  scene.face = Face::mean;
  scene.deformation.method = mlmi::Method::fft;
  scene.solver.tolerance = 1e-10;
  if (H_oil > 0.0) scene.supply = [H_oil](double) { return H_oil; };
  return scene;
}

double first_wet(const steady::Solution& solution) {
  int i = 0;
  while (i < solution.grid.nx && solution.P(i, solution.grid.ny / 2) <= 0.0) ++i;
  return solution.grid.X(i);
}

}  // namespace

// Values of an independent semismooth Newton solver for (50, 10) on 64 x 64 cells.
BOOST_AUTO_TEST_CASE(discrete_solutions_of_another_program) {
  const struct {
    Wedge wedge;
    double H_oil, Hc, Hm, H00, wet;
  } exact[] = {{Wedge::upstream2, flooded, 0.21347950, 0.12809353, -0.78718, -2.4375},
               {Wedge::upstream2, 0.5, 0.20345715, 0.12382326, -0.79923987, -2.0},
               {Wedge::upstream2, 0.25, 0.16861678, 0.10889509, -0.83400895, -1.4375},
               {Wedge::upstream1, flooded, 0.23523914, 0.13887487, std::nan(""), -2.4375},
               {Wedge::upstream1, 0.25, 0.17830679, 0.11458042, -0.82800687, -1.3750}};
  for (const auto& [wedge, H_oil, Hc, Hm, H00, wet] : exact) {
    const steady::Solution solution = steady::solve(scene_of(50, 10, {64, 64, -2.5, 1.5, -2.0, 2.0}, H_oil, wedge));
    const steady::LevelRow& row = solution.levels.back();
    BOOST_TEST_MESSAGE("H_oil = " << H_oil << ": Hc off by " << row.Hc / Hc - 1.0 << ", Hm by " << row.Hm / Hm - 1.0
                                  << ", H00 by " << solution.H00 - H00 << " (allowed 1e-6), first wet node "
                                  << first_wet(solution) << ", " << row.cycles << " cycles, oil "
                                  << solution.oil.imbalance() << " (allowed 1e-9)");
    BOOST_TEST(solution.converged);
    BOOST_TEST(std::abs(row.Hc / Hc - 1.0) <= 1e-6);
    BOOST_TEST(std::abs(row.Hm / Hm - 1.0) <= 1e-6);
    if (std::isfinite(H00)) BOOST_TEST(std::abs(solution.H00 - H00) <= (std::isfinite(H_oil) ? 1e-6 : 5e-6));
    BOOST_TEST(first_wet(solution) == wet);
    BOOST_TEST(std::abs(solution.oil.imbalance()) <= 1e-9);
  }
}

// If the inlet is full, the mass-conserving and the other cavitation model have the same solution.
BOOST_AUTO_TEST_CASE(a_full_inlet_gives_the_solution_of_the_other_model) {
  struct Case {
    double M, L, ratio;
    Wedge wedge;
    Face face;
    bool sheared;
  };
  const Case cases[] = {{5, 2, 1, Wedge::upstream2, Face::mean, false},
                        {20, 10, 1, Wedge::upstream2, Face::mean, false},
                        {20, 10, 1, Wedge::upstream1, Face::mean, false},
                        {20, 10, 1, Wedge::upstream3, Face::mean, false},
                        {20, 10, 1, Wedge::upstream3, Face::logmean_bounded, false},
                        {20, 10, 1, Wedge::upstream2, Face::logmean, true},
                        {50, 10, 1, Wedge::upstream2, Face::mean, true},
                        {100, 5, 1, Wedge::upstream2, Face::mean, false},
                        {100, 5, 1, Wedge::upstream1, Face::mean, false},
                        {200, 10, 1, Wedge::upstream3, Face::logmean_bounded, false},
                        {20, 10, 0.5, Wedge::upstream2, Face::mean, false},
                        {20, 10, 0.5, Wedge::upstream3, Face::logmean_bounded, false}};
  for (const auto& [M, L, ratio, wedge, face, sheared] : cases) {
    steady::Scene scene = scene_of(M, L, {64, 48, -4.5, 1.5, -2.25, 2.25}, 0.0, wedge);
    scene.solver.tolerance = 1e-14;  // the cycles end at rounding errors, some of which exceed this tolerance
    if (ratio != 1.0) {
      scene.contact = steady::scales_of(scene.contact.M, scene.contact.L, contact::ellipse(ratio));
      const contact::Groups groups = contact::from_moes(M, L, scene.contact.shape);
      scene.lambda = groups.lambda;
    }
    scene.face = face;
    if (sheared) scene.thinning = rheology::ShearThinning{rheology::Eyring{}, 0.02};
    scene.polish = steady::Polish::always;
    const steady::Solution other = steady::solve(scene);
    scene.supply = [](double) { return flooded; };
    const steady::Solution full = steady::solve(scene);
    const double P = core::max_abs_difference(other.P, full.P), H = core::max_abs_difference(other.H, full.H);
    BOOST_TEST_MESSAGE("M = " << M << ", L = " << L << ", R_x/R_y = " << ratio << ": P differs by " << P << ", H by "
                              << H << " (allowed 1e-12), residual " << full.levels.back().residual);
    BOOST_TEST(full.chattering_nodes == 0);
    BOOST_TEST(full.levels.back().residual <= 1e-12);
    BOOST_TEST(P <= 1e-12);
    BOOST_TEST(H <= 1e-12);
  }
}

// In a thin layer on y = 0 of a Hertz contact with isoviscous, incompressible oil, side flow increases Q^-2 by 2
// pi/lambda through the contact; half of it is reached at the centre.
BOOST_AUTO_TEST_CASE(side_flow_of_thin_layers) {
  for (const double H_oil : {0.02, 0.01}) {
    steady::Scene scene = scene_of(20, 0, {96, 96, -3.0, 1.5, -2.25, 2.25}, H_oil);
    scene.viscosity = rheology::Isoviscous{};
    scene.density = rheology::Incompressible{};
    const steady::Solution solution = steady::solve(scene);
    const double formula = 1.0 / std::sqrt(1.0 + H_oil * H_oil * std::numbers::pi / scene.lambda);
    const double out = 1.0 / std::sqrt(1.0 + 2.0 * H_oil * H_oil * std::numbers::pi / scene.lambda);
    const double centre = solution.levels.back().Hc / H_oil;
    const double behind = solution.Q(solution.grid.nx - 1, solution.grid.ny / 2) / H_oil;
    BOOST_TEST_MESSAGE("H_oil = " << H_oil << ": 1 - Q_c/H_oil = " << 1.0 - centre << " (formula " << 1.0 - formula
                                  << "), behind it " << 1.0 - behind << " (" << 1.0 - out << ")");
    BOOST_TEST(solution.converged);
    BOOST_TEST(std::abs(centre - formula) <= 0.005 * H_oil);
    BOOST_TEST(std::abs((1.0 - behind) / (1.0 - out) - 1.0) <= 0.02);
  }
}

// The half domain and the whole domain agree, the cycles and Newton's method agree, and Q is constant
// along X behind the contact.
BOOST_AUTO_TEST_CASE(ways_agree) {
  steady::Scene scene = scene_of(20, 10, {64, 64, -2.5, 1.5, -2.0, 2.0}, 0.3, Wedge::upstream3);
  scene.face = Face::logmean_bounded;
  const steady::Solution half = steady::solve(scene);
  scene.use_symmetry = false;
  const steady::Solution whole = steady::solve(scene);
  scene.polish = steady::Polish::always;
  const steady::Solution newton = steady::solve(scene);
  BOOST_TEST_MESSAGE("half and whole: P differs by "
                     << core::max_abs_difference(half.P, whole.P) << ", Q by "
                     << core::max_abs_difference(half.Q, whole.Q) << "; Newton's method: "
                     << core::max_abs_difference(newton.P, whole.P) << " (allowed 1e-8: a residual of 1e-10)");
  BOOST_TEST(half.converged);
  BOOST_TEST(newton.polish_failure.empty());
  BOOST_TEST(core::max_abs_difference(half.P, whole.P) <= 1e-8);
  BOOST_TEST(core::max_abs_difference(half.Q, whole.Q) <= 1e-8);
  BOOST_TEST(core::max_abs_difference(newton.P, whole.P) <= 1e-8);
  BOOST_TEST(std::abs(newton.oil.imbalance()) <= 1e-10);
  const int n = half.grid.nx;
  for (int j = 1; j < half.grid.ny; ++j) BOOST_TEST(std::abs(half.Q(n - 1, j) - half.Q(n - 3, j)) <= 1e-9);
}

// A tenth of the flooded film on a coarse grid: with the second-order flux, nodes at the edge of the film chatter. An
// independent program gives the factor 0.0999.
BOOST_AUTO_TEST_CASE(nodes_that_swing_get_a_flux_of_first_order) {
  steady::Scene scene = scene_of(50, 10, {64, 64, -2.5, 1.5, -2.0, 2.0}, 0.025075);
  scene.solver.tolerance = 1e-9;
  const steady::Solution solution = steady::solve(scene);
  BOOST_TEST_MESSAGE("factor " << solution.starvation->factor << " (0.0999 +- 0.0005), " << solution.chattering_nodes
                               << " nodes, residual " << solution.levels.back().residual << ", oil "
                               << solution.oil.imbalance() << " (allowed 1e-10)");
  BOOST_TEST(solution.converged);
  BOOST_TEST(solution.chattering_nodes > 0);
  BOOST_TEST(std::abs(solution.starvation->factor - 0.0999) <= 5e-4);
  BOOST_TEST(std::abs(solution.oil.imbalance()) <= 1e-10);
}

// Chattering within the cycles: a node without pressure that is full passes its surplus to its neighbour; otherwise no
// start converges. So thin a layer passes unchanged: Q at the centre divided by H_oil is 1 minus the side flow, 1e-4.
BOOST_AUTO_TEST_CASE(cycles_go_on_where_a_node_swings) {
  const double H_oil = 0.00703;
  steady::Scene scene = scene_of(200, 10, {128, 128, -63.0 / 22, 1.5, -24.0 / 11, 24.0 / 11}, H_oil, Wedge::upstream3);
  scene.face = Face::logmean_bounded;
  scene.deformation = {};
  scene.solver.tolerance = 1e-9;
  scene.polish = steady::Polish::off;
  const steady::Solution solution = steady::solve(scene);
  const double through = solution.starvation->factor / solution.starvation->supply_ratio;
  BOOST_TEST_MESSAGE("Q_c/H_oil = " << through << " (1 - 1e-4), " << solution.chattering_nodes << " nodes, residual "
                                    << solution.levels.back().residual << " in " << solution.levels.back().cycles
                                    << " cycles of start " << solution.attempts.size());
  BOOST_TEST(solution.converged);
  BOOST_TEST(solution.attempts.size() == 1U);
  BOOST_TEST(solution.chattering_nodes == 2);  // one in each half
  BOOST_TEST(std::abs(through - 1.0) <= 2e-4);
  BOOST_TEST(std::abs(solution.oil.imbalance()) <= 1e-10);
}

// Cycles that stop at the discretization error leave residuals in the rows of full nodes. The oil must still balance,
// and the film must agree with that of many cycles.
BOOST_AUTO_TEST_CASE(oil_balances_where_cycles_end_early) {
  for (const double H_oil : {0.1, 0.25, 1.0, 3.0}) {
    steady::Scene scene = scene_of(50, 10, {128, 128, -2.5, 1.5, -2.0, 2.0}, H_oil, Wedge::upstream3);
    scene.face = Face::logmean_bounded;
    scene.solver.tolerance = 1e-8;
    const double many = steady::solve(scene).levels.back().Hc;
    scene.solver.tolerance = std::nan("");
    const steady::Solution solution = steady::solve(scene);
    const double off = solution.levels.back().Hc / many - 1.0;
    BOOST_TEST_MESSAGE("H_oil = " << H_oil << ": oil " << solution.oil.imbalance() << " (allowed 1e-10), residual "
                                  << solution.levels.back().residual << ", Hc off by " << off
                                  << " (allowed 2e-4: a tenth of the mesh's error)");
    BOOST_TEST(solution.converged);
    BOOST_TEST(solution.levels.back().residual >= 1e-6);  // the cycles stop early
    BOOST_TEST(std::abs(solution.oil.imbalance()) <= 1e-10);
    BOOST_TEST(std::abs(off) <= 2e-4);
  }
}

// A meniscus far from the inlet, with the default stopping criterion. The global mass correction is added where the
// last cycle changed the film, so that it causes no rough error and needs no additional cycles.
BOOST_AUTO_TEST_CASE(closing_the_oil_takes_no_cycles) {
  steady::Scene scene = scene_of(50, 10, {512, 512, -4.5, 1.5, -3.0, 3.0}, 0.319614, Wedge::upstream3);
  scene.face = Face::logmean_bounded;
  scene.deformation.method = mlmi::Method::mlmi;
  scene.solver.tolerance = std::nan("");
  scene.polish = steady::Polish::off;
  const steady::Solution solution = steady::solve(scene);
  constexpr double by_newton = 0.191551;
  const double off = solution.levels.back().Hc / by_newton - 1.0;
  BOOST_TEST_MESSAGE("off by " << off << " (allowed 1e-5), " << solution.levels.back().cycles << " cycles of start "
                               << solution.attempts.size());
  BOOST_TEST(solution.converged);
  BOOST_TEST(solution.attempts.size() == 1U);
  BOOST_TEST(solution.levels.back().cycles <= 7);
  BOOST_TEST(std::abs(off) <= 1e-5);
}

// With a loose tolerance, the cycles continue until the oil balances.
BOOST_AUTO_TEST_CASE(no_solution_without_a_balance) {
  for (const double H_oil : {0.05, 0.1, 0.2}) {
    steady::Scene scene = scene_of(4.7, 0, {94, 94, -10.7, 1.9, -6.3, 6.3}, H_oil, Wedge::upstream3);
    scene.face = Face::logmean_bounded;
    scene.viscosity = rheology::Isoviscous{};
    scene.density = rheology::Incompressible{};
    scene.solver.tolerance = 0.01;
    scene.solver.cycle = multigrid::Cycle::F;
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST_MESSAGE("H_oil = " << H_oil << ": " << solution.levels.back().cycles << " cycles, oil "
                                  << solution.oil.imbalance() << " (allowed 1e-10)");
    BOOST_TEST(solution.converged);
    BOOST_TEST(std::abs(solution.oil.imbalance()) <= 1e-10);
  }
}

BOOST_AUTO_TEST_SUITE_END()
