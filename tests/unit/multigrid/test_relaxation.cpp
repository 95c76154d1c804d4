// The relaxation compared with a sweep that is implemented point by point, and its two line solvers with each other.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <utility>

#include "contact/ellipse.hpp"
#include "core/errors.hpp"
#include "core/norms.hpp"
#include "multigrid/line_batch.hpp"
#include "multigrid/relaxation.hpp"
#include "unit/multigrid/circular_contact.hpp"
#include "unit/multigrid/plain_sweep.hpp"

BOOST_AUTO_TEST_SUITE(test_multigrid_relaxation)

using namespace ehl::tests;
namespace multigrid = ehl::multigrid;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using ehl::reynolds::Wedge;

namespace {

multigrid::Hierarchy one_level(const multigrid::Problem& problem, const multigrid::RelaxationParameters& relaxation,
                               const Patch& grid) {
  multigrid::Parameters parameters;
  parameters.relaxation = relaxation;
  parameters.coarsest_cells = grid.nx;
  return multigrid::make_hierarchy(problem, parameters, {.method = ehl::mlmi::Method::fft}, grid, 1);
}

struct Counts {
  int single = 0, distributive = 0, held = 0, clipped = 0, bounded = 0, withheld = 0;
};

// The rounding of the residual, divided by the coefficients, is a few 1e-16 of P; the condition number of the
// line system multiplies it.
constexpr double tolerance = 1e-12;

void compare_with_plain_sweep(const multigrid::Problem& problem, const multigrid::RelaxationParameters& relaxation,
                              const Patch& grid, Counts& counts) {
  multigrid::Hierarchy hierarchy = one_level(problem, relaxation, grid);
  multigrid::Level& level = hierarchy.finest();
  Random random(static_cast<std::uint64_t>(100 * grid.nx + grid.ny));
  set_rough_state(hierarchy, level, random);
  const Field before = level.P;
  double error = 0.0;
  // The second sweep starts with the work space of the first.
  for (int sweep = 0; sweep < 2; ++sweep) {
    const PlainSweep plain = plain_sweep(problem, relaxation, level);
    counts.single += plain.single;
    counts.distributive += plain.distributive;
    counts.held += plain.held;
    counts.clipped += plain.clipped;
    counts.bounded += plain.bounded;
    counts.withheld += plain.withheld;
    multigrid::relax_pressure(hierarchy, level, relaxation);  // along X only, on stretched cells too
    multigrid::update_film(hierarchy, level);
    const double difference = ehl::core::max_abs_difference(level.P, plain.P) / ehl::core::max_abs(plain.P);
    error = difference <= error ? error : difference;
  }
  BOOST_TEST_MESSAGE(grid.nx << " x " << grid.ny << ", reach " << relaxation.reach
                             << (problem.transport.wedge == Wedge::upstream1 ? ", upstream1" : ", upstream2")
                             << (relaxation.line_solver == multigrid::LineSolver::decimation ? ", decimation" : "")
                             << ": difference of P " << error << " (tolerance " << tolerance << ")");
  BOOST_TEST(error < tolerance);
  BOOST_TEST(ehl::core::max_abs_difference(before, level.P) > 1e-3);
}

// Numbers of lines that fill a batch, that leave one over, or that lack one, for either colour; hx != hy.
const Grid grids[] = {{16, 16, -4.5, 1.5, -3, 3}, {16, 17, -4.5, 1.5, -3, 3},   {12, 18, -3.0, 1.5, -3, 3},
                      {14, 2, -3.0, 1.5, -1, 1},  {18, 34, -3.5, 1.5, -2, 2.5}, {16, 19, -3.0, 1.5, -2, 2}};

}  // namespace

