// The features that surfaces carry through the contact, compared with their formulas.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/norms.hpp"
#include "support/random.hpp"
#include "surface/feature.hpp"

BOOST_AUTO_TEST_SUITE(test_surface_feature)

using namespace ehl;
using namespace ehl::surface;
using Shape = Feature::Shape;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;
/// for formulas in a different form
constexpr double rounding = 1e-15;

constexpr Shape all_shapes[] = {Shape::dimple, Shape::bump,     Shape::ridge,
                                Shape::groove, Shape::waviness, Shape::cavity};
const std::string names[] = {"dimple", "bump", "ridge", "groove", "waviness", "cavity"};
std::string name(Shape shape) { return names[static_cast<int>(shape)]; }

struct At {
  double dX, dY, gap;
};

void compare(const std::string& what, const Feature& feature, const std::vector<At>& expected) {
  double worst = 0.0;
  for (const At& at : expected) worst = std::max(worst, std::abs(gap_of(feature, at.dX, at.dY) - at.gap));
  BOOST_TEST_MESSAGE(what << ": largest error " << worst << " (allowed " << rounding << ")");
  BOOST_TEST(worst <= rounding);
}

core::Field gap_field(const Feature& feature, const core::Patch& grid, double distance) {
  core::Field S(grid);
  add_gap(feature, grid, distance, S);
  return S;
}

}  // namespace

BOOST_AUTO_TEST_CASE(round_shapes_have_their_height_and_width) {
  // Half the depth at the width times sqrt(ln 2), 1/e of it at the width; the angle has no effect.
  const double half = 0.3 * std::sqrt(std::log(2.0));
  const Feature dimple{.shape = Shape::dimple, .height = 0.2, .width = 0.3, .angle = 0.4};
  compare("dimple", dimple,
          {{0, 0, 0.2}, {half, 0, 0.1}, {0, -half, 0.1}, {0.18, 0.24, 0.2 / std::exp(1.0)}, {30, 0, 0}});
  const Feature bump{.shape = Shape::bump, .height = 0.2, .width = 0.3, .angle = 0.4};
  compare("bump", bump, {{0, 0, -0.2}, {half, 0, -0.1}, {0, half, -0.1}, {-0.24, 0.18, -0.2 / std::exp(1.0)}});
}

BOOST_AUTO_TEST_CASE(lines_run_at_their_angle) {
  const double half = 0.3 * std::sqrt(std::log(2.0));
  for (const double angle : {0.0, 30.0 * degree, 90.0 * degree, -45.0 * degree}) {
    // The unit vector along the feature, at this angle from the Y axis, and the one transverse to it.
    const double along_x = -std::sin(angle), along_y = std::cos(angle);
    const double across_x = std::cos(angle), across_y = std::sin(angle);
    std::vector<At> expected;
    for (const double s : {-3.0, 0.0, 0.7}) {
      expected.push_back({s * along_x, s * along_y, 0.2});
      expected.push_back({s * along_x + half * across_x, s * along_y + half * across_y, 0.1});
      expected.push_back({s * along_x - 0.3 * across_x, s * along_y - 0.3 * across_y, 0.2 / std::exp(1.0)});
    }
    const std::string at = " at " + std::to_string(angle / degree) + " degrees";
    compare("groove" + at, {.shape = Shape::groove, .height = 0.2, .width = 0.3, .angle = angle}, expected);
    for (At& point : expected) point.gap *= -1.0;
    compare("ridge" + at, {.shape = Shape::ridge, .height = 0.2, .width = 0.3, .angle = angle}, expected);
  }
}

BOOST_AUTO_TEST_CASE(waves_fade_ahead_of_their_middle) {
  const Feature transverse{.shape = Shape::waviness, .height = 0.1, .width = 0.5};
  compare("transverse waves", transverse,
          {{0, 0, 0.1},
           {0, 3, 0.1},
           {-0.25, 1, -0.1},
           {-0.5, 0, 0.1},
           {-5, 0, 0.1},
           {-0.125, 0, 0},
           {-0.5 / 6, 0, 0.05},
           {0.25, 0, -0.1 * std::pow(10.0, -2.5)},
           {0.5, 0, 0.1e-10},
           {2, 0, 0}});
  const Feature longitudinal{.shape = Shape::waviness, .height = 0.1, .width = 0.5, .angle = 90.0 * degree};
  compare("longitudinal waves", longitudinal,
          {{-1, 0, 0.1}, {-3, 0.25, -0.1}, {0, -0.5, 0.1}, {0.25, 0.5, 0.1 * std::pow(10.0, -2.5)}, {1, 0.5, 1e-41}});
}

