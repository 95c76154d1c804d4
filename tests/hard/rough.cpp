// Surfaces at rest, up to twice as high as the film: the number of cycles, and the same solution by Newton's method.
#include <boost/test/unit_test.hpp>

#include "hard/hard_scene.hpp"
#include "steady/solve.hpp"
#include "surface/feature.hpp"

BOOST_AUTO_TEST_SUITE(test_hard_rough)

using namespace ehl;
using surface::Feature;
using Shape = Feature::Shape;

namespace {

struct Rough {
  hard::Load load;
  double film;  ///< central film of the smooth contact
};
constexpr Rough contacts[] = {{{50, 10}, 0.21}, {{200, 10}, 0.079}};

steady::Scene rough_scene(const Rough& contact, Shape shape, double films, int n) {
  steady::Scene scene = hard::scene(contact.load, n);
  scene.threads = 1;
  const Feature feature{.shape = shape, .height = films * contact.film, .width = 0.5, .front = false};
  scene.surface = [feature](const core::Patch& grid, core::Field& S) {
    S.fill(0.0);
    surface::add_cell_average(feature, grid, S);
  };
  return scene;
}

const char* name(Shape shape) {
  return shape == Shape::ridge ? "ridge" : shape == Shape::waviness ? "waves" : "dimple";
}

double pressure_at_centre(const steady::Solution& solution) {
  const core::Grid& grid = solution.grid;
  return solution.P(static_cast<int>(std::lround(-grid.X_a / grid.hx())), grid.ny / 2);
}

}  // namespace

// To the magnitude of the discretization error, a smooth contact needs two cycles on 256 cells. A ridge at the centre
// raises the pressure there, a dent lowers it.
BOOST_AUTO_TEST_CASE(cycles_with_waves_and_ridges_below_the_film) {
  for (const Rough& contact : contacts) {
    const double smooth = pressure_at_centre(steady::solve(hard::scene(contact.load, 256)));
    for (const Shape shape : {Shape::waviness, Shape::ridge, Shape::dimple})
      for (const double films : {0.1, 0.3}) {
        steady::Scene scene = rough_scene(contact, shape, films, 256);
        scene.solver.tolerance = std::numeric_limits<double>::quiet_NaN();
        const steady::Solution solution = steady::solve(scene);
        const double rise = pressure_at_centre(solution) - smooth;
        BOOST_TEST_MESSAGE(hard::name(scene)
                           << ", " << name(shape) << " of " << films << " films: " << solution.levels.back().cycles
                           << " cycles, " << solution.method << ", P at the centre changed by " << rise);
        BOOST_TEST(solution.converged, solution.failed_check);
        BOOST_TEST(solution.method == "full multigrid");
        BOOST_TEST(solution.levels.back().cycles <= 4);
        BOOST_TEST((shape == Shape::ridge ? rise : -rise) > 0.0);
      }
  }
}

BOOST_AUTO_TEST_CASE(higher_than_the_film_by_cycles_and_by_newton) {
  for (const Rough& contact : contacts)
    for (const Shape shape : {Shape::waviness, Shape::ridge}) {
      steady::Scene scene = rough_scene(contact, shape, 1.2, 128);
      scene.solver.tolerance = 1e-6;  // with waves this high, the cycles stall below this residual
      const steady::Solution solution = steady::solve(scene);
      scene.polish = steady::Polish::always;
      const steady::Solution newton = steady::solve(scene);
      BOOST_TEST(solution.converged, solution.failed_check);
      BOOST_TEST(newton.converged, newton.failed_check);
      BOOST_TEST(newton.verification.residual < 1e-10);
      BOOST_TEST(newton.newton.size() <= 8u);
      const double apart = hard::difference(solution, newton);
      BOOST_TEST_MESSAGE(hard::name(scene)
                         << ", " << name(shape) << ": " << solution.method << ", then residual "
                         << newton.verification.residual << ", load " << newton.verification.load_error << ", flow "
                         << newton.verification.flow_imbalance << " in " << newton.newton.size() << " steps; apart by "
                         << apart);
      BOOST_TEST(apart < 5e-5);  // the error of P at a residual of 1e-6
      BOOST_TEST(std::abs(newton.verification.flow_imbalance) < 1e-9);
    }
}

BOOST_AUTO_TEST_SUITE_END()
