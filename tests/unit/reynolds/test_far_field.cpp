// The far field compared with its equation, with the closed form for circles, and with plain sums.
#include <boost/math/tools/roots.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reynolds/far_field.hpp"
#include "unit/reynolds/fields.hpp"

BOOST_AUTO_TEST_SUITE(test_reynolds_far_field)

using namespace ehl::tests;
using ehl::core::Grid;
using ehl::core::QuadraticForm;
using ehl::reynolds::FarField;
namespace reynolds = ehl::reynolds;
namespace rheology = ehl::rheology;

namespace {

constexpr double lambda = 0.7;
constexpr QuadraticForm circle{0.5, 0.0, 0.5};
/// R_x/R_y = 3 and 1/4, at an angle.
constexpr QuadraticForm oblique{0.8, 0.5, 1.1};
constexpr QuadraticForm slender{0.25, -0.1, 0.07};

FarField isoviscous(const QuadraticForm& gap, double deformation = 0.0) {
  return FarField({.gap = gap, .lambda = lambda, .deformation = deformation, .viscosity = rheology::Isoviscous{}});
}

/// The largest residual of the discrete equation in the region from (-7, 1) to (-5, 3), relative to the
/// largest wedge term for U = 1.
double relative_residual(const QuadraticForm& gap, int cells, const reynolds::FarState& state = {}) {
  const Grid grid{cells, cells, -7.0, -5.0, 1.0, 3.0};
  const FarField far = isoviscous(gap);
  Fields fields = zero_fields(grid);
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const double H = state.H00 + gap.at(grid.X(i), grid.Y(j));
      fields.H(i, j) = H;
      fields.P(i, j) = far.P(far.at(grid.X(i), grid.Y(j)), H, state);
      fields.rho_bar(i, j) = 1.0;
      fields.eps(i, j) = H * H * H / lambda;
    }
  ehl::core::Field r(grid);
  reynolds::residual(grid, fields.state(), {reynolds::Wedge::upstream2, state.speed}, 1, r);
  double largest = 0.0;
  for (int i = 2; i < cells; ++i)
    for (int j = 1; j < cells; ++j) largest = std::max(largest, std::abs(r(i, j) - state.approach));
  return largest / (2.0 * gap.XX * 7.0);
}

}  // namespace

// f = lambda (0.8 cos phi + c cosh 3 phi) with f = f' = 0 at the rupture: tan phi = -3 tanh 3 phi.
BOOST_AUTO_TEST_CASE(beside_a_circle_it_is_the_closed_form) {
  const auto condition = [](double phi) { return std::tan(phi) + 3.0 * std::tanh(3.0 * phi); };
  const auto [low, high] = boost::math::tools::bisect(condition, 1.6, 3.0, boost::math::tools::eps_tolerance<double>());
  const double rupture = 0.5 * (low + high);
  const double c = -0.8 * std::cos(rupture) / std::cosh(3.0 * rupture);
  const FarField far = isoviscous(circle);
  const double degrees = 180.0 / std::numbers::pi;
  BOOST_TEST_MESSAGE("rupture at " << far.rupture_angle() * degrees << " degrees, exactly " << rupture * degrees
                                   << "; c = " << c);
  BOOST_TEST(std::abs(far.rupture_angle() - rupture) * degrees < 0.2);  // the resolution in phi is 0.09 degrees
  double worst = 0.0;
  const double r = 5.0;
  for (double phi = -3.1; phi <= 3.1; phi += 0.1) {
    const double exact =
        std::abs(phi) < rupture ? lambda * (0.8 * std::cos(phi) + c * std::cosh(3.0 * phi)) / (r * r * r) : 0.0;
    const double P = far.P(-r * std::cos(phi), r * std::sin(phi), 0.5 * r * r);
    worst = std::max(worst, std::abs(P - exact) / (0.8 * lambda / (r * r * r)));
  }
  BOOST_TEST_MESSAGE("largest difference from the closed form, of the largest pressure: " << worst);
  BOOST_TEST(worst < 5e-6);
}

