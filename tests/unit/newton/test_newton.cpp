// Newton's method: exact Jacobian, quadratic convergence, the same solution as the cycles, and reported failures.
#include <unistd.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "judgement/measures.hpp"
#include "multigrid/cycle.hpp"
#include "multigrid/cycles.hpp"
#include "newton/equations.hpp"
#include "newton/gmres.hpp"
#include "newton/preconditioner.hpp"
#include "newton/solve.hpp"
#include "support/random.hpp"
#include "unit/newton/newton_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_newton)

using namespace ehl;
using judgement::Measures;
using namespace ehl::tests;

namespace {

constexpr core::Grid square(int n) { return {n, n, -2.5, 1.5, -2.0, 2.0}; }

/// The Hertz pressure with noise inside; low pressures and cavitated nodes mixed outside; no number is zero.
std::vector<double> mixed_unknowns(const newton::Equations& equations, Random& random) {
  std::vector<double> u(equations.size());
  const core::Patch& grid = equations.grid();
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j) {
      const double X = grid.X(i);
      const double Y = grid.Y(j);
      const double hertz = std::sqrt(std::max(0.0, 1.0 - X * X - Y * Y));
      const double outside = random.chance(0.4) ? -0.05 : random.between(0.005, 0.02);
      u[equations.index(i, j)] = hertz > 0.0 ? (0.1 + hertz) * random.between(0.9, 1.1) : outside;
    }
  u.back() = -0.6;
  return u;
}

double largest(const std::vector<double>& v) {
  double value = 0.0;
  for (const double x : v) value = std::max(value, std::abs(x));
  return value;
}

}  // namespace

BOOST_AUTO_TEST_CASE(jacobian_products_are_the_slope_of_the_residual) {
  Random random(5);
  using reynolds::Face, reynolds::Wedge;
  const std::optional<rheology::ShearThinning> newtonian;
  const std::optional<rheology::ShearThinning> eyring = rheology::ShearThinning{rheology::Eyring{}, 0.02};
  const std::tuple<Wedge, Face, std::optional<rheology::ShearThinning>, double> schemes[] = {
      {Wedge::upstream1, Face::mean, newtonian, 0.0},         {Wedge::upstream2, Face::mean, newtonian, 0.0},
      {Wedge::upstream3, Face::mean, newtonian, 0.0},         {Wedge::upstream2, Face::logmean, newtonian, 0.0},
      {Wedge::upstream3, Face::logmean, newtonian, 0.0},      {Wedge::upstream3_inlet, Face::logmean, eyring, 0.0},
      {Wedge::upstream3, Face::logmean_bounded, eyring, 0.0}, {Wedge::upstream1, Face::mean, newtonian, 0.5},
      {Wedge::upstream2, Face::mean, newtonian, 0.5},         {Wedge::upstream3, Face::mean, newtonian, 0.5},
      {Wedge::upstream3, Face::logmean_bounded, eyring, 0.5}};
  for (const auto& [wedge, face, thinning, supply] : schemes) {
    // hx != hy, so that a wrong factor is noticed.
    multigrid::Hierarchy hierarchy =
        newton_hierarchy(50, 10, core::Grid{32, 24, -3.0, 1.5, -2.0, 2.0}, 1, wedge, thinning, face, supply);
    const std::size_t l = hierarchy.levels.size() - 1;
    multigrid::start_from_hertz(hierarchy, l, -0.6, 0);
    newton::Equations equations(hierarchy, l);
    std::vector<double> scratch(equations.size());
    equations.unknowns(scratch);
    const std::vector<double> u = mixed_unknowns(equations, random);
    std::vector<double> v(u.size()), product(u.size()), ahead(u.size()), behind(u.size()), F(u.size());
    constexpr double step = 1e-6;
    for (const double share_of_H00 : {0.0, 1.0}) {
      for (double& x : v) x = random.between(-1.0, 1.0);
      v.back() *= share_of_H00;
      equations.residual(u, F);
      equations.linearize(u);
      equations.jacobian(v, product);
      std::vector<double> there = u;
      for (std::size_t k = 0; k < u.size(); ++k) there[k] = u[k] + step * v[k];
      equations.residual(there, ahead);
      for (std::size_t k = 0; k < u.size(); ++k) there[k] = u[k] - step * v[k];
      equations.residual(there, behind);
      double error = 0.0;
      for (std::size_t k = 0; k < u.size(); ++k)
        error = std::max(error, std::abs(product[k] - (ahead[k] - behind[k]) / (2.0 * step)));
      BOOST_TEST_MESSAGE("largest error " << error / largest(product) << " of the largest product (allowed 1e-7: "
                                          << "rounding of a difference over 1e-6)");
      BOOST_TEST(error <= 1e-7 * largest(product));
    }
  }
}

