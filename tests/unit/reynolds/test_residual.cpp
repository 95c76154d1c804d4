// The residual compared with eq. (4), the coefficient epsilon, and the norms of the complementarity problem.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "core/norms.hpp"
#include "film/model.hpp"
#include "reynolds/flux.hpp"
#include "unit/reynolds/fields.hpp"

BOOST_AUTO_TEST_SUITE(test_reynolds_residual)

using namespace ehl::tests;
namespace reynolds = ehl::reynolds;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using reynolds::Wedge;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Q through the face downstream of node i, with its share of third order.
double carried_at(const Fields& s, const reynolds::Transport& transport, int i, int j) {
  const auto Q = [&](int k) { return s.rho_bar(k, j) * s.H(k, j); };
  if (transport.wedge == Wedge::upstream1) return Q(i);
  if (i == 0) return 0.5 * (Q(0) + Q(1));
  const double share = reynolds::third_order(transport.wedge) ? s.third_order(i, j) : 0.0;
  return (1.0 - share) * (1.5 * Q(i) - 0.5 * Q(i - 1)) + share * (2.0 * Q(i + 1) + 5.0 * Q(i) - Q(i - 1)) / 6.0;
}

// f - L(P) at one node, eq. (4) term by term.
double residual_at(const Patch& grid, const Fields& s, const reynolds::Transport& transport, int i, int j) {
  const double hx = grid.hx();
  const double hy = grid.hy();
  const bool mean = s.face == reynolds::Face::mean;
  const double eps_west = mean ? 0.5 * (s.eps(i - 1, j) + s.eps(i, j)) : s.eps(i - 1, j);
  const double eps_east = mean ? 0.5 * (s.eps(i + 1, j) + s.eps(i, j)) : s.eps(i, j);
  const double eps_south = mean ? 0.5 * (s.eps(i, j - 1) + s.eps(i, j)) : s.eps(i, j - 1);
  const double eps_north = mean ? 0.5 * (s.eps(i, j + 1) + s.eps(i, j)) : s.eps(i, j);
  const double along_x =
      (eps_west * s.P(i - 1, j) - (eps_west + eps_east) * s.P(i, j) + eps_east * s.P(i + 1, j)) / (hx * hx);
  const double along_y =
      (eps_south * s.P(i, j - 1) - (eps_south + eps_north) * s.P(i, j) + eps_north * s.P(i, j + 1)) / (hy * hy);
  const double d_flow_dX = (carried_at(s, transport, i, j) - carried_at(s, transport, i - 1, j)) / hx;
  const double flow = s.rho_bar(i, j) * s.H(i, j);
  return s.f(i, j) - (along_x + along_y - transport.speed * d_flow_dX - transport.squeeze * flow);
}

}  // namespace

BOOST_AUTO_TEST_CASE(residual_is_equation_4) {
  for (const Grid& grid : {Grid{16, 16, -2, 2, -2, 2}, Grid{37, 22, -4.5, 1.5, -1, 1}, Grid{2, 2, 0, 1, 0, 1}})
    for (const reynolds::Transport transport :
         {reynolds::Transport(Wedge::upstream1), reynolds::Transport(Wedge::upstream2),
          reynolds::Transport(Wedge::upstream1, 0.7, 4.0), reynolds::Transport(Wedge::upstream2, 0.0, 9.0),
          reynolds::Transport(Wedge::upstream3, 0.7, 4.0), reynolds::Transport(Wedge::upstream3_inlet)}) {
      Random random(1);
      Fields fields = random_fields(grid, random);
      if (transport.wedge == Wedge::upstream3) fields.face = reynolds::Face::logmean;
      Field r(grid);
      r.fill(not_a_number);
      reynolds::residual(grid, fields.state(), transport, 1, r);
      double largest = 0.0;
      double error = 0.0;
      for (int i = 0; i <= grid.nx; ++i)
        for (int j = 0; j <= grid.ny; ++j) {
          const bool boundary = i == 0 || j == 0 || i == grid.nx || j == grid.ny;
          const double truth = boundary ? 0.0 : residual_at(grid, fields, transport, i, j);
          largest = std::max(largest, std::abs(truth));
          const double difference = std::abs(r(i, j) - truth);
          error = difference <= error ? error : difference;
        }
      BOOST_TEST_MESSAGE(grid.nx << " x " << grid.ny << ", upstream"
                                 << std::min(static_cast<int>(transport.wedge) + 1, 3) << ": " << error / largest
                                 << " of the largest residual (tolerance 1e-14)");
      BOOST_TEST(error / largest < 1e-14);
    }
}

