// Surfaces at rest in a steady contact, compared with contacts of known solution.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "contact/groups.hpp"
#include "contact/hertz.hpp"
#include "core/norms.hpp"
#include "steady/continuation.hpp"
#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_surface)

using namespace ehl;
using Path = steady::ContinuationParameters::Path;

namespace {

using Gap = double (*)(double X, double Y);

steady::Scene contact_scene(double M, double L, const core::Grid& grid) {
  steady::Scene scene = tests::roelands_scene(M, L, grid);
  scene.solver.tolerance = 1e-9;
  scene.deformation.method = mlmi::Method::fft;
  return scene;
}

template <class Function>
auto surface_of(Function gap) {
  return [gap](const core::Patch& grid, core::Field& S) {
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) S(i, j) = gap(grid.X(i), grid.Y(j));
  };
}

constexpr core::Grid square{64, 64, -2.5, 1.5, -2, 2};

double dent(double X, double Y) { return 0.05 * std::exp(-((X + 0.2) * (X + 0.2) + Y * Y) / 0.09); }
double dent_aside(double X, double Y) { return dent(X, Y - 0.3); }

/// A smooth contact with q times the curvature of (M, L), converted to the units of (M, L). R' = R/q: a' = a q^(-1/3),
/// p_h' = p_h q^(2/3), a'^2/R' = a^2/R q^(1/3); M' = M q^(5/4), L' = L q^(1/4).
struct Curved {
  double q;
  double length() const { return std::cbrt(q); }
  steady::Scene scene(double M, double L, core::Grid grid) const {
    for (double* bound : {&grid.X_a, &grid.X_b, &grid.Y_a, &grid.Y_b}) *bound *= length();
    return contact_scene(M * std::pow(q, 1.25), L * std::pow(q, 0.25), grid);
  }
};

double difference_of_P(const steady::Solution& a, const steady::Solution& b, double scale_of_b) {
  double largest = 0.0;
  for (int i = 0; i <= a.grid.nx; ++i)
    for (int j = 0; j <= a.grid.ny; ++j) largest = std::max(largest, std::abs(a.P(i, j) - scale_of_b * b.P(i, j)));
  return largest;
}

void compare_with_curved(steady::Scene (*change)(steady::Scene), const char* what, double tolerance) {
  for (const double q : {1.3, 0.8}) {
    const Curved curved{q};
    steady::Scene bent = contact_scene(50, 10, square);
    bent.surface = surface_of([q](double X, double Y) { return 0.5 * (q - 1.0) * (X * X + Y * Y); });
    const steady::Solution one = steady::solve(change(bent));
    const steady::Solution other = steady::solve(change(curved.scene(50, 10, square)));
    BOOST_TEST(one.converged, one.failed_check);
    BOOST_TEST(other.converged, other.failed_check);
    const double P = difference_of_P(one, other, std::pow(q, 2.0 / 3.0));
    const double Hc = std::abs(one.levels.back().Hc / (other.levels.back().Hc * curved.length()) - 1.0);
    const double Hm = std::abs(one.levels.back().Hm / (other.levels.back().Hm * curved.length()) - 1.0);
    BOOST_TEST_MESSAGE(what << ", curvature " << q << ": P apart by " << P << ", Hc by " << Hc << ", Hm by " << Hm
                            << " (tolerance " << tolerance << "); " << one.method);
    BOOST_TEST(P < tolerance);
    BOOST_TEST(Hc < tolerance);
    BOOST_TEST(Hm < tolerance);
    // The coarse grids belong to the same contact, and not to the smooth one.
    BOOST_REQUIRE(one.levels.size() == other.levels.size());
    for (std::size_t k = 0; k < one.levels.size(); ++k)
      BOOST_TEST(std::abs(one.levels[k].Hc / (other.levels[k].Hc * curved.length()) - 1.0) < 2e-3);
  }
}

}  // namespace

// S = (q - 1)(X^2 + Y^2)/2 gives a ball of another radius: the discrete problems are the same except for their units.
BOOST_AUTO_TEST_CASE(a_surface_that_is_a_ball_of_another_radius) {
  compare_with_curved(
      [](steady::Scene scene) {
        scene.grid.nx = scene.grid.ny = 128;
        return scene;
      },
      "full multigrid", 1e-7);
  compare_with_curved(
      [](steady::Scene scene) {
        scene.polish = steady::Polish::always;
        return scene;
      },
      "Newton after the cycles", 1e-9);
  compare_with_curved(
      [](steady::Scene scene) {
        scene.continuation.path = Path::load;
        return scene;
      },
      "load continuation", 1e-7);
}

