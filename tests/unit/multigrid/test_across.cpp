// The Y sweep on stretched cells: linear systems are solved by one pass, and inactive nodes stay unchanged.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/norms.hpp"
#include "multigrid/across_relaxation.hpp"
#include "support/mirrored.hpp"
#include "unit/multigrid/circular_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_multigrid_across)

using namespace ehl::tests;
namespace multigrid = ehl::multigrid;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using ehl::reynolds::Face;
using ehl::reynolds::Wedge;

namespace {

constexpr double stretch = 8.0;
const Grid domain{32, 64, -1, 1, -0.25, 0.25};

multigrid::Hierarchy on(const Patch& patch, const multigrid::Problem& problem, int threads = 1) {
  multigrid::Parameters parameters;
  parameters.coarsest_cells = patch.nx;
  return multigrid::make_hierarchy(problem, parameters, {.method = ehl::mlmi::Method::fft}, patch, threads);
}

/// Rigid bodies and a given epsilon: the equations are linear, and the film does not depend on the pressure.
multigrid::Problem linear(double epsilon) {
  multigrid::Problem problem;
  problem.film.given_epsilon = [epsilon](double X, double Y) { return epsilon * std::exp(X + 3.0 * Y); };
  problem.geometry.kernel.factor = 0.0;
  problem.cavitation = ehl::reynolds::Cavitation::none;
  problem.load.reset();
  return problem;
}

}  // namespace

/// The damping of a node's change: none with epsilon at the nodes if it varies little, and less than 1
/// with epsilon at half points.
constexpr double at_nodes = 1.0, at_half_points = 0.7;

/// The even columns are relaxed last. The result is the largest difference between the remaining residual and (1
/// - weight) times the residual before, relative to the largest residual. Nodes with unchanged P distribute
/// their change and are excluded.
double left_but_for_the_weight(multigrid::Hierarchy& hierarchy, double weight) {
  multigrid::Level& level = hierarchy.finest();
  const Field before = level.P;
  multigrid::relax_across(hierarchy, level, hierarchy.parameters.relaxation);
  const Field after = level.P;
  const auto residual = [&] {
    ehl::core::fill_ghosts(level.grid, level.P);
    multigrid::update_film(hierarchy, level);
    multigrid::update_residual(hierarchy, level);
    return level.r;
  };
  for (int i = 0; i <= domain.nx; i += 2)
    for (int j = 0; j <= domain.ny; ++j) level.P(i, j) = before(i, j);
  const Field met = residual();
  level.P = after;
  const Field left = residual();
  double worst = 0.0, largest = 0.0;
  for (int i = 2; i < domain.nx; i += 2)
    for (int j = 1; j < domain.ny; ++j) {
      largest = std::max(largest, std::abs(met(i, j)));
      if (after(i, j) != before(i, j)) worst = std::max(worst, std::abs(left(i, j) - (1.0 - weight) * met(i, j)));
    }
  return worst / largest;
}

BOOST_AUTO_TEST_CASE(a_station_is_solved_whole) {
  multigrid::Hierarchy hierarchy = on(domain, linear(10.0));
  multigrid::Level& level = hierarchy.finest();
  BOOST_TEST(level.grid.hx() == stretch * level.grid.hy());
  Random random(7);
  set_rough_state(hierarchy, level, random);
  ehl::core::fill_ghosts(level.grid, level.P);
  const double worst = left_but_for_the_weight(hierarchy, at_nodes);
  BOOST_TEST_MESSAGE("left but for the weight: " << worst << " of the residual (at most 1e-11)");
  BOOST_TEST(worst < 1e-11);
}

