// Contacts with a shear-thinning oil: their equation evaluated directly, Newton's Jacobian, the Newtonian limit.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "core/norms.hpp"
#include "newton/equations.hpp"
#include "steady/continuation.hpp"
#include "steady/solve.hpp"
#include "support/random.hpp"
#include "support/roelands_scene.hpp"
#include "unit/newton/newton_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_shear)

using namespace ehl;
using rheology::ShearThinning;

namespace {

/// Strong thinning: in the contact, eta times the rate is up to 1e3 times the characteristic stress of the law.
const std::vector<ShearThinning> thinnings{{rheology::Eyring{}, 5e-3}, {rheology::Carreau{0.46}, 5e-3}};

steady::Scene scene_of(double M, double L, int n) {
  // The cells are not square, so that a wrong factor is noticed.
  steady::Scene scene = tests::roelands_scene(M, L, {n, n, -2.5, 1.5, -2.5, 2.5});
  scene.solver.tolerance = 1e-9;
  return scene;
}

struct Epsilons {
  core::Field along, across, rho_bar;
};

// rho_bar H^3/(eta lambda) with the effective eta of the law, point by point.
Epsilons plain_epsilons(const steady::Scene& scene, const steady::Solution& solution) {
  Epsilons eps{core::Field(scene.grid), core::Field(scene.grid), core::Field(scene.grid)};
  const auto nodes = static_cast<std::size_t>(scene.grid.nodes_y());
  std::vector<double> ln_eta(nodes);
  for (int i = 0; i <= scene.grid.nx; ++i) {
    rheology::log_viscosity(scene.viscosity, solution.P.station(i), ln_eta);
    rheology::density(scene.density, solution.P.station(i), eps.rho_bar.station(i));
    for (int j = 0; j <= scene.grid.ny; ++j) {
      const double H = solution.H(i, j), eta = std::exp(ln_eta[static_cast<std::size_t>(j)]);
      const rheology::Thinned ratio = rheology::thinned(scene.thinning->law, scene.thinning->k * eta / H);
      const double newtonian = eps.rho_bar(i, j) * H * H * H / (eta * scene.lambda);
      eps.along(i, j) = newtonian / ratio.along;
      eps.across(i, j) = newtonian / ratio.across;
    }
  }
  return eps;
}

// The root mean square of eq. (4) over the wet interior, relative to that of the wedge.
double plain_residual(const steady::Scene& scene, const steady::Solution& solution) {
  const Epsilons eps = plain_epsilons(scene, solution);
  const double hx = scene.grid.hx(), hy = scene.grid.hy();
  const core::Field& P = solution.P;
  double sum = 0.0, scale = 0.0;
  for (int i = 2; i < scene.grid.nx; ++i)
    for (int j = 1; j < scene.grid.ny; ++j) {
      if (P(i, j) <= 0.0) continue;
      const auto q = [&](int k) { return eps.rho_bar(k, j) * solution.H(k, j); };
      const double wedge = (1.5 * q(i) - 2.0 * q(i - 1) + 0.5 * q(i - 2)) / hx;
      const auto flux_x = [&](int a, int b) { return 0.5 * (eps.along(a, j) + eps.along(b, j)) * (P(b, j) - P(a, j)); };
      const auto flux_y = [&](int a, int b) {
        return 0.5 * (eps.across(i, a) + eps.across(i, b)) * (P(i, b) - P(i, a));
      };
      const double r =
          (flux_x(i, i + 1) - flux_x(i - 1, i)) / (hx * hx) + (flux_y(j, j + 1) - flux_y(j - 1, j)) / (hy * hy) - wedge;
      sum += r * r;
      scale += wedge * wedge;
    }
  return std::sqrt(sum / scale);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_solution_meets_the_equation_written_out) {
  for (const ShearThinning& thinning : thinnings) {
    steady::Scene scene = scene_of(50, 10, 64);
    scene.thinning = thinning;
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST(solution.converged);
    const double residual = plain_residual(scene, solution);
    BOOST_TEST_MESSAGE("law " << thinning.law.index() << ": Hc " << solution.levels.back().Hc << ", residual "
                              << residual << " (tolerance 1e-7: the solver's 1e-9 and the exponentials' rounding)");
    BOOST_TEST(residual < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(jacobian_products_are_the_slope_of_the_residual) {
  tests::Random random(5);
  // Also on a mirrored grid with its image lines.
  constexpr core::Grid whole{32, 24, -3.0, 1.5, -2.0, 2.0};
  for (const core::Patch& grid : {core::Patch(whole), core::lower_half(whole)})
    for (const ShearThinning& thinning : thinnings) {
      multigrid::Hierarchy hierarchy = tests::newton_hierarchy(50, 10, grid, 1, reynolds::Wedge::upstream2, thinning);
      const std::size_t l = hierarchy.levels.size() - 1;
      multigrid::start_from_hertz(hierarchy, l, -0.6, 0);
      newton::Equations equations(hierarchy, l);
      std::vector<double> u(equations.size()), v(u.size()), product(u.size()), ahead(u.size()), behind(u.size());
      equations.unknowns(u);
      for (double& x : u) x = x > 0.0 ? x + random.between(0.1, 0.2) : -0.05;
      u.back() = -0.6;
      for (double& x : v) x = random.between(-1.0, 1.0);
      equations.residual(u, ahead);
      equations.linearize(u);
      equations.jacobian(v, product);
      constexpr double step = 1e-6;
      std::vector<double> there = u;
      for (std::size_t k = 0; k < u.size(); ++k) there[k] = u[k] + step * v[k];
      equations.residual(there, ahead);
      for (std::size_t k = 0; k < u.size(); ++k) there[k] = u[k] - step * v[k];
      equations.residual(there, behind);
      double error = 0.0, largest = 0.0;
      for (std::size_t k = 0; k < u.size(); ++k) {
        error = std::max(error, std::abs(product[k] - (ahead[k] - behind[k]) / (2.0 * step)));
        largest = std::max(largest, std::abs(product[k]));
      }
      BOOST_TEST_MESSAGE("law " << thinning.law.index() << ": largest error " << error / largest
                                << " of the largest product (allowed 1e-7: rounding of a difference over 1e-6)");
      BOOST_TEST(error <= 1e-7 * largest);
    }
}

// From the solution of the cycles, few Newton steps with few inner iterations reach rounding, because the
// preconditioner contains both epsilons. The half domain and the whole domain agree.
BOOST_AUTO_TEST_CASE(newton_on_the_half_and_on_the_whole) {
  steady::Scene scene = scene_of(100, 10, 64);
  scene.thinning = thinnings[0];
  scene.polish = steady::Polish::always;
  scene.solver.tolerance = 1e-2;  // leaves some work for Newton's method
  const steady::Solution half = steady::solve(scene);
  scene.use_symmetry = false;
  const steady::Solution whole = steady::solve(scene);
  BOOST_TEST((half.converged && whole.converged));
  const double P = core::max_abs_difference(half.P, whole.P), H = core::max_abs_difference(half.H, whole.H);
  BOOST_TEST_MESSAGE("half against whole: P " << P << ", H " << H << " (tolerance 1e-10)");
  BOOST_TEST((P < 1e-10 && H < 1e-10));
  BOOST_REQUIRE(!half.newton.empty());
  int most = 0;
  for (const newton::Step& step : half.newton) most = std::max(most, step.linear_iterations);
  BOOST_TEST_MESSAGE(half.newton.size() << " Newton steps to " << half.newton.back().residual << ", at most " << most
                                        << " inner iterations (allowed 4, 1e-11 and 30)");
  BOOST_TEST((half.newton.size() <= 4u && half.newton.back().residual < 1e-11 && most <= 30));
}

// For a very large characteristic stress the law is Newtonian, and a load continuation keeps the sliding speed.
BOOST_AUTO_TEST_CASE(the_newtonian_limit_and_continuation) {
  steady::Scene scene = scene_of(100, 10, 64);
  scene.polish = steady::Polish::always;  // down to rounding
  const steady::Solution newtonian = steady::solve(scene);
  for (const ShearThinning& thinning : thinnings) {
    scene.thinning = ShearThinning{thinning.law, 1e-20};
    const steady::Solution limit = steady::solve(scene);
    const double P = core::max_abs_difference(newtonian.P, limit.P), H = core::max_abs_difference(newtonian.H, limit.H);
    BOOST_TEST_MESSAGE("law " << thinning.law.index() << ": away from Newtonian by P " << P << ", H " << H
                              << " (tolerance 1e-9: Newton's 1e-11 times the condition)");
    BOOST_TEST((P < 1e-9 && H < 1e-9));
  }
  scene.thinning = thinnings[0];
  const steady::Solution direct = steady::solve(scene);
  scene.continuation.path = steady::ContinuationParameters::Path::load;
  const steady::Solution led = steady::solve(scene);
  const double H = core::max_abs_difference(direct.H, led.H);
  BOOST_TEST_MESSAGE("load continuation against the direct way: H " << H << " (tolerance 1e-8)");
  BOOST_TEST((led.converged && H < 1e-8));
  // For eight times the load, p_h and a are doubled, and k changes with 1/a^2.
  BOOST_TEST(std::abs(steady::under_load(scene, 8.0 * scene.contact.M).thinning->k / scene.thinning->k - 0.25) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