BOOST_AUTO_TEST_CASE(cavity_of_mourier) {
  // S = d cos(pi r/(2 1.2 r_t)) exp(-2 (r/(1.2 r_t))^2), Mourier et al. 2006.
  constexpr double d = 0.13, r_t = 0.25;
  const Feature cavity{.shape = Shape::cavity, .height = d, .width = r_t};
  std::vector<At> expected{{0, 0, d}, {1.2 * r_t, 0, 0}, {0, -1.2 * r_t, 0}, {-2.4 * r_t, 0, -d * std::exp(-8.0)}};
  tests::Random random(61);
  for (int k = 0; k < 100; ++k) {
    const double dX = random.between(-1.0, 1.0), dY = random.between(-1.0, 1.0);
    const double r = std::hypot(dX, dY);
    expected.push_back(
        {dX, dY, d * std::cos(pi * r / (2.0 * 1.2 * r_t)) * std::exp(-2.0 * std::pow(r / (1.2 * r_t), 2))});
  }
  compare("cavity", cavity, expected);
}

BOOST_AUTO_TEST_CASE(features_move_with_their_surface_and_add_up) {
  const core::Grid grid{32, 24, -2.5, 1.5, -1.5, 1.5};
  for (const Shape shape : all_shapes) {
    Feature feature{.shape = shape, .height = 0.2, .width = 0.4, .angle = 0.5, .X = -1.25, .Y = 0.25};
    // The centre of a feature that has moved by 1 is at X = -0.25: a node, where its height is that of the start.
    const core::Field S = gap_field(feature, grid, 1.0);
    const double sign = shape == Shape::bump || shape == Shape::ridge ? -1.0 : 1.0;
    BOOST_TEST(grid.X(18) == -0.25);
    BOOST_TEST(grid.Y(14) == 0.25);
    BOOST_TEST(S(18, 14) == sign * 0.2);
    BOOST_TEST((core::max_abs(S) == 0.2));
    // A feature that has moved equals one that started elsewhere, and equals the field shifted by whole cells.
    const core::Field before = gap_field(feature, grid, 0.5);
    double shifted = 0.0;
    for (int i = 4; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) shifted = std::max(shifted, std::abs(S(i, j) - before(i - 4, j)));
    feature.X += 1.0;
    const double begun = core::max_abs_difference(S, gap_field(feature, grid, 0.0));
    // The gap is added to the existing field.
    core::Field twice = S;
    add_gap(feature, grid, 0.0, twice);
    double added = 0.0;
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) added = std::max(added, std::abs(twice(i, j) - 2.0 * S(i, j)));
    BOOST_TEST_MESSAGE(name(shape) << ": shifted " << shifted << ", begun elsewhere " << begun << ", added " << added
                                   << " (allowed " << rounding << ")");
    BOOST_TEST(shifted <= rounding);
    BOOST_TEST(begun <= rounding);
    BOOST_TEST(added <= rounding);
  }
}

BOOST_AUTO_TEST_CASE(symmetric_features_are_those_whose_gap_is_symmetric) {
  const core::Grid grid{24, 24, -2.5, 1.5, -2, 2};
  for (const Shape shape : all_shapes)
    for (const double angle : {0.0, 30.0, 90.0})
      for (const double Y : {0.0, 0.3}) {
        const Feature feature{.shape = shape, .height = 0.2, .width = 0.7, .angle = angle * degree, .X = -1.0, .Y = Y};
        const core::Field S = gap_field(feature, grid, 0.37);
        double apart = 0.0;
        for (int i = 0; i <= grid.nx; ++i)
          for (int j = 0; j <= grid.ny; ++j) apart = std::max(apart, std::abs(S(i, j) - S(i, grid.ny - j)));
        const bool is_symmetric = apart < 1e-14;
        BOOST_TEST_MESSAGE(name(shape) << ", " << angle << " degrees, Y = " << Y << ": differs from its image by "
                                       << apart << " (symmetric: below 1e-14), "
                                       << (symmetric(feature) ? "symmetric" : "not symmetric"));
        BOOST_TEST(symmetric(feature) == is_symmetric);
        BOOST_TEST((is_symmetric || apart > 1e-2));  // no case is ambiguous
      }
}

