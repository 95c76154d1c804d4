// Entrainment that changes its sign.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "core/norms.hpp"
#include "unit/transient/cycling.hpp"

BOOST_AUTO_TEST_SUITE(test_transient_reversal)

using namespace ehl;
using namespace ehl::tests;
using namespace ehl::transient;

namespace {

steady::Scene both_ways(int n) {
  steady::Scene scene = roelands_scene(50, 10, {n, n, -2.5, 2.5, -2.5, 2.5});
  scene.far_field = false;
  return scene;
}

core::Field mirrored(const core::Field& field) {
  core::Field image = field;
  const int nx = field.nodes_x() - 1;
  for (int i = 0; i <= nx; ++i)
    for (int j = 0; j < field.nodes_y(); ++j) image(i, j) = field(nx - i, j);
  return image;
}

/// Compares the frames of the last half period with those half a period before: they must be mirror images.
void check_mirrored(const char* what, const Marched& all, int frames_per_half, double allowed) {
  BOOST_REQUIRE_MESSAGE(all.report.end == MarchEnd::end_time, all.report.reason);
  double P = 0.0, H = 0.0, same = 0.0;
  const auto count = static_cast<int>(all.frames.size());
  for (int k = count - frames_per_half; k < count; ++k) {
    const Frame &now = all.frames[static_cast<std::size_t>(k)],
                &then = all.frames[static_cast<std::size_t>(k - frames_per_half)];
    P = std::max(P, core::max_abs_difference(now.P, mirrored(then.P)));
    H = std::max(H, core::max_abs_difference(now.H, mirrored(then.H)));
    same = std::max(same, core::max_abs_difference(now.P, then.P));
  }
  BOOST_TEST_MESSAGE(what << ": " << all.report.steps << " steps, " << all.report.rejected << " rejected, "
                          << all.report.not_solved
                          << " not solved; half a period later P differs from its mirror image "
                          << "by " << P << ", H by " << H << " (allowed " << allowed << ": of the order of rtol); "
                          << "without mirroring P differs by " << same);
  BOOST_TEST(P <= allowed);
  BOOST_TEST(H <= allowed);
  BOOST_TEST(same > 20.0 * allowed);
}

}  // namespace

// U = cos(2 pi T/p): after a first period the contact repeats mirrored after half a period.
BOOST_AUTO_TEST_CASE(a_symmetric_reversal_repeats_mirrored) {
  constexpr double period = 16.0, periods = 2.0;
  const MarchParameters parameters{.end = period * periods, .rtol = 1e-5, .output_interval = period / 8.0};
  const Conditions conditions = reciprocating(period, periods);
  check_mirrored("point", marched(both_ways(64), conditions, parameters), 4, 5e-4);
  const steady::Scene line = roelands_line(20, 5, core::line_grid(256, -4.5, 4.5));
  check_mirrored("line", marched(line, conditions, parameters), 4, 5e-4);
}

// While rigid cylinders with H = H_0 + X^2/2 do not move, only the squeeze carries the load: H_0' = -sqrt(2)
// H_0^(3/2)/lambda (test_line.cpp). A small speed adds pressure on one side and takes the same away on the other.
BOOST_AUTO_TEST_CASE(without_speed_only_the_squeeze_carries) {
  constexpr double period = 100.0;
  const steady::Scene scene = roelands_line(0.05, 0, core::line_grid(256, -240, 240));
  const Marched all = marched(scene, reciprocating(period, 1.0), {.end = 0.9 * period});
  BOOST_REQUIRE_MESSAGE(all.report.end == MarchEnd::end_time, all.report.reason);
  for (const double turn : {0.25 * period, 0.75 * period}) {
    const auto after = std::ranges::find_if(all.rows, [&](const StepRow& row) { return row.T > turn; });
    BOOST_TEST_REQUIRE((after - all.rows.begin() > 3 && all.rows.end() - after > 3));
    const StepRow &a = after[-2], &b = after[1];
    const double rate = (b.Hc - a.Hc) / (b.T - a.T), H = 0.5 * (a.Hc + b.Hc);
    const double error = rate / (-std::numbers::sqrt2 * std::pow(H, 1.5) / scene.lambda) - 1.0;
    BOOST_TEST_MESSAGE("U = 0 at T = " << turn << ": Hc = " << H << ", its rate " << rate
                                       << " is off the squeeze film's by " << error
                                       << " (allowed 0.02: elasticity, domain, and the distance of the steps)");
    BOOST_TEST(std::abs(error) <= 0.02);
  }
}

// The supplied layer arrives from the other side after each reversal; no oil comes from nowhere or gets lost. The first
// period begins with the steady film; the others repeat each other.
BOOST_AUTO_TEST_CASE(oil_is_conserved_through_the_reversals) {
  constexpr double period = 16.0, periods = 3.0;
  const auto check = [&](const char* what, const steady::Scene& scene, bool content, double repeats) {
    Conditions conditions = reciprocating(period, periods);
    conditions.conserves_mass = content;
    const Marched all = marched(scene, conditions, {.end = period * periods, .period = period});
    BOOST_REQUIRE_MESSAGE(all.report.end == MarchEnd::end_time, all.report.reason);
    double lost = 0.0, least = all.rows.front().oil.stored, most = 0.0;
    for (const StepRow& row : all.rows) {
      lost = std::max(lost, std::abs(row.oil.lost));
      if (row.T < period) continue;
      least = std::min(least, row.oil.stored);
      most = std::max(most, row.oil.stored);
    }
    BOOST_TEST_MESSAGE(what << ": " << all.report.steps << " steps, " << all.report.rejected << " rejected, "
                            << all.report.not_solved << " not solved; oil lost " << lost << " (allowed 1e-6), between "
                            << least << " and " << most << " after the first period; Hc and Hm change by "
                            << all.report.change_of_period << " from period to period (allowed " << repeats << ")");
    BOOST_TEST(lost <= 1e-6);
    BOOST_TEST(all.report.periods == 3);
    BOOST_TEST(all.report.change_of_period <= repeats);
  };
  steady::Scene starved = both_ways(48);
  starved.supply = [](double) { return 0.25; };
  check("point with a supplied layer", starved, false, 0.01);
  for (const int cells : {64, 128})
    check("flooded line", roelands_line(10, 5, core::line_grid(cells, -4.0, 4.0)), true, 0.01);
  steady::Scene line = roelands_line(10, 5, core::line_grid(128, -4.0, 4.0));
  line.supply = [](double) { return 0.2; };
  // The edge of a thin front passes single nodes, at other times in each period.
  check("line with a supplied layer", line, false, 0.1);
}

BOOST_AUTO_TEST_SUITE_END()
