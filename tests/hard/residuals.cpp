// High loads reach a residual of 1e-10 in few cycles, and the finer grids have the digits of the independent solutions.
#include <boost/test/unit_test.hpp>

#include "hard/hard_scene.hpp"
#include "steady/solve.hpp"

BOOST_AUTO_TEST_SUITE(test_hard_residuals)

using namespace ehl;

namespace {

// Both limits are about twice as large as on 256 x 256 cells with either wedge; more indicates a fault.
constexpr int most_cycles = 28;
constexpr double worst_factor = 0.4;

// Half a unit of the seventh decimal, the last one of the reference, plus 1e-6 relative.
double allowed(double reference) { return 1e-6 + 0.5e-7 / std::abs(reference); }

}  // namespace

BOOST_AUTO_TEST_CASE(residuals_fall_to_1e_10_by_the_first_start) {
  for (const hard::Load load : {hard::Load{50, 10}, {20, 20}, {200, 15}, {1000, 20}, {2000, 10}})
    for (const reynolds::Wedge wedge : {reynolds::Wedge::upstream1, reynolds::Wedge::upstream2}) {
      const steady::Scene scene = hard::scene(load, 256, wedge);
      const steady::Solution solution = steady::solve(scene);
      const steady::LevelRow& last = solution.levels.back();
      BOOST_TEST_MESSAGE(hard::name(scene)
                         << ": residual " << last.residual << " in " << last.cycles << " cycles (allowed "
                         << most_cycles << "), factor " << solution.cycle_factor << " (allowed " << worst_factor
                         << "); Hc " << last.Hc << ", Hm " << last.Hm << ", mass balance open by "
                         << solution.verification.flow_imbalance << " (allowed 1e-6)");
      BOOST_TEST_CONTEXT(hard::name(scene)) {
        BOOST_TEST(solution.converged, solution.failed_check);
        BOOST_TEST(solution.attempts.size() == 1U);
        BOOST_TEST(solution.method == "full multigrid");
        BOOST_TEST(last.residual <= 1e-10);
        BOOST_TEST(last.load_error <= 1e-10);
        BOOST_TEST(last.cycles <= most_cycles);
        BOOST_TEST(solution.cycle_factor <= worst_factor);
        // The mass balance of thin films, which the residual does not show.
        BOOST_TEST(std::abs(solution.verification.flow_imbalance) <= 1e-6);
      }
    }
}

// The coarser grids are tested in tests/convergence.
BOOST_AUTO_TEST_CASE(fine_grids_have_the_reference_digits) {
  for (const reference::CircularContact& contact : reference::circular_contacts) {
    if (contact.n != 512) continue;
    steady::Scene scene = test::scene_of(contact);
    scene.deformation.method = mlmi::Method::fft;
    scene.solver.tolerance = 1e-10;
    scene.threads = 2;
    const steady::Solution solution = steady::solve(scene);
    const steady::LevelRow& last = solution.levels.back();
    BOOST_TEST_MESSAGE(test::name_of(contact)
                       << ": Hc off by " << hard::relative(last.Hc, contact.Hc) << " (allowed " << allowed(contact.Hc)
                       << "), Hm by " << hard::relative(last.Hm, contact.Hm) << " (allowed " << allowed(contact.Hm)
                       << "), H00 by " << hard::relative(solution.H00, contact.H00) << "; residual " << last.residual
                       << " in " << last.cycles << " cycles, factor " << solution.cycle_factor);
    BOOST_TEST_CONTEXT(test::name_of(contact)) {
      BOOST_TEST(solution.converged, solution.failed_check);
      BOOST_TEST(last.residual <= 1e-10);
      BOOST_TEST(last.cycles <= 2 * most_cycles);
      BOOST_TEST(hard::relative(last.Hc, contact.Hc) <= allowed(contact.Hc));
      BOOST_TEST(hard::relative(last.Hm, contact.Hm) <= allowed(contact.Hm));
      BOOST_TEST(hard::relative(solution.H00, contact.H00) <= allowed(contact.H00));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
