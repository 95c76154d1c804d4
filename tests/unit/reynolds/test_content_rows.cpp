// Rows and oil balance of the mass-conserving cavitation model, for rough random fields.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "reynolds/content.hpp"
#include "reynolds/flow_balance.hpp"
#include "unit/reynolds/fields.hpp"

BOOST_AUTO_TEST_SUITE(test_reynolds_content)

using namespace ehl;
using namespace ehl::tests;
using reynolds::Wedge;

namespace {

constexpr double flooded = std::numeric_limits<double>::infinity();

}  // namespace

// If all points are full, the rows are those of the equation with rho_bar H, and no oil is lost for any P.
BOOST_AUTO_TEST_CASE(full_points_have_the_rows_of_the_other_model_and_oil_is_conserved) {
  Random random(11);
  for (const core::Edge north : {core::Edge::zero, core::Edge::mirror}) {
    core::Patch grid = core::Grid{24, 26, -2.0, 1.0, -1.5, 1.5};
    if (north == core::Edge::mirror) grid = core::lower_half(grid.domain);
    for (const Wedge wedge : {Wedge::upstream1, Wedge::upstream2, Wedge::upstream3}) {
      Fields fields = random_fields(grid, random);
      core::Field Q(grid), r(grid), plain(grid), two(grid);
      const std::vector<double> supply(static_cast<std::size_t>(grid.nodes_y()), 0.7);
      const std::vector<double> much(static_cast<std::size_t>(grid.nodes_y()), flooded);
      Fields wet = fields;
      for (int i = 0; i <= grid.nx; ++i)
        for (int j = 0; j <= grid.ny; ++j) wet.P(i, j) = std::abs(fields.P(i, j)) + 1e-3;
      for (core::Field* field : {&wet.P, &wet.eps, &fields.P, &fields.eps}) core::fill_ghosts(grid, *field);
      reynolds::residual(grid, wet.state(), {Q, much}, wedge, 1, r);
      reynolds::residual(grid, wet.state(), wedge, 1, plain);
      double worst = 0.0;
      for (int i = 0; i <= grid.nx; ++i)
        for (int j = 0; j <= grid.ny; ++j) worst = std::max(worst, std::abs(r(i, j) - plain(i, j)));
      BOOST_TEST_MESSAGE("full: rows differ by " << worst << " (allowed 1e-11: rounding of eps/h^2)");
      BOOST_TEST(worst <= 1e-11);

      // Random dry points: the inflow plus the residuals equals the outflow.
      for (int i = 0; i <= grid.nx; ++i)
        for (int j = 0; j <= grid.ny; ++j)
          if (i == 0 || i == grid.nx || j == 0 || j > grid.last_line() || fields.P(i, j) < 0.4) fields.P(i, j) = 0.0;
      fields.f.fill(0.0);
      core::fill_ghosts(grid, fields.P);
      reynolds::residual(grid, fields.state(), {Q, supply}, wedge, 1, r);
      reynolds::residual(grid, fields.state(), {Q, supply}, wedge, 2, two);
      reynolds::Fields with_content = fields.state();
      with_content.content = &Q;
      const reynolds::OilBalance oil = reynolds::oil_balance(grid, with_content, wedge);
      double lacking = 0.0, scale = 0.0;
      int differ = 0;
      for (int i = 1; i < grid.nx; ++i)
        for (int j = 1; j <= grid.last_line(); ++j) {
          const double full = fields.rho_bar(i, j) * fields.H(i, j);
          const double violation = fields.P(i, j) > 0.0 || r(i, j) < 0.0 ? r(i, j) : 0.0;
          lacking += grid.lines(j) * grid.hx() * grid.hy() * violation;
          scale += grid.lines(j) * grid.hx() * grid.hy() * std::abs(violation);
          differ += r(i, j) != two(i, j) ? 1 : 0;
          BOOST_REQUIRE(Q(i, j) <= full);
          if (fields.P(i, j) > 0.0) BOOST_REQUIRE(Q(i, j) == full);
        }
      const double lost = oil.out + oil.aside - oil.in - lacking;
      BOOST_TEST_MESSAGE("in " << oil.in << ", out " << oil.out << ", aside " << oil.aside << ", lost " << lost
                               << " (allowed 1e-12 of the sum of what rows lack)");
      BOOST_TEST(std::abs(lost) <= 1e-12 * scale);
      BOOST_TEST(differ == 0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
