// A contact in time with the far field in closed form: the result must not depend on the size of the domain.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "unit/transient/marching.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_far_field)

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;
using Points = std::vector<Schedule::Point>;

namespace {

steady::Scene closed_scene(const core::Grid& grid) {
  steady::Scene scene = roelands_scene(20, 10, grid);
  scene.far_field = true;
  return scene;
}

constexpr core::Grid small{48, 48, -3.0, 1.5, -2.25, 2.25};
constexpr core::Grid large{96, 96, -6.0, 3.0, -4.5, 4.5};

}  // namespace

BOOST_AUTO_TEST_CASE(a_steady_contact_stays_where_it_is) {
  const Marched all = marched(closed_scene(small), {}, {.end = 20.0});
  BOOST_REQUIRE_MESSAGE((all.report.end == MarchEnd::end_time), all.report.reason);
  steady::Scene exact = closed_scene(small);
  exact.polish = steady::Polish::always;
  const steady::Solution steady = steady::solve(exact);
  const double Hc = largest_difference(all.rows, steady.levels.back().Hc, [](const StepRow& row) { return row.Hc; });
  BOOST_TEST_MESSAGE("Hc moves by " << Hc << " (allowed 1e-8), load by " << all.report.worst_load_error);
  BOOST_TEST(Hc <= 1e-8);
  BOOST_TEST(all.report.worst_load_error <= 1e-6);
}

// A load that rises by a half within half a time unit: the bodies approach, and oil is squeezed out of the gap outside
// the domain. With P = 0 on the boundary, as in the paper, the error would be several per cent.
BOOST_AUTO_TEST_CASE(half_of_the_domain_gives_the_same_film_while_the_load_rises) {
  const Conditions rises{.load = {.points = Points{{0.5, 1}, {1.0, 1.5}}}};
  const MarchParameters parameters{.end = 2.0, .rtol = 1e-5, .longest_step = 0.05, .output_interval = 0.25};
  const auto films = [&](steady::Scene scene, bool far_field) {
    scene.far_field = far_field;
    const Marched all = marched(scene, rises, parameters);
    BOOST_REQUIRE_MESSAGE((all.report.end == MarchEnd::end_time), all.report.reason);
    BOOST_TEST_MESSAGE(all.report.steps << " steps, " << all.report.cycles << " cycles, load off by "
                                        << all.report.worst_load_error);
    BOOST_TEST(all.report.worst_load_error <= 1e-6);
    std::vector<double> Hc;
    for (const Frame& frame : all.frames) {
      const int i = static_cast<int>(std::lround(-scene.grid.X_a / scene.grid.hx()));
      Hc.push_back(frame.H(i, scene.grid.ny / 2));
    }
    return Hc;
  };
  const std::vector<double> few = films(closed_scene(small), true);
  const std::vector<double> many = films(closed_scene(large), true);
  const std::vector<double> cut = films(closed_scene(small), false);
  BOOST_TEST_REQUIRE(few.size() == many.size());
  double closed = 0.0, zero = 0.0;
  for (std::size_t k = 0; k < few.size(); ++k) {
    closed = std::max(closed, std::abs(few[k] / many[k] - 1.0));
    zero = std::max(zero, std::abs(cut[k] / many[k] - 1.0));
  }
  BOOST_TEST_MESSAGE("half of the domain moves Hc by " << closed << " (allowed 0.003); without the far field by "
                                                       << zero);
  BOOST_TEST(closed < 0.003);
  BOOST_TEST(zero > 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