// The factors would be the exact inverse without the deformation beyond its self term, so GMRES needs few iterations.
BOOST_AUTO_TEST_CASE(preconditioner_solves_the_local_equations) {
  Random random(6);
  multigrid::Hierarchy hierarchy = newton_hierarchy(50, 10, square(32), 1);
  const std::size_t l = hierarchy.levels.size() - 1;
  multigrid::start_from_hertz(hierarchy, l, -0.6, 0);
  newton::Equations equations(hierarchy, l);
  std::vector<double> u(equations.size()), F(u.size());
  equations.unknowns(u);
  u = mixed_unknowns(equations, random);
  equations.residual(u, F);
  equations.linearize(u);
  newton::Preconditioner preconditioner(equations);
  BOOST_REQUIRE(preconditioner.factor());
  // A change of H00 alone causes no deformation. Its product with the exact Jacobian therefore equals that with the
  // local one, except in the load row, which does not contain H00.
  std::vector<double> v(u.size(), 0.0), product(u.size());
  v.back() = 0.01;
  equations.jacobian(v, product);
  preconditioner.solve(product);
  double error = std::abs(product.back() - 0.01);
  for (std::size_t k = 0; k + 1 < u.size(); ++k)
    if (equations.wet(k)) error = std::max(error, std::abs(product[k]));
  BOOST_TEST_MESSAGE("a change of H00 comes back with an error of " << error / 0.01 << " (allowed 1e-10)");
  BOOST_TEST(error <= 1e-10 * 0.01);
  // The load row contains no deformation either.
  for (double& x : v) x = random.between(-1.0, 1.0);
  const double asked = v.back();
  preconditioner.solve(v);
  equations.jacobian(v, product);
  BOOST_TEST_MESSAGE("the load row is met to " << std::abs(product.back() - asked) << " (allowed 1e-10)");
  BOOST_TEST(std::abs(product.back() - asked) <= 1e-10);
}

BOOST_AUTO_TEST_CASE(from_hertz_to_the_solution_of_the_cycles) {
  const core::Grid grid = square(64);
  multigrid::Hierarchy cycles = newton_hierarchy(200, 10, grid, 1);
  const std::size_t l = cycles.levels.size() - 1;
  multigrid::start_from_hertz(cycles, l, first_H00(200, 10), 20);
  Measures state = multigrid::measures_of(cycles, l);
  for (int cycle = 1; cycle <= 40 && !(state.residual < 1e-12 && state.load_error < 1e-12); ++cycle) {
    multigrid::fas_cycle(cycles, l);
    state = multigrid::measures_of(cycles, l);
  }
  BOOST_REQUIRE(state.residual < 1e-11);

  multigrid::Hierarchy alone = newton_hierarchy(200, 10, grid, 1);
  multigrid::start_from_hertz(alone, l, first_H00(200, 10), 0);
  const newton::Result result = newton::solve(alone, l);
  BOOST_TEST((result.converged && result.reason.empty()), result.reason);
  const double P_apart = core::max_abs_difference(alone.levels[l].P, cycles.levels[l].P);
  const double H_apart = core::max_abs_difference(alone.levels[l].H, cycles.levels[l].H);
  BOOST_TEST_MESSAGE("P " << P_apart << ", H " << H_apart << ", H00 " << std::abs(alone.H00 - cycles.H00)
                          << " away from the cycles' (allowed 1e-9), in " << result.steps.size() << " steps");
  BOOST_TEST(std::max({P_apart, H_apart, std::abs(alone.H00 - cycles.H00)}) <= 1e-9);

  // The final convergence is quadratic, down to the accuracy of the linear solutions, and thus faster than any cycle.
  double best = 1.0;
  for (std::size_t k = 1; k < result.steps.size(); ++k)
    best = std::min(best, result.steps[k].residual / result.steps[k - 1].residual);
  BOOST_TEST_MESSAGE("the best step leaves " << best << " of the residual (allowed 1e-3)");
  BOOST_TEST(best <= 1e-3);

  // A solution needs no step, and a slightly disturbed one needs few.
  BOOST_TEST(newton::solve(alone, l).steps.size() <= 1);
  multigrid::fas_cycle(alone, l);
  BOOST_TEST(newton::solve(alone, l).steps.size() <= 2);

  // Only the force balance is disturbed.
  alone.levels[l].load *= 1.0 + 1e-6;
  BOOST_TEST(newton::solve(alone, l).converged);
  BOOST_TEST(multigrid::measures_of(alone, l).load_error <= 1e-11);
}

