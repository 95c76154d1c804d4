// An accuracy instead of a grid, with a domain that may grow.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "unit/steady/made_solutions.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_free_domain)

using namespace ehl;
using namespace ehl::test;
using boost::test_tools::tolerance;

namespace {

Scene free_scene(double error) {
  Scene scene = scene_for(error);
  scene.accuracy.domain_is_free = true;
  scene.accuracy.most_cells = 4096;
  return scene;
}

// The load is so light that a domain of 200 Hertz radii is 72 times the size of the contact zone.
Scene light_free_scene(double error) {
  Scene scene = free_scene(error);
  scene.contact = steady::scales_of(2.0, 0.0);
  return scene;
}

}  // namespace

// The inlet error e decreases with length^-3, so doubling the length removes 7/8 e. The estimate takes this for 3/4,
// that is (7/6) e, and asks for sqrt(estimate/(accuracy/2)) times the length; the next size is 1.5 * 32/3 = 16.
BOOST_AUTO_TEST_CASE(it_grows_until_half_of_the_target_is_left) {
  Made made;
  made.mesh = 0.05;
  made.inlet = -0.01 * 216.0;
  const Solution solution = run(free_scene(0.004), made);
  BOOST_TEST(solution.accuracy.met);
  BOOST_REQUIRE(made.asked.size() >= 4u);
  // Three coarse solutions, well converged: the domain itself, its double, and the double of that;
  // none asks for an accuracy.
  for (const std::size_t k : {0u, 1u, 2u}) {
    BOOST_TEST(std::isnan(made.asked[k].accuracy.error));
    BOOST_TEST(made.asked[k].solver.tolerance == 1e-6);
  }
  BOOST_TEST(made.asked[0].grid.nx == 64);
  BOOST_TEST(made.asked[0].grid.X_a == -4.5);
  BOOST_TEST(made.asked[1].grid.X_a == -10.5);
  BOOST_TEST(made.asked[1].grid.nx == 128);
  BOOST_TEST(made.asked[1].grid.ny == 128);
  BOOST_TEST(made.asked[1].grid.Y_a == -6.0);
  BOOST_TEST(made.asked[1].grid.Y_b == 6.0);
  BOOST_TEST(made.asked[2].grid.X_a == -22.5);
  BOOST_TEST(made.asked[2].grid.nx == 256);
  const core::Grid& grid = made.asked[3].grid;
  BOOST_TEST_MESSAGE("from " << grid.X_a << " on, " << grid.nx << " cells; error of the domain "
                             << solution.domain_error_Hc << " (0.0117 by the square of that)");
  const double length = grid.X_b - grid.X_a;
  BOOST_TEST(length == 1.5 * 32.0 / 3.0, tolerance(1e-12));
  BOOST_TEST(solution.domain_error_Hc == 7.0 / 6.0 * 0.01 * 36.0 / (length * length), tolerance(0.02));
  BOOST_TEST(solution.error_bars.domain == solution.domain_error_Hc);
  BOOST_TEST(std::isnan(made.asked[3].solver.tolerance));
  BOOST_TEST(made.asked[3].accuracy.error == 0.004);
  BOOST_TEST(solution.accuracy.asked == 0.004);
}

// An error of missing load decreases with the first power: from 1 % at a length of 6, half of 0.4 % needs a length
// of 30; the next size is 48.
BOOST_AUTO_TEST_CASE(missing_load_falls_slowly) {
  Made made;
  made.diverges_from = 10000;
  made.mesh = 0.001;
  made.load = -0.01 * 6.0;
  const Solution solution = run(free_scene(0.004), made);
  BOOST_TEST(solution.accuracy.met);
  BOOST_TEST(solution.grid.X_a == -46.5);
  BOOST_TEST(solution.domain_error_Hc == 0.01 / 8.0, tolerance(0.02));
  // 0.4 % from the inlet and 0.6 % from the load, at sixteen times the length: the two parts are separated.
  Made both;
  both.diverges_from = 10000;
  both.mesh = 0.001;
  both.inlet = -0.004 * 216.0;
  both.load = -0.006 * 6.0;
  BOOST_TEST(run(free_scene(0.5), both).domain_error_Hc == 0.01, tolerance(0.02));
  BOOST_TEST(run(light_free_scene(0.0012), both).domain_error_Hc == 0.006 / 16.0 + 0.004 / 4096.0, tolerance(0.02));
}

// If the domain may use half of 0.4 %, it needs a length of 48 and 512 cells. If 256 cells are allowed, it may use 0.7,
// for which 24 suffices; with 128 cells there is no solution.
BOOST_AUTO_TEST_CASE(more_for_the_domain_where_half_is_too_little) {
  const auto length = [](int most_cells) {
    Made made;
    made.mesh = 0.001;
    made.load = -0.01 * 6.0;
    Scene scene = free_scene(0.004);
    scene.accuracy.most_cells = most_cells;
    const Solution solution = run(scene, made);
    BOOST_TEST(solution.accuracy.met == (most_cells > 128));
    return solution.grid.X_b - solution.grid.X_a;
  };
  BOOST_TEST(length(512) == 48.0, tolerance(1e-12));
  BOOST_TEST(length(256) == 24.0, tolerance(1e-12));
  BOOST_TEST(length(128) == 6.0, tolerance(1e-12));
}

