// Lubricated contacts of coated bodies in the limits of thickness: a very thin coating is not felt, and a very thick
// one is a body of its material.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/norms.hpp"
#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_coated)

using namespace ehl;

namespace {

steady::Solution solved(steady::Scene scene) {
  scene.solver.tolerance = 1e-8;
  const steady::Solution solution = steady::solve(scene);
  BOOST_TEST(solution.converged, solution.failed_check);
  return solution;
}

// in: stiffness, the modulus of the scales over that of the bodies.
steady::Scene coated(steady::Scene scene, const kernel::Coating& coating, double stiffness) {
  scene.coatings.stiffness = stiffness;
  scene.coatings.parts = {kernel::SmoothPart(coating, contact::line(scene.contact.shape))};
  return scene;
}

void compare(const steady::Scene& scene, const char* what) {
  const steady::Solution uncoated = solved(scene);
  for (const double E : {0.1, 10.0}) {
    kernel::Coating c{{E, 0.2}, {1.0, 0.3}, 1e-7, 0.5};
    const steady::Solution thin = solved(coated(scene, c, 1.0));
    c.thickness = 1e6;
    const steady::Solution thick = solved(coated(scene, c, 1.0 / (1.0 + c.share * kernel::local_response(c))));
    for (const auto& [solution, limit] : {std::pair{&thin, "thin"}, {&thick, "thick"}}) {
      const double of_P = core::max_abs_difference(solution->P, uncoated.P);
      const double of_H = core::max_abs_difference(solution->H, uncoated.H);
      BOOST_TEST_MESSAGE(what << ", E " << E << ", " << limit << ": P differs by " << of_P << ", H by " << of_H
                              << " (tolerance 1e-5)");
      BOOST_TEST((of_P < 1e-5 && of_H < 1e-5));
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(points_have_the_limits_of_their_materials) {
  compare(tests::roelands_scene(20, 5, {64, 64, -4.5, 1.5, -3, 3}), "point");
}

BOOST_AUTO_TEST_CASE(lines_have_the_limits_of_their_materials) {
  compare(tests::roelands_line(20, 5, core::line_grid(256, -4.5, 1.5)), "line");
}

BOOST_AUTO_TEST_SUITE_END()
