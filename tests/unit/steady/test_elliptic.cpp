// Elliptic contacts compared with the equations in SI and in the frame of the bodies; one
// contact described in two ways.
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "contact/film_formulas.hpp"
#include "contact/groups.hpp"
#include "contact/hertz.hpp"
#include "core/constants.hpp"
#include "core/norms.hpp"
#include "steady/domain_error.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/resolution.hpp"
#include "steady/solve.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_elliptic)

using namespace ehl;

namespace {

constexpr double alpha = 2.2e-8;
constexpr double z = 0.68;

steady::Scene scene_of(const contact::Groups& groups, const core::Grid& grid) {
  steady::Scene scene;
  scene.contact = steady::scales_of(groups.M, groups.L, groups.shape);
  scene.lambda = groups.lambda;
  const double p_h = groups.alpha_bar / alpha;
  scene.viscosity = rheology::make_roelands(alpha, rheology::roelands_p0, z, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  scene.grid = grid;
  scene.solver.tolerance = 1e-10;
  return scene;
}

void check(const char* what, double value, double tolerance) {
  BOOST_TEST_MESSAGE(what << " " << value << " (tolerance " << tolerance << ")");
  BOOST_TEST(value < tolerance);
}

// The integral of 1/r over a rectangle from (0,0) to (x,y), by its four corners.
double corner(double x, double y) {
  return (x == 0.0 ? 0.0 : x * std::asinh(y / std::abs(x))) + (y == 0.0 ? 0.0 : y * std::asinh(x / std::abs(y)));
}
double cell_integral(double x, double y, double hx, double hy) {
  return corner(x + hx / 2, y + hy / 2) - corner(x - hx / 2, y + hy / 2) - corner(x + hx / 2, y - hy / 2) +
         corner(x - hx / 2, y - hy / 2);
}

}  // namespace

// A solution in metres and pascals: the film between two bodies of radii R_x and R_y, at an angle, by a sum over all
// cells; the load; and the Reynolds equation in the direction of entrainment.
BOOST_AUTO_TEST_CASE(equations_in_si) {
  const contact::SiContact si{12.0, 9e-3, 2.1e11, 0.9, 0.08, alpha, contact::ellipse(0.4, 30.0)};
  const contact::Groups groups = contact::from_si(si);
  const contact::Hertz dry = contact::hertz(si.load, si.radius, si.E_prime, si.shape);
  BOOST_TEST_MESSAGE("M " << groups.M << ", L " << groups.L << ", p_h " << dry.p_h);
  steady::Scene scene = scene_of(groups, {64, 64, -5.0, 3.0, -4.0, 4.0});
  scene.deformation.method = mlmi::Method::direct;
  const steady::Solution solution = steady::solve(scene);
  BOOST_REQUIRE(solution.converged);
  const core::Grid& grid = solution.grid;
  const double hx = grid.hx() * dry.a, hy = grid.hy() * dry.a;
  const auto p = [&](int i, int j) { return solution.P(i, j) * dry.p_h; };
  const auto h = [&](int i, int j) { return solution.H(i, j) * dry.h_scale; };

  double load = 0.0;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j) load += hx * hy * p(i, j);
  check("load, relative error", std::abs(load / si.load - 1.0), 1e-8);

  const double R_y = si.radius / si.shape.radius_ratio;
  const double theta = core::pi / 6.0;
  double worst = 0.0;
  for (const auto& [i0, j0] : {std::array{40, 32}, {20, 10}, {46, 39}, {52, 50}, {35, 21}}) {
    const double X = grid.X(i0) * dry.a, Y = grid.Y(j0) * dry.a;
    const double x = X * std::cos(theta) - Y * std::sin(theta), y = X * std::sin(theta) + Y * std::cos(theta);
    double film = solution.H00 * dry.h_scale + x * x / (2.0 * si.radius) + y * y / (2.0 * R_y);
    for (int i = 1; i < grid.nx; ++i)
      for (int j = 1; j < grid.ny; ++j)
        film += 2.0 / (core::pi * si.E_prime) * p(i, j) * cell_integral((i - i0) * hx, (j - j0) * hy, hx, hy);
    worst = std::max(worst, std::abs(film - h(i0, j0)) / dry.h_scale);
  }
  check("film, largest error in a^2/R_x", worst, 1e-11);

