// Order of accuracy of the discrete operator, both the exponent and the constant, for fields with a
// truncation error in closed form.
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "unit/reynolds/fields.hpp"

BOOST_AUTO_TEST_SUITE(test_reynolds_order)

using namespace ehl::tests;
namespace reynolds = ehl::reynolds;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;
using reynolds::Wedge;

namespace {

// P = exp(mu X + nu Y), eps = exp(alpha X + beta Y), rho_bar H = exp(gamma X + delta Y): every derivative is a
// multiple of the function.
constexpr double mu = 0.7, nu = -0.9, alpha = 1.1, beta = 0.6, gamma = -0.8, delta = 0.5;
constexpr double growth_rho = 0.2;

Fields sampled_fields(const Patch& grid) {
  Fields fields = zero_fields(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) {
      const double X = grid.X(i);
      const double Y = grid.Y(j);
      fields.P(i, j) = std::exp(mu * X + nu * Y);
      fields.eps(i, j) = std::exp(alpha * X + beta * Y);
      fields.third_order(i, j) = i > 0 ? 1.0 : 0.0;
      fields.rho_bar(i, j) = std::exp(growth_rho * X);
      fields.H(i, j) = std::exp((gamma - growth_rho) * X + delta * Y);
    }
  return fields;
}

// The Poiseuille term in one direction, for growth rates p of P and e of eps, in units of eps P: its value,
// and its h^2 error. With means at half points, the flux is F + h^2 (eps'' P'/8 + eps P'''/24), and the
// difference adds h^2 F'''/24.
double poiseuille(double p, double e) { return p * (p + e); }
double poiseuille_error(double p, double e) {
  return p * (p + e) * (e * e / 8.0 + p * p / 24.0 + (p + e) * (p + e) / 24.0);
}

struct Errors {
  double measured = 0.0;     ///< largest difference from the differential operator
  double unexplained = 0.0;  ///< largest difference after subtraction of the leading error term
};

Errors errors(int n, Wedge wedge, bool with_poiseuille, bool with_wedge) {
  const Grid grid{n, 3 * n / 2, -1.0, 1.0, -0.5, 1.0};
  Fields fields = sampled_fields(grid);
  if (!with_poiseuille) fields.P.fill(1.0);
  if (!with_wedge) fields.H.fill(0.0);
  Field r(grid);
  reynolds::residual(grid, fields.state(), wedge, 1, r);
  const double hx = grid.hx();
  const double hy = grid.hy();
  Errors result;
  for (int i = 2; i < grid.nx; ++i)  // column 1 has the first-order wedge, which is tested separately
    for (int j = 1; j < grid.ny; ++j) {
      const double eps_P = fields.eps(i, j) * fields.P(i, j);
      const double flow = fields.rho_bar(i, j) * fields.H(i, j);
      double exact = 0.0;
      double leading = 0.0;
      if (with_poiseuille) {
        exact += eps_P * (poiseuille(mu, alpha) + poiseuille(nu, beta));
        leading += eps_P * (hx * hx * poiseuille_error(mu, alpha) + hy * hy * poiseuille_error(nu, beta));
      }
      if (with_wedge) {
        exact -= gamma * flow;
        const double gamma2 = gamma * gamma;
        leading -= wedge == Wedge::upstream1   ? -hx / 2.0 * gamma2 * flow
                   : wedge == Wedge::upstream2 ? -hx * hx / 3.0 * gamma2 * gamma * flow
                                               : hx * hx * hx / 12.0 * gamma2 * gamma2 * flow;
      }
      const double error = -r(i, j) - exact;
      result.measured = std::max(result.measured, std::abs(error));
      result.unexplained = std::max(result.unexplained, std::abs(error - leading));
    }
  return result;
}

void check_order(const char* what, double order, Wedge wedge, bool with_poiseuille, bool with_wedge) {
  std::array<Errors, 3> e;
  for (int k = 0; k < 3; ++k) e[static_cast<std::size_t>(k)] = errors(32 << k, wedge, with_poiseuille, with_wedge);
  const double slope = std::log2(e[1].measured / e[2].measured);
  const double share = e[2].unexplained / e[2].measured;
  BOOST_TEST_MESSAGE(what << ": errors " << e[0].measured << ' ' << e[1].measured << ' ' << e[2].measured << ", order "
                          << slope << " (wanted " << order << " +- 0.1), beyond the leading term " << share
                          << " of it (tolerance 0.02)");
  // On finer grids the node with the largest error is closer to the corner, which reduces the slope slightly.
  BOOST_TEST(std::abs(slope - order) < 0.1);
  BOOST_TEST(share < 0.02);
  // The remainder after the leading term is of higher order, so the constant is exact.
  BOOST_TEST(std::log2(e[1].unexplained / e[2].unexplained) > order + 0.8);
}

}  // namespace

BOOST_AUTO_TEST_CASE(poiseuille_terms_are_of_second_order) {
  check_order("Poiseuille", 2.0, Wedge::upstream2, true, false);
}

BOOST_AUTO_TEST_CASE(upstream1_is_of_first_order) { check_order("upstream1", 1.0, Wedge::upstream1, false, true); }

BOOST_AUTO_TEST_CASE(upstream2_is_of_second_order) { check_order("upstream2", 2.0, Wedge::upstream2, false, true); }

// epsilon/h^2 is large on every grid, so that the share of second order is negligible.
BOOST_AUTO_TEST_CASE(upstream3_is_of_third_order) { check_order("upstream3", 3.0, Wedge::upstream3, false, true); }

BOOST_AUTO_TEST_CASE(whole_operator_has_the_order_of_its_wedge) {
  check_order("all, upstream1", 1.0, Wedge::upstream1, true, true);
  check_order("all, upstream2", 2.0, Wedge::upstream2, true, true);
}

BOOST_AUTO_TEST_CASE(first_column_has_the_first_order_wedge) {
  const Grid grid{32, 32, -1, 1, -1, 1};
  Fields fields = sampled_fields(grid);
  Field one(grid);
  Field two(grid);
  reynolds::residual(grid, fields.state(), Wedge::upstream1, 1, one);
  reynolds::residual(grid, fields.state(), Wedge::upstream2, 1, two);
  for (int j = 1; j < grid.ny; ++j) BOOST_TEST(one(1, j) == two(1, j));
  BOOST_TEST(one(2, 1) != two(2, 1));
}

BOOST_AUTO_TEST_SUITE_END()
