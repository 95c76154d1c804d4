// The steady solver compared with fully converged solutions of an independent program.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "convergence/circular_scene.hpp"
#include "steady/solve.hpp"

BOOST_AUTO_TEST_SUITE(test_reference)

using namespace ehl;

namespace {

constexpr int largest_grid = 256;  // the rows with 512 and 1024 cells take minutes with sanitizers

double relative(double value, double reference) { return std::abs(value / reference - 1.0); }

/// 1e-6 relative, plus half a unit of the seventh decimal, the last one that the reference gives.
double allowed(double reference) { return 1e-6 + 0.5e-7 / std::abs(reference); }

/// The magnitude of a grid's discretization error. If it happens to be close to zero, a quarter of the
/// coarser grid's error is used.
double discretization_error(double value, double limit, double coarser) {
  return std::max(std::abs(value - limit), std::isnan(coarser) ? 0.0 : 0.25 * std::abs(coarser - limit));
}

/// The algebraic errors of a row divided by the discretization errors of its grid.
struct Shares {
  double Hc, Hm;
};
Shares shares(const steady::LevelRow& row, const reference::CircularContact& exact) {
  const reference::CircularLimit& limit = test::limit_of(exact);
  double coarser_Hc = std::nan("");
  double coarser_Hm = std::nan("");
  for (const reference::CircularContact& other : reference::circular_contacts)
    if (other.M == exact.M && other.L == exact.L && other.fluid == exact.fluid && other.wedge == exact.wedge &&
        2 * other.n == exact.n) {
      coarser_Hc = other.Hc;
      coarser_Hm = other.Hm;
    }
  return {std::abs(row.Hc - exact.Hc) / discretization_error(exact.Hc, limit.Hc, coarser_Hc),
          std::abs(row.Hm - exact.Hm) / discretization_error(exact.Hm, limit.Hm, coarser_Hm)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_film_gives_the_reference_digits) {
  for (const reference::CircularContact& contact : reference::circular_contacts) {
    if (contact.n > largest_grid) continue;
    steady::Scene scene = test::scene_of(contact);
    scene.deformation.method = mlmi::Method::fft;
    scene.solver.tolerance = 1e-10;
    const steady::Solution solution = steady::solve(scene);
    const steady::LevelRow& row = solution.levels.back();
    BOOST_TEST_MESSAGE(test::name_of(contact)
                       << ": Hc off by " << relative(row.Hc, contact.Hc) << ", Hm by " << relative(row.Hm, contact.Hm)
                       << ", H00 by " << relative(solution.H00, contact.H00)
                       << " (allowed 1e-6 and the rounding of the reference); residual " << row.residual << " in "
                       << row.cycles << " cycles");
    BOOST_TEST_CONTEXT(test::name_of(contact)) {
      BOOST_TEST(solution.converged);
      BOOST_TEST(row.residual <= 1e-10);
      BOOST_TEST(relative(row.Hc, contact.Hc) <= allowed(contact.Hc));
      BOOST_TEST(relative(row.Hm, contact.Hm) <= allowed(contact.Hm));
      BOOST_TEST(relative(solution.H00, contact.H00) <= allowed(contact.H00));
    }
  }
}

BOOST_AUTO_TEST_CASE(default_film_evaluation_is_below_a_tenth_of_the_discretization_error) {
  for (const reference::CircularContact& contact : reference::circular_contacts) {
    if (contact.n > largest_grid || contact.n < 128) continue;
    steady::Scene scene = test::scene_of(contact);
    scene.solver.tolerance = 1e-8;
    const steady::Solution solution = steady::solve(scene);
    const steady::LevelRow& row = solution.levels.back();
    const Shares share = shares(row, contact);
    BOOST_TEST_MESSAGE(test::name_of(contact) << ": " << share.Hc << " of the discretization error in Hc, " << share.Hm
                                              << " in Hm (allowed 0.1)");
    BOOST_TEST_CONTEXT(test::name_of(contact)) {
      BOOST_TEST(solution.converged);
      BOOST_TEST(share.Hc <= 0.1);
      BOOST_TEST(share.Hm <= 0.1);
    }
  }
}

// Full multigrid with its default number of cycles solves every level to the magnitude of its discretization error.
BOOST_AUTO_TEST_CASE(default_cycles_reach_the_discretization_error_on_every_level) {
  for (const reference::CircularContact& contact : reference::circular_contacts) {
    if (contact.n != largest_grid) continue;
    steady::Scene scene = test::scene_of(contact);
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST_CONTEXT(test::name_of(contact)) {
      BOOST_TEST(solution.converged);
      for (const steady::LevelRow& row : solution.levels)
        for (const reference::CircularContact& exact : reference::circular_contacts) {
          if (exact.M != contact.M || exact.L != contact.L || exact.fluid != contact.fluid ||
              exact.wedge != contact.wedge || exact.n != row.nx)
            continue;
          const Shares share = shares(row, exact);
          BOOST_TEST_MESSAGE(test::name_of(exact)
                             << ", " << row.cycles << " cycles, " << row.work_units << " work units: " << share.Hc
                             << " of the discretization error in Hc, " << share.Hm << " in Hm (allowed 0.1)");
          BOOST_TEST(share.Hc <= 0.1);
          BOOST_TEST(share.Hm <= 0.1);
        }
    }
  }
}

// The convergence factor on the fine grid, down to rounding: the paper's "almost one order of magnitude".
BOOST_AUTO_TEST_CASE(every_cycle_at_M50_L10_gains_a_factor_of_five) {
  for (const reference::Wedge wedge : {reference::Wedge::upstream1, reference::Wedge::upstream2}) {
    reference::CircularContact contact{50, 10, reference::Fluid::roelands_z060, wedge, 256, 0, 0, 0, 0};
    steady::Scene scene = test::scene_of(contact);
    scene.deformation.method = mlmi::Method::fft;
    scene.solver.tolerance = 1e-10;
    const steady::Solution solution = steady::solve(scene);
    const int finest = solution.levels.back().level;
    double first = 0.0;
    double last = 0.0;
    int cycles = 0;
    for (const steady::CycleRow& row : solution.history) {
      if (row.level != finest) continue;
      if (cycles == 0) first = row.residual;
      last = row.residual;
      ++cycles;
    }
    const double factor = std::pow(last / first, 1.0 / (cycles - 1));
    BOOST_TEST_MESSAGE(test::name_of(contact) << ": " << factor << " per W(2,1) cycle over " << cycles << " cycles to "
                                              << last << " (allowed 0.2)");
    BOOST_TEST(factor <= 0.2);
    BOOST_TEST(last <= 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(same_bits_with_one_and_two_threads) {
  reference::CircularContact contact{50, 10, reference::Fluid::roelands_z060, reference::Wedge::upstream2, 256, 0, 0,
                                     0,  0};
  steady::Scene scene = test::scene_of(contact);
  scene.threads = 1;
  const steady::Solution one = steady::solve(scene);
  scene.threads = 2;
  const steady::Solution two = steady::solve(scene);
  int different = 0;
  for (int i = 0; i <= scene.grid.nx; ++i)
    for (int j = 0; j <= scene.grid.ny; ++j)
      if (one.P(i, j) != two.P(i, j) || one.H(i, j) != two.H(i, j)) ++different;
  BOOST_TEST_MESSAGE(different << " of the nodes differ between 1 and 2 threads (allowed 0)");
  BOOST_TEST(different == 0);
  BOOST_TEST(one.H00 == two.H00);
}

BOOST_AUTO_TEST_SUITE_END()