BOOST_AUTO_TEST_CASE(resolving_distances) {
  const auto distance = [](Shape shape, double angle) {
    return resolving_distance({.shape = shape, .height = 0.2, .width = 0.8, .angle = angle * degree});
  };
  for (const Shape shape : {Shape::dimple, Shape::bump, Shape::cavity}) BOOST_TEST(distance(shape, 90.0) == 0.2);
  for (const Shape shape : {Shape::ridge, Shape::groove}) {
    BOOST_TEST(distance(shape, 0.0) == 0.2);
    BOOST_TEST(std::abs(distance(shape, -60.0) - 0.4) <= rounding);  // the domain is twice as long along X
    BOOST_TEST(distance(shape, 90.0) == std::numeric_limits<double>::infinity());
  }
  BOOST_TEST(distance(Shape::waviness, 0.0) == 0.05);
  BOOST_TEST(std::abs(distance(Shape::waviness, 60.0) - 0.1) <= rounding);
}

BOOST_AUTO_TEST_CASE(waves_without_a_front_stand_everywhere) {
  const Feature waves{.shape = Shape::waviness, .height = 0.1, .width = 0.5, .front = false};
  compare("waves", waves, {{0, 0, 0.1}, {0.25, 1, -0.1}, {0.5, 0, 0.1}, {2, 0, 0.1}, {-5, 3, 0.1}});
}

// The mean of a wave over a cell is the wave times sin(pi h/w)/(pi h/w) in each direction; that of a Gaussian bell is a
// product of error functions. Cells range from a twentieth of the width to three times the width.
BOOST_AUTO_TEST_CASE(means_over_cells) {
  const Feature waves{.shape = Shape::waviness, .height = 0.1, .width = 0.5, .angle = 30.0 * degree, .front = false};
  const Feature dimple{.shape = Shape::dimple, .height = 0.1, .width = 0.5, .X = 0.13, .Y = -0.21};
  for (const double h : {0.025, 0.125, 0.5, 1.5}) {
    const core::Grid grid{16, 12, -8 * h, 8 * h, -6 * h, 6 * h};
    core::Field of_waves(grid), of_dimple(grid);
    add_cell_average(waves, grid, of_waves);
    add_cell_average(dimple, grid, of_dimple);
    const auto factor = [&](double slope) {
      const double x = pi * h * slope / 0.5;
      return std::sin(x) / x;
    };
    const double left = factor(std::cos(waves.angle)) * factor(std::sin(waves.angle));
    const auto mean_of_bell = [&](double d) {
      return 0.5 * std::sqrt(pi) * 0.5 / h * (std::erf((d + 0.5 * h) / 0.5) - std::erf((d - 0.5 * h) / 0.5));
    };
    double worst_wave = 0.0, worst_dimple = 0.0;
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) {
        const double X = grid.X(i), Y = grid.Y(j);
        worst_wave = std::max(worst_wave, std::abs(of_waves(i, j) - left * gap_of(waves, X, Y)));
        worst_dimple = std::max(
            worst_dimple, std::abs(of_dimple(i, j) - 0.1 * mean_of_bell(X - dimple.X) * mean_of_bell(Y - dimple.Y)));
      }
    BOOST_TEST_MESSAGE("h = " << h << ": errors " << worst_wave << ", " << worst_dimple << " (allowed 1e-4)");
    BOOST_TEST(worst_wave < 1e-4);
    BOOST_TEST(worst_dimple < 1e-4);
  }
}

BOOST_AUTO_TEST_SUITE_END()
