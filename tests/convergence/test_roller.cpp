// Rollers of finite length compared with the line contact, Lundberg's theory, and a strip with linearly varying load.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "contact/groups.hpp"
#include "effects/roller/distribution.hpp"
#include "effects/roller/scene.hpp"
#include "steady/solve.hpp"

BOOST_AUTO_TEST_SUITE(test_roller)

namespace {

using namespace ehl;
using roller::Profile;

constexpr double alpha = 2.2e-8;

steady::Scene scene_of(double M, double L, int cells, const contact::Ellipse& shape) {
  steady::Scene scene;
  scene.contact = steady::scales_of(M, L, shape);
  const contact::Groups groups = contact::from_moes(M, L, shape);
  scene.lambda = groups.lambda;
  const double p_h = groups.alpha_bar / alpha;
  scene.viscosity = rheology::make_roelands(alpha, rheology::roelands_p0, 0.68, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  scene.wedge = reynolds::Wedge::upstream3;
  scene.face = reynolds::Face::logmean_bounded;
  scene.far_field = false;
  scene.adjoint_errors = false;
  scene.grid = core::line_grid(cells, -4.5, 1.5);
  return scene;
}

/// A roller on cells that are twice as long in Y.
steady::Scene roller_scene(double M, double L, int cells, const Profile& profile) {
  steady::Scene scene = scene_of(M, L, cells, contact::roller_contact(profile.length));
  const double half = 0.5 * profile.length;
  const int coarsest_pairs = static_cast<int>(std::lround(profile.length / 6.0 * 32.0 / 4.0));
  scene.grid = {
      .nx = cells, .ny = 2 * coarsest_pairs * (cells / 32), .X_a = -4.5, .X_b = 1.5, .Y_a = -half, .Y_b = half};
  roller::lay(profile, scene);
  return scene;
}

roller::Distribution dry_roller(int cells, const Profile& profile) {
  const steady::Scene scene = roller_scene(20.0, 5.0, cells, profile);
  dry::Problem problem = roller::dry_problem(scene, scene.grid);
  problem.parameters.tolerance = 1e-7;
  const dry::Solution solution = dry::solve(problem);
  BOOST_TEST(solution.rows.back().error <= 1e-7);
  return roller::distribution(solution.grid, solution.P, solution.H);
}

const roller::Slice& slice_at(const roller::Distribution& found, double Y) {
  return *std::ranges::min_element(found.slices, {}, [=](const roller::Slice& one) { return std::abs(one.Y - Y); });
}

// Under its design load, a logarithmic profile gives a uniform load except at the ends, with the Hertz pressure of the
// line contact. Kernel, load and profile have independent derivations.
BOOST_AUTO_TEST_CASE(lundbergs_profile_carries_its_design_load_evenly) {
  const double length = 40.0;
  const roller::Distribution found = dry_roller(128, {.length = length});
  for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 0.9}) {
    const roller::Slice& slice = slice_at(found, 0.5 * share * length);
    BOOST_TEST_MESSAGE("at " << share << ": load " << slice.load << ", P " << slice.P_max);
    BOOST_TEST(std::abs(slice.load - 1.0) < 0.02);
    BOOST_TEST(std::abs(slice.P_max - 1.0) < (share < 0.85 ? 0.01 : 0.025));  // it falls near the end
  }
}

// A strip (-l/2, l/2) with the load q = 1 + q_1 Y per length over the local Hertz width is displaced on its axis by
//   q [1/4 + ln(2)/2 + (1/4) ln(l^2 - 4 Y^2)] - (1/4) q ln q - q_1 Y/2.
// A tilt of the uniformly loaded roller therefore gives q_1 = -tilt/C, where C is the factor of q_1 Y. Its mean with
// the weight Y^2 is C = ln(2)/2 - 1/2 + ln(l)/2 - 0.32009, and the resultant acts at q_1 l^2/12.
BOOST_AUTO_TEST_CASE(a_small_tilt_moves_the_load_as_the_strip_of_linear_load) {
  const double length = 60.0, tilt = 0.002;
  const double C = 0.5 * std::numbers::ln2 - 0.5 + 0.5 * std::log(length) - 0.32009;
  const double expected = -tilt / C * length * length / 12.0;
  const roller::Distribution up = dry_roller(128, {.length = length, .tilt = tilt});
  const roller::Distribution twice = dry_roller(128, {.length = length, .tilt = 2.0 * tilt});
  BOOST_TEST_MESSAGE("resultant at " << up.load_centre << ", " << twice.load_centre << "; strip " << expected);
  BOOST_TEST(std::abs(up.load_centre / expected - 1.0) < 0.05);
  BOOST_TEST(std::abs(twice.load_centre / up.load_centre / 2.0 - 1.0) < 0.02);
}

// A crowned roller that carries its load within its length is a Hertzian ellipse. With F = F' length, the
// circle has a_c^3 = (3 pi/16) length in a^3, and p_c = (3/4) length/a_c^2 in p_h. A tilt moves the circle
// by -tilt times its radius.
BOOST_AUTO_TEST_CASE(a_crowned_roller_is_the_ellipse_of_hertz) {
  const double length = 30.0, radius = 40.0;
  const contact::Ellipse ellipse = contact::ellipse(1.0 / radius);
  const double a_c = std::cbrt(3.0 * std::numbers::pi / 16.0 * length);
  const double P = ellipse.p_h * 0.75 * length / (a_c * a_c), half = ellipse.kappa * ellipse.a * a_c;
  for (const double tilt : {0.0, 0.025}) {
    const roller::Distribution found =
        dry_roller(128, {.shape = Profile::Shape::crowned, .length = length, .crown_radius = radius, .tilt = tilt});
    double highest = 0.0, reach = 0.0;
    for (const roller::Slice& slice : found.slices) {
      highest = std::max(highest, slice.P_max);
      if (slice.P_max > 0.0) reach = std::max(reach, slice.Y);
    }
    BOOST_TEST_MESSAGE("P " << highest << ", Hertz " << P << "; reaches to " << reach << ", Hertz "
                            << half - tilt * radius << "; resultant at " << found.load_centre);
    BOOST_TEST(std::abs(highest / P - 1.0) < 2e-3);
    BOOST_TEST(std::abs(reach - (half - tilt * radius)) < 0.1);
    BOOST_TEST(std::abs(found.load_centre + tilt * radius) < 2e-3);
  }
}

