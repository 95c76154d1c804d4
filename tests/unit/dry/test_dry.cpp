// The dry contact compared with Hertz and, for a wavy surface, with Westergaard.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "dry/solve.hpp"

BOOST_AUTO_TEST_SUITE(test_dry)

using namespace ehl;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double load = 2.0 * pi / 3.0;

core::Grid square(int cells, double half = 1.5) { return {cells, cells, -half, half, -half, half}; }

dry::Problem smooth(const core::Patch& grid, mlmi::Method method = mlmi::Method::fft) {
  return {grid, dry::smooth_gap(grid), load, {.method = method}, {}, 1};
}

struct Errors {
  double center, approach, mean, area;
};

Errors against_hertz(int cells, mlmi::Method method) {
  const core::Grid grid = square(cells);
  const dry::Solution s = dry::solve(smooth(core::lower_half(grid), method));
  double mean = 0.0;
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) {
      const double square_of_P = 1.0 - grid.X(i) * grid.X(i) - grid.Y(j) * grid.Y(j);
      mean += std::abs(s.P(i, j) - std::sqrt(std::max(0.0, square_of_P))) * grid.hx() * grid.hy();
    }
  return {std::abs(s.P(cells / 2, cells / 2) - 1.0), std::abs(s.H00 + 1.0), mean / load,
          std::abs(s.rows.back().area / pi - 1.0)};
}

// G = smooth + A cos(2 pi X/wavelength).
dry::Problem wavy(int cells, double amplitude, double wavelength) {
  const core::Patch grid = core::lower_half(square(cells, 1.25));
  dry::Problem problem = smooth(grid);
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j)
      problem.gap(i, j) += amplitude * std::cos(2.0 * pi * grid.X(i) / wavelength);
  return problem;
}

// The amplitude of -cos(2 pi X/wavelength) in P along Y = 0, over the two waves in the middle.
double amplitude_of(const core::Patch& grid, const core::Field& P, double wavelength) {
  const int wave = static_cast<int>(std::lround(wavelength / grid.hx()));
  double sum = 0.0;
  for (int i = grid.nx / 2 - wave; i < grid.nx / 2 + wave; ++i)
    sum -= P(i, grid.ny / 2) * std::cos(2.0 * pi * grid.X(i) / wavelength);
  return sum / wave;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_pressure_tends_to_hertz) {
  for (const auto& [method, name] : {std::pair{mlmi::Method::fft, "fft"}, {mlmi::Method::mlmi, "mlmi"}}) {
    std::vector<Errors> errors;
    for (const int cells : {32, 64, 128, 256}) {
      errors.push_back(against_hertz(cells, method));
      BOOST_TEST_MESSAGE(name << ", " << cells << " cells over 3 a: P(0,0) " << errors.back().center << ", approach "
                              << errors.back().approach << ", mean of |P - Hertz| " << errors.back().mean);
    }
    const auto order = [&](double Errors::*error) { return std::log2(errors[0].*error / errors[3].*error) / 3.0; };
    BOOST_TEST_MESSAGE(name << ": orders " << order(&Errors::center) << " " << order(&Errors::approach) << " (2) "
                            << order(&Errors::mean) << " (1.5, the square root at the edge)");
    BOOST_TEST(order(&Errors::approach) > 1.8);
    BOOST_TEST(order(&Errors::mean) > 1.3);
    // The error of mlmi, about a tenth of that of the mesh, may have either sign.
    BOOST_TEST(order(&Errors::center) > (method == mlmi::Method::fft ? 1.8 : 1.4));
    BOOST_TEST(errors[3].center < 5e-5);
    BOOST_TEST(errors[3].approach < 1e-5);
    BOOST_TEST_MESSAGE(name << ": area " << errors[3].area << " (0.005: nodes within half a cell of the edge)");
    BOOST_TEST(errors[3].area < 0.005);
  }
}

BOOST_AUTO_TEST_CASE(signorini_holds_at_every_node) {
  const dry::Problem problem = smooth(core::lower_half(square(96)));
  const dry::Solution s = dry::solve(problem);
  BOOST_TEST(s.converged);
  double least_P = 0.0, least_H = 0.0, largest_product = 0.0, sum = 0.0;
  for (int i = 0; i <= 96; ++i)
    for (int j = 0; j <= 96; ++j) {
      least_P = std::min(least_P, s.P(i, j));
      least_H = std::min(least_H, s.H(i, j));
      largest_product = std::max(largest_product, std::abs(s.P(i, j) * s.H(i, j)));
      sum += s.P(i, j);
    }
  const double load_error = std::abs(sum * s.grid.hx() * s.grid.hy() / load - 1.0);
  BOOST_TEST_MESSAGE("least P " << least_P << ", least H " << least_H << ", largest P H " << largest_product
                                << " (1e-8), load error " << load_error << " (1e-13)");
  BOOST_TEST(least_P == 0.0);
  BOOST_TEST(least_H >= -1e-8);
  BOOST_TEST(largest_product < 1.1e-8);
  BOOST_TEST(load_error < 1e-13);
  // H satisfies the film equation.
  mlmi::Deformation deformation(s.grid, {.method = mlmi::Method::direct}, 1);
  core::Field w(s.grid);
  deformation.evaluate(s.P, w);
  double difference = 0.0;
  for (int i = 0; i <= 96; i += 8)
    for (int j = 0; j <= 96; j += 8)
      difference = std::max(difference, std::abs(s.H(i, j) - w(i, j) - s.H00 - 0.5 * s.grid.X(i) * s.grid.X(i) -
                                                 0.5 * s.grid.Y(j) * s.grid.Y(j)));
  BOOST_TEST_MESSAGE("gap against the direct sum " << difference << " (1e-12)");
  BOOST_TEST(difference < 1e-12);
}

