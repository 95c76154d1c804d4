// An accuracy instead of a grid: all ways in which such a run may end, with artificial solutions.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "steady/larger_domain.hpp"
#include "unit/steady/made_solutions.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_accuracy)

using namespace ehl;
using namespace ehl::test;
using boost::test_tools::tolerance;

namespace {

bool says(const Solution& solution, const char* word) { return solution.failed_check.find(word) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(met_on_the_first_grid) {
  Made made;
  const Solution solution = run(scene_for(1.001 * first_error), made);
  BOOST_TEST(solution.converged);
  BOOST_TEST(solution.accuracy.met);
  BOOST_TEST(!solution.accuracy.by_extrapolation);
  BOOST_TEST(solution.accuracy.stopped_by == "");
  BOOST_TEST(solution.accuracy.asked == 1.001 * first_error);
  BOOST_TEST(solution.error_bars.Hm.total() == first_error, tolerance(1e-12));
  BOOST_TEST(std::isnan(solution.domain_error_Hc));
  BOOST_TEST(cells(made) == std::vector<int>{64}, boost::test_tools::per_element());
  // Both parts of the error count, and both films.
  Made with_cycles;
  with_cycles.algebraic = 0.01 * first_error;
  run(scene_for(1.001 * first_error), with_cycles);
  BOOST_TEST(with_cycles.asked.size() == 2u);
  Made of_Hc;
  of_Hc.mesh_of_Hm = 0.5;
  run(scene_for(0.499 * first_error), of_Hc);
  BOOST_TEST(of_Hc.asked.size() == 2u);
}

// The error is predicted to fall by a factor of four per halving. A level that would use more than 0.95 of the accuracy
// is skipped: 64 -> 128 or 256.
BOOST_AUTO_TEST_CASE(the_level_is_foretold) {
  const auto last = [](double target, reynolds::Wedge wedge) {
    Made made;
    Scene scene = scene_for(target);
    scene.wedge = wedge;
    const Solution solution = run(scene, made);
    BOOST_TEST(solution.accuracy.met);
    BOOST_TEST(solution.levels.back().nx == made.asked.back().grid.nx);
    BOOST_TEST(made.asked.back().grid.ny == made.asked.back().grid.nx);
    return made.asked.size() == 2 ? made.asked.back().grid.nx : 0;
  };
  const reynolds::Wedge second = reynolds::Wedge::upstream2;
  BOOST_TEST(last(0.99 * first_error, second) == 128);
  BOOST_TEST(last(0.27 * first_error, second) == 128);
  BOOST_TEST(last(0.26 * first_error, second) == 256);
  BOOST_TEST(last(0.07 * first_error, second) == 256);
  BOOST_TEST(last(0.54 * first_error, reynolds::Wedge::upstream1) == 128);
  BOOST_TEST(last(0.51 * first_error, reynolds::Wedge::upstream1) == 256);
}

// On the finest grid the 2 h^2 of Hm is too large although the h^2 of Hc is not: both films must be accurate enough.
BOOST_AUTO_TEST_CASE(stopped_by_the_level_limit) {
  Made made;
  made.kink_of_Hc = 0.01;
  const Solution solution = run(scene_for(0.04 * first_error), made);
  BOOST_TEST(!solution.converged);
  BOOST_TEST(!solution.accuracy.met);
  BOOST_TEST(solution.accuracy.stopped_by == "the largest allowed grid, 256 cells");
  BOOST_TEST_MESSAGE(solution.failed_check);
  BOOST_TEST(says(solution, "the accuracy 0.044 % was not reached because of the largest allowed grid, 256 cells"));
  BOOST_TEST(says(solution, "of Hc 0.034 %, of Hm 0.069 % on 256 cells"));
  // If the predicted level exceeds the limit, the levels are solved one after another.
  BOOST_TEST(cells(made) == (std::vector<int>{64, 128, 256}), boost::test_tools::per_element());
}

// 129 x 129 nodes are allowed in one case, and one node less in the other.
BOOST_AUTO_TEST_CASE(stopped_by_memory) {
  for (const double less : {0.0, 1.0}) {
    Made made;
    made.kink_of_Hm = 0.01;
    Scene scene = scene_for(0.07 * first_error);
    scene.accuracy.most_nodes = 129.0 * 129.0 - less;
    const Solution solution = run(scene, made);
    BOOST_TEST(!solution.converged);
    BOOST_TEST(!solution.accuracy.met);
    BOOST_TEST(solution.accuracy.stopped_by == (less > 0.0 ? "the memory for 128 cells" : "the memory for 256 cells"));
    BOOST_TEST(made.asked.back().grid.nx == (less > 0.0 ? 64 : 128));
  }
}

// Films of exactly second order: the extrapolated value is accurate to a fifth of the correction, 0.16 of the error of
// Hm. It is used if the plain values cannot reach the accuracy.
BOOST_AUTO_TEST_CASE(met_by_extrapolation) {
  Made made;
  const Solution solution = run(scene_for(0.05 * first_error), made);
  BOOST_TEST(solution.converged);
  BOOST_TEST(solution.accuracy.met);
  BOOST_TEST(solution.accuracy.by_extrapolation);
  BOOST_TEST(solution.error_bars.Hm.total() > 0.05 * first_error);
  BOOST_TEST(solution.error_bars.Hm_extrapolated.error <= 0.05 * first_error);
  BOOST_TEST(cells(made) == (std::vector<int>{64, 128}), boost::test_tools::per_element());
  Made once_more;
  BOOST_TEST(run(scene_for(0.03 * first_error), once_more).accuracy.by_extrapolation);
  BOOST_TEST(once_more.asked.back().grid.nx == 256);
  // If the plain values reach the accuracy, nothing is extrapolated.
  Made plain;
  BOOST_TEST(!run(scene_for(0.07 * first_error), plain).accuracy.by_extrapolation);
  BOOST_TEST(plain.asked.back().grid.nx == 256);
}

// With adjoint error estimates, the values that are printed first must reach the accuracy.
BOOST_AUTO_TEST_CASE(met_by_what_is_shown_first) {
  for (const double share : {0.9, 1.1}) {
    Made made;
    const SolveOnGrid solve = [&](const Scene& one) {
      Solution solution = made(one);
      const double target = one.accuracy.error;
      solution.error_bars.Hc_best = {0.4, 0.5 * target};
      solution.error_bars.Hm_best = {0.3, (made.asked.size() == 1 ? share : 0.5) * target};
      return solution;
    };
    const Solution solution = solve_to_accuracy(scene_for(0.01 * first_error), solve, {});
    BOOST_TEST(solution.accuracy.met);
    BOOST_TEST(solution.accuracy.by_extrapolation);
    BOOST_TEST(made.asked.size() == (share < 1.0 ? 1u : 2u));
  }
}

BOOST_AUTO_TEST_CASE(an_unconverged_run_is_not_met) {
  Made at_once;
  at_once.diverges_from = 64;
  const Solution first = run(scene_for(0.9), at_once);
  BOOST_TEST(!first.converged);
  BOOST_TEST(!first.accuracy.met);
  BOOST_TEST(first.accuracy.stopped_by == "made up to fail");
  BOOST_TEST(first.failed_check == "made up to fail");
  BOOST_TEST(at_once.asked.size() == 1u);
  Made far_off;
  far_off.diverges_from = 64;
  BOOST_TEST(run(scene_for(0.3 * first_error), far_off).grid.nx == 64);
  Made later;
  later.diverges_from = 128;
  const Solution second = run(scene_for(0.5 * first_error), later);
  BOOST_TEST(!second.converged);
  BOOST_TEST(!second.accuracy.met);
  BOOST_TEST(second.accuracy.stopped_by == "made up to fail");
  BOOST_TEST(second.grid.nx == 128);
}

// A grid without an error estimate (one level) is followed by the next one.
BOOST_AUTO_TEST_CASE(an_unknown_error_is_not_small) {
  for (ErrorBar ErrorBars::*bar : {&ErrorBars::Hc, &ErrorBars::Hm}) {
    Made made;
    const SolveOnGrid solve = [&](const Scene& one) {
      Solution solution = made(one);
      if (made.asked.size() == 1) (solution.error_bars.*bar).discretization = unknown;
      return solution;
    };
    const Solution solution = solve_to_accuracy(scene_for(0.9), solve, {});
    BOOST_TEST(solution.accuracy.met);
    BOOST_TEST(cells(made) == (std::vector<int>{64, 128}), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(warnings_are_those_of_the_last_grid) {
  Made made;
  made.mesh = 20.0;
  const Solution solution = run(scene_for(0.9), made);
  BOOST_TEST(solution.accuracy.met);
  BOOST_REQUIRE(solution.warnings.size() == 1u);
  BOOST_TEST(solution.warnings[0].name == "mesh");
}

// (0,0) is a node of the grid with 64 cells as well; the cells do not grow; the domain is at most one step of the
// sequence of sizes too long.
BOOST_AUTO_TEST_CASE(larger_domains) {
  const core::Grid grid{256, 128, -4.5, 1.5, -1.5, 1.5};
  for (const double factor : {1.0, 1.01, 1.5, 2.0, 3.0, 5.0, 8.0, 9.0, 17.0, 33.0, 60.0}) {
    const core::Grid larger = on_larger_domain(grid, factor);
    const double length = larger.X_b - larger.X_a;
    const double node = -larger.X_a / (length / (larger.nx > 4096 ? 256 : 64));
    BOOST_TEST_MESSAGE("factor " << factor << ": from " << larger.X_a << " on, " << larger.nx
                                 << " cells, (0,0) at node " << node << " of 64 or 256");
    BOOST_TEST(length >= 6.0 * factor * (1.0 - 1e-9));
    BOOST_TEST(length <= 6.0 * factor * 2.0);
    BOOST_TEST(std::abs(node - std::round(node)) < 1e-9);
    BOOST_TEST(larger.hx() <= grid.hx() * (1.0 + 1e-9));
    BOOST_TEST(larger.hx() > 0.5 * grid.hx());
    BOOST_TEST(larger.X_b == 1.5);
    BOOST_TEST((larger.Y_b - larger.Y_a) / length == 0.5, tolerance(1e-12));
    BOOST_TEST(larger.Y_a == -larger.Y_b);
    BOOST_TEST(larger.nx == 2 * larger.ny);
  }
  BOOST_TEST(on_larger_domain(grid, 1.0).X_a == -4.5);
  BOOST_TEST(on_larger_domain(grid, 1.0).nx == 256);
  BOOST_TEST(on_larger_domain({64, 64, -1.5, 1.5, -1.5, 1.5}, 1.0).X_a == -1.5);
  // Twice the length means twice the cells, whatever the rounding.
  for (int k = 1; k < 40; ++k) {
    const double X_b = 0.1 * k;
    BOOST_TEST(on_larger_domain({64, 64, -3.0 * X_b, X_b, -1.0, 1.0}, 2.0).nx == 128);
  }
  BOOST_TEST(on_larger_domain(grid, 2.0).X_a == -10.5);  // 28 of 32 parts; 14 Hertz radii would suffice, but not less
  BOOST_TEST(on_larger_domain(grid, 8.5).X_a == -94.5);  // 63 of 64 parts
}

// The solver from a normal start: 64 cells are not accurate enough, 256 are. The solution continues from grid to
// grid, and all levels are kept.
BOOST_AUTO_TEST_CASE(the_climb_goes_on_from_the_last_solution) {
  int starts = 0;
  const SolveOnGrid solve_it = [&](const Scene& one) {
    ++starts;
    Scene plain = one;
    plain.accuracy = {};
    Solution solution = steady::solve(plain);
    solution.continuation.push_back({});
    return solution;
  };
  Scene scene = scene_for(0.008);
  scene.grid.nx = scene.grid.ny = 128;
  scene.accuracy.most_cells = 512;
  const Solution solution = solve_to_accuracy(scene, solve_it, {});
  BOOST_TEST(starts == 1);
  BOOST_TEST(solution.accuracy.met);
  BOOST_REQUIRE(solution.levels.size() == 3u);
  BOOST_TEST(solution.levels.front().nx == 64);
  BOOST_TEST(solution.levels.back().nx == 256);
  BOOST_TEST(solution.levels[1].seconds > 0.0);
  BOOST_TEST((solution.method == "full multigrid" && solution.path == "full-multigrid"));
  BOOST_TEST(solution.attempts.size() == 1u);
  BOOST_TEST(solution.continuation.size() == 1u);
  std::size_t cycles = 0;
  for (const LevelRow& row : solution.levels) cycles += static_cast<std::size_t>(row.cycles);
  BOOST_TEST(solution.history.size() == cycles);
  BOOST_TEST_MESSAGE("Hc " << solution.levels.back().Hc
                           << ", of the limit 0.43247 on this domain, error at most 0.008");
  BOOST_TEST(std::abs(solution.levels.back().Hc / 0.43247 - 1.0) < 0.008);
  BOOST_TEST(std::abs(solution.levels.back().Hm / 0.29275 - 1.0) < 0.008);
}

// If the continued solution does not converge, because of too few cycles, all strategies are tried.
BOOST_AUTO_TEST_CASE(the_climb_that_fails_is_replaced) {
  int starts = 0;
  const SolveOnGrid solve_it = [&](const Scene& one) {
    ++starts;
    Scene plain = one;
    plain.accuracy = {};
    plain.solver = {};
    return steady::solve(plain);
  };
  Scene scene = scene_for(0.03);
  scene.solver.tolerance = 1e-12;
  scene.solver.max_cycles = 2;
  const Solution solution = solve_to_accuracy(scene, solve_it, {});
  BOOST_TEST(solution.accuracy.met);
  BOOST_TEST(starts == 2);
  BOOST_TEST(solution.grid.nx == 128);
}

BOOST_AUTO_TEST_SUITE_END()
