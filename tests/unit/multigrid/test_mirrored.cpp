// Relaxation, cycle and starts on the lower half of a symmetric domain, compared with the whole domain.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <utility>

#include "multigrid/cycle.hpp"
#include "multigrid/relaxation.hpp"
#include "support/mirrored.hpp"
#include "unit/multigrid/circular_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_multigrid_mirrored)

using namespace ehl::tests;
namespace multigrid = ehl::multigrid;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using ehl::reynolds::Face;
using ehl::reynolds::Wedge;

namespace {

void make_symmetric(const Patch& grid, Field& field) {
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; 2 * j < grid.ny; ++j) field(i, grid.ny - j) = field(i, j);
}

/// Sets the same rough symmetric state on the finest level of both.
void set_both(multigrid::Hierarchy& whole, multigrid::Hierarchy& half, std::uint64_t seed) {
  Random random(seed);
  multigrid::Level& all = whole.finest();
  multigrid::Level& one = half.finest();
  set_rough_state(whole, all, random);
  make_symmetric(all.grid, all.P);
  make_symmetric(all.grid, all.F);
  make_symmetric(all.grid, all.f);
  one.P = half_of(all.grid.domain, all.P);
  one.F = half_of(all.grid.domain, all.F);
  one.f = half_of(all.grid.domain, all.f);
  half.H00 = whole.H00;
  multigrid::update_film(whole, all);
  multigrid::update_film(half, one);
}

/// upstream3 uses epsilon at half points.
multigrid::Hierarchy hierarchy_on(const Patch& grid, const multigrid::Parameters& parameters, Wedge wedge,
                                  int threads = 1) {
  const Face face = wedge == Wedge::upstream3 ? Face::logmean_bounded : Face::mean;
  return multigrid::make_hierarchy(circular_contact(20, 10, wedge, face), parameters,
                                   {.method = ehl::mlmi::Method::fft}, grid, threads);
}

double difference_of_P(const multigrid::Hierarchy& whole, const multigrid::Hierarchy& half) {
  const multigrid::Level& all = whole.levels.back();
  return difference_of_half(all.grid.domain, all.P, half.levels.back().P);
}

constexpr double tolerance = 1e-11;

/// Compares P and the residual, which depends on the image lines.
void compare_levels(const char* when, multigrid::Hierarchy& whole, multigrid::Hierarchy& half, std::size_t l) {
  multigrid::Level& all = whole.levels[l];
  multigrid::Level& one = half.levels[l];
  multigrid::update_residual(whole, all);
  multigrid::update_residual(half, one);
  const double P = difference_of_half(all.grid.domain, all.P, one.P);
  const double r = difference_of_half(all.grid.domain, all.r, one.r) / ehl::core::max_abs(all.r);
  BOOST_TEST_MESSAGE(when << ": difference of P " << P << ", of the residual " << r << " (tolerance " << tolerance
                          << " and 1e-9)");
  BOOST_TEST(P < tolerance);
  BOOST_TEST(r < 1e-9);
}

}  // namespace

// The axis is in either colour, and in every lane of a batch from the first to the last.
BOOST_AUTO_TEST_CASE(a_sweep_of_the_half_is_the_sweep_of_the_whole) {
  double worst = 0.0;
  for (int ny = 8; ny <= 76; ny += 2)
    for (const Wedge wedge : {Wedge::upstream1, Wedge::upstream2, Wedge::upstream3}) {
      const Grid grid{20, ny, -3.5, 1.5, -2.5, 2.5};
      multigrid::Parameters parameters;
      parameters.coarsest_cells = grid.nx;
      multigrid::Hierarchy whole = hierarchy_on(grid, parameters, wedge);
      multigrid::Hierarchy half = hierarchy_on(ehl::core::lower_half(grid), parameters, wedge);
      set_both(whole, half, static_cast<std::uint64_t>(ny));
      const Field before = whole.finest().P;
      for (int sweep = 0; sweep < 2; ++sweep) {
        multigrid::relax(whole, whole.finest());
        multigrid::relax(half, half.finest());
      }
      BOOST_TEST(ehl::core::max_abs_difference(before, whole.finest().P) > 1e-3);
      const double difference = difference_of_P(whole, half);
      worst = difference <= worst ? worst : difference;
    }
  BOOST_TEST_MESSAGE("sweeps: largest difference " << worst << " (tolerance " << tolerance << ")");
  BOOST_TEST(worst < tolerance);
}

