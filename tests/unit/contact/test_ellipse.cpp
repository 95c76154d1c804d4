// The exact Hertz ellipse, its groups, and the film formulas of elliptic contacts.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <initializer_list>

#include "contact/ellipse.hpp"
#include "contact/film_formulas.hpp"
#include "contact/groups.hpp"
#include "contact/hertz.hpp"
#include "core/constants.hpp"

BOOST_AUTO_TEST_SUITE(test_contact_ellipse)

using namespace ehl::contact;
using ehl::core::pi;
using ehl::core::QuadraticForm;

namespace {

void check(const char* what, double computed, double expected, double tolerance) {
  const double error = std::abs(computed - expected) / std::max(1.0, std::abs(expected));
  BOOST_TEST_MESSAGE(what << " = " << computed << ", expected " << expected << ", difference " << error
                          << " (tolerance " << tolerance << ")");
  BOOST_TEST(error <= tolerance);
}

double value(const QuadraticForm& form, double X, double Y) {
  return form.XX * X * X + form.XY * X * Y + form.YY * Y * Y;
}

// The integral of P/r over the dry contact for a point (X, Y) inside it, P = sqrt(1 - outline). Along a chord with P^2
// = A - 2 B t - C t^2, the integral of P is pi (B^2 + A C)/(2 C^(3/2)). The sum over directions converges faster than
// any power of their number.
double integral_from(const QuadraticForm& form, double X, double Y) {
  constexpr int directions = 400;
  double sum = 0.0;
  for (int n = 0; n < directions; ++n) {
    const double c = std::cos(n * pi / directions), s = std::sin(n * pi / directions);
    const double A = 1.0 - value(form, X, Y);
    const double B = form.XX * X * c + 0.5 * form.XY * (X * s + Y * c) + form.YY * Y * s;
    const double C = value(form, c, s);
    sum += pi * (B * B + A * C) / (2.0 * std::pow(C, 1.5));
  }
  return sum * pi / directions;
}

}  // namespace

