// The flow through rough gaps against exact averages.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "asperities/aggregation.hpp"
#include "asperities/cell_flow.hpp"
#include "asperities/roughness_numbers.hpp"
#include "random_map.hpp"

BOOST_AUTO_TEST_SUITE(test_asperity_flow)

using namespace ehl;
using asperities::Cell;
using asperities::FlowAlong;

namespace {
constexpr double pi = std::numbers::pi;
}

// g = 1 + e cos(2 pi x): the flow across the waves is <g^-3>^-1 = (1 - e^2)^(5/2)/(1 + e^2/2), along them
// <g^3> = 1 + (3/2) e^2.
BOOST_AUTO_TEST_CASE(striations_have_their_exact_factors) {
  const double e = 0.6, across = std::pow(1.0 - e * e, 2.5) / (1.0 + 0.5 * e * e), along = 1.0 + 1.5 * e * e;
  double errors[2][2];
  for (const int refined : {0, 1}) {
    const int n = 32 << refined;
    for (const bool turned : {false, true}) {
      const Cell cell{turned ? 6 : n, turned ? n : 6, turned ? 1.0 : 1.0 / n, turned ? 1.0 / n : 1.0};
      std::vector<double> gap;
      for (int j = 0; j < cell.ny; ++j)
        for (int i = 0; i < cell.nx; ++i) gap.push_back(1.0 + e * std::cos(2.0 * pi * ((turned ? j : i) + 0.5) / n));
      const double first = flow_through(cell, gap, 1.0, turned ? FlowAlong::y : FlowAlong::x).factor;
      const double second = flow_through(cell, gap, 1.0, turned ? FlowAlong::x : FlowAlong::y).factor;
      if (turned) BOOST_TEST(std::abs(first / across - 1.0 - errors[refined][0]) < 1e-6);
      errors[refined][0] = first / across - 1.0;
      errors[refined][1] = second / along - 1.0;
    }
  }
  BOOST_TEST_MESSAGE("across on 32 and 64 points: " << errors[0][0] << ", " << errors[1][0]
                                                    << " (tolerance 5e-3; order 2: ratio above 3.5), along: "
                                                    << errors[1][1] << " (1e-6)");
  BOOST_TEST(std::abs(errors[1][0]) < 5e-3);
  BOOST_TEST(errors[0][0] / errors[1][0] > 3.5);
  BOOST_TEST(std::abs(errors[1][1]) < 1e-6);
}

// Small roughness: 1 + 3 (Sq/h)^2 (1 - 3 <q_x^2/q^2>) along x, for isotropic and stretched surfaces, from fields.
BOOST_AUTO_TEST_CASE(small_roughness_follows_the_perturbation_theory) {
  for (const double gamma : {1.0, 4.0}) {
    const Cell cell{128, 128, 1e-6, 1e-6};
    const std::vector<double> z = support::random_heights(cell, 0.1e-6, 64e-6, 16e-6, 2.0, gamma, 3);
    const double share = asperities::roughness_numbers(cell, z).share_x, h = 2e-6, e = 0.05;
    // Odd orders cancel between a surface and its negative.
    double x = 0.0, y = 0.0;
    for (const double sign : {-1.0, 1.0}) {
      std::vector<double> gap(z);
      for (double& g : gap) g = h + sign * g;
      x += 0.5 * flow_through(cell, gap, h, FlowAlong::x).factor;
      y += 0.5 * flow_through(cell, gap, h, FlowAlong::y).factor;
    }
    const double exact_x = asperities::small_roughness_factor(e, share),
                 exact_y = asperities::small_roughness_factor(e, 1.0 - share);
    BOOST_TEST_MESSAGE("gamma " << gamma << ", <q_x^2/q^2> " << share << ": phi - 1 along x " << x - 1.0 << ", theory "
                                << exact_x - 1.0 << ", along y " << y - 1.0 << ", theory " << exact_y - 1.0
                                << " (tolerance 1e-4: fourth order and mesh)");
    BOOST_TEST(std::abs(x - exact_x) < 1e-4);
    BOOST_TEST(std::abs(y - exact_y) < 1e-4);
  }
}

// Walls: a channel of a given width, a dead end, a pocket, and a wall from side to side.
BOOST_AUTO_TEST_CASE(only_open_ways_carry_oil) {
  const Cell cell{16, 16, 1.0, 1.0};
  std::vector<double> gap(256, 0.0);
  const auto open = [&](int i0, int i1, int j0, int j1) {
    for (int j = j0; j < j1; ++j)
      for (int i = i0; i < i1; ++i) gap[static_cast<std::size_t>(16 * j + i)] = 1.0;
  };
  open(0, 16, 2, 6);   // from edge to edge, four wide
  open(0, 9, 8, 10);   // a dead end
  open(5, 8, 12, 14);  // a pocket
  const auto x = flow_through(cell, gap, 1.0, FlowAlong::x), y = flow_through(cell, gap, 1.0, FlowAlong::y);
  BOOST_TEST_MESSAGE("a channel of a quarter of the width: " << x.factor << " (tolerance 1e-6), blocked: " << y.factor);
  BOOST_TEST(std::abs(x.factor - 0.25) < 1e-6);
  BOOST_TEST(y.factor == 0.0);
}

// Conductances over ten decades at random: the iteration does not depend on the size, and inflow is outflow.
BOOST_AUTO_TEST_CASE(the_solver_stands_large_contrasts) {
  int iterations[2];
  for (const int refined : {0, 1}) {
    const int n = 64 << refined;
    const Cell cell{n, n, 1e-6, 1e-6};
    const std::vector<double> z = support::random_heights(cell, 0.3e-6, 32e-6, 4e-6, 3.6, 1.0, 5);
    std::vector<double> gap(z);
    for (double& g : gap) g = 0.25e-6 > g ? 0.25e-6 - g : 0.0;
    const auto x = flow_through(cell, gap, 0.25e-6, FlowAlong::x);
    iterations[refined] = x.iterations;
    BOOST_TEST_MESSAGE(n << "^2 points with contact: phi_x " << x.factor << ", " << x.iterations
                         << " iterations, residual " << x.residual << " (tolerance 1e-8)");
    BOOST_TEST(x.residual < 1e-8);
    BOOST_TEST((x.factor > 0.0 && x.factor < 1.0));
  }
  BOOST_TEST(iterations[1] < 2 * iterations[0] + 10);
}

BOOST_AUTO_TEST_SUITE_END()
