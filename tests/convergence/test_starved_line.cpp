// Starved line contacts. There is no side flow, so the mass flow is one number, that of the layer supplied, and the
// Reynolds equation can be integrated once.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <utility>

#include "core/norms.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_starved_line)

using namespace ehl;

namespace {

steady::Scene scene_of(double M, double L, int cells, double H_oil) {
  steady::Scene scene = tests::roelands_line(M, L, core::line_grid(cells, -4.5, 1.5));
  scene.solver.tolerance = 1e-9;
  if (H_oil > 0.0) scene.supply = [H_oil](double) { return H_oil; };
  return scene;
}

double flow_of_flooded(double M, double L, int cells) {
  return steady::solve(scene_of(M, L, cells, 0.0)).verification.flow_through;
}

// Integrates dP/dX = lambda (H - q)/H^3 from the rupture point, where P = 0 and H = q, by the trapezoidal rule.
struct Integrated {
  double largest_difference = 0.0;  // difference in P between the cell of the meniscus and the rupture point
  double meniscus = 0.0;            // where P becomes zero again
};
Integrated integrate(const steady::Scene& scene, const steady::Solution& solution, double q) {
  const core::Grid& grid = solution.grid;
  const auto slope = [&](int i) {
    const double H = solution.H(i, 1);
    return scene.lambda * (H - q) / (H * H * H);
  };
  int i = grid.nx;
  while (solution.P(i, 1) <= 0.0) --i;
  while (solution.H(i, 1) > q) --i;
  // The gap equals q between i and i+1.
  const double share = (q - solution.H(i, 1)) / (solution.H(i + 1, 1) - solution.H(i, 1));
  Integrated result;
  double P = -0.5 * share * grid.hx() * slope(i);
  for (; P > 0.0 && i > 1; --i) {
    if (solution.P(i - 1, 1) > 0.0)
      result.largest_difference = std::max(result.largest_difference, std::abs(P - solution.P(i, 1)));
    const double before = P;
    P -= 0.5 * grid.hx() * (slope(i) + slope(i - 1));
    if (P <= 0.0) result.meniscus = grid.X(i) - grid.hx() * before / (before - P);
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(reynolds_equation_integrated_once) {
  for (const double r : {0.5, 0.9}) {
    double first = 0.0, last = 0.0;
    const double q = r * flow_of_flooded(2, 0, 1024);
    for (const int cells : {256, 512, 1024}) {
      const steady::Scene scene = scene_of(2, 0, cells, q);
      const steady::Solution solution = steady::solve(scene);
      const Integrated exact = integrate(scene, solution, q);
      BOOST_TEST_MESSAGE("r = " << r << ", " << cells << " cells: P differs by " << exact.largest_difference
                                << "; meniscus " << solution.starvation->meniscus_X << ", by the integral "
                                << exact.meniscus);
      BOOST_TEST(solution.converged, solution.failed_check << " " << solution.levels.back().residual);
      BOOST_TEST(std::abs(solution.starvation->meniscus_X - exact.meniscus) <= solution.grid.hx());
      last = exact.largest_difference;
      if (cells == 256) first = last;
    }
    // Second order would give a sixteenth; the position of the meniscus within its cell changes
    // this by a limited amount.
    BOOST_TEST(first / last >= 8.0);
    BOOST_TEST(last <= 2e-4);
  }
}

// Upstream of the meniscus and downstream of the contact, Q is that of the layer supplied. The node next to the edge of
// the film is excluded: its Q depends on the position of the edge in the cell.
BOOST_AUTO_TEST_CASE(the_flow_is_one_number) {
  for (const auto& [M, L] : {std::pair{5.0, 0.0}, std::pair{20.0, 5.0}, std::pair{20.0, 15.0}, std::pair{100.0, 10.0}})
    for (const double r : {0.1, 0.5, 0.9}) {
      const double H_oil = r * flow_of_flooded(M, L, 1024);
      const steady::Solution solution = steady::solve(scene_of(M, L, 1024, H_oil));
      double worst = 0.0;
      int dry = 0;
      for (int i = 0; i < solution.grid.nx; ++i)
        if (solution.theta(i, 1) < 1.0 && (i == 0 || (solution.P(i + 1, 1) <= 0.0 && solution.theta(i - 1, 1) < 1.0))) {
          worst = std::max(worst, std::abs(solution.Q(i, 1) / H_oil - 1.0));
          ++dry;
        }
      BOOST_TEST_MESSAGE("M = " << M << ", L = " << L << ", r = " << r << ": Q of " << dry << " dry nodes is off by "
                                << worst << " (allowed 1e-10), oil " << solution.oil.imbalance() << ", "
                                << solution.method);
      BOOST_TEST(solution.converged);
      BOOST_TEST(dry > 50);
      BOOST_TEST(worst <= 1e-10);
      BOOST_TEST(std::abs(solution.starvation->factor / solution.starvation->supply_ratio - 1.0) <= 5e-3);
    }
}

// rho_bar H at the centre equals that of the layer, and the pressure is that of the dry contact.
BOOST_AUTO_TEST_CASE(thin_layers_below_hertz_pressure) {
  double before = 1.0;
  const double flooded = flow_of_flooded(20, 10, 512);
  for (const double r : {0.4, 0.2, 0.1, 0.05}) {
    const steady::Scene scene = scene_of(20, 10, 512, r * flooded);
    const steady::Solution solution = steady::solve(scene);
    double distance = 0.0;
    for (int i = 0; i <= scene.grid.nx; ++i) {
      const double X = scene.grid.X(i);
      distance += scene.grid.hx() * std::abs(solution.P(i, 1) - std::sqrt(std::max(0.0, 1.0 - X * X)));
    }
    const double off = steady::carried_at_centre(scene, solution) / (r * flooded) - 1.0;
    BOOST_TEST_MESSAGE("r = " << r << ": rho H_c/H_oil - 1 = " << off << " (allowed 1e-6), |P - Hertz| " << distance
                              << ", " << distance / before << " of the one before (allowed 0.75)");
    BOOST_TEST(solution.converged);
    BOOST_TEST(std::abs(off) <= 1e-6);
    BOOST_TEST(distance <= 0.75 * before);
    before = distance;
  }
}

// Oil that cannot pass stays in front of the contact, and the film is flooded.
BOOST_AUTO_TEST_CASE(more_than_goes_through) {
  for (const double M : {5.0, 100.0}) {
    const steady::Solution flooded = steady::solve(scene_of(M, 5, 512, 0.0));
    for (const double r : {1.01, 2.0, 100.0}) {
      const steady::Solution full = steady::solve(scene_of(M, 5, 512, r * flooded.verification.flow_through));
      const double P = core::max_abs_difference(full.P, flooded.P), H = core::max_abs_difference(full.H, flooded.H);
      BOOST_TEST_MESSAGE("M = " << M << ", r = " << r << ": P differs by " << P << ", H by " << H << " (allowed 1e-8)");
      BOOST_TEST(full.converged);
      BOOST_TEST(P <= 1e-8);
      BOOST_TEST(H <= 1e-8);
      BOOST_TEST(!full.warnings.empty());
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
