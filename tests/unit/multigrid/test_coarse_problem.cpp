// The restriction of the problem to the coarser grid, and the film.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "core/constants.hpp"
#include "core/norms.hpp"
#include "kernel/influence.hpp"
#include "multigrid/coarse_problem.hpp"
#include "transfer/transfer.hpp"
#include "unit/multigrid/circular_contact.hpp"

BOOST_AUTO_TEST_SUITE(test_multigrid_coarse_problem)

using namespace ehl::tests;
namespace multigrid = ehl::multigrid;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using ehl::reynolds::Wedge;

namespace {

// The contribution of the elastic film to the coupling, as coarse_problem.hpp defines it.
constexpr double elastic_coupling = 0.5;

multigrid::Hierarchy two_levels(
    const Patch& fine, ehl::reynolds::Cavitation cavitation = ehl::reynolds::Cavitation::nonnegative_pressure) {
  multigrid::Problem problem = circular_contact(20, 10, Wedge::upstream2);
  problem.cavitation = cavitation;
  multigrid::Parameters parameters;
  parameters.coarsest_cells = fine.nx / 2;
  return multigrid::make_hierarchy(problem, parameters, {.method = ehl::mlmi::Method::fft}, fine, 1);
}

const Grid fine_grid{20, 24, -3.0, 1.5, -2, 2};

// Distributes r of one fine point to the coarse nodes as the header defines it;
// restrict_residual is the transposed sum.
class Scatter {
 public:
  explicit Scatter(const multigrid::Level& fine) : fine_(fine), sums_(ehl::core::coarsened(fine.grid)) {}

  void add(int i, int j) {
    const double r = 0.25 * fine_.r(i, j);
    if (i % 2 == 0 || j % 2 == 0) {
      to_nodes(i, j, r);
      return;
    }
    const double w = coupling(i, j, -1, 0), e = coupling(i, j, 1, 0), s = coupling(i, j, 0, -1),
                 n = coupling(i, j, 0, 1);
    const double all = w + e + s + n;
    to_nodes(i - 1, j, r * w / all);
    to_nodes(i + 1, j, r * e / all);
    to_nodes(i, j - 1, r * s / all);
    to_nodes(i, j + 1, r * n / all);
  }
  /// Sums at interior nodes; those on the boundary are dropped.
  double operator()(int I, int J) const { return sums_(I, J); }

 private:
  double coupling(int i, int j, int di, int dj) const {
    const double h = di != 0 ? fine_.grid.hx() : fine_.grid.hy();
    return elastic_coupling + 0.5 * (fine_.eps(i, j) + fine_.eps(i + di, j + dj)) / (h * h);
  }
  void to_nodes(int i, int j, double r) {
    if (i % 2 == 0 && j % 2 == 0) {
      sums_(i / 2, j / 2) += r;
    } else if (j % 2 == 0) {
      const double w = coupling(i, j, -1, 0), e = coupling(i, j, 1, 0);
      sums_((i - 1) / 2, j / 2) += r * w / (w + e);
      sums_((i + 1) / 2, j / 2) += r * e / (w + e);
    } else {
      const double s = coupling(i, j, 0, -1), n = coupling(i, j, 0, 1);
      sums_(i / 2, (j - 1) / 2) += r * s / (s + n);
      sums_(i / 2, (j + 1) / 2) += r * n / (s + n);
    }
  }

