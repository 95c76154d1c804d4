// Relaxation across X on stretched cells: a system that one pass solves, and what it leaves alone.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/norms.hpp"
#include "fmg/across_relaxation.hpp"
#include "support/mirrored.hpp"
#include "unit/fmg/circular_contact.hpp"

using namespace ehl::tests;
namespace fmg = ehl::fmg;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using ehl::reynolds::Face;
using ehl::reynolds::Wedge;

namespace {

constexpr double stretch = 8.0;
const Grid domain{32, 64, -1, 1, -0.25, 0.25};

fmg::Hierarchy on(const Patch& patch, const fmg::Problem& problem, int threads = 1) {
  fmg::Parameters parameters;
  parameters.coarsest_cells = patch.nx;
  return fmg::make_hierarchy(problem, parameters, {.method = ehl::mlmi::Method::fft}, patch, threads);
}

/// Rigid bodies and a given epsilon: the equations are linear, and no node's film answers.
fmg::Problem linear(double epsilon) {
  fmg::Problem problem;
  problem.film.given_epsilon = [epsilon](double X, double Y) { return epsilon * std::exp(X + 3.0 * Y); };
  problem.geometry.elastic = 0.0;
  problem.cavitation = ehl::reynolds::Cavitation::none;
  problem.load.reset();
  return problem;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_station_is_solved_whole) {
  fmg::Hierarchy hierarchy = on(domain, linear(10.0));
  fmg::Level& level = hierarchy.finest();
  BOOST_TEST(level.grid.hx() == stretch * level.grid.hy());
  Random random(7);
  set_rough_state(hierarchy, level, random);
  ehl::core::fill_ghosts(level.grid, level.P);
  fmg::update_residual(hierarchy, level);
  const double before = ehl::core::max_abs(level.r);
  fmg::relax_across(hierarchy, level, hierarchy.parameters.relaxation);
  fmg::update_residual(hierarchy, level);
  // The even stations come last: their equations hold.
  double even = 0.0, odd = 0.0;
  for (int i = 1; i < domain.nx; ++i)
    for (int j = 1; j < domain.ny; ++j)
      (i % 2 == 0 ? even : odd) = std::max(i % 2 == 0 ? even : odd, std::abs(level.r(i, j)));
  BOOST_TEST_MESSAGE("residual " << before << " before, on even stations " << even << " (at most 1e-11 of it), on odd "
                                 << odd);
  BOOST_TEST(even < 1e-11 * before);
  BOOST_TEST(odd > 1e-3 * before);
}

BOOST_AUTO_TEST_CASE(nodes_that_distribute_their_change_stay) {
  fmg::Hierarchy hierarchy = on(domain, linear(1e-6));
  fmg::Level& level = hierarchy.finest();
  Random random(8);
  set_rough_state(hierarchy, level, random);
  ehl::core::fill_ghosts(level.grid, level.P);
  const Field before = level.P;
  fmg::relax_across(hierarchy, level, hierarchy.parameters.relaxation);
  BOOST_TEST(ehl::core::max_abs_difference(level.P, before) == 0.0);
}

BOOST_AUTO_TEST_CASE(half_of_a_symmetric_contact_and_threads) {
  for (const Face face : {Face::mean, Face::logmean_bounded}) {
    const fmg::Problem problem =
        circular_contact(20, 10, face == Face::mean ? Wedge::upstream2 : Wedge::upstream3, face);
    const Grid grid{128, 256, -4.5, 1.5, -0.75, 0.75};
    fmg::Hierarchy whole = on(grid, problem), half = on(ehl::core::lower_half(grid), problem),
                   shared = on(grid, problem, 2);
    Random random(9);
    fmg::Level& all = whole.finest();
    set_rough_state(whole, all, random);
    const auto mirror = [&](Field& field) {
      for (int i = 0; i <= grid.nx; ++i)
        for (int j = 0; 2 * j < grid.ny; ++j) field(i, grid.ny - j) = field(i, j);
    };
    for (Field* field : {&all.P, &all.F, &all.f}) mirror(*field);
    for (fmg::Hierarchy* other : {&half, &shared}) {
      fmg::Level& level = other->finest();
      const auto of = [&](const Field& field) { return other == &half ? half_of(grid, field) : field; };
      level.P = of(all.P), level.F = of(all.F), level.f = of(all.f);
      other->H00 = whole.H00;
    }
    for (fmg::Hierarchy* hierarchy : {&whole, &half, &shared}) {
      fmg::Level& level = hierarchy->finest();
      ehl::core::fill_ghosts(level.grid, level.P);
      fmg::update_film(*hierarchy, level);
      fmg::relax_across(*hierarchy, level, hierarchy->parameters.relaxation);
    }
    const double difference = difference_of_half(grid, all.P, half.finest().P);
    BOOST_TEST_MESSAGE("difference of the half " << difference << " (at most 1e-11)");
    BOOST_TEST(difference < 1e-11);
    BOOST_TEST(ehl::core::max_abs_difference(all.P, shared.finest().P) == 0.0);
  }
}
