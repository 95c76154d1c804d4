// A shear-thinning oil in time: the thinning follows the speed of sliding.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "unit/transient/marching.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_thinning)

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;
using Points = std::vector<Schedule::Point>;

namespace {

/// k of the law where the surfaces slide at u_m: the stress of a Newtonian oil would be this many times tau_c at H = 1
/// and ambient pressure. The film of M = 50, L = 10 then becomes some per cent thinner between rolling and |u1 - u2| =
/// u_m.
constexpr double k_of_u_m = 0.1;

steady::Scene scene_with(const rheology::ShearLaw& law, double sliding, bool line = false) {
  steady::Scene scene = line ? roelands_line(20.0, 5.0, core::line_grid(128, -4.5, 1.5)) : marching_scene(32);
  scene.thinning = rheology::ShearThinning{law, sliding * k_of_u_m};
  scene.solver.tolerance = 1e-10;
  return scene;
}

double film_of(const rheology::ShearLaw& law, double sliding) {
  const steady::Solution solution = steady::solve(scene_with(law, sliding));
  BOOST_REQUIRE(solution.converged);
  return solution.levels.back().Hc;
}

/// Both speeds with the mean u_m.
Conditions sliding(const Points& over_u_m) {
  Conditions conditions{.thinning_k = k_of_u_m};
  for (const Schedule::Point& at : over_u_m) {
    conditions.u1.points.push_back({at.T, 1.0 + 0.5 * at.value});
    conditions.u2.points.push_back({at.T, 1.0 - 0.5 * at.value});
  }
  return conditions;
}

const rheology::ShearLaw eyring = rheology::Eyring{}, carreau = rheology::Carreau{0.46};

}  // namespace

BOOST_AUTO_TEST_CASE(a_steady_contact_that_slides_stays_where_it_is) {
  for (const auto& law : {eyring, carreau}) {
    const steady::Scene scene = scene_with(law, 0.5);
    const Marched all = marched(scene, sliding({{0.0, 0.5}}), {.end = 3.0});
    BOOST_REQUIRE((all.report.end == MarchEnd::end_time));
    const double Hc = film_of(law, 0.5);
    const double moved = largest_difference(all.rows, Hc, [](const StepRow& row) { return row.Hc; });
    BOOST_TEST_MESSAGE("Hc " << Hc << ", without thinning " << film_of(law, 0.0) << ": moves by " << moved
                             << " (allowed 1e-7)");
    BOOST_TEST(moved <= 1e-7);
    BOOST_TEST(Hc < 0.97 * film_of(law, 0.0));
  }
}

// The scene is solved without sliding, so the sliding of every step comes from the conditions. Sliding that reverses
// its direction thins by its magnitude.
BOOST_AUTO_TEST_CASE(a_slow_change_of_sliding_passes_through_the_steady_films) {
  for (const auto& law : {eyring, carreau}) {
    const double end = 400.0;
    const Marched all = marched(scene_with(law, 0.0), sliding({{0.0, 0.0}, {end, -1.0}}), {.end = end});
    BOOST_REQUIRE((all.report.end == MarchEnd::end_time));
    // The film follows the sliding by the time that the oil takes through the contact.
    const double lag = 2.0;
    for (const double share : {0.25, 0.5, 1.0}) {
      const auto row = std::ranges::find_if(all.rows, [&](const StepRow& one) { return one.T >= share * end - 1e-9; });
      const double slides = row->T / end;
      const double steady = film_of(law, slides), slope = (steady - film_of(law, slides - 0.05)) / (0.05 * end);
      const double error = row->Hc / steady - 1.0;
      const double allowed = std::abs(lag * slope / steady) + 1e-5;
      BOOST_TEST_MESSAGE("sliding " << slides << ": Hc " << row->Hc << ", steady " << steady << ", apart by " << error
                                    << " (allowed " << allowed << ")");
      BOOST_TEST(std::abs(error) <= allowed);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_jump_of_sliding_ends_at_the_steady_film) {
  const Marched all = marched(scene_with(eyring, 0.0), sliding({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}), {.end = 12.0});
  BOOST_REQUIRE((all.report.end == MarchEnd::end_time));
  const double steady = film_of(eyring, 1.0), error = all.rows.back().Hc / steady - 1.0;
  BOOST_TEST_MESSAGE("Hc " << all.rows.back().Hc << ", steady " << steady << ": apart by " << error
                           << " (allowed 1e-4), " << all.report.steps << " steps");
  BOOST_TEST(std::abs(error) <= 1e-4);
}

// Newton's method solves the steps of this line contact from its first failure of the cycles on; its Jacobian contains
// the thinning.
BOOST_AUTO_TEST_CASE(a_line_contact_follows_too) {
  const Marched all = marched(scene_with(eyring, 0.0, true), sliding({{0.0, 0.0}, {4.0, 1.0}}), {.end = 14.0});
  BOOST_REQUIRE((all.report.end == MarchEnd::end_time));
  const steady::Solution solution = steady::solve(scene_with(eyring, 1.0, true));
  BOOST_REQUIRE(solution.converged);
  const double steady = solution.levels.back().Hc, error = all.rows.back().Hc / steady - 1.0;
  BOOST_TEST_MESSAGE("line: Hc " << all.rows.front().Hc << " to " << all.rows.back().Hc << ", steady " << steady
                                 << ": apart by " << error << " (allowed 1e-4)");
  BOOST_TEST(std::abs(error) <= 1e-4);
  BOOST_TEST(steady < 0.9 * all.rows.front().Hc);
}

BOOST_AUTO_TEST_SUITE_END()