// In a line contact nothing varies along Y: its residual is that of a wide grid whose lines are all equal.
BOOST_AUTO_TEST_CASE(a_line_contact_is_a_wide_one_whose_lines_are_equal) {
  const Grid line = ehl::core::line_grid(37, -4.5, 1.5), wide{37, 12, -4.5, 1.5, -1.0, 1.0};
  for (const reynolds::Transport transport :
       {reynolds::Transport(Wedge::upstream1), reynolds::Transport(Wedge::upstream3, 0.7, 4.0)}) {
    Random random(7);
    Fields of_line = random_fields(line, random), of_wide = zero_fields(wide);
    if (transport.wedge == Wedge::upstream3) of_line.face = of_wide.face = reynolds::Face::logmean;
    for (Field Fields::*field :
         {&Fields::P, &Fields::H, &Fields::rho_bar, &Fields::eps, &Fields::f, &Fields::third_order})
      for (int i = 0; i <= wide.nx; ++i) std::ranges::fill((of_wide.*field).station(i), (of_line.*field)(i, 1));
    Field r_line{Patch(line)}, r_wide(wide);
    reynolds::residual(line, of_line.state(), transport, 1, r_line);
    reynolds::residual(wide, of_wide.state(), transport, 1, r_wide);
    double largest = 0.0, error = 0.0;
    for (int i = 0; i <= line.nx; ++i) {
      const double truth = r_wide(i, wide.ny / 2);
      largest = std::max(largest, std::abs(truth));
      for (const double r : r_line.station(i)) error = std::max(error, std::abs(r - truth));
    }
    BOOST_TEST_MESSAGE("line contact against equal lines: " << error / largest << " of the largest (tolerance 1e-14)");
    BOOST_TEST(error / largest < 1e-14);
  }
}

// theta = e^2/(1 + e^2), where e is the harmonic mean of epsilon/hx^2 divided by U.
BOOST_AUTO_TEST_CASE(third_order_follows_the_weaker_of_two_nodes) {
  constexpr double hx = 0.1;
  const reynolds::ThirdOrderShare share(reynolds::Transport(Wedge::upstream3, 2.0, 0.0), hx);
  const double half = 2.0 * hx * hx;  // the epsilon that gives theta = 1/2
  BOOST_TEST(std::abs(share(half, half) - 0.5) < 1e-15);
  BOOST_TEST(std::abs(share(1e9 * half, half) - 0.8) < 1e-8);
  BOOST_TEST(share(1e9 * half, 1e-3 * half) < 4.1e-6);
  BOOST_TEST(share(half, 0.0) == 0.0);
  BOOST_TEST(share(0.0, 0.0) == 0.0);
  double worst = 0.0;
  for (const double before : {0.01, 0.7, 3.0, 50.0})
    for (const double behind : {0.0, 0.2, 3.0}) {
      constexpr double step = 1e-6;
      const auto at = [&](double t) { return share(half * (before + 0.3 * t), half * (behind + 0.8 * t)); };
      const double slope = (at(step) - at(behind > 0.0 ? -step : 0.0)) / (behind > 0.0 ? 2.0 * step : step);
      worst = std::max(worst, std::abs(share.change(half * before, half * behind, 0.3 * half, 0.8 * half) - slope));
    }
  BOOST_TEST_MESSAGE("largest error of its change " << worst << " (tolerance 1e-5: a one-sided difference over 1e-6)");
  BOOST_TEST(worst < 1e-5);
}

BOOST_AUTO_TEST_CASE(residual_has_the_same_bits_with_two_threads) {
  const Grid grid{203, 150, -4.5, 1.5, -3, 3};
  Random random(2);
  const Fields fields = random_fields(grid, random);
  Field one(grid);
  Field two(grid);
  reynolds::residual(grid, fields.state(), Wedge::upstream2, 1, one);
  reynolds::residual(grid, fields.state(), Wedge::upstream2, 2, two);
  for (int i = 0; i <= grid.nx; ++i)
    BOOST_TEST(std::memcmp(one.at_x(i), two.at_x(i), sizeof(double) * static_cast<std::size_t>(grid.nodes_y())) == 0);
}