// The film and the pressure in the middle of a long roller are those of a line contact under the load that the middle
// carries. H in Moes' units does not depend on the load.
BOOST_AUTO_TEST_CASE(the_middle_of_a_long_roller_is_a_line_contact) {
  const double M = 20.0, L = 5.0;
  for (const Profile& profile :
       {Profile{.length = 60.0, .design_load = 1.5},
        Profile{.shape = Profile::Shape::straight, .length = 60.0, .end_length = 4.0, .end_radius = 4.0}}) {
    const steady::Solution solution = steady::solve(roller_scene(M, L, 256, profile));
    BOOST_TEST(solution.converged, solution.failed_check);
    const roller::Distribution found = roller::distribution(solution.grid, solution.P, solution.H);
    const double of_middle = found.middle.load;
    const steady::Solution line = steady::solve(scene_of(M * of_middle, L, 256, contact::line_contact()));
    const double Hc = contact::H_to_moes_units(found.middle.H_c, M, contact::line_contact());
    const double Hm = contact::H_to_moes_units(found.middle.H_min, M, contact::line_contact());
    const double Hc_line = contact::H_to_moes_units(line.levels.back().Hc, M * of_middle, contact::line_contact());
    const double Hm_line = contact::H_to_moes_units(line.levels.back().Hm, M * of_middle, contact::line_contact());
    const double P_line = line.levels.back().P_max * std::sqrt(of_middle);
    BOOST_TEST_MESSAGE("load " << of_middle << ": Hc " << Hc / Hc_line - 1.0 << ", Hm " << Hm / Hm_line - 1.0 << ", P "
                               << found.middle.P_max / P_line - 1.0);
    BOOST_TEST(std::abs(Hc / Hc_line - 1.0) < 5e-3);
    BOOST_TEST(std::abs(Hm / Hm_line - 1.0) < 5e-3);
    BOOST_TEST(std::abs(found.middle.P_max / P_line - 1.0) < 5e-3);
  }
}

// The slices together carry the load. Where the film is thin compared with the deformation, the pressure is that of the
// dry contact, also at the ends.
BOOST_AUTO_TEST_CASE(the_pressure_of_a_heavy_roller_is_that_of_the_dry_one) {
  for (const Profile& profile :
       {Profile{.length = 30.0, .design_load = 2.0},
        Profile{.shape = Profile::Shape::straight, .length = 30.0, .end_length = 3.0, .end_radius = 2.0}}) {
    const steady::Scene scene = roller_scene(100.0, 10.0, 256, profile);
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST(solution.converged, solution.failed_check);
    const roller::Distribution found = roller::distribution(solution.grid, solution.P, solution.H);
    const roller::Distribution dry = dry_roller(256, profile);
    double load = 0.0;
    for (const roller::Slice& slice : found.slices) load += slice.load * solution.grid.hy() / profile.length;
    BOOST_TEST_MESSAGE("load " << load - 1.0 << ", middle " << found.middle.P_max << " dry " << dry.middle.P_max
                               << ", end " << found.upper.P << " at " << found.upper.P_Y << " dry " << dry.upper.P
                               << " at " << dry.upper.P_Y);
    BOOST_TEST(std::abs(load - 1.0) < 1e-4);
    BOOST_TEST(std::abs(found.middle.P_max / dry.middle.P_max - 1.0) < 0.02);
    BOOST_TEST(std::abs(found.upper.P / dry.upper.P - 1.0) < 0.05);
  }
}

// With the opposite tilt, the solution is mirrored and the moment changes its sign.
BOOST_AUTO_TEST_CASE(the_opposite_tilt_mirrors_the_solution) {
  const auto solved = [](double tilt) {
    return steady::solve(roller_scene(20.0, 5.0, 128, {.length = 24.0, .design_load = 2.0, .tilt = tilt}));
  };
  const steady::Solution up = solved(0.01), down = solved(-0.01);
  BOOST_TEST(up.converged);
  const core::Grid& grid = up.grid;
  double P_off = 0.0, H_off = 0.0, moment = 0.0, load = 0.0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) {
      P_off = std::max(P_off, std::abs(up.P(i, j) - down.P(i, grid.ny - j)));
      H_off = std::max(H_off, std::abs(up.H(i, j) - down.H(i, grid.ny - j)));
      moment += up.P(i, j) * grid.Y(j);
      load += up.P(i, j);
    }
  const double centre = roller::distribution(grid, up.P, up.H).load_centre;
  BOOST_TEST_MESSAGE("off by " << P_off << " in P, " << H_off << " in H; resultant at " << centre);
  BOOST_TEST(P_off < 0.01);
  BOOST_TEST(H_off < 1e-3);
  BOOST_TEST(std::abs(centre * load / moment - 1.0) < 1e-10);
  BOOST_TEST(centre < -0.1);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
