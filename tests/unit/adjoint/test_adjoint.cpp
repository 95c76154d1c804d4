// The adjoint solutions of Hc and Hm, compared with contacts that are solved again with a disturbed right-hand side.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "adjoint/errors.hpp"
#include "adjoint/truncation.hpp"
#include "adjoint/weights.hpp"
#include "contact/groups.hpp"
#include "core/norms.hpp"
#include "judgement/measures.hpp"
#include "multigrid/full_multigrid.hpp"
#include "multigrid/start.hpp"
#include "newton/solve.hpp"
#include "steady/multigrid_solve.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_adjoint)

using namespace ehl;

namespace {

struct Case {
  std::string name;
  double M, L;
  core::Grid grid;
  reynolds::Wedge wedge;
  reynolds::Face face;
  bool far_field;
  double ratio = 1.0, angle = 0.0;
};

/// The deformation is computed by Fourier transforms, so K is symmetric to rounding.
multigrid::Run run_of(const Case& c, int first_cells) {
  steady::Scene scene = tests::roelands_scene(c.M, c.L, c.grid);
  const contact::Groups groups = contact::from_moes(c.M, c.L, contact::ellipse(c.ratio, c.angle));
  scene.lambda = groups.lambda;
  scene.contact = steady::scales_of(groups.M, groups.L, groups.shape);
  if (c.L == 0.0) {
    scene.viscosity = rheology::Isoviscous{};
    scene.density = rheology::Incompressible{};
  }
  scene.wedge = c.wedge;
  scene.face = c.face;
  scene.far_field = c.far_field;
  scene.deformation.method = mlmi::Method::fft;
  return steady::begin_multigrid(scene, {.cells = first_cells, .damping_at_first = 0.5}, {});
}

void solve(multigrid::Run& run, std::size_t l) {
  const newton::Result result = newton::solve(run.hierarchy, l);
  BOOST_TEST_REQUIRE(result.converged, result.reason);
}

struct Numbers {
  adjoint::Number Hc, Hm;
};
Numbers numbers_of(const multigrid::Level& level) {
  const core::Location least = core::minimum(level.H);
  return {judgement::weights_at(level.grid, 0.0, 0.0),
          judgement::weights_of_fitted_minimum(level.grid, level.H, least.i, least.j)};
}

struct Values {
  double Hc, Hm;
};
Values values_of(const multigrid::Level& level) {
  const core::Location least = core::minimum(level.H);
  return {judgement::value_at(level.grid, level.H, 0.0, 0.0),
          judgement::fitted_minimum(level.grid, level.H, least.i, least.j).value};
}

const Case cases[] = {
    {"circle", 20, 10, {128, 128, -3, 1.5, -2.25, 2.25}, reynolds::Wedge::upstream2, reynolds::Face::mean, false},
    {"circle, closed",
     20,
     10,
     {128, 128, -3, 1.5, -2.25, 2.25},
     reynolds::Wedge::upstream3,
     reynolds::Face::logmean_bounded,
     true},
    {"light, closed",
     2,
     0,
     {96, 128, -12, 6, -12, 12},
     reynolds::Wedge::upstream3,
     reynolds::Face::logmean_bounded,
     true},
    {"ellipse",
     20,
     10,
     {128, 128, -6, 3, -4.5, 4.5},
     reynolds::Wedge::upstream3,
     reynolds::Face::logmean_bounded,
     false,
     0.2,
     45.0},
    {"ellipse, closed",
     20,
     10,
     {128, 128, -6, 3, -4.5, 4.5},
     reynolds::Wedge::upstream2,
     reynolds::Face::mean,
     true,
     0.2,
     45.0},
};

}  // namespace