BOOST_AUTO_TEST_CASE(waviness_in_full_contact_is_westergaards) {
  // A wave A cos(2 pi x/wavelength) that is pressed flat carries p* cos with p* = pi E' A/(2 wavelength) (Johnson,
  // section 13.2, E* = E'/2); in units of p_h and a^2/R: p* = pi^2 A/(2 wavelength). The edge of the contact is several
  // wavelengths away and has little influence.
  constexpr double wavelength = 0.25, star = 0.2, amplitude = 2.0 * wavelength * star / (pi * pi);
  double error[3] = {};
  for (int k = 0; k < 3; ++k) {
    const int cells = 80 << k;
    const dry::Solution with = dry::solve(wavy(cells, amplitude, wavelength));
    const dry::Solution without = dry::solve(wavy(cells, 0.0, wavelength));
    BOOST_TEST(with.converged);
    const double found = amplitude_of(with.grid, with.P, wavelength) - amplitude_of(with.grid, without.P, wavelength);
    error[k] = std::abs(found / star - 1.0);
    double gap = 0.0;
    for (int i = 3 * cells / 8; i <= 5 * cells / 8; ++i) gap = std::max(gap, std::abs(with.H(i, cells / 2)));
    BOOST_TEST_MESSAGE((8 << k) << " cells to a wave: amplitude " << found << " p_h (Westergaard " << star
                                << "), error " << error[k] << "; gap in the middle " << gap);
    BOOST_TEST(gap < 1e-8);
  }
  const double order = std::log2(error[0] / error[2]) / 2.0;
  BOOST_TEST_MESSAGE("order " << order << " (2)");
  BOOST_TEST(order > 1.8);
  BOOST_TEST(error[2] < 0.003);
}

BOOST_AUTO_TEST_CASE(waviness_above_the_mean_pressure_parts_the_surfaces) {
  // Westergaard's wave is flat where the mean pressure reaches p*; here the mean pressure is at most 1.
  constexpr double wavelength = 0.25;
  for (const double star : {0.7, 1.5}) {
    const dry::Solution s = dry::solve(wavy(160, 2.0 * wavelength * star / (pi * pi), wavelength));
    BOOST_TEST(s.converged);
    const int middle = 80;
    BOOST_TEST_MESSAGE("p* = " << star << ": gap at the centre " << s.H(middle, middle) << ", pressure "
                               << s.P(middle, middle));
    if (star < 1.0)
      BOOST_TEST((std::abs(s.H(middle, middle)) < 1e-8 && s.P(middle, middle) > 0.0));
    else
      BOOST_TEST((s.H(middle, middle) > 1e-4 && s.P(middle, middle) == 0.0));
  }
}

BOOST_AUTO_TEST_CASE(half_a_domain_other_evaluators_and_threads_change_nothing) {
  const core::Grid grid = square(64);
  // The solutions must agree beyond their tolerance, so a much smaller tolerance than the default is used.
  const auto solved = [](dry::Problem problem) {
    problem.parameters.tolerance = 1e-11;
    return dry::solve(problem);
  };
  const dry::Solution half = solved(smooth(core::lower_half(grid)));
  const dry::Solution whole = solved(smooth(grid));
  const dry::Solution direct = solved(smooth(core::lower_half(grid), mlmi::Method::direct));
  dry::Problem more = smooth(core::lower_half(square(256)));
  const dry::Solution one = dry::solve(more);
  more.threads = 3;
  const dry::Solution three = dry::solve(more);
  const double by_half = core::max_abs_difference(half.P, whole.P);
  const double by_sum = core::max_abs_difference(half.P, direct.P);
  BOOST_TEST_MESSAGE("half " << by_half << ", direct sum " << by_sum << " (1e-9: the tolerance of the gap over K)");
  BOOST_TEST((half.converged && whole.converged && direct.converged));
  BOOST_TEST(by_half < 1e-9);
  BOOST_TEST(by_sum < 1e-9);
  BOOST_TEST(core::max_abs_difference(one.P, three.P) == 0.0);
}

BOOST_AUTO_TEST_CASE(what_does_not_converge_says_so) {
  dry::Problem hasty = smooth(core::lower_half(square(64)));
  hasty.parameters.max_iterations = 3;
  const dry::Solution s = dry::solve(hasty);
  BOOST_TEST(!s.converged);
  BOOST_TEST(s.failed_check.find("3 iterations") != std::string::npos);
  const dry::Solution narrow = dry::solve(smooth(core::lower_half(square(32, 0.9))));
  BOOST_TEST(!narrow.converged);
  BOOST_TEST(narrow.failed_check.find("larger domain") != std::string::npos);
  BOOST_CHECK_THROW(dry::solve(smooth(square(32)), [](const dry::Progress&) { return false; }), core::Interrupted);
  dry::Problem broken = smooth(square(32));
  broken.gap(5, 5) = std::nan("");
  BOOST_CHECK_THROW(dry::solve(broken), core::SolverError);
}

BOOST_AUTO_TEST_SUITE_END()
