// Elimination and decimation of the band, compared with a dense solution with pivoting.
#include <boost/test/unit_test.hpp>
#include <limits>

#include "unit/line_solvers/bands.hpp"

BOOST_AUTO_TEST_SUITE(test_line_solvers_bands)

using namespace ehl::tests;
using ehl::line_solvers::BandRow;
using ehl::line_solvers::Decimation;
using ehl::line_solvers::SmallPivot;

namespace {

// The condition numbers of the random bands are below 1e3.
constexpr double tolerance = 1e-12;

// Lengths below, at and above the block width of decimation, with odd and even numbers of blocks.
constexpr int lengths[] = {1, 2, 3, 7, 8, 63, 255};

template <int reach>
Eigen::MatrixXd dense_solution(const Band<reach>& band) {
  const int points = points_of(band.size());
  Eigen::MatrixXd solution(points, lanes);
  for (int lane = 0; lane < lanes; ++lane) {
    Eigen::VectorXd rhs(points);
    for (int i = 1; i <= points; ++i) rhs(i - 1) = band[static_cast<std::size_t>(i)].rhs[lane];
    solution.col(lane) = matrix_of<reach>(band, lane).partialPivLu().solve(rhs);
  }
  return solution;
}

template <int reach>
void compare_with_dense() {
  Random random(100 + reach);
  double worst_elimination = 0.0;
  double worst_decimation = 0.0;
  for (const int points : lengths) {
    Decimation<reach> decimation(points);
    for (int repeat = 0; repeat < (points < 10 ? 20 : 2); ++repeat) {
      const Band<reach> band = random_band<reach>(points, random);
      const Eigen::MatrixXd truth = dense_solution<reach>(band);
      const Solved eliminated = eliminate<reach>(band);
      // The work space is reused; nothing may remain of the previous system.
      const Solved decimated = decimate<reach>(band, decimation);
      BOOST_TEST(eliminated.small.point == -1);
      BOOST_TEST(decimated.small.point == -1);
      worst_elimination = std::max(worst_elimination, difference(truth, eliminated.delta));
      worst_decimation = std::max(worst_decimation, difference(truth, decimated.delta));
      BOOST_TEST(difference(truth, eliminated.delta) < tolerance, points << " points, elimination");
      BOOST_TEST(difference(truth, decimated.delta) < tolerance, points << " points, decimation");
    }
  }
  BOOST_TEST_MESSAGE("reach " << reach << ": elimination " << worst_elimination << ", decimation " << worst_decimation
                              << " (tolerance " << tolerance << ")");
}

template <int reach>
void known_solution() {
  Random random(7);
  Band<reach> band = random_band<reach>(63, random);
  Eigen::MatrixXd x(63, lanes);
  for (int lane = 0; lane < lanes; ++lane) {
    for (int i = 0; i < 63; ++i) x(i, lane) = std::sin(0.1 * (lane + 1) * (i + 1));
    const Eigen::VectorXd rhs = matrix_of<reach>(band, lane) * x.col(lane);
    for (int i = 1; i <= 63; ++i) band[static_cast<std::size_t>(i)].rhs[lane] = rhs(i - 1);
  }
  const double elimination = difference(x, eliminate<reach>(band).delta);
  const double decimation = difference(x, decimate<reach>(band).delta);
  BOOST_TEST_MESSAGE("reach " << reach << ", sines: elimination " << elimination << ", decimation " << decimation
                              << " (tolerance " << tolerance << ")");
  BOOST_TEST(elimination < tolerance);
  BOOST_TEST(decimation < tolerance);
}

// Points held at zero in some lanes stay exactly zero, and the other points solve the system without them.
template <int reach>
void identity_rows() {
  Random random(17);
  Band<reach> band = random_band<reach>(40, random);
  std::vector<std::array<bool, lanes>> held(band.size());
  for (std::size_t i = 1; i < band.size(); ++i) {
    ehl::core::LaneMask mask{};
    for (int lane = 0; lane < lanes; ++lane) {
      held[i][static_cast<std::size_t>(lane)] = random.chance(0.3);
      mask[lane] = held[i][static_cast<std::size_t>(lane)] ? -1 : 0;
    }
    const BandRow<reach> before = band[i];
    ehl::line_solvers::make_identity(band[i], mask);
    for (int lane = 0; lane < lanes; ++lane)
      if (!mask[lane]) BOOST_TEST(+band[i].a[0][lane] == +before.a[0][lane]);
  }
  const Solved eliminated = eliminate<reach>(band);
  const Solved decimated = decimate<reach>(band);
  double worst = 0.0;
  for (int lane = 0; lane < lanes; ++lane) {
    std::vector<int> free;
    for (std::size_t i = 1; i < band.size(); ++i)
      if (!held[i][static_cast<std::size_t>(lane)]) free.push_back(static_cast<int>(i) - 1);
    const Eigen::MatrixXd A = matrix_of<reach>(band, lane);
    Eigen::VectorXd rhs(static_cast<Eigen::Index>(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k)
      rhs(static_cast<Eigen::Index>(k)) = band[static_cast<std::size_t>(free[k]) + 1].rhs[lane];
    const Eigen::VectorXd x = A(free, free).partialPivLu().solve(rhs);
    for (std::size_t k = 0; k < free.size(); ++k) {
      const auto i = static_cast<std::size_t>(free[k]) + 1;
      const double truth = x(static_cast<Eigen::Index>(k));
      worst =
          std::max({worst, std::abs(eliminated.delta[i][lane] - truth), std::abs(decimated.delta[i][lane] - truth)});
    }
    for (std::size_t i = 1; i < band.size(); ++i)
      if (held[i][static_cast<std::size_t>(lane)])
        BOOST_TEST((eliminated.delta[i][lane] == 0.0 && decimated.delta[i][lane] == 0.0));
  }
  BOOST_TEST_MESSAGE("reach " << reach << ": free points beside held ones " << worst << " (tolerance " << tolerance
                              << ")");
  BOOST_TEST(worst < tolerance);
}

void same_place(const SmallPivot& small, int point, int lane) {
  BOOST_TEST(small.point == point);
  BOOST_TEST(small.lane == lane);
}

template <int reach>
void pivots_that_cannot_be_divided_by() {
  using Row = BandRow<reach>;
  Random random(27);
  const Band<reach> good = random_band<reach>(63, random);
  constexpr auto diagonal = static_cast<std::size_t>(Row::lower);
  for (const int point : {1, 2, 6, 32, 63})
    for (const int lane : {0, lanes / 2, lanes - 1}) {
      Band<reach> zero = good;
      for (Lanes& a : zero[static_cast<std::size_t>(point)].a) a[lane] = 0.0;
      same_place(eliminate<reach>(zero).small, point, lane);
      same_place(decimate<reach>(zero).small, point, lane);
      BOOST_TEST(eliminate<reach>(zero).small.pivot == 0.0);

      for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Band<reach> broken = good;
        broken[static_cast<std::size_t>(point)].a[diagonal][lane] = value;
        same_place(eliminate<reach>(broken).small, point, lane);
        same_place(decimate<reach>(broken).small, point, lane);
      }
    }
  constexpr int last = lanes - 1;
  // The matrix 1 1; 1 1+d has the pivot d: below 1e-13 it is lost in rounding, well above it is not.
  Band<reach> pair(static_cast<std::size_t>(3));
  for (std::size_t i = 1; i <= 2; ++i) pair[i].a[diagonal] += 1.0;
  pair[1].a[diagonal + 1][last] = 1.0;
  pair[2].a[diagonal - 1][last] = 1.0;
  for (const double pivot : {4e-15, -4e-15, 1e-11}) {
    pair[2].a[diagonal][last] = 1.0 + pivot;
    const SmallPivot eliminated = eliminate<reach>(pair).small;
    same_place(eliminated, std::abs(pivot) < 1e-13 ? 2 : -1, std::abs(pivot) < 1e-13 ? last : 0);
    same_place(decimate<reach>(pair).small, std::abs(pivot) < 1e-13 ? 2 : -1, std::abs(pivot) < 1e-13 ? last : 0);
    if (std::abs(pivot) < 1e-13) BOOST_TEST(std::abs(eliminated.pivot - pivot) < 1e-15);
  }
}

// All places where the two ends can meet, including an end without rows, or with fewer rows than the band width.
template <int reach>
void both_ends_meet() {
  Random random(200 + reach);
  double worst = 0.0;
  for (const int points : lengths) {
    const Band<reach> band = random_band<reach>(points, random);
    const Eigen::MatrixXd truth = dense_solution<reach>(band);
    for (int from_first = 0; from_first <= points; from_first += points < 10 ? 1 : 7) {
      const Solved solved = eliminate_from_both_ends<reach>(band, from_first);
      BOOST_TEST(solved.small.point == -1);
      worst = std::max(worst, difference(truth, solved.delta));
      BOOST_TEST(difference(truth, solved.delta) < tolerance, points << " points, " << from_first << " from the first");
    }
  }
  BOOST_TEST_MESSAGE("reach " << reach << ": from both ends " << worst << " (tolerance " << tolerance << ")");

  const Band<reach> good = random_band<reach>(63, random);
  for (const int point : {1, 20, 40, 63}) {
    Band<reach> broken = good;
    for (Lanes& a : broken[static_cast<std::size_t>(point)].a) a[lanes - 1] = 0.0;
    same_place(eliminate_from_both_ends<reach>(broken, 31).small, point, lanes - 1);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_solvers_give_the_dense_solution) {
  compare_with_dense<1>();
  compare_with_dense<2>();
  compare_with_dense<3>();
}

BOOST_AUTO_TEST_CASE(elimination_from_both_ends_gives_the_dense_solution) {
  both_ends_meet<1>();
  both_ends_meet<2>();
  both_ends_meet<3>();
}

BOOST_AUTO_TEST_CASE(both_solvers_find_a_known_solution) {
  known_solution<1>();
  known_solution<2>();
  known_solution<3>();
}

BOOST_AUTO_TEST_CASE(held_points_stay_and_let_the_others_solve) {
  identity_rows<1>();
  identity_rows<2>();
  identity_rows<3>();
}

BOOST_AUTO_TEST_CASE(bad_pivots_are_reported_where_they_are) {
  pivots_that_cannot_be_divided_by<1>();
  pivots_that_cannot_be_divided_by<2>();
  pivots_that_cannot_be_divided_by<3>();
}

BOOST_AUTO_TEST_SUITE_END()