// Each part is taken from the film in which it is larger: here the load error of Hm is ten times that of Hc.
BOOST_AUTO_TEST_CASE(parts_of_the_worse_film) {
  const auto error = [](double inlet, double load) {
    Made made;
    made.mesh = 1e-4;
    made.inlet = -216.0 * inlet;
    made.load = -6.0 * load;
    made.domain_of_Hm = 10.0;
    return run(free_scene(0.5), made).domain_error_Hc;
  };
  BOOST_TEST(error(0.0001, 0.001) == 0.011, tolerance(0.03));
  BOOST_TEST(error(0.001, 0.001) == 0.02, tolerance(0.03));
}

// An error that decreases faster than the third power has no part from the load. A domain of any length is
// kept if its error is small.
BOOST_AUTO_TEST_CASE(no_load_less_than_none) {
  Made made;
  int size = 0;
  const SolveOnGrid solve = [&](const Scene& one) {
    Solution solution = made(one);
    LevelRow& row = solution.levels.back();
    for (double LevelRow::*film : {&LevelRow::Hc, &LevelRow::Hm, &LevelRow::Hm_fitted})
      row.*film = size == 0 ? 0.99 : 1.0;
    ++size;
    return solution;
  };
  Scene scene = free_scene(0.9);
  scene.grid.X_a = -10.5;
  const Solution solution = solve_to_accuracy(scene, solve, {});
  BOOST_TEST(solution.domain_error_Hc == 4.0 / 3.0 * (1.0 / 0.99 - 1.0), tolerance(1e-9));
  BOOST_TEST(solution.grid.X_a == -10.5);
}

// Four times the domain is tried with up to 1024 cells.
BOOST_AUTO_TEST_CASE(cells_spent_on_the_domain) {
  for (const int cells : {512, 1024}) {
    Made made;
    made.diverges_from = 10000;
    Scene scene = free_scene(0.5);
    scene.grid = {cells, 4, -4.5, 1.5, -3.0, 3.0};
    run(scene, made);
    BOOST_TEST(made.asked.size() == (cells == 512 ? 4u : 3u));
  }
}

// An error of the domain of 0.36 % is less than half of the accuracy of 0.8 %; the mesh must use less
// than the remaining 0.44 %.
BOOST_AUTO_TEST_CASE(the_mesh_has_what_the_domain_leaves) {
  const auto last = [](double estimate_of_mesh) {
    Made made;
    made.inlet = -0.0036 * 6.0 / 7.0 * 216.0;
    made.mesh = estimate_of_mesh / first_error * 0.5;
    BOOST_TEST(run(free_scene(0.008), made).accuracy.met);
    BOOST_TEST(made.asked[3].grid.X_a == -4.5);
    return made.asked.back().grid.nx;
  };
  BOOST_TEST(last(0.0042) == 64);
  BOOST_TEST(last(0.0046) == 128);
}

// The larger error of Hc and Hm counts, for films that grow and that shrink.
BOOST_AUTO_TEST_CASE(the_worse_of_both_films_tells_the_domain) {
  const auto error = [](double domain, double domain_of_Hm) {
    Made made;
    made.mesh = 1e-4;
    made.inlet = 216.0 * domain;
    made.domain_of_Hm = domain_of_Hm;
    return run(free_scene(0.5), made).domain_error_Hc;
  };
  for (const double sign : {1.0, -1.0}) {
    BOOST_TEST(error(0.01 * sign, 0.2) == 7.0 / 6.0 * 0.01, tolerance(0.02));
    BOOST_TEST(error(0.01 * sign, 3.0) == 7.0 / 6.0 * 0.03, tolerance(0.05));
  }
}

// A jump of the smallest node or of the fitted minimum by 5 % on the second or third domain is no error of the domain.
BOOST_AUTO_TEST_CASE(a_minimum_that_jumps_is_no_loss) {
  for (double LevelRow::*film : {&LevelRow::Hm, &LevelRow::Hm_fitted})
    for (const std::size_t jumps : {2u, 3u}) {
      Made made;
      made.mesh = 1e-4;
      made.inlet = -0.01 * 216.0;
      const SolveOnGrid solve = [&](const Scene& one) {
        Solution solution = made(one);
        if (made.asked.size() == jumps) solution.levels.back().*film *= 0.95;
        return solution;
      };
      const Solution solution = solve_to_accuracy(free_scene(0.5), solve, {});
      BOOST_TEST(solution.domain_error_Hc == 7.0 / 6.0 * 0.01, tolerance(0.02));
    }
}