// Residuals of the Reynolds equation, in patches of the inlet, the contact and its sides, and a residual of the load.
BOOST_AUTO_TEST_CASE(weights_foretell_what_a_right_hand_side_changes) {
  for (const Case& c : cases) {
    multigrid::Run run = run_of(c, c.grid.nx);
    const std::size_t l = run.finest() - 1;
    multigrid::Hierarchy& hierarchy = run.hierarchy;
    multigrid::Level& level = hierarchy.levels[l];
    multigrid::start_from_hertz(hierarchy, l, run.plan.H00, 40);
    solve(run, l);
    const multigrid::State solution = multigrid::state_of(hierarchy, l);
    const Numbers numbers = numbers_of(level);
    adjoint::Adjoint adjoint(hierarchy, l);
    const auto Hc = adjoint.weights(numbers.Hc, 1e-9);
    const int iterations = adjoint.iterations();
    const auto Hm = adjoint.weights(numbers.Hm, 1e-9);
    BOOST_REQUIRE((Hc && Hm));
    BOOST_TEST_MESSAGE(c.name << ": " << iterations << " and " << adjoint.iterations() << " iterations");
    struct Bump {
      double X, Y, load;
    };
    for (const Bump& bump : {Bump{-1.1, 0.1, 0}, Bump{0.2, -0.3, 0}, Bump{0.4, -0.9, 0}, Bump{0, 0, 1}}) {
      constexpr double size = 2e-5;
      const auto shape = [&](int i, int j) {
        if (level.P(i, j) <= 0.0 || bump.load > 0.0) return 0.0;
        const double dX = level.grid.X(i) - bump.X;
        const double dY = level.grid.Y(j) - bump.Y;
        return size * std::exp(-8.0 * (dX * dX + dY * dY));
      };
      double predicted_Hc = 0.0, predicted_Hm = 0.0;
      core::Field f(level.grid);
      for (int i = 1; i < level.grid.nx; ++i)
        for (int j = 1; j <= level.grid.last_line(); ++j) {
          f(i, j) = shape(i, j);
          predicted_Hc -= Hc->residual(i, j) * f(i, j);
          predicted_Hm -= Hm->residual(i, j) * f(i, j);
        }
      predicted_Hc += Hc->load * size * bump.load;
      predicted_Hm += Hm->load * size * bump.load;
      double true_Hc = 0.0, true_Hm = 0.0;
      for (const double sign : {1.0, -1.0}) {
        multigrid::start_from_state(hierarchy, l, solution);
        for (int i = 1; i < level.grid.nx; ++i)
          for (int j = 1; j <= level.grid.last_line(); ++j) level.f(i, j) = sign * f(i, j);
        level.load += sign * size * bump.load;
        solve(run, l);
        const Values values = values_of(level);
        true_Hc += 0.5 * sign * values.Hc;
        true_Hm += 0.5 * sign * values.Hm;
      }
      multigrid::start_from_state(hierarchy, l, solution);
      BOOST_TEST_MESSAGE("  at (" << bump.X << ", " << bump.Y << "): Hc " << predicted_Hc << " true " << true_Hc
                                  << ", Hm " << predicted_Hm << " true " << true_Hm);
      BOOST_TEST(std::abs(predicted_Hc - true_Hc) <= 2e-4 * std::abs(true_Hc));
      BOOST_TEST(std::abs(predicted_Hm - true_Hm) <= 2e-4 * std::abs(true_Hm));
    }
  }
}

