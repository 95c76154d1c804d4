// Elliptic contacts compared with independent programs, the limit of a line contact, and the published formula.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <optional>
#include <utility>

#include "contact/film_formulas.hpp"
#include "contact/groups.hpp"
#include "core/constants.hpp"
#include "steady/domain_error.hpp"
#include "steady/resolution.hpp"
#include "steady/solve.hpp"

BOOST_AUTO_TEST_SUITE(test_elliptic)

using namespace ehl;
using core::pi;

namespace {

// The default domain of a deck, with this number of cells along X and the oil of the reference.
steady::Scene scene_of(double M, double L, const contact::Ellipse& shape, int cells,
                       std::optional<double> far_field_error = {}) {
  steady::Scene scene;
  const contact::Groups groups = contact::from_moes(M, L, shape);
  scene.contact = steady::scales_of(M, L, shape);
  scene.lambda = groups.lambda;
  const double p_h = groups.alpha_bar / 2.2e-8;
  scene.viscosity = rheology::make_roelands(2.2e-8, rheology::roelands_p0, 0.68, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  const double X_b = steady::chosen_outlet({}, scene.contact, far_field_error);
  const double X_a = steady::chosen_inlet({}, scene.contact, X_b, far_field_error);
  const double Y_b = steady::chosen_half_width({}, X_a, X_b, shape, far_field_error.has_value());
  scene.far_field = far_field_error.has_value();
  scene.grid = {cells, static_cast<int>(std::lround(cells * 2.0 * Y_b / (X_b - X_a))), X_a, X_b, -Y_b, Y_b};
  return scene;
}
/// The scene with the default scheme and boundary of a deck.
steady::Scene default_scene_of(double M, double L, const contact::Ellipse& shape, int cells) {
  steady::Scene scene = scene_of(M, L, shape, cells, steady::Tuning{}.error_of_closed_domain);
  scene.wedge = reynolds::Wedge::upstream3;
  scene.face = reynolds::Face::logmean_bounded;
  return scene;
}
/// R_x/R_y = 20, elongated in the rolling direction, on 256 cells that are four times as long as wide.
steady::Scene stretched_scene_of(double M, double L) {
  steady::Scene scene = default_scene_of(M, L, contact::ellipse(20), 256);
  scene.grid.ny = scene.grid.ny / 16 * 16 * 4;
  return scene;
}

struct Film {
  double Hc;
  double Hm;
};
/// The film in Moes' units, extrapolated to mesh size zero.
Film film_of(const steady::Scene& scene) {
  const steady::Solution solution = steady::solve(scene);
  BOOST_TEST(solution.converged, solution.failed_check);
  return {contact::H_to_moes_units(solution.error_bars.Hc_extrapolated.value, scene.contact.M, scene.contact.shape),
          contact::H_to_moes_units(solution.error_bars.Hm_extrapolated.value, scene.contact.M, scene.contact.shape)};
}

void check(const char* what, double computed, double expected, double tolerance) {
  const double difference = computed / expected - 1.0;
  BOOST_TEST_MESSAGE("  " << what << " " << computed << ", " << expected << ": " << difference << " (tolerance "
                          << tolerance << ")");
  BOOST_TEST(std::abs(difference) < tolerance);
}

}  // namespace

// Values of a program without multigrid, accurate to 3 %. Its domain ends 3 a upstream and 1.5 b to the sides, which
// makes the film a few per cent thinner than on an infinite domain.
BOOST_AUTO_TEST_CASE(independent_program) {
  struct Row {
    double M, Hc, Hm, Hc_infinite, Hm_infinite;
  };
  for (const Row& row : {Row{100, 4.77, 3.86, 4.960, 3.996}, Row{300, 4.40, 3.49, 4.471, 3.564}}) {
    BOOST_TEST_MESSAGE("M = " << row.M << ", L = 10, R_x/R_y = 0.2:");
    steady::Scene scene = scene_of(row.M, 10, contact::ellipse(0.2), 256);
    const Film chosen = film_of(scene);
    check("Hc on the chosen domain, on an infinite one", chosen.Hc, row.Hc_infinite, 0.01);
    check("Hm", chosen.Hm, row.Hm_infinite, 0.01);
    scene.grid = {256, 512, -3.0, 1.5, -4.335, 4.335};
    const Film found = film_of(scene);
    check("Hc on the short domain", found.Hc, row.Hc, 0.01);
    check("Hm", found.Hm, row.Hm, 0.01);
  }
}

// The discrete equations solved to rounding by an independent program: a dense Newton method in SI with its own
// ellipse, kernel and frame of reference. It reproduces all digits of the circular reference.
BOOST_AUTO_TEST_CASE(exact_discrete_solutions) {
  struct Row {
    double M, ratio, angle, X_a, X_b, Y_b, Hc, Hm, H00, P_right, P_left;  ///< P at the nodes (40, 24) and (40, 40)
  };
  for (const Row& row : {Row{100, 0.2, 0, -4.5, 1.5, 4.5, 0.29923329, 0.24580926, -0.99248331, 0.42791598, 0.42791598},
                         Row{20, 0.2, 90, -12, 4, 4, 0.69735242, 0.47571353, -0.55156279, 0.13815656, 0.13815656},
                         Row{50, 0.4, 30, -6, 2, 4, 0.33885306, 0.23727923, -0.79545653, 0.49277737, 0.07654233},
                         Row{30, 2.5, -50, -6, 2, 4, 0.13293249, 0.08469125, -0.71150976, 0.02350203, 0.00342025}}) {
    steady::Scene scene = scene_of(row.M, 10, contact::ellipse(row.ratio, row.angle), 64);
    scene.grid = {64, 64, row.X_a, row.X_b, -row.Y_b, row.Y_b};
    scene.deformation.method = mlmi::Method::fft;
    scene.solver.tolerance = 1e-9;
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST(solution.converged, solution.failed_check);
    BOOST_TEST_MESSAGE("M = " << row.M << ", R_x/R_y = " << row.ratio << ", " << row.angle << " degrees:");
    check("Hc", solution.levels.back().Hc, row.Hc, 1e-6);
    check("Hm", solution.levels.back().Hm, row.Hm, 1e-6);
    check("H00", solution.H00, row.H00, 1e-6);
    check("P to the right", solution.P(40, 24), row.P_right, 3e-6);
    check("P to the left", solution.P(40, 40), row.P_left, 3e-6);
  }
}

// The middle of a wide contact is a line contact with the same Hertz pressure. The reference is a line contact solved
// by an independent program (dense Newton method, 512 and 1024 cells, extrapolated), with Hc and Hm in Moes' units of
// the point contact. At finite R_x/R_y the point contact is slightly thinner.
BOOST_AUTO_TEST_CASE(limit_of_a_line) {
  BOOST_TEST_MESSAGE("M = 100, L = 10, R_x/R_y = 0.05:");
  const Film light = film_of(scene_of(100, 10, contact::ellipse(0.05), 256));
  check("Hc", light.Hc, 5.5341, 0.01);
  check("Hm", light.Hm, 4.5939, 0.01);
  BOOST_TEST_MESSAGE("M = 300, L = 10, R_x/R_y = 0.05:");
  const Film heavy = film_of(scene_of(300, 10, contact::ellipse(0.05), 256));
  check("Hc", heavy.Hc, 4.9961, 0.01);
  check("Hm", heavy.Hm, 4.2169, 0.01);
  BOOST_TEST_MESSAGE("M = 300, L = 10, R_x/R_y = 0.2:");
  const double wide = film_of(scene_of(300, 10, contact::ellipse(0.2), 256)).Hc / 4.5684;
  const double wider = heavy.Hc / 4.9961;
  BOOST_TEST_MESSAGE("  Hc over the line's: " << wide << ", at 0.05 " << wider);
  BOOST_TEST(std::abs(1.0 - wider) < 0.5 * std::abs(1.0 - wide));
}

// Very wide contacts, on cells that are twice as long in Y. At R_x/R_y = 0.005 the middle is a line contact with
// M = 20, L = 5, which a one-dimensional program solved to six digits, in H = h R/a^2. The line's lambda = 3
// pi^2/(8 M^2) and alpha_bar = L (M/(2 pi))^(1/2) are those of the point contact. The tolerance includes the
// error of the mesh of 256 cells.
BOOST_AUTO_TEST_CASE(limit_of_a_line_on_long_cells) {
  const contact::Ellipse shape = contact::ellipse(0.005);
  BOOST_TEST((steady::cell_aspect({}, shape) == 2.0 && steady::cell_aspect({}, contact::ellipse(0.05)) == 1.0));
  BOOST_TEST(steady::cell_aspect({}, contact::ellipse(0.005, 45.0)) == 1.0);
  const double lambda = 3.0 * pi * pi / (8.0 * 20.0 * 20.0), alpha_bar = 5.0 * std::sqrt(20.0 / (2.0 * pi));
  const double M =
      std::pow(128.0 * pi * pi * pi / 3.0, 0.25) * std::pow(lambda * std::pow(shape.a, 3) * shape.p_h, -0.75);
  const double L = pi * alpha_bar / (std::cbrt(1.5 * M) * shape.p_h);
  steady::Scene scene = scene_of(M, L, shape, 256);
  scene.far_field = true;
  scene.grid.ny = scene.grid.ny / 64 * 32;
  const steady::Solution solution = steady::solve(scene);
  BOOST_TEST(solution.converged, solution.failed_check);
  check("lambda", scene.lambda, lambda, 1e-12);
  check("Hc", solution.levels.back().Hc, 3.085739 * pi / (8.0 * 20.0), 5e-3);
  check("Hm", solution.levels.back().Hm, 2.568930 * pi / (8.0 * 20.0), 1e-2);
}

// A long ellipse at an angle has the film of the velocity component across it; the component along it finds no wedge.
// Each case is solved on the domain chosen for it, with the far field closed.
BOOST_AUTO_TEST_CASE(aslant_and_its_component_across) {
  const auto film = [](double M, double L, double angle, double* expected) {
    const contact::Ellipse shape = contact::ellipse(0.005, angle);
    steady::Scene scene = default_scene_of(M, L, shape, angle == 0.0 ? 256 : 512);
    scene.grid.ny = static_cast<int>(scene.grid.ny / steady::cell_aspect({}, shape)) / 64 * 64;
    *expected = steady::scales_of(M, L, shape).film;
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST(solution.converged, solution.failed_check);
    return solution.levels.back().Hc;
  };
  const double speed = std::sqrt(0.5);
  for (const auto& [M, L] : {std::pair{20.0, 5.0}, std::pair{100.0, 15.0}}) {
    BOOST_TEST_MESSAGE("M = " << M << ", L = " << L << ":");
    double expected = 0.0, expected_across = 0.0;
    const double oblique = film(M, L, 45.0, &expected);
    const double across = film(M * std::pow(speed, -0.75), L * std::pow(speed, 0.25), 0.0, &expected_across);
    check("Hc", oblique, across, 0.01);
    check("film to expect", expected, oblique, 0.3);
  }
}

// The formula of Nijenbanning, Venner and Moes, within 15 % where its interpolation between the asymptotes and its
// fluid permit: from the elastic regime upward, and up to 1 GPa.
BOOST_AUTO_TEST_CASE(formula_over_a_map) {
  for (const double ratio : {0.05, 0.2, 0.5, 1.0})
    for (const double M : {50.0, 300.0})
      for (const double L : {5.0, 10.0}) {
        const contact::Ellipse shape = contact::ellipse(ratio);
        const double formula = contact::nijenbanning_venner_moes(M, L, shape);
        BOOST_TEST_MESSAGE("R_x/R_y = " << ratio << ", M = " << M << ", L = " << L << ":");
        check("Hc", film_of(scene_of(M, L, shape, 256)).Hc, formula, 0.15);
      }
}

// For every shape and orientation, the cycles reduce the residual as well as in the circular contact.
BOOST_AUTO_TEST_CASE(convergence_of_the_cycles) {
  struct Case {
    double ratio, angle, M;
    int cells;
    double most;  ///< upper limit of the convergence factor
  };
  for (const auto& [ratio, angle, M, cells, most] :
       {Case{0.05, 0, 100, 256, 0.27}, Case{0.2, 0, 1000, 256, 0.17}, Case{0.2, 45, 100, 256, 0.21},
        Case{2, 45, 100, 256, 0.19}, Case{5, 0, 100, 512, 0.23}}) {
    steady::Scene scene = scene_of(M, 10, contact::ellipse(ratio, angle), cells);
    scene.solver.tolerance = 1e-8;
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST_MESSAGE("R_x/R_y = " << ratio << ", " << angle << " degrees, M = " << M << ", " << cells << " cells: "
                                    << solution.cycle_factor << " per cycle, " << solution.levels.back().cycles
                                    << " cycles, " << solution.method << " (at most " << most << ")");
    BOOST_TEST((solution.converged && solution.method == "full multigrid"), solution.failed_check);
    BOOST_TEST(solution.cycle_factor < most);
  }
}

// Next to a slender, heavily loaded contact the film is thin, and its cavitated region ends far out along a curved
// line. A start without pressure there made the cycles slow, or kept them from converging.
BOOST_AUTO_TEST_CASE(a_slender_heavy_contact) {
  steady::Scene scene = scene_of(200, 10, contact::ellipse(20), 2048);
  scene.solver.tolerance = 1e-5;
  const steady::Solution solution = steady::solve(scene);
  const steady::LevelRow& last = solution.levels.back();
  BOOST_TEST_MESSAGE("R_x/R_y = 20, M = 200: " << last.cycles << " cycles (at most 20), Hm/Hc " << last.Hm / last.Hc);
  BOOST_TEST(solution.converged, solution.failed_check);
  BOOST_TEST((last.cycles <= 20 && last.Hm > 0.0));
}

// Contacts that are strongly elongated in the rolling direction use cells of the contact's own shape, coarsened in Y
// only until they are square. The film is the same as on square cells with the same hy, within the error bars.
BOOST_AUTO_TEST_CASE(a_slender_contact_on_stretched_cells) {
  const contact::Ellipse shape = contact::ellipse(20);
  BOOST_TEST(steady::cell_aspect({}, shape) == 0.25);
  for (const auto& square : {contact::ellipse(10), contact::ellipse(200, 5.0)})
    BOOST_TEST(steady::cell_aspect({}, square) == 1.0);
  steady::Scene scene = stretched_scene_of(20, 5);
  const steady::Solution stretched = steady::solve(scene);
  scene.solver.tolerance = 1e-6;
  const steady::Solution cycled = steady::solve(scene);
  BOOST_TEST_MESSAGE("R_x/R_y = 20, (20, 5), 256 x " << scene.grid.ny << " cells: " << cycled.cycle_factor
                                                     << " per cycle (at most 0.5), " << cycled.method);
  BOOST_TEST((cycled.converged && cycled.method == "full multigrid"), cycled.failed_check);
  BOOST_TEST(cycled.cycle_factor < 0.5);
  scene.solver.tolerance = multigrid::Parameters{}.tolerance;
  scene.grid.nx *= 4;
  const steady::Solution square = steady::solve(scene);
  const steady::ErrorBars& bars = stretched.error_bars;
  check("Hc", stretched.levels.back().Hc, square.levels.back().Hc, bars.Hc.total() + square.error_bars.Hc.total());
  check("Hm", stretched.levels.back().Hm_fitted, square.levels.back().Hm_fitted,
        bars.Hm_fitted.total() + square.error_bars.Hm_fitted.total());
}

// At the rim of a heavily loaded contact at an angle, the top of a pressure spike and its flank are neighbours along X
// in some places and along Y in others. Relaxation of lines along X alone converges slowly.
BOOST_AUTO_TEST_CASE(a_spike_along_an_aslant_rim) {
  struct Case {
    double ratio, M;
    int cells;
    double most;  ///< upper limit of the convergence factor
  };
  for (const auto& [ratio, M, cells, most] :
       {Case{5, 100, 256, 0.155}, Case{5, 1000, 512, 0.17}, Case{200, 20, 512, 0.29}}) {
    steady::Scene scene = default_scene_of(M, 15, contact::ellipse(ratio, 45.0), cells);
    scene.grid.ny = scene.grid.ny / 64 * 64;
    scene.solver.tolerance = 1e-8;
    const steady::Solution solution = steady::solve(scene);
    BOOST_TEST_MESSAGE("R_x/R_y = " << ratio << ", 45 degrees, M = " << M << ", L = 15, " << cells << " x "
                                    << scene.grid.ny << " cells: " << solution.cycle_factor << " per cycle, "
                                    << solution.method << " (at most " << most << ")");
    BOOST_TEST((solution.converged && solution.method == "full multigrid"), solution.failed_check);
    BOOST_TEST(solution.cycle_factor < most);
  }
}

// Elongated contacts. `otherwise` is the number of cycles without one feature of the solver each: more than (2,1)
// relaxations; an interior that follows the boundary; epsilon updated on coarse grids; at an angle, the flux of the
// outer film in the Y sweep; a limit for single thin nodes alone; operator-dependent interpolation next to a spike.
BOOST_AUTO_TEST_CASE(cycles_beside_slender_contacts) {
  struct Case {
    double ratio, angle, M, L, tolerance;
    int cells, lines, most, otherwise;
  };
  const double mesh = multigrid::Parameters{}.tolerance;
  for (const auto& [ratio, angle, M, L, tolerance, cells, lines, most, otherwise] :
       {Case{20, 0, 1000, 15, 1e-6, 512, 384, 8, 10}, Case{100, 0, 100, 10, 1e-6, 512, 1024, 11, 15},
        Case{50, 0, 1000, 10, mesh, 512, 768, 17, 25}, Case{100, 45, 1000, 15, 1e-6, 1024, 1280, 7, 13},
        Case{37.8, 5, 36.1, 11.8, 1e-6, 2048, 512, 8, 12}}) {
    steady::Scene scene = default_scene_of(M, L, contact::ellipse(ratio, angle), cells);
    scene.grid.ny = lines;
    scene.solver.tolerance = tolerance;
    const steady::Solution solution = steady::solve(scene);
    const int cycles = solution.levels.back().cycles;
    BOOST_TEST_MESSAGE(ratio << ", (" << M << ", " << L << "): " << cycles << " of " << most << ", else " << otherwise);
    BOOST_TEST((solution.converged && solution.method == "full multigrid"), solution.failed_check);
    BOOST_TEST(cycles <= most);
  }
}

BOOST_AUTO_TEST_SUITE_END()