BOOST_AUTO_TEST_CASE(epsilon_is_equation_5_and_never_negative) {
  const double lambda = 0.3;
  const std::vector<double> H{0.0, -0.1, -1e-300, 0.2, 2.0, 0.5, 1e-4};
  const std::vector<double> rho_bar{1.0, 1.1, 1.2, 1.3, 1.0, 1.34, 1.0};
  // eta_bar = 1, 1e9, and one so large that 1/eta_bar has underflowed.
  const std::vector<double> fluidity{1.0, 1.0, 1.0, 1e-9, 1.0, 0.0, 1.0};
  std::vector<double> eps(H.size(), not_a_number);
  ehl::film::epsilon(H, rho_bar, fluidity, lambda, eps);
  for (const std::size_t k : {0u, 1u, 2u, 5u}) BOOST_TEST((eps[k] == 0.0 && !std::signbit(eps[k])));
  double error = 0.0;
  for (const std::size_t k : {3u, 4u, 6u})
    error = std::max(error, std::abs(eps[k] / (rho_bar[k] * std::pow(H[k], 3) * fluidity[k] / lambda) - 1.0));
  BOOST_TEST_MESSAGE("epsilon: relative error " << error << " (tolerance 1e-15)");
  BOOST_TEST(error < 1e-15);

  std::vector<double> one(1);
  ehl::film::epsilon(std::vector{not_a_number}, std::vector{1.0}, std::vector{1.0}, lambda, one);
  BOOST_TEST(std::isnan(one[0]), "a film that is not a number must show");
}

BOOST_AUTO_TEST_CASE(norms_count_only_what_violates_complementarity) {
  const Grid grid{12, 8, 0, 1.2, 0, 1.6};
  Fields fields = zero_fields(grid);
  fields.P.fill(0.5);
  fields.rho_bar.fill(1.0);
  fields.rho_bar(4, 3) = 1.1;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) fields.H(i, j) = 0.3 * grid.X(i);  // wedge term 0.3
  fields.P(5, 5) = 0.0;
  fields.P(6, 5) = 0.0;
  Field r(grid);
  r(5, 5) = 7.0;   // cavitated, L(P) < f: satisfied
  r(6, 5) = -2.0;  // cavitated, L(P) > f: violated
  r(3, 3) = 1.0;   // with pressure: any residual counts
  r(8, 2) = -1.5;
  r(0, 4) = 100.0;  // the boundary has no equation
  const double points = (grid.nx - 1) * (grid.ny - 1);

  const auto norms =
      reynolds::residual_norms(grid, fields.state(), Wedge::upstream1, reynolds::Cavitation::nonnegative_pressure, r);
  BOOST_TEST(std::abs(norms.root_mean_square - std::sqrt((4.0 + 1.0 + 2.25) / points)) < 1e-15);
  BOOST_TEST(norms.largest == 2.0);
  BOOST_TEST((norms.i == 6 && norms.j == 5));
  // Without cavitation all residuals count.
  const auto all = reynolds::residual_norms(grid, fields.state(), Wedge::upstream1, reynolds::Cavitation::none, r);
  BOOST_TEST(std::abs(all.root_mean_square - std::sqrt((49.0 + 4.0 + 1.0 + 2.25) / points)) < 1e-15);
  BOOST_TEST(all.largest == 7.0);

  // The wedge term is 0.3, except next to the denser node, where rho_bar H is 0.012 higher;
  // cavitated nodes do not count.
  const double up = 0.3 + 0.1 * 0.3 * grid.X(4) / grid.hx();
  const double down = 0.3 - 0.1 * 0.3 * grid.X(4) / grid.hx();
  const double wedge = std::sqrt((0.09 * (points - 4) + up * up + down * down) / (points - 2));
  BOOST_TEST_MESSAGE("wedge " << norms.wedge << ", by hand " << wedge << " (tolerance 1e-14)");
  BOOST_TEST(std::abs(norms.wedge - wedge) < 1e-14);
  BOOST_TEST(norms.relative() == norms.root_mean_square / norms.wedge);
}

BOOST_AUTO_TEST_CASE(what_is_not_a_number_shows_in_the_norms) {
  const Grid grid{12, 8, 0, 1.2, 0, 1.6};
  Random random(3);
  for (const bool cavitated : {false, true}) {
    Fields fields = random_fields(grid, random);
    fields.P(7, 4) = cavitated ? 0.0 : 0.5;
    Field r = random_field(grid, random, -1.0, 1.0);
    r(7, 4) = not_a_number;
    const auto norms =
        reynolds::residual_norms(grid, fields.state(), Wedge::upstream2, reynolds::Cavitation::nonnegative_pressure, r);
    BOOST_TEST(std::isnan(norms.root_mean_square));
    BOOST_TEST(std::isnan(norms.largest));
    BOOST_TEST((norms.i == 7 && norms.j == 4), "found at " << norms.i << ", " << norms.j);
  }
}

BOOST_AUTO_TEST_SUITE_END()