BOOST_AUTO_TEST_CASE(its_residual_in_the_discrete_operator_falls_with_the_second_order) {
  for (const QuadraticForm& gap : {circle, oblique, slender}) {
    const double coarse = relative_residual(gap, 16);
    const double fine = relative_residual(gap, 32);
    BOOST_TEST_MESSAGE("relative residual on 16, 32 cells: " << coarse << ", " << fine << ", order "
                                                             << std::log2(coarse / fine));
    BOOST_TEST(coarse < 0.02);
    BOOST_TEST(std::log2(coarse / fine) > 1.8);
  }
}

// -L(P) = -dH/dT, for a slow approach and separation in addition to a wedge that ruptures, and for an approach without
// rupture, for any H00. Where the far field consists of directions with a wedge, H00 is small compared with the gap.
BOOST_AUTO_TEST_CASE(with_a_squeeze_as_well) {
  for (const QuadraticForm& gap : {circle, oblique, slender})
    for (const reynolds::FarState& state :
         {reynolds::FarState{.speed = 0.7, .approach = 0.05}, reynolds::FarState{.speed = 1.2, .approach = -0.3},
          reynolds::FarState{.H00 = 2.0, .speed = 0.4, .approach = 20.0}}) {
      const double coarse = relative_residual(gap, 16, state);
      const double fine = relative_residual(gap, 32, state);
      BOOST_TEST_MESSAGE("U = " << state.speed << ", V = " << state.approach << ": relative residual on 16, 32 cells: "
                                << coarse << ", " << fine << ", order " << std::log2(coarse / fine));
      BOOST_TEST(fine < 0.02);
      BOOST_TEST(std::log2(coarse / fine) > 1.8);
    }
}

// A circular body that approaches without rolling: P = lambda V/(4 H^2), whose integral over r from r_0 is
// lambda V/(4 (H00 + r_0^2/2)).
BOOST_AUTO_TEST_CASE(pure_squeeze_is_the_elementary_solution) {
  const FarField far(
      {.gap = circle, .lambda = lambda, .viscosity = rheology::Isoviscous{}, .domain = {16, 16, -2.0, 2.0, -2.0, 2.0}});
  const reynolds::FarState state{.H00 = 1.5, .speed = 0.0, .approach = 3.0};
  const double H = state.H00 + 0.5 * (4.0 + 1.0);
  BOOST_TEST(std::abs(far.P(far.at(2.0, -1.0), H, state) / (0.25 * lambda * 3.0 / (H * H)) - 1.0) < 1e-12);
  // Four times the integral over the angles within 45 degrees, where the boundary is at r = 2/cos phi.
  double exact = 0.0;
  constexpr int n = 2000;
  for (int k = 0; k < n; ++k) {
    const double c = std::cos((k + 0.5) / n * std::numbers::pi / 4.0);
    exact += 8.0 * std::numbers::pi / 4.0 / n * 0.25 * lambda * 3.0 / (state.H00 + 2.0 / (c * c));
  }
  BOOST_TEST_MESSAGE("load outside " << far.load_outside(state) << ", exactly " << exact);
  BOOST_TEST(std::abs(far.load_outside(state) / exact - 1.0) < 1e-6);
  BOOST_TEST(far.load_outside({.H00 = 1.5, .speed = 0.0, .approach = -3.0}) == 0.0);
}