// The viscosity of a Barus oil, and thus epsilon, depends on the pressures: the rows are the derivatives of the
// equations. At half points, epsilon varies from node to node by large factors, below and above the bound of the
// logarithmic mean, but no change reaches the step limit; at the nodes it varies by less than 2. The odd columns have
// no residual, so they do not change epsilon before the even ones.
BOOST_AUTO_TEST_CASE(epsilon_follows_the_pressures_of_a_station) {
  for (const Face face : {Face::mean, Face::logmean_bounded}) {
    multigrid::Problem problem = circular_contact(200, 10, Wedge::upstream2, face);
    problem.film.viscosity = ehl::rheology::Barus{12.0};
    problem.film.density = ehl::rheology::Incompressible{};
    problem.film.lambda *= 1e-9;
    problem.geometry.kernel.factor = 0.0;
    problem.cavitation = ehl::reynolds::Cavitation::none;
    problem.load.reset();
    multigrid::Hierarchy hierarchy = on(domain, problem);
    multigrid::Level& level = hierarchy.finest();
    Random random(11);
    const double rough = face == Face::mean ? 0.01 : 0.3;
    for (int i = 0; i <= domain.nx; ++i)
      for (int j = 0; j <= domain.ny; ++j) level.P(i, j) = 0.6 + random.between(-rough, rough);
    ehl::core::fill_ghosts(level.grid, level.P);
    hierarchy.H00 = 1.0;
    level.f = Field(level.grid);
    multigrid::update_film(hierarchy, level);
    multigrid::update_residual(hierarchy, level);
    for (int i = 1; i < domain.nx; ++i)
      for (int j = 1; j < domain.ny; ++j)
        level.f(i, j) = -level.r(i, j) * (1.0 + (i % 2 == 0 ? random.between(-1e-9, 1e-9) : 0.0));
    const double worst = left_but_for_the_weight(hierarchy, face == Face::mean ? at_nodes : at_half_points);
    BOOST_TEST_MESSAGE("left but for the weight: " << worst << " of the residual (at most 1e-4)");
    BOOST_TEST(worst < 1e-4);
  }
}

// A straight edge at an angle on square cells: the pressure rises within one cell, and outside the film opens by a
// factor of three within one cell. A residual that is equal at all nodes of the edge must be reduced, including the
// effect of their common film, without overshoot.
BOOST_AUTO_TEST_CASE(the_edge_of_a_contact_is_not_overshot) {
  const Grid square{64, 64, -1, 1, -1, 1};
  multigrid::Problem problem = circular_contact(1000, 15, Wedge::upstream2);
  problem.film.lambda *= 0.01;
  multigrid::Hierarchy hierarchy = on(square, problem);
  multigrid::Level& level = hierarchy.finest();
  const auto inside = [&](int i, int j) { return -(square.X(i) + square.Y(j)) / std::sqrt(2.0); };
  level.F = Field(level.grid);
  level.f = Field(level.grid);
  hierarchy.H00 = 0.0;
  for (int i = 1; i < square.nx; ++i)
    for (int j = 1; j < square.ny; ++j) level.P(i, j) = inside(i, j) > 1e-9 ? 0.25 + 0.7 * inside(i, j) : 0.0;
  ehl::core::fill_ghosts(level.grid, level.P);
  multigrid::update_film(hierarchy, level);
  ehl::core::set_nodes(level.grid, level.F, [&](int i, int j) {
    return 3e-3 + std::max(0.0, -0.3 * (inside(i, j) - square.hx() / std::sqrt(2.0))) - level.H(i, j);
  });
  multigrid::update_film(hierarchy, level);
  multigrid::update_residual(hierarchy, level);
  const double asked = 1e-3;
  for (int i = 1; i < square.nx; ++i)
    for (int j = 1; j < square.ny; ++j) level.f(i, j) = -level.r(i, j);
  const int edge = square.nx - 1;  // i + j of the last nodes with pressure
  for (int i = 8; i <= edge - 8; ++i) level.f(i, edge - i) += asked;
  multigrid::relax_across(hierarchy, level, hierarchy.parameters.relaxation);
  ehl::core::fill_ghosts(level.grid, level.P);
  multigrid::update_film(hierarchy, level);
  multigrid::update_residual(hierarchy, level);
  double least = 1.0, most = -1.0;
  for (int i = 16; i <= edge - 16; ++i) {
    least = std::min(least, level.r(i, edge - i) / asked);
    most = std::max(most, level.r(i, edge - i) / asked);
  }
  BOOST_TEST_MESSAGE("left of a residual along the edge: " << least << " to " << most << " (-0.2 to 0.8)");
  BOOST_TEST(least > -0.2);
  BOOST_TEST(most < 0.8);
}