BOOST_AUTO_TEST_CASE(one_sweep_is_the_sweep_written_point_by_point) {
  Counts counts;
  for (const Grid& grid : grids)
    for (const Wedge wedge : {Wedge::upstream1, Wedge::upstream2})
      for (const int reach : {1, 3}) {
        multigrid::RelaxationParameters relaxation;
        relaxation.reach = reach;
        multigrid::Problem problem = circular_contact(20, 10, wedge);
        compare_with_plain_sweep(problem, relaxation, grid, counts);
        problem.transport = {wedge, 0.6, 5.0};  // one step in time
        compare_with_plain_sweep(problem, relaxation, grid, counts);
        problem.transport = {wedge, 0.0, 30.0};  // pure squeeze
        compare_with_plain_sweep(problem, relaxation, grid, counts);
      }
  multigrid::RelaxationParameters relaxation;
  relaxation.reach = 2;
  relaxation.line_solver = multigrid::LineSolver::decimation;
  compare_with_plain_sweep(circular_contact(20, 10, Wedge::upstream2), relaxation, grids[4], counts);
  BOOST_TEST_MESSAGE("points: " << counts.single << " single, " << counts.distributive << " distributive, "
                                << counts.held << " held at zero; " << counts.clipped << " stopped at zero, "
                                << counts.withheld << " by what they have");
  BOOST_TEST(counts.single > 100);
  BOOST_TEST(counts.distributive > 100);
  BOOST_TEST(counts.held > 50);
  BOOST_TEST(counts.clipped > 100);
  BOOST_TEST(counts.withheld > 50);
}

BOOST_AUTO_TEST_CASE(one_sweep_changes_no_pressure_by_more_than_allowed) {
  Counts counts;
  multigrid::Problem problem = circular_contact(20, 10, Wedge::upstream2);
  multigrid::RelaxationParameters relaxation;
  relaxation.most_change = 0.02;
  compare_with_plain_sweep(problem, relaxation, grids[0], counts);
  problem.transport = {Wedge::upstream2, 0.6, 5.0};  // one step in time
  compare_with_plain_sweep(problem, relaxation, grids[0], counts);
  BOOST_TEST_MESSAGE(counts.bounded << " changes bounded");
  BOOST_TEST(counts.bounded > 50);
  BOOST_TEST(counts.bounded < counts.single + counts.distributive);
}

BOOST_AUTO_TEST_CASE(one_sweep_without_cavitation_lets_pressures_be_negative) {
  Counts counts;
  multigrid::Problem problem = circular_contact(20, 10, Wedge::upstream2);
  problem.cavitation = ehl::reynolds::Cavitation::none;
  // Roelands' law has no value far below zero pressure.
  problem.film.viscosity = ehl::rheology::Isoviscous{};
  problem.film.density = ehl::rheology::Incompressible{};
  multigrid::Hierarchy hierarchy = one_level(problem, {}, grids[0]);
  compare_with_plain_sweep(problem, {}, grids[0], counts);
  BOOST_TEST((counts.held == 0 && counts.clipped == 0));

  // A model problem with a given epsilon, so that all points have the same relaxation.
  for (const double eps : {1e-3, 10.0}) {
    counts = {};
    problem.film.given_epsilon = [eps](double, double) { return eps; };
    compare_with_plain_sweep(problem, {}, grids[2], counts);
    BOOST_TEST((eps < 1.0 ? counts.single : counts.distributive) == 0);
  }
}

BOOST_AUTO_TEST_CASE(elimination_and_decimation_agree_on_the_systems_of_the_relaxation) {
  // Three sweeps from the dry contact: epsilon decreases by orders of magnitude from the inlet to the centre.
  for (const double M : {50.0, 1000.0})
    for (const int reach : {1, 2, 3}) {
      multigrid::RelaxationParameters relaxation;
      relaxation.reach = reach;
      const multigrid::Problem problem = circular_contact(M, 10, Wedge::upstream2);
      multigrid::Hierarchy hierarchy = one_level(problem, relaxation, Grid{64, 64, -4.5, 1.5, -3, 3});
      multigrid::Level& level = hierarchy.finest();
      multigrid::start_from_hertz(hierarchy, 0, M > 500.0 ? -0.96 : -0.7, 3);
      const Field start = level.P;
      multigrid::relax(hierarchy, level);
      const Field eliminated = level.P;
      level.P = start;
      multigrid::update_film(hierarchy, level);
      relaxation.line_solver = multigrid::LineSolver::decimation;
      level.thread_work = multigrid::WorkSpace(1, multigrid::make_thread_work(level.grid, problem.film, relaxation));
      multigrid::relax(hierarchy, level, relaxation);
      const double difference = ehl::core::max_abs_difference(level.P, eliminated);
      BOOST_TEST_MESSAGE("M = " << M << ", reach " << reach << ": " << difference << " (tolerance 1e-11)");
      BOOST_TEST(difference < 1e-11);
      BOOST_TEST(ehl::core::max_abs_difference(start, eliminated) > 1e-6);
    }
}

