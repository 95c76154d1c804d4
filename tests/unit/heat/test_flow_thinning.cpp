// An oil that thins by the pressure flow, without heat: the film in pure rolling, its order, the transition
// from sliding to pure rolling; the secant fluidities at the end of the iteration, compared with the closed
// form at the actual gradient.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "unit/heat/heated_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_heat_flow_thinning)

using namespace ehl;
using support::BaseCase, support::Found, support::solve, support::square;

namespace {

BaseCase thin_oil(double srr) {
  BaseCase base;
  base.srr = srr;
  base.tau_0 = 1e6;
  return base;
}
// h dp/dx divided by tau_0 for H = 1 and dP/dX = 1.
double gradient_unit(const BaseCase& base) { return base.p_h() * base.a() / (base.R * base.tau_0); }

auto thinned_by_flow(const BaseCase& base) {
  return [&base](thermal::Setup& setup) {
    setup.Br = setup.Pe = setup.compression = 0.0;
    setup.flow_thinning = rheology::FlowThinning{
        rheology::Eyring{}, base.eta0 * base.u_m * base.R / (base.a() * base.a() * base.tau_0), std::abs(base.srr)};
  };
}

// The mobility 12 (flow/g) of an Eyring oil without sliding.
double mobility(double g) {
  return g < 1e-2 ? 1.0 + g * g / 40.0 : 12.0 / (g * g) * (std::cosh(g / 2) - 2 * std::sinh(g / 2) / g);
}

}  // namespace

BOOST_AUTO_TEST_CASE(secants_of_pure_rolling) {
  const BaseCase base = thin_oil(0.0);
  const thermal::Setup setup = base.setup(core::lower_half(square(128)));
  double worst = 0.0, largest = 0.0;
  const auto look = [&](const thermal::FilmTemperature& film, const multigrid::Level& level) {
    const core::Patch& grid = level.grid;
    std::vector<double> fluidity(static_cast<std::size_t>(grid.nodes_y()));
    for (int i = 1; i < grid.nx; ++i) {
      rheology::fluidity(setup.viscosity, level.P.station(i), fluidity);
      for (int j = 1; j < grid.ny; ++j) {
        if (!(level.P(i, j) > 0.0)) continue;
        const double H = level.H(i, j);
        const double P_X = (level.P(i + 1, j) - level.P(i - 1, j)) / (2 * grid.hx());
        const double P_Y = (level.P(i, j + 1) - level.P(i, j - 1)) / (2 * grid.hy());
        const double exact = mobility(gradient_unit(base) * H * std::hypot(P_X, P_Y));
        const double flow = H * H * fluidity[static_cast<std::size_t>(j)] / setup.lambda * std::hypot(P_X, P_Y);
        for (const core::Field* found : {&film.more_x(), &film.more_y()})
          worst = std::max(worst, flow * std::abs((*found)(i, j) - exact));
        largest = std::max(largest, exact);
      }
    }
  };
  const Found found = solve(base, square(128), thinned_by_flow(base), 1e-3, look);
  BOOST_TEST_MESSAGE("Hc " << found.Hc << ", " << 100 * (found.Hc / found.Hc_cold - 1) << " % (-3.7 %), "
                           << found.result.passes.size() << " passes; mobility up to " << largest << "; flow at worst "
                           << worst
                           << " u_m off that of the closed form (tolerance 0.01: rim nodes, where the pressure sets "
                              "the flow, settle last)");
  BOOST_TEST(found.result.unmet.empty());
  BOOST_TEST(largest > 1.5);
  BOOST_TEST(worst < 0.01);
  BOOST_TEST(std::abs(found.Hc / found.Hc_cold - 1 + 0.037) < 0.002);
  BOOST_TEST(found.mu == 0.0);
}

BOOST_AUTO_TEST_CASE(sliding_that_vanishes) {
  const BaseCase rolling = thin_oil(0.0), creeping = thin_oil(1e-4);
  const Found none = solve(rolling, square(64), thinned_by_flow(rolling), 1e-3);
  const Found little = solve(creeping, square(64), thinned_by_flow(creeping), 1e-3);
  BOOST_TEST_MESSAGE("Hc " << none.Hc << ", with srr = 1e-4 " << little.Hc << ", mu " << little.mu);
  BOOST_TEST(std::abs(little.Hc / none.Hc - 1) < 1e-4);
  BOOST_TEST(little.mu > 0.0);
}

BOOST_AUTO_TEST_CASE(second_order_with_thinning) {
  const BaseCase base = thin_oil(0.0);
  double Hc[3];
  for (const int level : {0, 1, 2}) Hc[level] = solve(base, square(64 << level), thinned_by_flow(base), 0.005).Hc;
  const double order = std::log2(std::abs((Hc[1] - Hc[0]) / (Hc[2] - Hc[1])));
  BOOST_TEST_MESSAGE("65^2, 129^2, 257^2: Hc " << Hc[0] << ", " << Hc[1] << ", " << Hc[2] << ", order " << order);
  BOOST_TEST(order > 1.6);
}

BOOST_AUTO_TEST_CASE(a_newtonian_oil_answers_nothing) {
  BaseCase base = thin_oil(1.0);
  base.tau_0 = 1e12;
  const Found found = solve(base, square(64), thinned_by_flow(base), 1e-3);
  BOOST_TEST(std::abs(found.Hc / found.Hc_cold - 1) < 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()
