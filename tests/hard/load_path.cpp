// Load continuation from M = 20 to M = 5000: it ends at the directly computed solution, reports every step, and fails
// with a reason if it cannot succeed. Newton's method after the cycles. A mesh on which no film is positive.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "core/errors.hpp"
#include "hard/hard_scene.hpp"
#include "steady/continuation.hpp"
#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_hard_load_path)

using namespace ehl;
using Path = steady::ContinuationParameters::Path;

namespace {

constexpr double first_M = 20.0;

steady::Scene heaviest(int n, Path path) {
  steady::Scene scene = hard::scene({5000, 10}, n);
  scene.continuation.path = path;
  if (path == Path::load) scene.continuation.load_ratio = first_M / scene.contact.M;
  return scene;
}

/// The loads stay within the range, each is reported, and a rejected step is followed by a shorter one.
void require_sensible(const std::vector<steady::ContinuationStep>& steps, double last_M) {
  BOOST_TEST_REQUIRE(!steps.empty());
  BOOST_TEST(steps.front().M == first_M, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(steps.front().converged);
  double reached = steps.front().M;
  for (std::size_t k = 1; k < steps.size(); ++k) {
    const steady::ContinuationStep& step = steps[k];
    BOOST_TEST_MESSAGE("  M = " << step.M << (step.converged ? ", solved in " : ", rejected after ") << step.cycles
                                << " cycles, Hc " << step.Hc << ", Hm " << step.Hm << ", residual " << step.residual);
    BOOST_TEST(step.M > reached);
    BOOST_TEST(step.M <= last_M);
    BOOST_TEST(step.load_ratio == step.M / last_M, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(step.cycles >= 1);
    if (!step.converged) {
      // Half the step in ln M, from the same load.
      if (k + 1 < steps.size())
        BOOST_TEST(std::log(steps[k + 1].M / reached) == 0.5 * std::log(step.M / reached),
                   boost::test_tools::tolerance(1e-9));
      continue;
    }
    BOOST_TEST(step.residual <= 1e-4);
    BOOST_TEST(step.Hc < steps.front().Hc);
    reached = step.M;
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(direct_and_by_continuation_the_end_is_the_same) {
  const steady::Solution direct = steady::solve(heaviest(256, Path::off));
  const steady::Solution by_load = steady::solve(heaviest(256, Path::load));
  BOOST_TEST(direct.converged, direct.failed_check);
  BOOST_TEST(direct.method == "full multigrid");
  BOOST_TEST(direct.continuation.empty());
  BOOST_TEST(by_load.converged, by_load.failed_check);
  BOOST_TEST((by_load.method == "load continuation" && by_load.path == "load-continuation"));
  BOOST_TEST(by_load.attempts.size() == 1U);
  require_sensible(by_load.continuation, 5000.0);
  BOOST_TEST(by_load.continuation.back().converged);
  BOOST_TEST(by_load.continuation.back().M == 5000.0);
  const double apart = hard::difference(direct, by_load);
  BOOST_TEST_MESSAGE("(20,10) to (5000,10) on 256 cells: apart by " << apart << " (allowed 1e-6) from the direct way; "
                                                                    << by_load.continuation.size() << " loads");
  BOOST_TEST(apart <= 1e-6);
  BOOST_TEST(apart > 0.0);
}

// An intermediate load of the continuation has the same solution as that load by itself.
BOOST_AUTO_TEST_CASE(a_load_on_the_way_is_solved_as_by_itself) {
  steady::Scene scene = hard::scene({400, 10}, 128);
  scene.continuation.path = Path::load;
  scene.continuation.load_ratio = first_M / scene.contact.M;
  const steady::Solution solution = steady::solve(scene);
  BOOST_TEST(solution.converged, solution.failed_check);
  require_sensible(solution.continuation, 400.0);
  for (const steady::ContinuationStep& step : solution.continuation) {
    if (!step.converged) continue;
    steady::Scene alone = hard::scene({step.M, 10}, 128);
    alone.grid = scene.grid;
    alone.continuation.path = Path::off;
    const steady::LevelRow row = steady::solve(alone).levels.back();
    BOOST_TEST_MESSAGE("M = " << step.M << ": Hc off by " << hard::relative(step.Hc, row.Hc) << ", Hm by "
                              << hard::relative(step.Hm, row.Hm) << " (allowed 1e-3: a residual of 1e-4)");
    BOOST_TEST(hard::relative(step.Hc, row.Hc) <= 1e-3);
    BOOST_TEST(hard::relative(step.Hm, row.Hm) <= 1e-3);
  }
}

// Next to a slender contact, the minimum film is a small fraction of the central film. A prediction of H00 from the
// central film would exceed it, and the continuation would need many more loads.
BOOST_AUTO_TEST_CASE(the_film_at_the_side_lives_from_load_to_load) {
  steady::Scene scene = tests::roelands_scene(200, 5, {256, 384, -2.5, 1.5, -0.3125, 0.3125}, contact::ellipse(50));
  scene.wedge = reynolds::Wedge::upstream3;
  scene.face = reynolds::Face::logmean_bounded;
  scene.far_field = true;
  scene.continuation.path = Path::load;
  scene.continuation.load_ratio = first_M / scene.contact.M;
  const steady::Solution solution = steady::solve(scene);
  BOOST_TEST(solution.converged, solution.failed_check);
  require_sensible(solution.continuation, scene.contact.M);
  BOOST_TEST_MESSAGE("R_x/R_y = 50, (20, 5) to (200, 5): " << solution.continuation.size() << " loads (at most 5)");
  BOOST_TEST(solution.continuation.size() <= 5U);
}

BOOST_AUTO_TEST_CASE(a_continuation_that_runs_out_of_steps_says_where) {
  steady::Scene scene = heaviest(256, Path::load);
  scene.continuation.max_steps = 2;
  scene.polish = steady::Polish::off;
  std::string said;
  try {
    steady::solve(scene);
  } catch (const core::SolverError& error) {
    said = error.what();
  }
  BOOST_TEST_MESSAGE("max_steps = 2: " << said);
  BOOST_TEST(said.find("2 steps (max_steps)") != std::string::npos);
  BOOST_TEST(said.find("M = 40") != std::string::npos);
}

// All loads but the last have a solution on this mesh; for the last one the film is negative.
BOOST_AUTO_TEST_CASE(a_mesh_too_coarse_is_not_cured_by_continuation) {
  for (const steady::Polish polish : {steady::Polish::fallback, steady::Polish::off}) {
    steady::Scene scene = heaviest(128, Path::load);
    scene.polish = polish;
    scene.solver.tolerance = std::numeric_limits<double>::quiet_NaN();
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST_MESSAGE("(5000,10) on 128 cells: " << solution.failed_check << "; " << solution.attempts.size()
                                                  << " ways tried, " << solution.seconds << " s");
    BOOST_TEST(!solution.converged);
    BOOST_TEST(solution.failed_check.find("the mesh is too coarse") != std::string::npos);
    BOOST_TEST(solution.attempts.size() == 1U);
    require_sensible(solution.continuation, 5000.0);
  }
}

// No film on these cells is positive: there must be a single attempt, and the reason must be the mesh.
BOOST_AUTO_TEST_CASE(a_mesh_without_a_solution_is_named) {
  for (const int n : {64, 128, 256}) {
    steady::Scene scene = hard::scene({5000, 1}, n);
    scene.contact = steady::scales_of(scene.contact.M, 0.0);
    scene.lambda = contact::from_moes(5000, 0).lambda;
    scene.viscosity = rheology::Isoviscous{};
    scene.density = rheology::Incompressible{};
    scene.solver.tolerance = std::numeric_limits<double>::quiet_NaN();
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST_MESSAGE(hard::name(scene) << ": " << solution.failed_check << "; least H " << solution.levels.back().Hm
                                         << ", residual " << solution.levels.back().residual << ", "
                                         << solution.attempts.size() << " ways tried, " << solution.levels.back().cycles
                                         << " cycles");
    BOOST_TEST(!solution.converged);
    BOOST_TEST((solution.end == steady::CyclesEnd::no_solution));
    BOOST_TEST(solution.failed_check.find("the mesh is too coarse") != std::string::npos);
    BOOST_TEST(solution.levels.back().Hm <= 0.0);
    BOOST_TEST(solution.levels.back().residual <= 1e-5);
    BOOST_TEST(solution.attempts.size() == 1U);
    BOOST_TEST(solution.levels.back().cycles < 60);
  }
}

// Newton refinement to rounding errors, with all else unchanged, shows that the default stopping criterion leaves less
// than a tenth of the discretization error.
BOOST_AUTO_TEST_CASE(a_polish_reaches_rounding_errors) {
  for (const hard::Load load : {hard::Load{20, 20}, {200, 15}, {2000, 10}}) {
    steady::Scene scene = hard::scene(load, 256);
    scene.solver.tolerance = std::numeric_limits<double>::quiet_NaN();
    const steady::Solution cycles = steady::solve(scene);
    scene.polish = steady::Polish::always;
    const steady::Solution polished = steady::solve(scene);
    const steady::LevelRow& row = polished.levels.back();
    BOOST_TEST_MESSAGE(hard::name(scene) << ": residual " << cycles.levels.back().residual << " and polished "
                                         << row.residual << " (allowed 1e-10) in " << polished.newton.size()
                                         << " steps; Hc changed by " << hard::relative(cycles.levels.back().Hc, row.Hc)
                                         << " (allowed " << 0.1 * row.mesh_error_Hc << "), Hm by "
                                         << hard::relative(cycles.levels.back().Hm, row.Hm) << " (allowed "
                                         << 0.1 * row.mesh_error_Hm << ")");
    BOOST_TEST(polished.converged, polished.failed_check);
    BOOST_TEST(polished.polish_failure == "");
    BOOST_TEST(polished.newton.size() >= 1U);
    BOOST_TEST(row.residual <= 1e-10);
    BOOST_TEST(row.load_error <= 1e-10);
    BOOST_TEST(hard::relative(cycles.levels.back().Hc, row.Hc) <= 0.1 * row.mesh_error_Hc);
    BOOST_TEST(hard::relative(cycles.levels.back().Hm, row.Hm) <= 0.1 * row.mesh_error_Hm);
  }
}

// On cells eight times as long as wide, relaxation diverges unless the changes of ln eta are limited.
BOOST_AUTO_TEST_CASE(long_cells_are_solved_at_once) {
  steady::Scene scene = hard::scene({1000, 10}, 64);
  scene.grid.ny = 512;
  const steady::Solution solution = steady::solve(scene);
  BOOST_TEST_MESSAGE(hard::name(scene) << ": " << solution.method << ", " << solution.levels.back().cycles
                                       << " cycles, " << solution.cycle_factor << " left by each (at most 0.7)");
  BOOST_TEST(solution.converged, solution.failed_check);
  BOOST_TEST(solution.method == "full multigrid");
  BOOST_TEST(solution.cycle_factor <= 0.7);
}

// If the cycles fail, another strategy must succeed and be reported.
BOOST_AUTO_TEST_CASE(newtons_method_saves_what_cycles_leave_unsolved) {
  steady::Scene scene = hard::scene({2000, 15}, 64);
  scene.grid.ny = 512;  // also too long for this film, so that the cycles stall
  scene.continuation.path = Path::off;
  const steady::Solution saved = steady::solve(scene);
  BOOST_TEST_MESSAGE(hard::name(scene) << ": " << saved.method << ", residual " << saved.levels.back().residual
                                       << ", after " << saved.attempts.size() - 1 << " ways that failed");
  for (const steady::Attempt& attempt : saved.attempts)
    BOOST_TEST_MESSAGE("  " << attempt.method << ": " << (attempt.reason.empty() ? "solved" : attempt.reason));
  BOOST_TEST(saved.converged, saved.failed_check);
  BOOST_TEST((saved.method.starts_with("Newton-Krylov") && saved.path.starts_with("newton")));
  BOOST_TEST(saved.levels.back().residual <= 1e-10);
  BOOST_TEST(saved.attempts.back().reason == "");
  for (std::size_t k = 0; k + 1 < saved.attempts.size(); ++k) BOOST_TEST(saved.attempts[k].reason != "");

  scene.polish = steady::Polish::off;
  const steady::Solution left = steady::solve(scene);
  BOOST_TEST_MESSAGE("  without: " << left.failed_check);
  BOOST_TEST(!left.converged);
  BOOST_TEST(left.failed_check != "");
}

// If all other strategies are forbidden, there may be no state to show.
BOOST_AUTO_TEST_CASE(what_cannot_be_shown_is_an_error) {
  steady::Scene scene = hard::scene({1000, 0}, 64);
  scene.grid.ny = 1024;
  scene.continuation.path = Path::off;
  scene.polish = steady::Polish::off;
  BOOST_CHECK_EXCEPTION(steady::solve(scene), core::SolverError, [](const core::SolverError& error) {
    BOOST_TEST_MESSAGE("  without: " << error.what());
    return std::string(error.what()).find("no other strategy gave a state") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