template <int reach>
void compare_line_with_batch(const multigrid::Problem& problem, double squeeze, int cells) {
  multigrid::RelaxationParameters relaxation;
  relaxation.reach = reach;
  multigrid::Hierarchy hierarchy = one_level(problem, relaxation, ehl::core::line_grid(cells, -4.5, 1.5));
  hierarchy.transport.squeeze = squeeze;
  multigrid::Level& level = hierarchy.finest();
  Random random(static_cast<std::uint64_t>(cells));
  set_rough_state(hierarchy, level, random);
  ehl::core::fill_ghosts(level.grid, level.P);
  // The work space of a batch belongs to the film model whose rows are assembled one after another.
  const auto nodes = static_cast<std::size_t>(level.grid.nodes_x());
  multigrid::ThreadWork work =
      multigrid::make_thread_work(level.grid, problem.film, relaxation, ehl::reynolds::Cavitation::mass_conserving);
  work.answers.resize(nodes);
  work.answers_west.resize(nodes);
  const Field zero(level.grid.nodes_x(), 2 * ehl::core::lanes);
  level.changes = {zero, zero};
  multigrid::LineBatch<reach, multigrid::LineSolver::elimination>(work, relaxation).solve(hierarchy, level, 0, 0);
  const auto distributed = [&](int i) { return level.changes.distributed(i, 0); };
  Field expected = level.P;
  for (int i = 1; i < level.grid.nx; ++i) {
    const double P = level.P(i, 1) + level.changes.delta(i, 0) - 0.5 * (distributed(i - 1) + distributed(i + 1));
    ehl::core::fill_lines(expected.at_x(i), std::max(0.0, P));
  }
  multigrid::relax_pressure(hierarchy, level, relaxation);
  const double difference = ehl::core::max_abs_difference(level.P, expected) / ehl::core::max_abs(expected);
  BOOST_TEST(difference < 1e-11, cells << " cells, reach " << reach << ", squeeze " << squeeze << ": " << difference);
}

// One system is solved from both ends of a line and from one end.
BOOST_AUTO_TEST_CASE(nodes_of_a_line_side_by_side_are_relaxed_as_a_batch_of_lines) {
  using ehl::reynolds::Face;
  const ehl::contact::Ellipse shape = ehl::contact::line_contact();
  for (const auto& [wedge, face] : {std::pair{Wedge::upstream1, Face::mean},
                                    {Wedge::upstream2, Face::mean},
                                    {Wedge::upstream3, Face::logmean_bounded}}) {
    multigrid::Problem problem = circular_contact(20, 10, wedge, face);
    problem.geometry = {ehl::contact::gap(shape), ehl::contact::outline(shape),
                        ehl::kernel::half_plane(ehl::contact::elastic_factor(shape))};
    for (const double squeeze : {0.0, 30.0})
      for (const int cells : {16, 63, 256}) {  // vectors that end with the line, or beyond it
        compare_line_with_batch<1>(problem, squeeze, cells);
        compare_line_with_batch<2>(problem, squeeze, cells);
        compare_line_with_batch<3>(problem, squeeze, cells);
      }
  }
}

BOOST_AUTO_TEST_CASE(a_pivot_that_is_no_number_is_reported_with_its_line_and_point) {
  multigrid::Hierarchy hierarchy = one_level(circular_contact(20, 10, Wedge::upstream1), {}, grids[4]);
  multigrid::Level& level = hierarchy.finest();
  Random random(1);
  set_rough_state(hierarchy, level, random);
  level.eps(9, 21) = std::numeric_limits<double>::quiet_NaN();
  // Point 8 is the first one whose half points depend on it.
  const auto names_the_point = [](const ehl::core::SolverError& error) {
    const std::string text = error.what();
    BOOST_TEST_MESSAGE(text);
    return text.find("18 x 34 cells") != std::string::npos && text.find("i = 8 of line j = 21") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(multigrid::relax(hierarchy, level), ehl::core::SolverError, names_the_point);
}

BOOST_AUTO_TEST_SUITE_END()