// From the solution of one grid, the adjoint predicts Hc and Hm of the grid with half as many
// cells, which is solved too.
BOOST_AUTO_TEST_CASE(truncation_times_weights_foretells_the_coarser_grid) {
  for (const Case& c : cases) {
    multigrid::Run run = run_of(c, c.grid.nx);
    const std::size_t fine = run.finest();
    multigrid::Hierarchy& hierarchy = run.hierarchy;
    multigrid::Level& level = hierarchy.levels[fine - 1];
    multigrid::full_multigrid(run);
    solve(run, fine);
    const Values fine_values = values_of(hierarchy.finest());
    const adjoint::Truncation parts = adjoint::truncation(hierarchy, fine - 1, fine);
    const Values injected = values_of(level);
    const core::Field P = level.P;
    core::Field r(level.grid);
    for (int i = 1; i < level.grid.nx; ++i)
      for (int j = 1; j <= level.grid.last_line(); ++j)
        r(i, j) = parts.poiseuille(i, j) + parts.wedge(i, j) + parts.film(i, j);
    const Numbers numbers = numbers_of(level);
    adjoint::Adjoint adjoint(hierarchy, fine - 1);
    const auto weights_Hc = adjoint.weights(numbers.Hc, 1e-6);
    const auto weights_Hm = adjoint.weights(numbers.Hm, 1e-6);
    solve(run, fine - 1);
    const Values coarse_values = values_of(level);
    const auto check = [&](const char* name, const std::optional<adjoint::Weights>& weights, double Values::*value,
                           double second_order) {
      BOOST_REQUIRE(weights);
      const double change = adjoint::left_over(*weights, r, P, parts.load);
      const double now = fine_values.*value;
      const double predicted = now - (injected.*value - change);
      const double changed = now - coarse_values.*value;
      BOOST_TEST_MESSAGE(c.name << ": " << name << " changes by " << changed / now << ", predicted "
                                << predicted / now);
      // The prediction is of first order. The remainder is quadratic in the change of pressure, which is
      // largest at a spike near Hm.
      BOOST_TEST(std::abs(predicted - changed) <= 0.04 * std::abs(changed) + second_order * now);
    };
    check("Hc", weights_Hc, &Values::Hc, 1e-4);
    check("Hm", weights_Hm, &Values::Hm, 5e-4);
  }
}

// The predicted algebraic errors of Hc and Hm after the default cycles, compared with the converged equations of the
// same grid. The prediction must not change the solution.
BOOST_AUTO_TEST_CASE(what_the_cycles_leave) {
  for (const Case& c : cases) {
    if (!reynolds::third_order(c.wedge)) continue;
    multigrid::Run run = run_of(c, c.grid.nx / 2);
    multigrid::full_multigrid(run);
    multigrid::Hierarchy& hierarchy = run.hierarchy;
    const Values left = values_of(hierarchy.finest());
    const core::Field P = hierarchy.finest().P, H = hierarchy.finest().H;
    const double H00 = hierarchy.H00;
    const std::optional<adjoint::Errors> errors = adjoint::errors(hierarchy, true);
    BOOST_REQUIRE(errors);
    BOOST_TEST(core::max_abs_difference(P, hierarchy.finest().P) == 0.0);
    BOOST_TEST(core::max_abs_difference(H, hierarchy.finest().H) == 0.0);
    BOOST_TEST(H00 == hierarchy.H00);
    // The error maps integrate to the parts of the error, except for one cell at the boundary.
    const auto integral = [&](const core::Field& map) {
      double sum = 0.0;
      for (int i = 0; i <= c.grid.nx; ++i)
        for (int j = 0; j <= c.grid.ny; ++j) sum += map(i, j) * c.grid.hx() * c.grid.hy();
      return sum;
    };
    for (const auto& [parts, map] : {std::pair(&errors->Hc, &errors->map_Hc), {&errors->Hm, &errors->map_Hm}}) {
      const double wanted = -parts->poiseuille / 3.0 - parts->wedge / 7.0;
      BOOST_TEST_MESSAGE(c.name << ": map " << integral(*map) << ", parts " << wanted);
      BOOST_TEST(std::abs(integral(*map) - wanted) <= 1e-3 * std::abs(wanted));
    }
    solve(run, run.finest());
    const Values solved = values_of(hierarchy.finest());
    const auto check = [&](const char* name, const adjoint::PredictedChange& predicted, double before, double after,
                           double by_change) {
      const double error = 1.0 - after / before;
      const double bound = by_change + std::abs(predicted.left) + 0.1 * predicted.scattered;
      BOOST_TEST_MESSAGE(c.name << ": " << name << " " << error << ", bound " << bound);
      BOOST_TEST(std::abs(error) <= bound);
    };
    check("Hc", errors->Hc, left.Hc, solved.Hc, run.record.verification.algebraic_error_Hc);
    check("Hm", errors->Hm, left.Hm, solved.Hm, run.record.verification.algebraic_error_Hm);
  }
}

BOOST_AUTO_TEST_SUITE_END()
