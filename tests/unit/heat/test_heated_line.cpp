// A line contact with heat, with pressure and temperature coupled: without heat nothing changes; order of convergence.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "effects/heat/solve.hpp"
#include "steady/solve.hpp"
#include "unit/heat/heated_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_heat_heated_line)

using namespace ehl;
using support::along, support::BaseCase, support::Found, support::solve, support::teeth;

// Without any heat source, or if bodies and oil conduct all heat away, the film is isothermal to rounding.
BOOST_AUTO_TEST_CASE(no_heat_is_the_isothermal_line) {
  BaseCase base = teeth();
  base.expansion = 0.0;
  for (const bool conducts_well : {false, true}) {
    thermal::Setup setup = base.setup(along(256));
    if (conducts_well) {
      for (double* group : {&setup.Br, &setup.Pe, &setup.compression}) *group *= 1e-12;
      setup.body_1.resistance = setup.body_2.resistance = 0.0;
    } else {
      setup.Br = setup.compression = 0.0;
    }
    steady::Scene scene = support::scene_of(base, setup, along(256));
    scene.solver.tolerance = 1e-10;
    scene.adjoint_errors = false;
    const steady::Solution cold = steady::solve(scene);
    BOOST_TEST(cold.converged, cold.failed_check);
    const heat::Solution warm = heat::solve(scene, setup, {}, cold, {});
    BOOST_TEST(warm.film.converged, warm.film.failed_check);
    double off = 0.0;
    for (int i = 0; i <= scene.grid.nx; ++i) off = std::max(off, std::abs(warm.film.H(i, 1) / cold.H(i, 1) - 1));
    BOOST_TEST_MESSAGE("film " << off << " off (tolerance 1e-8)");
    BOOST_TEST(off < 1e-8);
    BOOST_TEST(std::abs(warm.C - 1) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(second_order_along_a_line) {
  constexpr int grids = 4;
  Found found[grids];
  for (int level = 0; level < grids; ++level) {
    found[level] = solve(
        teeth(), along(128 << level), [](thermal::Setup&) {}, 0.005);
    BOOST_TEST(found[level].result.unmet.empty(), found[level].result.unmet);
  }
  for (int level = 2; level < grids; ++level) {
    const auto order = [&](double Found::*value) {
      return std::log2(std::abs((found[level - 1].*value - found[level - 2].*value) /
                                (found[level].*value - found[level - 1].*value)));
    };
    BOOST_TEST_MESSAGE((128 << level) << " cells: mu " << found[level].mu << ", order " << order(&Found::mu)
                                      << "; Hc order " << order(&Found::Hc) << "; film " << found[level].film
                                      << " K, order " << order(&Found::film) << "; surface 2 " << found[level].surface_2
                                      << " K, order " << order(&Found::surface_2) << "; "
                                      << found[level].result.passes.size() << " passes");
    BOOST_TEST(order(&Found::mu) > 1.4);
    BOOST_TEST(order(&Found::Hc) > 1.6);
    BOOST_TEST(order(&Found::film) > 1.4);
    // The hottest point of a surface lies between nodes.
    for (double Found::*surface : {&Found::surface_1, &Found::surface_2})
      BOOST_TEST(std::abs(found[level].*surface / found[level - 1].*surface - 1) < 5e-3);
  }
}

BOOST_AUTO_TEST_SUITE_END()