BOOST_AUTO_TEST_CASE(failures_are_told) {
  const auto tells = [](const newton::Result& result, const char* word) {
    BOOST_TEST_MESSAGE(result.reason);
    BOOST_TEST((!result.converged && result.reason.find(word) != std::string::npos));
  };
  // A grid whose discrete film is negative has no meaningful solution.
  multigrid::Hierarchy coarse = newton_hierarchy(1000, 10, square(32), 1);
  multigrid::start_from_hertz(coarse, 0, first_H00(1000, 10), 0);
  const newton::Result negative = newton::solve(coarse, 0);
  tells(negative, "film");
  BOOST_TEST(negative.equations_met);
  // Without pressure, nothing depends on H00.
  multigrid::Hierarchy dry = newton_hierarchy(50, 10, square(32), 1);
  multigrid::start_from_hertz(dry, 0, first_H00(50, 10), 0);
  dry.levels[0].P.fill(0.0);
  tells(newton::solve(dry, 0), "no node carries pressure");
  dry.H00 = std::numeric_limits<double>::quiet_NaN();
  multigrid::start_from_hertz(dry, 0, dry.H00, 0);
  tells(newton::solve(dry, 0), "not finite");
  // Stopped early, after a step that increased the residual: the result is the best state so far with its film.
  multigrid::Hierarchy stopped = newton_hierarchy(20, 10, core::Grid{64, 64, -4.5, 1.5, -3.0, 3.0}, 1);
  const std::size_t l = stopped.levels.size() - 1;
  multigrid::start_from_hertz(stopped, l, first_H00(20, 10), 0);
  const newton::Result result = newton::solve(stopped, l, {.max_steps = 3, .tuning = {}});
  tells(result, "after 3 steps");
  BOOST_TEST(!result.equations_met);
  BOOST_REQUIRE(result.steps.size() == 3U);
  BOOST_REQUIRE(result.steps[1].residual < result.steps[2].residual);
  BOOST_TEST(multigrid::measures_of(stopped, l).residual == result.steps[1].residual);
  const core::Field H = stopped.levels[l].H;
  multigrid::update_film(stopped, stopped.levels[l]);
  BOOST_TEST(core::max_abs_difference(H, stopped.levels[l].H) == 0.0);
  // The user asks to stop.
  int calls = 0;
  BOOST_CHECK_THROW(newton::solve(stopped, l, {}, [&](const newton::Step&) { return ++calls < 2; }), core::Interrupted);
  BOOST_TEST(calls == 2);
  // A problem without a force balance is a different one.
  multigrid::Problem without_load = stopped.problem;
  without_load.load.reset();
  multigrid::Hierarchy other = multigrid::make_hierarchy(without_load, {}, {}, stopped.finest().grid, 1);
  BOOST_CHECK_THROW(newton::solve(other, l), core::InputError);
}