BOOST_AUTO_TEST_CASE(a_cycle_of_the_half_is_the_cycle_of_the_whole) {
  for (const auto& [cycle, wedge] :
       {std::pair(multigrid::Cycle::V, Wedge::upstream2), std::pair(multigrid::Cycle::W, Wedge::upstream2),
        std::pair(multigrid::Cycle::W, Wedge::upstream3)}) {
    const Grid grid{64, 48, -4.5, 1.5, -2.5, 2.5};
    multigrid::Parameters parameters;
    parameters.cycle = cycle;
    parameters.coarsest_cells = 16;
    multigrid::Hierarchy whole = hierarchy_on(grid, parameters, wedge);
    multigrid::Hierarchy half = hierarchy_on(ehl::core::lower_half(grid), parameters, wedge);
    multigrid::State kept[2];
    const auto both = [&](const char* when, std::size_t l, auto&& action) {
      action(whole, kept[0]);
      action(half, kept[1]);
      compare_levels(when, whole, half, l);
    };
    both("Hertz", 0, [](multigrid::Hierarchy& one, multigrid::State& keep) {
      multigrid::start_from_hertz(one, 0, -0.6, 20);
      multigrid::fas_cycle(one, 0);
      keep = {one.levels[0].P, one.H00};
    });
    both("from coarser", 1,
         [](multigrid::Hierarchy& one, multigrid::State&) { multigrid::start_from_coarser(one, 1); });
    both("cycle", 1, [](multigrid::Hierarchy& one, multigrid::State&) { multigrid::fas_cycle(one, 1); });
    both("from two coarser", 2, [](multigrid::Hierarchy& one, multigrid::State& keep) {
      multigrid::start_from_two_coarser(one, 2, keep, 2.0);
    });
    both("cycle", 2, [](multigrid::Hierarchy& one, multigrid::State&) { multigrid::fas_cycle(one, 2); });
    both("cycle that ends with the correction", 2, [](multigrid::Hierarchy& one, multigrid::State&) {
      multigrid::Parameters how = one.parameters;
      how.post = 0;
      multigrid::fas_cycle(one, 2, how);
    });
    const double shift = std::abs(whole.H00 - half.H00);
    BOOST_TEST_MESSAGE("H00: difference " << shift << " (tolerance " << tolerance << ")");
    BOOST_TEST(shift < tolerance);
    BOOST_TEST(std::abs(multigrid::carried_load(half.finest()) - multigrid::carried_load(whole.finest())) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(two_threads_give_the_same_bits_on_the_half) {
  const ehl::core::Patch half = ehl::core::lower_half(Grid{256, 256, -4.5, 1.5, -3, 3});
  multigrid::Parameters parameters;
  for (const Wedge wedge : {Wedge::upstream2, Wedge::upstream3}) {
    multigrid::Hierarchy one = hierarchy_on(half, parameters, wedge, 1);
    multigrid::Hierarchy two = hierarchy_on(half, parameters, wedge, 2);
    for (multigrid::Hierarchy* hierarchy : {&one, &two}) {
      multigrid::start_from_hertz(*hierarchy, 3, -0.6, 2);
      multigrid::fas_cycle(*hierarchy, 3);
    }
    BOOST_TEST(ehl::core::max_abs_difference(one.finest().P, two.finest().P) == 0.0);
    BOOST_TEST(ehl::core::max_abs_difference(one.finest().H, two.finest().H) == 0.0);
    BOOST_TEST(one.H00 == two.H00);
  }
}

BOOST_AUTO_TEST_SUITE_END()