  const multigrid::Level& fine_;
  Field sums_;
};

double largest_interior_difference(const Patch& grid, const Field& a, const auto& b) {
  double largest = 0.0;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j) {
      const double difference = std::abs(a(i, j) - b(i, j));
      largest = difference <= largest ? largest : difference;
    }
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(residuals_go_down_by_full_weighting_where_epsilon_is_constant) {
  multigrid::Hierarchy hierarchy = two_levels(fine_grid);
  multigrid::Level& fine = hierarchy.levels[1];
  const Patch& grid = hierarchy.levels[0].grid;
  Random random(1);
  fine.r = random_field(fine_grid, random, -1.0, 1.0);
  for (int i = 0; i <= fine_grid.nx; ++i)
    for (int j = 0; j <= fine_grid.ny; ++j)
      if (i == 0 || j == 0 || i == fine_grid.nx || j == fine_grid.ny) fine.r(i, j) = 0.0;
  for (const double eps : {0.0, 1e-3, 10.0}) {
    fine.eps.fill(eps);
    Field restricted(grid);
    Field full_weighting(grid);
    multigrid::restrict_residual(hierarchy, fine, restricted);
    ehl::transfer::restrict_full_weighting(grid, fine.r, full_weighting);
    const double difference = largest_interior_difference(grid, restricted, full_weighting);
    BOOST_TEST_MESSAGE("epsilon " << eps << ": " << difference << " (tolerance 1e-15)");
    BOOST_TEST(difference < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(residuals_are_shared_by_coupling_and_none_is_lost) {
  multigrid::Hierarchy hierarchy = two_levels(fine_grid);
  multigrid::Level& fine = hierarchy.levels[1];
  const Patch& grid = hierarchy.levels[0].grid;
  Random random(2);
  for (int i = 0; i <= fine_grid.nx; ++i)
    for (int j = 0; j <= fine_grid.ny; ++j) fine.eps(i, j) = std::pow(10.0, random.between(-8.0, 4.0));
  double sum = 0.0;
  Scatter scatter(fine);
  for (int i = 2; i <= fine_grid.nx - 2; ++i)
    for (int j = 2; j <= fine_grid.ny - 2; ++j) {
      fine.r(i, j) = random.between(-1.0, 2.0);
      sum += fine.r(i, j);
      scatter.add(i, j);
    }
  Field restricted(grid);
  multigrid::restrict_residual(hierarchy, fine, restricted);
  const double difference = largest_interior_difference(grid, restricted, scatter);
  const double lost = std::abs(4.0 * ehl::core::interior_sum(restricted) / sum - 1.0);
  BOOST_TEST_MESSAGE("difference to sharing point by point " << difference << " (tolerance 1e-15), lost " << lost
                                                             << " of the sum (tolerance 1e-14)");
  BOOST_TEST(difference < 1e-15);
  BOOST_TEST(lost < 1e-14);
}

BOOST_AUTO_TEST_CASE(strong_residuals_stay_on_their_side_of_a_jump) {
  multigrid::Hierarchy hierarchy = two_levels(fine_grid);
  multigrid::Level& fine = hierarchy.levels[1];
  const Patch& grid = hierarchy.levels[0].grid;
  const double h2 = fine_grid.hx() * fine_grid.hx();
  const double strong = 1e4;  // epsilon/h^2 for i <= 10; beyond that it is zero
  for (int i = 0; i <= fine_grid.nx; ++i)
    for (int j = 0; j <= fine_grid.ny; ++j) fine.eps(i, j) = i <= 10 ? strong * h2 : 0.0;
  Field restricted(grid);

  fine.r(11, 12) = 1.0;  // the first point of the weak side is coupled to the strong side by its western half point
  multigrid::restrict_residual(hierarchy, fine, restricted);
  const double share = elastic_coupling / (strong / 2.0 + 2.0 * elastic_coupling);
  BOOST_TEST_MESSAGE("beyond the jump " << 4.0 * restricted(6, 6) << ", stated " << share << " (to 1e-12)");
  BOOST_TEST(std::abs(4.0 * restricted(6, 6) / share - 1.0) < 1e-12);
  BOOST_TEST(std::abs(4.0 * restricted(5, 6) - (1.0 - share)) < 1e-15);
  BOOST_TEST(restricted(7, 6) == 0.0);

  // Between coarse rows, the residual goes first to the four neighbours, then as above.
  fine.r.fill(0.0);
  fine.r(11, 13) = 1.0;
  multigrid::restrict_residual(hierarchy, fine, restricted);
  const double beyond = restricted(6, 6) + restricted(6, 7) + restricted(6, 5) + restricted(6, 8);
  BOOST_TEST_MESSAGE("between rows: beyond the jump " << 4.0 * beyond << " (at most " << 3.0 * share << ")");
  BOOST_TEST(4.0 * beyond < 3.0 * share);
  BOOST_TEST(beyond > 0.0);

  // Residuals of the strong side do not pass the first weak point.
  fine.r.fill(0.0);
  for (int j = 1; j < fine_grid.ny; ++j)
    for (int i = 1; i <= 10; ++i) fine.r(i, j) = 1.0;
  multigrid::restrict_residual(hierarchy, fine, restricted);
  for (int J = 1; J < grid.ny; ++J) BOOST_TEST(restricted(6, J) == 0.0);
}

BOOST_AUTO_TEST_CASE(the_film_is_equation_6) {
  const Grid grid{12, 10, -2.0, 1.0, -1.5, 1.2};
  multigrid::Parameters parameters;
  parameters.coarsest_cells = grid.nx;
  for (const ehl::mlmi::Method method : {ehl::mlmi::Method::direct, ehl::mlmi::Method::fft}) {
    multigrid::Hierarchy hierarchy =
        multigrid::make_hierarchy(circular_contact(20, 10, Wedge::upstream1), parameters, {.method = method}, grid, 1);
    multigrid::Level& level = hierarchy.finest();
    Random random(4);
    set_rough_state(hierarchy, level, random);
    double error = 0.0;
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) {
        double sum = 0.0;
        for (int k = 0; k <= grid.nx; ++k)
          for (int l = 0; l <= grid.ny; ++l)
            sum += ehl::kernel::influence(i - k, j - l, grid.hx(), grid.hy()) * level.P(k, l);
        const double w = 2.0 / (ehl::core::pi * ehl::core::pi) * sum;
        const double H = hierarchy.H00 + grid.X(i) * grid.X(i) / 2.0 + grid.Y(j) * grid.Y(j) / 2.0 +
                         (level.F.nodes_x() > 0 ? level.F(i, j) : 0.0) + w;
        error = std::max(error, std::abs(level.H(i, j) - H));
      }
    BOOST_TEST_MESSAGE((method == ehl::mlmi::Method::fft ? "fft" : "direct") << ": " << error << " (tolerance 1e-14)");
    BOOST_TEST(error < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(the_coarse_problem_starts_with_what_is_left_of_the_fine_one) {
  // Full approximation scheme: for the restricted state, the coarse film equals the fine film, and the coarse residuals
  // of all three equations are the restricted fine residuals. Without cavitation, no residual is omitted.
  multigrid::Hierarchy hierarchy = two_levels(fine_grid, ehl::reynolds::Cavitation::none);
  multigrid::Level& fine = hierarchy.levels[1];
  multigrid::Level& coarse = hierarchy.levels[0];
  Random random(5);
  set_rough_state(hierarchy, fine, random);
  fine.load = 1.7;
  multigrid::restrict_problem(hierarchy, fine, coarse);
  Field expected(coarse.grid);
  multigrid::restrict_residual(hierarchy, fine, expected);

  multigrid::update_film(hierarchy, coarse);
  double film = 0.0;
  for (int I = 0; I <= coarse.grid.nx; ++I)
    for (int J = 0; J <= coarse.grid.ny; ++J) film = std::max(film, std::abs(coarse.H(I, J) - fine.H(2 * I, 2 * J)));
  multigrid::update_residual(hierarchy, coarse);
  const double residual = largest_interior_difference(coarse.grid, coarse.r, expected) / ehl::core::max_abs(expected);
  const double balance = (coarse.load - multigrid::carried_load(coarse)) - (fine.load - multigrid::carried_load(fine));
  BOOST_TEST_MESSAGE("film " << film << " (tolerance 1e-14), residual " << residual
                             << " of the largest (tolerance 1e-11), load " << balance << " (tolerance 1e-14)");
  BOOST_TEST(film < 1e-14);
  BOOST_TEST(residual < 1e-11);
  BOOST_TEST(std::abs(balance) < 1e-14);

  // If the coarse grid changes nothing, the fine grid does not change.
  const Field P = fine.P;
  multigrid::correct_from_coarse(hierarchy, coarse, fine, false);
  BOOST_TEST(ehl::core::max_abs_difference(P, fine.P) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
