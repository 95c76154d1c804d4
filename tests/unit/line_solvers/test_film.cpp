// Elimination of the film equation, compared with the original system with two unknowns per point, solved densely.
#include <boost/test/unit_test.hpp>

#include "unit/line_solvers/bands.hpp"

BOOST_AUTO_TEST_SUITE(test_line_solvers_film)

using namespace ehl::tests;
using ehl::line_solvers::BandRow;
using ehl::line_solvers::FilmTerms;
using ehl::line_solvers::PointEquation;

namespace {

constexpr int points = 30;
// The number of entries of `distributive` that lie outside the line on each side.
constexpr int margin = ehl::line_solvers::max_reach + 2;

struct Line {
  FilmTerms film;
  std::vector<PointEquation<3>> point;  // 1..points
  std::vector<Lanes> distributive;      // point i at i + margin
};

/// share: the share of points with distributive relaxation.
Line random_line(int reach, double share, Random& random) {
  Line line;
  line.film.reach = reach;
  for (std::size_t d = 0; d <= static_cast<std::size_t>(reach); ++d) {
    line.film.K[d] = random.between(0.5, 1.0) / static_cast<double>(d + 1);
    line.film.delta_K[d] = random.between(-0.3, 0.6) / static_cast<double>(d + 1);
  }
  line.point.resize(points + 1);
  line.distributive.resize(points + 1 + 2 * margin);
  for (std::size_t i = 1; i <= points; ++i)
    for (int lane = 0; lane < lanes; ++lane) {
      PointEquation<3>& point = line.point[i];
      for (Lanes& a : point.a) a[lane] = random.between(-1.0, 1.0);
      for (Lanes& c : point.c) c[lane] = random.between(-1.0, 1.0);
      point.a[2][lane] = -random.between(8.0, 12.0);
      point.r[lane] = random.between(-1.0, 1.0);
      line.distributive[i + margin][lane] = random.chance(share) ? 1.0 : 0.0;
    }
  return line;
}

/// Unknowns delta_1..delta_n and h_-1..h_n: the film also changes upstream of the line's first point. The equations are
/// those of line_system.hpp.
Eigen::VectorXd solve_both_unknowns(const Line& line, int lane) {
  constexpr int first_h = -1;
  constexpr int films = points - first_h + 1;
  const auto at_delta = [](int i) { return i - 1; };
  const auto at_h = [](int i) { return points + i - first_h; };
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(points + films, points + films);
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(points + films);
  for (int i = first_h; i <= points; ++i) {
    A(at_h(i), at_h(i)) = 1.0;
    for (int k = 1; k <= points; ++k) {
      const auto distance = static_cast<std::size_t>(std::abs(i - k));
      if (std::abs(i - k) > line.film.reach) continue;
      const bool distributed = line.distributive[static_cast<std::size_t>(k + margin)][lane] > 0.0;
      A(at_h(i), at_delta(k)) = -(distributed ? line.film.delta_K[distance] : line.film.K[distance]);
    }
  }
  for (int i = 1; i <= points; ++i) {
    const PointEquation<3>& point = line.point[static_cast<std::size_t>(i)];
    for (int k = -2; k <= 2; ++k)
      if (i + k >= 1 && i + k <= points)
        A(at_delta(i), at_delta(i + k)) = point.a[static_cast<std::size_t>(k + 2)][lane];
    for (int m = 0; m < 3; ++m) A(at_delta(i), at_h(i - m)) = -point.c[static_cast<std::size_t>(m)][lane];
    rhs(at_delta(i)) = point.r[lane];
  }
  return A.partialPivLu().solve(rhs).head(points);
}

template <int reach>
void compare(double share) {
  Random random(static_cast<std::uint64_t>(1000 * share) + reach);
  const Line line = random_line(reach, share, random);
  Band<reach> band(points + 1);
  for (std::size_t i = 1; i <= points; ++i)
    band[i] = ehl::line_solvers::eliminate_film<reach>(line.film, line.point[i], line.distributive.data() + margin + i);
  Eigen::MatrixXd truth(points, lanes);
  for (int lane = 0; lane < lanes; ++lane) truth.col(lane) = solve_both_unknowns(line, lane);
  const double elimination = difference(truth, eliminate<reach>(band).delta);
  const double decimation = difference(truth, decimate<reach>(band).delta);
  BOOST_TEST_MESSAGE("reach " << reach << ", " << 100 * share << " % distributive: elimination " << elimination
                              << ", decimation " << decimation << " (tolerance 1e-12)");
  BOOST_TEST(elimination < 1e-12);
  BOOST_TEST(decimation < 1e-12);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_band_without_the_film_has_the_solution_of_the_full_system) {
  for (const double share : {0.0, 0.5, 1.0}) {
    compare<1>(share);
    compare<2>(share);
    compare<3>(share);
  }
}

BOOST_AUTO_TEST_SUITE_END()