  const auto rho = [&](int i, int j) { return (5.9e8 + 1.34 * p(i, j)) / (5.9e8 + p(i, j)); };
  const auto fluidity = [&](int i, int j) {
    const double p0 = rheology::roelands_p0;
    const double eta = si.eta0 * std::exp(alpha * p0 / z * (std::pow(1.0 + p(i, j) / p0, z) - 1.0));
    return rho(i, j) * std::pow(h(i, j), 3) / (12.0 * eta);
  };
  double sum = 0.0, wedge_sum = 0.0;
  for (int i = 2; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j) {
      const auto flow = [&](int di, int dj) {
        return 0.5 * (fluidity(i, j) + fluidity(i + di, j + dj)) * (p(i + di, j + dj) - p(i, j));
      };
      const double wedge =
          0.5 * si.u_s *
          (1.5 * rho(i, j) * h(i, j) - 2.0 * rho(i - 1, j) * h(i - 1, j) + 0.5 * rho(i - 2, j) * h(i - 2, j)) / hx;
      const double r = (flow(-1, 0) + flow(1, 0)) / (hx * hx) + (flow(0, -1) + flow(0, 1)) / (hy * hy) - wedge;
      wedge_sum += wedge * wedge;
      if (p(i, j) > 0.0) sum += r * r;
    }
  check("Reynolds equation, residual over the wedge", std::sqrt(sum / wedge_sum), 1e-9);
}

// R_x/R_y at an angle equals R_y/R_x at an angle smaller by 90 degrees, with the scales of the other radius.
BOOST_AUTO_TEST_CASE(one_contact_under_two_names) {
  for (const double angle : {90.0, 30.0}) {
    const contact::SiContact one{12.0, 9e-3, 2.1e11, 0.9, 0.08, alpha, contact::ellipse(0.4, angle)};
    contact::SiContact other = one;
    other.radius = one.radius / 0.4;
    other.shape = contact::ellipse(1.0 / 0.4, angle - 90.0);
    const contact::Hertz dry_1 = contact::hertz(one.load, one.radius, one.E_prime, one.shape);
    const contact::Hertz dry_2 = contact::hertz(other.load, other.radius, other.E_prime, other.shape);
    const double length = dry_1.a / dry_2.a;
    const core::Grid grid{128, 128, -5.0, 3.0, -4.0, 4.0};
    const core::Grid same{128, 128, -5.0 * length, 3.0 * length, -4.0 * length, 4.0 * length};
    const contact::Groups groups_1 = contact::from_si(one), groups_2 = contact::from_si(other);
    const steady::Solution a = steady::solve(scene_of(groups_1, grid));
    const steady::Solution b = steady::solve(scene_of(groups_2, same));
    BOOST_TEST((a.converged && b.converged));
    double H = 0.0;
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j)
        H = std::max(H, std::abs(a.H(i, j) - b.H(i, j) * dry_2.h_scale / dry_1.h_scale));
    BOOST_TEST_MESSAGE(angle << " degrees:");
    check("difference of P", core::max_abs_difference(a.P, b.P), 1e-7);
    check("difference of H", H, 1e-7);
    // The domain and the mesh chosen for them are the same.
    const steady::ContactScales scales_1 = steady::scales_of(groups_1.M, groups_1.L, one.shape);
    const steady::ContactScales scales_2 = steady::scales_of(groups_2.M, groups_2.L, other.shape);
    const double outlet = steady::chosen_outlet({}, scales_1);
    check("outlet", std::abs(steady::chosen_outlet({}, scales_2) / (outlet * length) - 1), 1e-12);
    const double inlet = steady::chosen_inlet({}, scales_1, outlet);
    check("inlet", std::abs(steady::chosen_inlet({}, scales_2, outlet * length) / (inlet * length) - 1), 1e-12);
    const auto step = [](const contact::Groups& g) {
      return steady::resolving_step({}, steady::scales_of(g.M, g.L, g.shape), reynolds::Wedge::upstream2);
    };
    check("step", std::abs(step(groups_2) / (step(groups_1) * length) - 1.0), 1e-12);
    check("load of a circle as heavy", std::abs(scales_1.circular_load / scales_2.circular_load - 1.0), 1e-12);
  }
}

// The film varies smoothly with the ratio, without a jump at the circle.
BOOST_AUTO_TEST_CASE(nearly_a_circle) {
  const core::Grid grid{64, 64, -4.5, 1.5, -3.0, 3.0};
  const auto film = [&](double ratio, double angle) {
    const contact::Groups groups = contact::from_moes(50.0, 10.0, contact::ellipse(ratio, angle));
    const steady::Solution solution = steady::solve(scene_of(groups, grid));
    BOOST_TEST(solution.converged);
    return contact::H_to_moes_units(solution.levels.back().Hc, 50.0, groups.shape);
  };
  const double circle = film(1.0, 0.0);
  BOOST_TEST(film(1.0, 45.0) == circle);
  for (const double angle : {0.0, 45.0}) {
    const double near = film(1.0 + 1e-6, angle) / circle - 1.0;
    const double nearer = film(1.0 + 1e-7, angle) / circle - 1.0;
    BOOST_TEST_MESSAGE(angle << " degrees: change of Hc for a ratio of 1 + 1e-6: " << near << ", 1 + 1e-7: " << nearer);
    BOOST_TEST(std::abs(near) < 1e-6);
    BOOST_TEST(std::abs(nearer) < 2e-7);
  }
}

