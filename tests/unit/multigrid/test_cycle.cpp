// A converged solution does not change, and the number of threads changes no bit.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/norms.hpp"
#include "multigrid/cycle.hpp"
#include "multigrid/relaxation.hpp"
#include "unit/multigrid/circular_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_multigrid_cycle)

using namespace ehl::tests;
namespace multigrid = ehl::multigrid;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::reynolds::Wedge;

namespace {

double relative_residual(multigrid::Hierarchy& hierarchy, multigrid::Level& level) {
  multigrid::update_residual(hierarchy, level);
  return ehl::reynolds::residual_norms(level.grid, multigrid::fields(level), hierarchy.problem.transport,
                                       hierarchy.problem.cavitation, level.r)
      .relative();
}

// The changes that a residual of 1e-12 may cause; the pressure per residual is below 1e3.
constexpr double still = 1e-9;

void stays(const char* what, const multigrid::Hierarchy& hierarchy, const Field& P, const Field& H, double H00) {
  const multigrid::Level& level = hierarchy.levels.back();
  const double dP = ehl::core::max_abs_difference(P, level.P);
  const double dH = ehl::core::max_abs_difference(H, level.H);
  const double dH00 = std::abs(hierarchy.H00 - H00);
  BOOST_TEST_MESSAGE("  " << what << " changes P by " << dP << ", H by " << dH << ", H00 by " << dH00 << " (tolerance "
                          << still << ")");
  BOOST_TEST(dP < still);
  BOOST_TEST(dH < still);
  BOOST_TEST(dH00 < still);
}

bool same_bits(const Field& a, const Field& b) {
  for (int i = 0; i < a.nodes_x(); ++i)
    if (!std::ranges::equal(a.station(i), b.station(i))) return false;
  return true;
}

void same_state(const multigrid::Level& a, const multigrid::Level& b) {
  BOOST_TEST(same_bits(a.P, b.P));
  BOOST_TEST(same_bits(a.H, b.H));
  BOOST_TEST(same_bits(a.eps, b.eps));
  BOOST_TEST(same_bits(a.rho_bar, b.rho_bar));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_solution_is_a_fixed_point_of_relaxation_and_cycles) {
  for (const Wedge wedge : {Wedge::upstream1, Wedge::upstream2}) {
    multigrid::Hierarchy hierarchy = multigrid::make_hierarchy(
        circular_contact(50, 10, wedge), {}, {.method = ehl::mlmi::Method::fft}, Grid{64, 64, -4.5, 1.5, -3, 3}, 1);
    const std::size_t finest = hierarchy.levels.size() - 1;
    BOOST_REQUIRE(finest > 0);
    multigrid::Level& level = hierarchy.finest();
    multigrid::start_from_hertz(hierarchy, finest, -0.65, 20);
    int cycles = 0;
    double residual = 1.0;
    for (; cycles < 60 && !(residual < 1e-12); ++cycles) {
      multigrid::fas_cycle(hierarchy, finest);
      residual = relative_residual(hierarchy, level);
    }
    for (int extra = 0; extra < 10; ++extra) multigrid::fas_cycle(hierarchy, finest);  // also for the load
    const double load = std::abs(multigrid::carried_load(level) / level.load - 1.0);
    BOOST_TEST_MESSAGE((wedge == Wedge::upstream1 ? "upstream1: " : "upstream2: ")
                       << cycles << " W cycles, relative residual " << residual << ", load error " << load);
    BOOST_TEST(residual < 1e-11);
    BOOST_TEST(load < 1e-10);

    const Field P = level.P;
    const Field H = level.H;
    const double H00 = hierarchy.H00;
    const auto back_to_the_solution = [&] {
      level.P = P;
      hierarchy.H00 = H00;
      multigrid::update_film(hierarchy, level);
    };
    multigrid::relax(hierarchy, level);
    stays("a relaxation", hierarchy, P, H, H00);
    for (const multigrid::Cycle cycle : {multigrid::Cycle::V, multigrid::Cycle::W, multigrid::Cycle::F}) {
      back_to_the_solution();
      multigrid::Parameters how = hierarchy.parameters;
      how.cycle = cycle;
      multigrid::fas_cycle(hierarchy, finest, how);
      stays(cycle == multigrid::Cycle::V   ? "a V cycle"
            : cycle == multigrid::Cycle::W ? "a W cycle"
                                           : "an F cycle",
            hierarchy, P, H, H00);
    }
    // The parameters of the relaxation change the iteration but not the solution.
    back_to_the_solution();
    multigrid::RelaxationParameters single;
    single.crossover = 1e-3;
    multigrid::relax(hierarchy, level, single);
    stays("a relaxation of single lines nearly everywhere", hierarchy, P, H, H00);
  }
}

BOOST_AUTO_TEST_CASE(two_threads_give_the_bits_of_one) {
  const Grid grid{256, 256, -4.5, 1.5, -3, 3};
  // From 64 cells upward as in a run: the start of each level, cycles, and then one relaxation.
  const auto hierarchy_for = [&](int threads) {
    multigrid::Hierarchy hierarchy =
        multigrid::make_hierarchy(circular_contact(50, 10, Wedge::upstream2), {}, {}, grid, threads);
    const std::size_t finest = hierarchy.levels.size() - 1;
    multigrid::start_from_hertz(hierarchy, finest - 2, -0.69, 20);
    for (std::size_t l = finest - 2; l <= finest; ++l) {
      if (l > finest - 2) multigrid::start_from_coarser(hierarchy, l);
      multigrid::fas_cycle(hierarchy, l);
      multigrid::fas_cycle(hierarchy, l);
    }
    return hierarchy;
  };
  multigrid::Hierarchy one = hierarchy_for(1);
  multigrid::Hierarchy two = hierarchy_for(2);
  BOOST_REQUIRE(two.threads_on(grid) == 2);
  same_state(one.finest(), two.finest());
  multigrid::relax(one, one.finest());
  multigrid::relax(two, two.finest());
  same_state(one.finest(), two.finest());
  multigrid::fas_cycle(one, one.levels.size() - 1);
  multigrid::fas_cycle(two, two.levels.size() - 1);
  for (std::size_t l = 0; l < one.levels.size(); ++l) same_state(one.levels[l], two.levels[l]);
  BOOST_TEST(one.H00 == two.H00);
  BOOST_TEST(std::isfinite(ehl::core::max_abs(one.finest().P)));
}

BOOST_AUTO_TEST_SUITE_END()
