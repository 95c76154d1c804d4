// A column of the film, compared with closed forms for sheared films with eta = eta_s exp(-beta (T - T_s)): sliding
// between walls of equal or different temperatures, any shear law, rolling; the order; the heat balance.
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/errors.hpp"
#include "rheology/laws.hpp"
#include "thermal/column.hpp"

BOOST_AUTO_TEST_SUITE(test_thermal_column)

using namespace ehl::thermal;
namespace rheology = ehl::rheology;
using ehl::core::broadcast;

namespace {

// T0 = 1, beta = 1: theta is beta (T - T_s), and Br sliding^2 is the Nahme number for H = 1.
ColumnLaws exponential(double Na) {
  return {.viscosity = rheology::make_thermal_viscosity(rheology::Barus{0.0}, {1.0, rheology::Exponential{1.0}}),
          .sliding = 1.0,
          .Br = Na,
          .theta_least = -10.0,
          .theta_most = 50.0};
}
Columns column(double theta_2, double theta_1, const Nodes& nodes) {
  Columns c;
  c.fluidity = c.H = c.k_bar = c.heated = broadcast(1.0);
  c.limit = broadcast(1e30);
  c.given_2 = broadcast(theta_2);
  c.given_1 = broadcast(theta_1);
  for (int k = 0; k <= nodes.intervals; ++k)
    c.theta[static_cast<std::size_t>(k)] =
        broadcast(theta_2 + (theta_1 - theta_2) * nodes.zeta[static_cast<std::size_t>(k)]);
  return c;
}
double largest(const Nodes& nodes, const Columns& c) {
  double most = -1e30;
  for (int k = 0; k <= nodes.intervals; ++k) most = std::max(most, c.theta[static_cast<std::size_t>(k)][0]);
  return most;
}
template <class F>
double root(F f, double low, double high) {
  std::uintmax_t steps = 200;
  const auto found =
      boost::math::tools::toms748_solve(f, low, high, boost::math::tools::eps_tolerance<double>(50), steps);
  return 0.5 * (found.first + found.second);
}
template <class F>
double integral(F f) {
  double sum = 0.0;
  for (int k = 0; k < 64; ++k)
    sum += boost::math::quadrature::gauss<double, 20>::integrate(f, k / 64.0, (k + 1) / 64.0);
  return sum;
}

struct Couette {
  double rise, tau, M2;
};
// sinh^2 B = Na/8.
Couette couette(double Na) {
  const double B = std::asinh(std::sqrt(Na / 8));
  const auto moment = [&](double zeta) {
    const double s = zeta - 0.5, c = std::cosh(B) / std::cosh(2 * B * s);
    return 12 * s * s * c * c;
  };
  return {std::log1p(Na / 8), B / (std::sinh(B) * std::cosh(B)), integral(moment)};
}
struct Errors {
  double rise, tau, M2;
  int steps;
};
Errors errors_of_couette(double Na, int intervals) {
  const Nodes nodes = make_nodes(intervals);
  Columns c = column(0, 0, nodes);
  const int steps = solve(nodes, exponential(Na), c, {});
  const Couette exact = couette(Na);
  BOOST_TEST(std::abs(c.z_bar[0] - 0.5) < 1e-7);
  return {largest(nodes, c) / exact.rise - 1, c.tau_m[0] / exact.tau - 1, c.M2[0] / exact.M2 - 1, steps};
}

}  // namespace

BOOST_AUTO_TEST_CASE(sliding_between_walls_of_one_temperature) {
  // The closed form, checked with its digits in extended arithmetic.
  const Couette at_100 = couette(100);
  BOOST_TEST(std::abs(at_100.rise - 2.6026896854) < 1e-9);
  BOOST_TEST(std::abs(at_100.tau - 0.1520691993) < 1e-9);
  BOOST_TEST(std::abs(at_100.M2 - 3.05095338) < 1e-7);
  for (const double Na : {1e-3, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4}) {
    const Errors e = errors_of_couette(Na, 16);
    const double tolerance = Na <= 100 ? 1e-4 : (Na <= 1e3 ? 5e-4 : 1e-2);
    BOOST_TEST_MESSAGE("Na = " << Na << ", 17 nodes: rise " << e.rise << ", stress " << e.tau << ", M2 " << e.M2
                               << " off (tolerance " << tolerance << "), " << e.steps << " steps");
    BOOST_TEST(std::abs(e.rise) < tolerance);
    BOOST_TEST(std::abs(e.tau) < tolerance);
    BOOST_TEST(std::abs(e.M2) < tolerance);
    BOOST_TEST(e.steps <= 15);
  }
  // Nahme numbers beyond those of any film.
  for (const double Na : {1e5, 1e6}) BOOST_TEST(errors_of_couette(Na, 64).steps <= 30);
}

