// The discrete equation on the lower half of a symmetric domain, compared with the whole domain.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "reynolds/flow_balance.hpp"
#include "support/mirrored.hpp"
#include "unit/reynolds/fields.hpp"

BOOST_AUTO_TEST_SUITE(test_reynolds_mirrored)

using namespace ehl::tests;
namespace reynolds = ehl::reynolds;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using reynolds::Wedge;

namespace {

/// A random state on the whole domain, and the same state on its lower half.
struct BothStates {
  explicit BothStates(const Grid& grid, Random& random)
      : whole(random_fields(grid, random)), half(zero_fields(ehl::core::lower_half(grid))) {
    Field Fields::*members[] = {&Fields::P, &Fields::H, &Fields::rho_bar, &Fields::eps, &Fields::f};
    for (const auto member : members) {
      Field& all = whole.*member;
      for (int i = 0; i <= grid.nx; ++i)
        for (int j = 0; 2 * j < grid.ny; ++j) all(i, grid.ny - j) = all(i, j);
      half.*member = half_of(grid, all);
    }
  }
  Fields whole, half;
};

constexpr double rounding = 1e-13;
const Grid grids[] = {{24, 18, -4.5, 1.5, -3, 3}, {20, 32, -2, 2, -1.7, 1.7}};

}  // namespace

BOOST_AUTO_TEST_CASE(residual_of_the_half) {
  Random random(3);
  for (const Grid& grid : grids)
    for (const Wedge wedge : {Wedge::upstream1, Wedge::upstream2}) {
      const BothStates both(grid, random);
      const ehl::core::Patch half = ehl::core::lower_half(grid);
      Field r(grid);
      Field r_half(half);
      reynolds::residual(grid, both.whole.state(), wedge, 1, r);
      reynolds::residual(half, both.half.state(), wedge, 1, r_half);
      const double error = difference_of_half(grid, r, r_half) / ehl::core::max_abs(r);
      BOOST_TEST_MESSAGE("residual: difference " << error << " (tolerance " << rounding << ")");
      BOOST_TEST(error < rounding);
      for (int i = 0; i <= grid.nx; ++i)
        for (int k = 1; k <= 2; ++k) BOOST_TEST(r_half(i, half.ny + k) == r_half(i, half.ny - k));
      for (const reynolds::Cavitation cavitation :
           {reynolds::Cavitation::nonnegative_pressure, reynolds::Cavitation::none}) {
        const auto all = reynolds::residual_norms(grid, both.whole.state(), wedge, cavitation, r);
        const auto one = reynolds::residual_norms(half, both.half.state(), wedge, cavitation, r_half);
        BOOST_TEST(std::abs(one.root_mean_square / all.root_mean_square - 1.0) < rounding);
        BOOST_TEST(std::abs(one.wedge / all.wedge - 1.0) < rounding);
        BOOST_TEST(std::abs(one.largest / all.largest - 1.0) < rounding);
        BOOST_TEST((one.i == all.i && one.j == all.j));
        BOOST_TEST(std::abs(one.largest_dry - all.largest_dry) <= rounding * all.largest);
        BOOST_TEST(one.least_P == all.least_P);
      }
    }
}

BOOST_AUTO_TEST_CASE(flow_balance_of_the_half) {
  Random random(4);
  for (const Grid& grid : grids)
    for (const reynolds::Cavitation cavitation :
         {reynolds::Cavitation::nonnegative_pressure, reynolds::Cavitation::none})
      for (const double reach : {std::numeric_limits<double>::infinity(), 1.5, 0.8}) {
        const BothStates both(grid, random);
        const auto all = reynolds::flow_balance(grid, both.whole.state(), Wedge::upstream2, cavitation, reach);
        const auto one =
            reynolds::flow_balance(ehl::core::lower_half(grid), both.half.state(), Wedge::upstream2, cavitation, reach);
        const double error = std::max({std::abs(one.in / all.in - 1.0), std::abs(one.out / all.out - 1.0),
                                       std::abs(one.through / all.through - 1.0)});
        BOOST_TEST_MESSAGE("flow balance: difference " << error << " (tolerance 1e-12)");
        BOOST_TEST(error < 1e-12);
      }
}

BOOST_AUTO_TEST_SUITE_END()