BOOST_AUTO_TEST_CASE(same_bits_with_one_and_two_threads) {
  std::vector<core::Field> P;
  for (const int threads : {1, 2}) {
    multigrid::Hierarchy hierarchy = newton_hierarchy(200, 10, square(128), threads);
    const std::size_t l = hierarchy.levels.size() - 1;
    multigrid::start_from_hertz(hierarchy, l, first_H00(200, 10), 0);
    const newton::Result result = newton::solve(hierarchy, l, {.max_steps = 3, .tuning = {}});
    BOOST_TEST(result.steps.size() == 3U);
    P.push_back(hierarchy.levels[l].P);
  }
  BOOST_TEST(core::max_abs(P[0]) > 0.9);
  BOOST_TEST(core::max_abs_difference(P[0], P[1]) == 0.0);
}

namespace {

/// The derivative of u_k^2 at u.
newton::LinearSystem slope_of_squares(const std::vector<double>& u) {
  return {[&u](std::span<const double> v, std::span<double> Av) {
            for (std::size_t k = 0; k < v.size(); ++k) Av[k] = 2.0 * u[k] * v[k];
          },
          [](std::span<double>) {}};
}

/// The number of bytes that a function writes to standard error.
long bytes_on_stderr(const std::function<void()>& function) {
  std::FILE* file = std::tmpfile();
  std::fflush(stderr);
  const int kept = dup(STDERR_FILENO);
  dup2(fileno(file), STDERR_FILENO);
  function();
  std::fflush(stderr);
  dup2(kept, STDERR_FILENO);
  close(kept);
  const long bytes = static_cast<long>(lseek(fileno(file), 0, SEEK_END));
  std::fclose(file);
  return bytes;
}

}  // namespace

BOOST_AUTO_TEST_CASE(gmres_takes_newton_steps_and_keeps_quiet) {
  std::vector<double> u{1.0, 1.5, 2.0}, minus_F(3), d(3);
  const newton::LinearSystem system = slope_of_squares(u);
  for (int step = 0; step < 6; ++step) {
    for (std::size_t k = 0; k < u.size(); ++k) minus_F[k] = static_cast<double>(k + 1) - u[k] * u[k];
    newton::gmres(system, minus_F, 1e-12, d);
    // Heron's method is this Newton step in closed form.
    for (std::size_t k = 0; k < u.size(); ++k) {
      const double heron = 0.5 * (u[k] + static_cast<double>(k + 1) / u[k]);
      u[k] += d[k];
      BOOST_TEST(std::abs(u[k] - heron) < 1e-11);
    }
  }
  for (std::size_t k = 0; k < u.size(); ++k) BOOST_TEST(std::abs(u[k] - std::sqrt(static_cast<double>(k + 1))) < 1e-14);

  u = {1.0, 1.5, 2.0};
  const std::vector<double> b{1.0, -1.0, 0.5};
  const auto quietly = [&](const newton::LinearSystem& some) {
    newton::GmresResult result;
    BOOST_TEST(bytes_on_stderr([&] { result = newton::gmres(some, b, 1e-10, d); }) == 0);
    return result;
  };
  const newton::GmresResult solved = quietly(system);
  BOOST_TEST((solved.reduced && solved.iterations == 3));  // three eigenvalues
  newton::LinearSystem exact = system;
  exact.precondition = [&](std::span<double> v) {
    for (std::size_t k = 0; k < v.size(); ++k) v[k] /= 2.0 * u[k];
  };
  BOOST_TEST(quietly(exact).iterations == 1);
  newton::LinearSystem flat = system;
  flat.product = [](std::span<const double>, std::span<double> Av) { std::ranges::fill(Av, 0.0); };
  BOOST_TEST(!quietly(flat).reduced);
  newton::LinearSystem throwing = system;
  throwing.product = [](std::span<const double>, std::span<double>) { throw std::runtime_error("mine"); };
  BOOST_CHECK_THROW(newton::gmres(throwing, b, 1e-10, d), std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