// A constant S only shifts H00; a dent far wider than the contact does so approximately.
BOOST_AUTO_TEST_CASE(a_constant_moves_the_bodies_and_nothing_else) {
  const steady::Scene smooth = contact_scene(50, 10, square);
  steady::Scene shifted = smooth;
  shifted.surface = surface_of([](double, double) { return 0.7; });
  steady::Scene wide = smooth;
  wide.surface = surface_of([](double X, double Y) { return 0.7 * std::exp(-(X * X + Y * Y) / 1e4); });
  const steady::Solution a = steady::solve(smooth), b = steady::solve(shifted), c = steady::solve(wide);
  BOOST_TEST((a.converged && b.converged && c.converged));
  const double H = core::max_abs_difference(a.H, b.H), P = core::max_abs_difference(a.P, b.P);
  BOOST_TEST_MESSAGE("constant: H apart by " << H << ", P by " << P << ", H00 by " << b.H00 - a.H00
                                             << "; very wide dent: Hc " << c.levels.back().Hc / a.levels.back().Hc - 1);
  BOOST_TEST(H < 1e-8);
  BOOST_TEST(P < 1e-7);
  BOOST_TEST(std::abs(b.H00 - a.H00 + 0.7) < 1e-8);
  // The curvature of the dent is 1.4e-4 of the ball's curvature; Hc depends on it with a power of about 0.13.
  BOOST_TEST(std::abs(c.levels.back().Hc / a.levels.back().Hc - 1.0) < 2e-4);
  BOOST_TEST(std::abs(c.H00 - a.H00 + 0.7) < 1e-3);
}

BOOST_AUTO_TEST_CASE(a_dent_by_cycles_and_by_newton_is_the_same) {
  for (const auto gap : {dent, dent_aside}) {
    steady::Scene scene = contact_scene(50, 10, square);
    scene.surface = surface_of(gap);
    scene.use_symmetry = gap == dent;
    const steady::Solution cycles = steady::solve(scene);
    scene.polish = steady::Polish::always;
    const steady::Solution newton = steady::solve(scene);
    BOOST_TEST((cycles.converged && newton.converged));
    BOOST_TEST(!newton.newton.empty());
    const double P = core::max_abs_difference(cycles.P, newton.P), H = core::max_abs_difference(cycles.H, newton.H);
    const steady::Verification& checked = newton.verification;
    BOOST_TEST_MESSAGE("P apart by " << P << ", H by " << H << "; Newton: residual " << checked.residual << ", load "
                                     << checked.load_error << ", flow " << checked.flow_imbalance);
    BOOST_TEST(P < 1e-6);
    BOOST_TEST(H < 1e-7);
    BOOST_TEST(checked.residual < 1e-10);
    BOOST_TEST(checked.load_error < 1e-10);
    BOOST_TEST(std::abs(checked.flow_imbalance) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(half_and_whole_domain_with_a_dent) {
  steady::Scene scene = contact_scene(50, 10, square);
  scene.surface = surface_of(dent);
  const steady::Solution half = steady::solve(scene);
  scene.use_symmetry = false;
  const steady::Solution whole = steady::solve(scene);
  BOOST_TEST((half.converged && whole.converged));
  const double P = core::max_abs_difference(half.P, whole.P), H = core::max_abs_difference(half.H, whole.H);
  BOOST_TEST_MESSAGE("P apart by " << P << ", H by " << H << " (tolerance 1e-10)");
  BOOST_TEST(P < 1e-10);
  BOOST_TEST(H < 1e-10);
  // The dent has an influence: less on the film, whose flow along x it hardly changes, than on the pressure.
  scene.surface = {};
  const steady::Solution smooth = steady::solve(scene);
  BOOST_TEST(core::max_abs_difference(whole.H, smooth.H) > 2e-3);
  BOOST_TEST(core::max_abs_difference(whole.P, smooth.P) > 0.05);
}

// Under another load the bodies are the same: S in metres is unchanged at the same place in metres.
BOOST_AUTO_TEST_CASE(a_lighter_load_meets_the_same_surface) {
  steady::Scene scene = contact_scene(200, 10, square);
  scene.surface = surface_of(dent_aside);
  constexpr double R = 0.0125, E = 110e9, F = 15.0, share = 0.05;
  const contact::Hertz full = contact::hertz(F, R, E), light = contact::hertz(share * F, R, E);
  const steady::Scene under = steady::under_load(scene, share * scene.contact.M);
  core::Field S(square);
  under.surface(square, S);
  double worst = 0.0;
  for (int i = 0; i <= square.nx; ++i)
    for (int j = 0; j <= square.ny; ++j) {
      const double x = square.X(i) * light.a, y = square.Y(j) * light.a;
      worst = std::max(worst, std::abs(S(i, j) * light.h_scale - dent_aside(x / full.a, y / full.a) * full.h_scale));
    }
  BOOST_TEST_MESSAGE("largest difference " << worst << " m of " << 0.05 * full.h_scale);
  BOOST_TEST(worst < 1e-12 * full.h_scale);
}

BOOST_AUTO_TEST_SUITE_END()
