// Newton's method started from the Hertz pressure, compared with fully converged solutions of an independent program.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

#include "contact/film_formulas.hpp"
#include "convergence/circular_scene.hpp"
#include "core/norms.hpp"
#include "judgement/measures.hpp"
#include "multigrid/cycles.hpp"
#include "multigrid/start.hpp"
#include "newton/solve.hpp"

BOOST_AUTO_TEST_SUITE(test_newton_reference)

using namespace ehl;

namespace {

double relative(double value, double reference) { return std::abs(value / reference - 1.0); }

/// 1e-6 relative, plus half a unit of the seventh decimal, the last one that the reference gives.
double allowed(double reference) { return 1e-6 + 0.5e-7 / std::abs(reference); }

}  // namespace

BOOST_AUTO_TEST_CASE(newton_from_hertz_gives_the_reference_digits) {
  for (const reference::CircularContact& contact : reference::circular_contacts) {
    if (contact.n > 128) continue;
    const steady::Scene scene = test::scene_of(contact);
    const multigrid::Problem problem{
        .film = {.lambda = scene.lambda, .viscosity = scene.viscosity, .density = scene.density},
        .transport = scene.wedge};
    mlmi::Parameters deformation;
    deformation.method = mlmi::Method::fft;
    multigrid::Hierarchy hierarchy = multigrid::make_hierarchy(problem, {}, deformation, scene.grid, 1);
    const std::size_t l = hierarchy.levels.size() - 1;
    const double film = contact::H_from_moes_units(contact::nijenbanning_venner_moes(scene.contact.M, scene.contact.L),
                                                   scene.contact.M);
    multigrid::start_from_hertz(hierarchy, l, -1.0 + film, 0);
    const newton::Result result = newton::solve(hierarchy, l);
    const judgement::Measures state = multigrid::measures_of(hierarchy, l);
    BOOST_TEST_MESSAGE(test::name_of(contact)
                       << ": Hc off by " << relative(state.Hc, contact.Hc) << ", Hm by "
                       << relative(state.Hm, contact.Hm) << ", H00 by " << relative(hierarchy.H00, contact.H00)
                       << " (allowed 1e-6 and the rounding of the reference); residual " << state.residual << " in "
                       << result.steps.size() << " steps");
    BOOST_TEST_CONTEXT(test::name_of(contact)) {
      BOOST_TEST(result.converged);
      BOOST_TEST(result.reason == "");
      BOOST_TEST(state.residual <= 1e-11);
      BOOST_TEST(state.load_error <= 1e-11);
      BOOST_TEST(relative(state.Hc, contact.Hc) <= allowed(contact.Hc));
      BOOST_TEST(relative(state.Hm, contact.Hm) <= allowed(contact.Hm));
      BOOST_TEST(relative(hierarchy.H00, contact.H00) <= allowed(contact.H00));
      BOOST_TEST(relative(core::max_abs(hierarchy.levels[l].P), contact.P_max) <= 1e-5);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