// Sums over square frames outside the domain, each twice as large as the one before, with the rest
// proportional to 1/r; midpoint rule.
BOOST_AUTO_TEST_CASE(the_load_outside_is_the_sum_of_the_pressure_there) {
  const Grid domain{32, 32, -3.0, 2.0, -2.5, 2.5};
  const double H00 = -0.4;
  for (const QuadraticForm& gap : {circle, oblique}) {
    const double deformation = 0.42;
    const FarField far({.gap = gap,
                        .lambda = lambda,
                        .deformation = deformation,
                        .viscosity = rheology::Isoviscous{},
                        .domain = domain});
    const auto P = [&](double X, double Y) { return far.P(X, Y, H00 + gap.at(X, Y) + deformation / std::hypot(X, Y)); };
    double sum = 0.0;
    double last_frame = 0.0;
    constexpr int n = 400;
    // The frame between s times and 2 s times the domain.
    for (double s = 1.0; s < 200.0; s *= 2.0) {
      last_frame = 0.0;
      const double hx = 2.0 * s * (domain.X_b - domain.X_a) / n;
      const double hy = 2.0 * s * (domain.Y_b - domain.Y_a) / n;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const double X = 2.0 * s * domain.X_a + (i + 0.5) * hx;
          const double Y = 2.0 * s * domain.Y_a + (j + 0.5) * hy;
          const bool inside = X > s * domain.X_a && X < s * domain.X_b && Y > s * domain.Y_a && Y < s * domain.Y_b;
          if (!inside) last_frame += P(X, Y) * hx * hy;
        }
      sum += last_frame;
    }
    sum += last_frame;  // the remaining frames form a geometric series, because P decays as r^-3
    const double load = far.load_outside({.H00 = H00});
    BOOST_TEST_MESSAGE("load outside " << load << ", summed " << sum);
    BOOST_TEST(std::abs(load / sum - 1.0) < 1e-3);
  }
}

// For a Barus oil q = (1 - exp(-alpha_bar P))/alpha_bar.
BOOST_AUTO_TEST_CASE(viscosity_enters_by_the_reduced_pressure) {
  const double alpha_bar = 12.0;
  const FarField oil({.gap = circle, .lambda = lambda, .viscosity = rheology::Barus{alpha_bar}});
  const double X = -2.6;
  const double Y = 0.7;
  const double H = 3.0;
  const double q = isoviscous(circle).P(X, Y, H);
  const double P = oil.P(X, Y, H);
  BOOST_TEST_MESSAGE("q = " << q << ", P = " << P);
  BOOST_TEST(std::abs((1.0 - std::exp(-alpha_bar * P)) / alpha_bar / q - 1.0) < 1e-9);
  BOOST_TEST(P > 1.1 * q);
  BOOST_TEST_MESSAGE("off by " << (1.0 - std::exp(-alpha_bar * P)) / alpha_bar / q - 1.0);
  // q = 1/alpha_bar is not reached at any pressure.
  BOOST_TEST(std::isnan(oil.P(-1.5, 0.1, 1.0)));
}

// Without deformation, q = -(lambda/3) X/H^2 has the flow 4/3 H00 and satisfies the equation exactly.
BOOST_AUTO_TEST_CASE(the_line_contact_has_its_exact_solution) {
  const Grid domain = ehl::core::line_grid(64, -3.0, 1.5);
  const FarField far({.gap = {0.5, 0.0, 0.0}, .lambda = lambda, .viscosity = rheology::Isoviscous{}, .domain = domain});
  for (const double H00 : {0.3, 0.0, -0.4}) {
    const reynolds::FarState state{.H00 = H00, .flow = 4.0 / 3.0 * H00};
    const auto exact = [&](double X) { return -lambda / 3.0 * X / std::pow(H00 + 0.5 * X * X, 2); };
    for (const double X : {-2.0, -3.0, -20.0})
      BOOST_TEST(std::abs(far.P(far.at(X, 0.0), H00 + 0.5 * X * X, state) / exact(X) - 1.0) < 1e-6, "X = " << X);
    // The integral of X/H^2 is -1/H.
    const double load = lambda / 3.0 / (H00 + 4.5);
    BOOST_TEST(std::abs(far.load_outside(state) / load - 1.0) < 1e-6, "load at H00 = " << H00);
    BOOST_TEST(far.P(far.at(1.5, 0.0), 1.0, state) == 0.0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
