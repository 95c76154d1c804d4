// The mass balance of the pressurised region: compared with the sum of the residuals, and for
// a channel with known flow.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "reynolds/flow_balance.hpp"
#include "unit/reynolds/fields.hpp"

BOOST_AUTO_TEST_SUITE(test_reynolds_flow_balance)

using namespace ehl::tests;
namespace reynolds = ehl::reynolds;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using reynolds::Wedge;

namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

// hx hy times the sum of r over the nodes of the region.
double sum_of_residuals(const Patch& grid, const Fields& fields, Wedge wedge, reynolds::Cavitation cavitation,
                        double reach) {
  Field r(grid);
  reynolds::residual(grid, fields.state(), wedge, 1, r);
  double sum = 0.0;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j)
      if (!reynolds::dry(cavitation, fields.P(i, j)) && std::abs(grid.X(i)) <= reach && std::abs(grid.Y(j)) <= reach)
        sum += r(i, j);
  return sum * grid.hx() * grid.hy();
}

}  // namespace

// The fluxes telescope: for any pressure, film and region, including cavities and islands, the balance over the edge
// equals that over the interior. hx = hy, hx < hy, hx > hy; with and without nodes at +-1.5.
BOOST_AUTO_TEST_CASE(edge_and_inside_give_the_same_balance) {
  double worst = 0.0;
  for (const Grid& grid : {Grid{48, 48, -3, 3, -3, 3}, Grid{61, 22, -4.5, 1.5, -2, 2}, Grid{20, 70, -2.3, 1.4, -3, 3}})
    for (const Wedge wedge : {Wedge::upstream1, Wedge::upstream2, Wedge::upstream3, Wedge::upstream3_inlet})
      for (const reynolds::Cavitation cavitation :
           {reynolds::Cavitation::nonnegative_pressure, reynolds::Cavitation::none})
        for (const double reach : {everywhere, 1.5, 0.8}) {
          Random random(7);
          Fields fields = random_fields(grid, random);
          for (int i = 0; i <= grid.nx; ++i)
            for (int j = 0; j <= grid.ny; ++j) fields.f(i, j) = 0.0;
          if (wedge == Wedge::upstream3) fields.face = reynolds::Face::logmean;
          const reynolds::FlowBalance balance = reynolds::flow_balance(grid, fields.state(), wedge, cavitation, reach);
          const double inside = sum_of_residuals(grid, fields, wedge, cavitation, reach);
          const double difference = std::abs(balance.out - balance.in - inside) / (balance.out + balance.in);
          worst = std::max(worst, difference);
          BOOST_TEST(std::abs(inside) > 1e-6);
        }
  BOOST_TEST_MESSAGE("largest difference " << worst << " of the flow over the edge (tolerance 1e-13)");
  BOOST_TEST(worst < 1e-13);
}

// A channel with unit film and density whose pressure decreases linearly along Y: a flow of 1 through each end, and
// eps dP/dY through its sides.
BOOST_AUTO_TEST_CASE(flow_of_a_channel) {
  const Grid grid{32, 40, -2, 2, -2, 2};
  Fields fields = zero_fields(grid);
  fields.H.fill(1.0);
  fields.rho_bar.fill(1.2);
  fields.eps.fill(0.3);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) fields.P(i, j) = 2.0 - 0.5 * grid.Y(j);
  for (const Wedge wedge : {Wedge::upstream1, Wedge::upstream2}) {
    const reynolds::FlowBalance balance =
        reynolds::flow_balance(grid, fields.state(), wedge, reynolds::Cavitation::nonnegative_pressure, 1.0);
    // The nodes within 1 represent cells that extend half a step further.
    const double length = 2.0 + grid.hx();
    const double width = 2.0 + grid.hy();
    const double truth = 1.2 * width + 0.3 * 0.5 * length;
    BOOST_TEST_MESSAGE("in " << balance.in << ", out " << balance.out << ", by hand " << truth);
    BOOST_TEST(std::abs(balance.in - truth) < 1e-12);
    BOOST_TEST(std::abs(balance.out - truth) < 1e-12);
    BOOST_TEST(std::abs(balance.through - 1.2 * width) < 1e-12);
    BOOST_TEST(std::abs(balance.imbalance()) < 1e-12);
  }
  // A film that becomes thinner along X at constant pressure loses mass accordingly.
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) fields.H(i, j) = 1.0 - 0.01 * grid.X(i);
  const reynolds::FlowBalance thinning =
      reynolds::flow_balance(grid, fields.state(), Wedge::upstream2, reynolds::Cavitation::nonnegative_pressure, 1.0);
  BOOST_TEST(std::abs(thinning.imbalance() + 0.01 * (2.0 + grid.hx())) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