BOOST_AUTO_TEST_CASE(fourth_order) {
  Errors before{};
  for (const int intervals : {8, 16, 32, 64}) {
    const Errors e = errors_of_couette(100, intervals);
    BOOST_TEST_MESSAGE(intervals << " intervals: rise " << e.rise << ", stress " << e.tau << ", M2 " << e.M2
                                 << "; orders " << std::log2(before.rise / e.rise) << " "
                                 << std::log2(before.tau / e.tau) << " " << std::log2(before.M2 / e.M2));
    if (intervals > 16)
      for (const double ratio : {before.rise / e.rise, before.tau / e.tau, before.M2 / e.M2})
        BOOST_TEST(std::abs(std::log2(ratio) - 4) < 0.4);
    before = e;
  }
}

BOOST_AUTO_TEST_CASE(stress_falls_beyond_its_maximum) {
  // B tanh B = 1 at Na = 18.21374; tau_max = 1.87452146 sqrt(k eta_s/beta)/h.
  const Nodes nodes = make_nodes(32);
  const auto stress = [&](double Na) {
    Columns c = column(0, 0, nodes);
    solve(nodes, exponential(Na), c, {});
    return c.tau_m[0] * std::sqrt(Na);
  };
  BOOST_TEST(std::abs(stress(18.21374) / 1.87452146 - 1) < 1e-5);
  BOOST_TEST(stress(17) < stress(18.21374));
  BOOST_TEST(stress(19.5) < stress(18.21374));
}