// An error of 10 % at a length of 6 and an accuracy of a twentieth of it: the next size is 192, of
// which 190.5 are upstream.
BOOST_AUTO_TEST_CASE(up_to_200_radii) {
  Made made;
  made.diverges_from = 10000;
  made.mesh = 1e-6;
  made.inlet = -0.1 * 216.0;
  Scene scene = light_free_scene(5e-4);
  scene.grid.ny = 4;
  const Solution solution = run(scene, made);
  BOOST_TEST(solution.accuracy.met);
  BOOST_TEST(solution.grid.X_a == -190.5);
  BOOST_TEST(solution.grid.nx == 2048);
}

BOOST_AUTO_TEST_CASE(half_the_cells_tell_the_domain) {
  Made made;
  Scene scene = free_scene(0.5);
  scene.grid.nx = scene.grid.ny = 256;
  run(scene, made);
  BOOST_TEST(cells(made) == (std::vector<int>{128, 256, 512, 256}), boost::test_tools::per_element());
  // A domain larger than necessary is kept.
  BOOST_TEST(made.asked[3].grid.X_a == -4.5);
}

BOOST_AUTO_TEST_CASE(what_stops_the_domain_stops_the_run) {
  const auto stopped = [](const Scene& scene, Made& made) {
    const Solution solution = run(scene, made);
    BOOST_TEST(!solution.converged);
    BOOST_TEST(!solution.accuracy.met);
    // The case is solved nevertheless, on the domain of the deck.
    BOOST_TEST(solution.grid.X_a == -4.5);
    BOOST_TEST_MESSAGE(solution.failed_check);
    return solution.accuracy.stopped_by;
  };
  // The inlet error at 6 radii is so large that the accuracy needs a domain far longer than 200 radii.
  Made far;
  far.mesh = 1e-4;
  far.inlet = -0.1 * 216.0;
  BOOST_TEST(stopped(light_free_scene(1e-4), far) ==
             "the length of the domain: more than 200 Hertz radii would be needed");
  BOOST_TEST(stopped(free_scene(1e-4), far) == "the length of the domain: more than 72 Hertz radii would be needed");
  // No other limit is reported instead.
  Made both;
  both.mesh = 1.0;
  both.inlet = -0.1 * 216.0;
  Scene narrow = free_scene(1e-4);
  narrow.accuracy.most_cells = 64;
  BOOST_TEST(stopped(narrow, both).starts_with("the length of the domain"));
  Made fine;
  fine.mesh = 0.01;
  fine.inlet = -0.1 * 216.0;
  Scene scene = free_scene(0.01);
  scene.accuracy.most_cells = 256;
  BOOST_TEST(stopped(scene, fine) == "the largest allowed grid, 256 cells");
  Made memory;
  memory.mesh = 0.01;
  memory.inlet = -0.1 * 216.0;
  scene.accuracy.most_cells = 4096;
  scene.accuracy.most_nodes = 1e5;
  BOOST_TEST(stopped(scene, memory) == "the memory for 512 cells");
}

// The smaller domain, the larger one, or both have no solution.
BOOST_AUTO_TEST_CASE(a_domain_without_an_estimate) {
  for (const char* fails : {"small", "large", "both"}) {
    const SolveOnGrid solve = [&](const Scene& one) {
      const bool coarse = std::isnan(one.accuracy.error);
      const bool large = one.grid.X_a < -4.5;
      Made made;
      if (coarse && (fails == std::string("both") || large == (fails == std::string("large")))) made.diverges_from = 0;
      return made(one);
    };
    const Solution solution = solve_to_accuracy(free_scene(0.1), solve, {});
    BOOST_TEST(solution.accuracy.stopped_by == "the error of the domain, which could not be estimated");
    BOOST_TEST(!solution.accuracy.met);
    BOOST_TEST(!solution.converged);
    BOOST_TEST(std::isnan(solution.domain_error_Hc));
  }
}

// The doubled domain has the same cells whatever the inlet: otherwise a different mesh would count
// as an error of the domain.
BOOST_AUTO_TEST_CASE(the_mesh_does_not_count_as_domain) {
  for (const double X_a : {-4.5, -1.5 * 21.0 / 11.0}) {
    Made made;
    made.mesh = 1.0;
    Scene scene = free_scene(0.5);
    scene.grid = {128, 128, X_a, 1.5, -3.0, 3.0};
    const Solution solution = run(scene, made);
    BOOST_TEST_MESSAGE("X_a = " << X_a << ": error of the domain " << solution.domain_error_Hc << " (none)");
    BOOST_TEST(std::abs(solution.domain_error_Hc) < 1e-12);
    BOOST_TEST(made.asked[1].grid.hx() == made.asked[0].grid.hx(), tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_SUITE_END()