BOOST_AUTO_TEST_CASE(half_of_a_symmetric_ellipse) {
  for (const double angle : {0.0, 90.0}) {
    const contact::Groups groups = contact::from_moes(30.0, 8.0, contact::ellipse(0.5, angle));
    steady::Scene scene = scene_of(groups, {64, 64, -6.0, 2.0, -4.0, 4.0});
    const steady::Solution half = steady::solve(scene);
    scene.use_symmetry = false;
    const steady::Solution whole = steady::solve(scene);
    BOOST_TEST((half.converged && whole.converged));
    check("difference of P", core::max_abs_difference(half.P, whole.P), 1e-9);
    check("difference of H", core::max_abs_difference(half.H, whole.H), 1e-9);
  }
}

// The rough estimate of the domain error: its two parts compared with integrals of the far field
// that they are derived from.
BOOST_AUTO_TEST_CASE(domain_of_an_ellipse) {
  // Along the axes: P = -c X/H^2 with c = lambda/(3 + 2 B/A), H = A X^2 + B Y^2, outside the rectangle.
  const contact::Groups groups = contact::from_moes(1.0, 0.0, contact::ellipse(0.2));
  steady::Scene scene;
  scene.contact = steady::scales_of(groups.M, groups.L, groups.shape);
  scene.grid = {64, 64, -40.0, 3.0, -60.0, 60.0};
  const core::QuadraticForm A = contact::gap(groups.shape);
  const double c = groups.lambda / (3.0 + 2.0 * A.YY / A.XX);
  double outside = 0.0;
  constexpr int n = 20000;
  for (int k = 0; k < n; ++k) {  // directions upstream; the integral along each ray from the boundary in closed form
    const double theta = core::pi * ((k + 0.5) / n - 0.5);
    const double boundary = std::min(40.0 / std::cos(theta), 60.0 / std::abs(std::sin(theta)));
    const double round = A.XX * std::pow(std::cos(theta), 2) + A.YY * std::pow(std::sin(theta), 2);
    outside += core::pi / n * c * std::cos(theta) / (round * round) / boundary;
  }
  const double share = outside / contact::load(groups.shape);
  const double inlet = 0.5 * 10.0 * groups.lambda / (3.0 * A.XX * A.XX * std::pow(40.0, 3));
  const double rigid = contact::asymptotes(1.0, 0.0, 0.2).rigid_isoviscous;
  const double power = 2.0 * std::min(1.0, rigid / contact::nijenbanning_venner_moes(1.0, 0.0, groups.shape));
  const double expected = inlet + power * share;
  BOOST_TEST_MESSAGE("rough domain error " << steady::rough_domain_error(scene) << ", expected " << expected);
  BOOST_TEST(std::abs(steady::rough_domain_error(scene) / expected - 1.0) < 1e-4);
}

// Stronger damping is used from the start if ln eta_bar exceeds 20 at the Hertz pressure one film zone inside the edge.
// For a Barus oil ln eta_bar = alpha p = alpha_bar P.
BOOST_AUTO_TEST_CASE(a_steep_edge_is_one_of_this_pressure) {
  const auto damping = [](const contact::Ellipse& shape, double log_viscosity) {
    steady::Scene scene = scene_of(contact::from_moes(200, 20, shape), {64, 64, -4.5, 1.5, -3.0, 3.0});
    const double depth = scene.contact.film_zone / contact::extent(shape).shorter;
    scene.viscosity = rheology::Barus{log_viscosity / std::sqrt(2.0 * depth)};
    return steady::begin_multigrid(scene, {}, {}).plan.above.steep;
  };
  for (const double radius_ratio : {0.1, 1.0, 5.0}) {
    const contact::Ellipse shape = contact::ellipse(radius_ratio);
    BOOST_TEST(damping(shape, 19.9) == 1.0, "R_x/R_y " << radius_ratio);
    BOOST_TEST(damping(shape, 20.1) < 1.0, "R_x/R_y " << radius_ratio);
  }
}

BOOST_AUTO_TEST_SUITE_END()