BOOST_AUTO_TEST_CASE(any_shear_law) {
  // Eyring, tau_0 = 5 MPa, beta = 0.042, k = 0.14, h = 300 nm, eta_s = 1000.
  constexpr double beta = 0.042, k = 0.14, h = 300e-9, eta = 1000, tau_0 = 5e6;
  constexpr double digits[3][4] = {{0.02, 16.4118048e6, 0.087975, 16.4240882e6},
                                   {0.2, 27.7195563e6, 1.500541, 27.9300675e6},
                                   {2.0, 36.2214099e6, 22.309052, 39.4429234e6}};
  const Nodes nodes = make_nodes(16);
  for (const auto& [du, tau, rise, isothermal] : digits) {
    ColumnLaws laws = exponential(beta * eta * du * du / k);
    laws.thinning = {rheology::Eyring{}, eta * du / (h * tau_0)};
    Columns c = column(0, 0, nodes);
    solve(nodes, laws, c, {});
    const double found = c.tau_m[0] * eta * du / h;
    BOOST_TEST_MESSAGE("du = " << du << ": stress " << found / tau - 1 << ", rise "
                               << largest(nodes, c) / beta / rise - 1 << " off (tolerance 1e-5: digits printed)");
    BOOST_TEST(std::abs(found / tau - 1) < 1e-5);
    BOOST_TEST(std::abs(largest(nodes, c) / beta / rise - 1) < 1e-5);
    BOOST_TEST(std::abs(std::asinh(eta * du / (h * tau_0)) * tau_0 / isothermal - 1) < 1e-7);
  }
  // Carreau and a limiting stress: B tanh B = beta tau du h/(8 k), I0 eta_s = sinh B cosh B/B.
  ColumnLaws laws = exponential(50);
  laws.thinning = {rheology::Carreau{0.4}, 3.0};
  for (const double limit : {1e30, 0.1}) {
    Columns c = column(0, 0, nodes);
    c.limit = broadcast(limit);
    solve(nodes, laws, c, {});
    const double B = root([&](double b) { return b * std::tanh(b) - 50 * c.tau_m[0] / 8; }, 1e-6, 10.0);
    BOOST_TEST(std::abs(c.I0[0] / (std::sinh(B) * std::cosh(B) / B) - 1) < 1e-4);
    BOOST_TEST(std::abs(largest(nodes, c) / (2 * std::log(std::cosh(B))) - 1) < 1e-4);
    const double t_N = 1 / c.I0[0];
    const double law = t_N * rheology::thinned(laws.thinning.law, 3.0 * t_N).across;
    BOOST_TEST(std::abs(c.tau_m[0] - std::min(law, limit)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(walls_of_two_temperatures) {
  struct Row {
    double Na, D, tau, z_bar, M2, theta_most, slope_0, slope_1;
  };
  // cosh a = e^(D/2) cosh b, sinh a + e^(D/2) sinh b = sqrt(Na/2).
  constexpr Row rows[] = {{10, 1, 0.40333142, 0.57610688, 2.0428824, 1.1807345, 2.7096942, -1.3236201},
                          {10, 2, 0.25342531, 0.65028155, 3.0281768, 2.0, 2.8862751, 0.35202197},
                          {100, 1, 0.12991444, 0.55979092, 4.0316628, 2.6654143, 6.7189516, -6.2724924},
                          {100, 2, 0.10544190, 0.62578735, 5.2735637, 2.8272324, NAN, NAN}};
  const Nodes nodes = make_nodes(16);
  for (const Row& row : rows) {
    Columns c = column(0, row.D, nodes);
    solve(nodes, exponential(row.Na), c, {});
    const double off[] = {c.tau_m[0] / row.tau - 1, c.z_bar[0] / row.z_bar - 1, c.M2[0] / row.M2 - 1};
    BOOST_TEST_MESSAGE("Na = " << row.Na << ", D = " << row.D << ": stress " << off[0] << ", z_bar " << off[1]
                               << ", M2 " << off[2] << " off (tolerance 1e-4)");
    for (const double e : off) BOOST_TEST(std::abs(e) < 1e-4);
    // The hottest point lies between nodes.
    BOOST_TEST(largest(nodes, c) < row.theta_most * (1 + 1e-4));
    BOOST_TEST(largest(nodes, c) > row.theta_most * 0.99);
    if (std::isnan(row.slope_0)) continue;
    BOOST_TEST(std::abs(c.q_2[0] - row.slope_0) < 3e-4 * std::abs(row.slope_0));
    BOOST_TEST(std::abs(-c.q_1[0] - row.slope_1) < 1e-3 * std::abs(row.slope_0));
  }
  // No sliding: a linear temperature, I0 = e - 1, z_bar = 1/(e - 1).
  Columns c = column(0, 1, nodes);
  solve(nodes, exponential(0), c, {});
  BOOST_TEST(std::abs(c.I0[0] / std::expm1(1.0) - 1) < 1e-6);
  BOOST_TEST(std::abs(c.z_bar[0] * std::expm1(1.0) - 1) < 1e-6);
}

BOOST_AUTO_TEST_CASE(rolling_heats_the_inlet) {
  struct Row {
    double Fw, M2, rise;
  };
  // The gap carries a given flow; with a given gradient, a column has no solution at some of these values.
  constexpr Row rows[] = {{0.01, 1.004284, 0.007480}, {0.1, 1.042693, 0.073058},  {1, 1.414529, 0.599644},
                          {10, 4.623425, 2.538178},   {100, 29.791564, 5.294946}, {1000, 231.620577, 8.057514}};
  for (const Row& row : rows)
    for (const int intervals : {16, 32}) {
      const Nodes nodes = make_nodes(intervals);
      ColumnLaws laws = exponential(row.Fw);
      laws.sliding = 0.0;
      Columns c = column(0, 0, nodes);
      c.flow_x = broadcast(1.0);
      const int steps = solve(nodes, laws, c, {});
      const double M2 = c.M2[0] / row.M2 - 1, rise = largest(nodes, c) / row.rise - 1;
      BOOST_TEST_MESSAGE("Fw = " << row.Fw << ", " << intervals + 1 << " nodes: 1/R " << M2 << ", rise " << rise
                                 << " off, " << steps << " steps");
      // The two hottest points lie between nodes, so the largest value at the nodes is too low.
      const double tolerance = row.Fw <= 100 ? 1e-4 : 2e-3;
      BOOST_TEST(std::abs(M2) < (intervals == 16 ? tolerance : tolerance / 4));
      BOOST_TEST(std::abs(rise) < (intervals == 16 ? 2 * tolerance : tolerance / 4));
      BOOST_TEST(steps <= 20);
    }
}

BOOST_AUTO_TEST_CASE(heat_balances_to_rounding) {
  // Sliding, flow along and transverse to it, surfaces that respond to their heat, and oil that
  // carries heat up and down.
  const Nodes nodes = make_nodes(16);
  ColumnLaws laws = exponential(30);
  laws.thinning = {rheology::Eyring{}, 2.0};
  Columns c = column(0.1, 0.3, nodes);
  c.H = broadcast(0.7);
  c.flow_x = broadcast(0.3);
  c.flow_y = broadcast(-0.2);
  c.self_2 = broadcast(0.15);
  c.self_1 = broadcast(0.05);
  c.carries = true;
  for (std::size_t k = 0; k <= 16; ++k) {
    c.convection.below[k] = broadcast(k > 8 ? 2.0 : 0.0);
    c.convection.above[k] = broadcast(k < 4 ? 1.0 : 0.0);
    c.convection.side[k] = broadcast(0.1 * static_cast<double>(k));
    c.convection.carried[k] = 0.2 * c.convection.side[k];
    c.convection.compression[k] = broadcast(-0.4);
  }
  const int steps = solve(nodes, laws, c, {});
  const double gap = (c.q_1 + c.q_2 + c.carried_off - c.heat)[0] / c.heat[0];
  BOOST_TEST_MESSAGE("q1 + q2 + carried off - made: " << gap << " of what is made (tolerance 1e-12), " << steps
                                                      << " steps");
  BOOST_TEST(std::abs(gap) < 1e-12);
  // The surface temperatures follow from the heat.
  BOOST_TEST(std::abs((c.theta[0] - c.given_2 - c.self_2 * c.q_2)[0]) < 1e-11);
  BOOST_TEST(std::abs((c.theta[16] - c.given_1 - c.self_1 * c.q_1)[0]) < 1e-11);
}

// Columns next to others with different Nahme numbers, which need more or fewer steps, with a coarse tolerance as
// in a film: the results must not depend on the number of columns that a processor treats together. With a single
// step most are not converged.
BOOST_AUTO_TEST_CASE(a_column_does_not_see_those_beside_it) {
  const Nodes nodes = make_nodes(16);
  ColumnLaws laws = exponential(1.0);
  for (const Steps& steps : {Steps{}, Steps{.most = 20, .tolerance = 1e-3}, Steps{.most = 2, .tolerance = 1e-3}})
    for (const double own : {1.0, 1e-3}) {
      Columns alone = column(0, 0.5, nodes);
      const auto heat = [](Columns& at, int lane, double fluidity) {
        at.fluidity[lane] = fluidity;
        at.log_eta[lane] = -std::log(fluidity);
      };
      for (int lane = 0; lane < ehl::core::lanes; ++lane) heat(alone, lane, own);
      Columns mixed = alone;
      for (int lane = 1; lane < ehl::core::lanes; ++lane) heat(mixed, lane, own == 1.0 ? 1e-3 * lane : 1.0 / lane);
      solve(nodes, laws, alone, steps);
      solve(nodes, laws, mixed, steps);
      for (std::size_t k = 0; k <= 16; ++k) BOOST_TEST(+alone.theta[k][0] == +mixed.theta[k][0]);
      for (const auto value :
           {&Columns::I0, &Columns::z_bar, &Columns::M2, &Columns::tau_m, &Columns::q_1, &Columns::q_2, &Columns::heat})
        BOOST_TEST(+(alone.*value)[0] == +(mixed.*value)[0]);
    }
}

BOOST_AUTO_TEST_CASE(nodes_that_do_not_exist) {
  for (const int intervals : {0, 2, 15, 66}) BOOST_CHECK_THROW(make_nodes(intervals), ehl::core::InputError);
  for (const int intervals : {4, 6, 16, 64}) {
    const Nodes nodes = make_nodes(intervals);
    double simpson = 0.0, heat = 0.0;
    for (std::size_t k = 0; k <= static_cast<std::size_t>(intervals); ++k) {
      simpson += nodes.simpson[k] * std::pow(nodes.zeta[k], 3);
      heat += nodes.heat[k] * std::pow(nodes.zeta[k], 3);
    }
    BOOST_TEST(std::abs(simpson - 0.25) < 1e-14);
    BOOST_TEST(std::abs(heat - 0.25) < 1e-14);
  }
}

BOOST_AUTO_TEST_SUITE_END()