// Solved by bracketing with the elliptic integrals of an independent program; the first digits
// are those of the reference.
BOOST_AUTO_TEST_CASE(semi_axes_of_given_radii) {
  struct Row {
    double radius_ratio, kappa;
  };
  for (const auto& [ratio, kappa] : {Row{1.25, 1.1603574976990}, Row{2, 1.5858021197026}, Row{5, 2.8901810398364},
                                     Row{10, 4.4994473031554}, Row{20, 6.9286809643572}}) {
    check("kappa of R_y/R_x > 1", ellipse(1.0 / ratio).kappa, kappa, 1e-10);
    check("kappa of R_y/R_x < 1", 1.0 / ellipse(ratio).kappa, kappa, 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(transcendental_equation) {
  double worst = 0.0;
  for (double ratio = 1.02; ratio < 400.0; ratio *= 1.1) {
    const double kappa = ellipse(1.0 / ratio).kappa;
    const double modulus = std::sqrt((1.0 - 1.0 / kappa) * (1.0 + 1.0 / kappa));
    const double K = std::comp_ellint_1(modulus), E = std::comp_ellint_2(modulus);
    worst = std::max(worst, std::abs((kappa * kappa * E - K) / (K - E) / ratio - 1.0));
  }
  check("residual for R_y/R_x from 1.02 to 400", worst, 0.0, 1e-12);
  // Near the circle kappa = (R_y/R_x)^(2/3) to first order; the integrals alone would suffer from cancellation there.
  check("(kappa - 1)/(R_y/R_x - 1) near the circle", (ellipse(1.0 / (1.0 + 1e-7)).kappa - 1.0) / 1e-7, 2.0 / 3.0, 1e-6);
}

// A dry contact has no gap inside: gap + elastic factor K*P = approach, and the pressure carries the load. Wide,
// slender and nearly circular contacts, along the axes and at an angle.
BOOST_AUTO_TEST_CASE(dry_contact_has_no_gap) {
  for (const double ratio : {0.005, 0.05, 0.3, 0.999, 1.0, 4.0, 20.0})
    for (const double angle : {0.0, 35.0, 90.0, -60.0}) {
      const Ellipse shape = ellipse(ratio, angle);
      const QuadraticForm form = outline(shape);
      double worst = 0.0;
      for (const double along : {0.0, 0.4, 0.8})
        for (const double direction : {0.0, 1.0, 2.5}) {
          const double c = std::cos(direction), s = std::sin(direction);
          const double r = along / std::sqrt(value(form, c, s));
          const double H = value(gap(shape), r * c, r * s) + elastic_factor(shape) * integral_from(form, r * c, r * s) -
                           shape.approach;
          worst = std::max(worst, std::abs(H));
        }
      BOOST_TEST_MESSAGE("R_x/R_y = " << ratio << ", " << angle << " degrees:");
      check("largest gap inside", worst, 0.0, 1e-11);
      const double area = pi / std::sqrt(form.XX * form.YY - 0.25 * form.XY * form.XY);
      check("load", load(shape) / (2.0 / 3.0 * area), 1.0, 1e-12);
      // The circumscribed rectangle touches the outline.
      const Extent sides = extent(shape);
      check("reach along X", sides.X * sides.X * (form.XX - 0.25 * form.XY * form.XY / form.YY), 1.0, 1e-12);
      check("reach along Y", sides.Y * sides.Y * (form.YY - 0.25 * form.XY * form.XY / form.XX), 1.0, 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(groups_of_an_ellipse_in_si) {
  const SiContact contact{40.0, 8e-3, 2.2e11, 1.6, 0.04, 2e-8, ellipse(0.35, 20.0)};
  const Groups groups = from_si(contact);
  const Hertz dry = hertz(contact.load, contact.radius, contact.E_prime, contact.shape);
  check("p_h a b over load", 2.0 / 3.0 * pi * dry.a * dry.b * dry.p_h / contact.load, 1.0, 1e-13);
  check("lambda",
        groups.lambda /
            (6 * contact.eta0 * contact.u_s * contact.radius * contact.radius / (dry.a * dry.a * dry.a * dry.p_h)),
        1.0, 1e-13);
  check("alpha p_h", groups.alpha_bar / (contact.alpha * dry.p_h), 1.0, 1e-13);
  check("elastic factor",
        elastic_factor(contact.shape) / (2 * dry.p_h * contact.radius / (pi * contact.E_prime * dry.a)), 1.0, 1e-13);
  check("load over p_h a^2", load(contact.shape) / (contact.load / (dry.p_h * dry.a * dry.a)), 1.0, 1e-13);
  const double h = 1e-7;
  const double H = h * contact.radius / (dry.a * dry.a);
  const double H_moes = h / contact.radius / std::sqrt(2.0 * groups.U);
  check("Moes' units", H_to_moes_units(H, groups.M, groups.shape) / H_moes, 1.0, 1e-13);
  check("and back", H_from_moes_units(H_moes, groups.M, groups.shape) / H, 1.0, 1e-13);
  check("h/R", H_from_thickness_over_radius(h / contact.radius, groups.W, groups.shape) / H, 1.0, 1e-13);
  const SiContact again = to_si(groups, contact.radius, contact.E_prime, contact.eta0);
  check("load again", again.load / contact.load, 1.0, 1e-13);
  BOOST_TEST(again.shape.kappa == contact.shape.kappa);
}

BOOST_AUTO_TEST_CASE(a_circle_is_a_circle_to_the_last_digit) {
  const Ellipse circle = ellipse(1.0, 30.0);
  BOOST_TEST(circular(circle));
  BOOST_TEST((gap(circle).XX == 0.5 && gap(circle).XY == 0.0 && gap(circle).YY == 0.5));
  BOOST_TEST((outline(circle).XX == 1.0 && outline(circle).XY == 0.0 && outline(circle).YY == 1.0));
  BOOST_TEST(elastic_factor(circle) == 2.0 / (pi * pi));
  BOOST_TEST(load(circle) == 2.0 * pi / 3.0);
  BOOST_TEST((gap(ellipse(0.3, 90.0)).XY == 0.0 && gap(ellipse(0.3, -90.0)).XY == 0.0));
}

// R_x/R_y at an angle, and R_y/R_x at an angle smaller by 90 degrees, describe the same contact.
BOOST_AUTO_TEST_CASE(one_contact_under_two_names) {
  for (const double angle : {90.0, 25.0}) {
    const SiContact one{40.0, 8e-3, 2.2e11, 1.6, 0.04, 2e-8, ellipse(0.35, angle)};
    const SiContact other{40.0, 8e-3 / 0.35, 2.2e11, 1.6, 0.04, 2e-8, ellipse(1.0 / 0.35, angle - 90.0)};
    const Groups a = from_si(one), b = from_si(other);
    const Hertz dry_a = hertz(one.load, one.radius, one.E_prime, one.shape);
    const Hertz dry_b = hertz(other.load, other.radius, other.E_prime, other.shape);
    check("a and b", dry_a.a / dry_b.b, 1.0, 1e-13);
    check("p_h", dry_a.p_h / dry_b.p_h, 1.0, 1e-13);
    check("approach", dry_a.approach / dry_b.approach, 1.0, 1e-13);
    const double length = dry_b.a / dry_a.a, height = dry_b.h_scale / dry_a.h_scale;
    check("gap", value(gap(b.shape), 0.3, -0.7) * height / value(gap(a.shape), 0.3 * length, -0.7 * length), 1.0,
          1e-13);
    check("h_c of Chittenden", chittenden(a).central * one.radius / (chittenden(b).central * other.radius), 1.0, 1e-13);
    const auto central = [](const Groups& g, double radius) {
      return nijenbanning_venner_moes(g.M, g.L, g.shape) * std::sqrt(2.0 * g.U) * radius;
    };
    check("h_c of Nijenbanning", central(a, one.radius) / central(b, other.radius), 1.0, 1e-13);
  }
}

// Numbers computed by hand from the formulas in the header.
BOOST_AUTO_TEST_CASE(film_formulas_of_ellipses) {
  const Groups groups = from_moes(100.0, 10.0, 1e-11, ellipse(0.2));
  check("Nijenbanning, q = 0.2", nijenbanning_venner_moes(100.0, 10.0, groups.shape), 5.213725, 1e-6);
  const double to_moes = 1.0 / std::sqrt(2e-11);
  check("Hamrock, Dowson, k = 2.89018, h_c", hamrock_dowson(groups).central * to_moes, 5.334580, 1e-6);
  check("h_m", hamrock_dowson(groups).minimum * to_moes, 4.020006, 1e-6);
  check("Chittenden, R_s/R_e = 5, h_c", chittenden(groups).central * to_moes, 5.398595, 1e-6);
  check("h_m", chittenden(groups).minimum * to_moes, 4.071227, 1e-6);
  BOOST_TEST(along_smaller_radius(groups.shape));
  BOOST_TEST(along_smaller_radius(Ellipse{}));
  BOOST_TEST(along_smaller_radius(ellipse(5.0, 90.0)));
  BOOST_TEST(!along_smaller_radius(ellipse(5.0)));
  BOOST_TEST((near_chittenden(ellipse(0.2)) && near_chittenden(ellipse(2.0)) && near_chittenden(ellipse(0.5, 45.0))));
  BOOST_TEST((!near_chittenden(ellipse(5.0)) && !near_chittenden(ellipse(0.2, 45.0))));
  BOOST_TEST(!along_smaller_radius(ellipse(0.2, 10.0)));
}

BOOST_AUTO_TEST_SUITE_END()