BOOST_AUTO_TEST_CASE(nodes_that_distribute_their_change_stay) {
  multigrid::Hierarchy hierarchy = on(domain, linear(1e-6));
  multigrid::Level& level = hierarchy.finest();
  Random random(8);
  set_rough_state(hierarchy, level, random);
  ehl::core::fill_ghosts(level.grid, level.P);
  const Field before = level.P;
  multigrid::relax_across(hierarchy, level, hierarchy.parameters.relaxation);
  BOOST_TEST(ehl::core::max_abs_difference(level.P, before) == 0.0);
}

BOOST_AUTO_TEST_CASE(a_pressure_changes_by_no_more_than_allowed) {
  multigrid::Hierarchy hierarchy = on(domain, linear(10.0));
  multigrid::Level& level = hierarchy.finest();
  Random random(7);
  set_rough_state(hierarchy, level, random);
  ehl::core::fill_ghosts(level.grid, level.P);
  const Field before = level.P;
  multigrid::RelaxationParameters how = hierarchy.parameters.relaxation;
  how.most_change = 1e-3;
  multigrid::relax_across(hierarchy, level, how);
  const double most = ehl::core::max_abs_difference(level.P, before);
  BOOST_TEST_MESSAGE("largest change " << most << " (at most " << how.most_change << ")");
  BOOST_TEST(std::abs(most / how.most_change - 1.0) < 1e-12);
}

BOOST_AUTO_TEST_CASE(half_of_a_symmetric_contact_and_threads) {
  for (const Face face : {Face::mean, Face::logmean_bounded}) {
    const multigrid::Problem problem =
        circular_contact(20, 10, face == Face::mean ? Wedge::upstream2 : Wedge::upstream3, face);
    const Grid grid{128, 256, -4.5, 1.5, -0.75, 0.75};
    multigrid::Hierarchy whole = on(grid, problem), half = on(ehl::core::lower_half(grid), problem),
                         shared = on(grid, problem, 2);
    Random random(9);
    multigrid::Level& all = whole.finest();
    set_rough_state(whole, all, random);
    const auto mirror = [&](Field& field) {
      for (int i = 0; i <= grid.nx; ++i)
        for (int j = 0; 2 * j < grid.ny; ++j) field(i, grid.ny - j) = field(i, j);
    };
    for (Field* field : {&all.P, &all.F, &all.f}) mirror(*field);
    for (multigrid::Hierarchy* other : {&half, &shared}) {
      multigrid::Level& level = other->finest();
      const auto of = [&](const Field& field) { return other == &half ? half_of(grid, field) : field; };
      level.P = of(all.P), level.F = of(all.F), level.f = of(all.f);
      other->H00 = whole.H00;
    }
    for (multigrid::Hierarchy* hierarchy : {&whole, &half, &shared}) {
      multigrid::Level& level = hierarchy->finest();
      ehl::core::fill_ghosts(level.grid, level.P);
      multigrid::update_film(*hierarchy, level);
      multigrid::relax_across(*hierarchy, level, hierarchy->parameters.relaxation);
    }
    const double difference = difference_of_half(grid, all.P, half.finest().P);
    BOOST_TEST_MESSAGE("difference of the half " << difference << " (at most 1e-11)");
    BOOST_TEST(difference < 1e-11);
    BOOST_TEST(ehl::core::max_abs_difference(all.P, shared.finest().P) == 0.0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
