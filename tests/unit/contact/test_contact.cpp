// Hertz theory, the groups and the film formulas, compared with published cases and exact relations.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "contact/film_formulas.hpp"
#include "contact/groups.hpp"
#include "contact/hertz.hpp"
#include "core/constants.hpp"

BOOST_AUTO_TEST_SUITE(test_contact)

using namespace ehl::contact;
using ehl::core::pi;

namespace {

void check_relative(const std::string& what, double computed, double expected, double tolerance) {
  const double error = std::abs(computed / expected - 1.0);
  BOOST_TEST_MESSAGE(what << " = " << computed << ", expected " << expected << ", relative difference " << error
                          << " (tolerance " << tolerance << ")");
  BOOST_TEST(error <= tolerance);
}

// The tolerance is half a unit of the last printed digit.
void check_digits(const std::string& what, double computed, double printed, double half_unit) {
  check_relative(what, computed, printed, half_unit / printed);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_case_of_venner_1992) {
  const Groups groups = from_moes(50.0, 10.0, 1e-11);
  check_digits("alpha_bar", groups.alpha_bar, 13.42, 0.005);
  check_digits("lambda", groups.lambda, 0.0596, 0.00005);
  check_digits("W", groups.W, 4.73e-7, 0.005e-7);
  check_digits("G", groups.G, 4728.0, 1.0);
  check_digits("p_h [GPa] at 17/GPa", hertz_pressure(groups, 17.0), 0.79, 0.0005);
  BOOST_TEST(std::isnan(from_moes(50.0, 10.0).W));
}

BOOST_AUTO_TEST_CASE(steel_ball_on_glass) {
  // Mourier et al. (2006). Their Hertz radius and pressure are rounded from slightly different
  // moduli, which explains 0.5 %.
  SiContact contact{};
  contact.load = 15.0;
  contact.radius = 12.5e-3;
  contact.E_prime = 110e9;
  contact.u_s = 2 * 0.09;
  contact.eta0 = 0.25;
  contact.alpha = 22e-9;
  const Groups groups = from_si(contact);
  check_digits("M", groups.M, 63.78, 0.02);
  check_digits("L", groups.L, 5.788, 0.0015);
  const Hertz dry = hertz(contact.load, contact.radius, contact.E_prime);
  check_relative("a [um]", dry.a * 1e6, 136.5, 0.005);
  check_relative("p_h [MPa]", dry.p_h * 1e-6, 385.0, 0.006);
  // The definitions of the groups in terms of SI quantities.
  check_relative("alpha p_h", groups.alpha_bar, contact.alpha * dry.p_h, 1e-13);
  const double lambda =
      6 * contact.eta0 * contact.u_s * contact.radius * contact.radius / (dry.a * dry.a * dry.a * dry.p_h);
  check_relative("lambda", groups.lambda, lambda, 1e-13);
}

BOOST_AUTO_TEST_CASE(hertz_satisfies_its_own_equations) {
  const double load = 37.0, radius = 9.5e-3, E_prime = 226e9;
  const Hertz dry = hertz(load, radius, E_prime);
  check_relative("load from the pressure, 2/3 pi a^2 p_h", 2.0 / 3.0 * pi * dry.a * dry.a * dry.p_h, load, 1e-14);
  // The Hertz pressure displaces the centre by pi p_h a/E' (both bodies together), which must equal a^2/R.
  check_relative("centre displacement", pi * dry.p_h * dry.a / E_prime, dry.approach, 1e-14);
  BOOST_TEST(dry.h_scale == dry.approach);
  // Steel on steel, and steel on a rigid body.
  const Elastic steel{206e9, 0.3};
  check_relative("E' of steel on steel [GPa]", reduced_modulus(steel, steel) * 1e-9, 226.37, 1e-4);
  check_relative("E' on a rigid body", reduced_modulus(steel, {INFINITY, 0.3}), 2.0 * reduced_modulus(steel, steel),
                 1e-14);
}

BOOST_AUTO_TEST_CASE(round_trips) {
  const Groups there = from_moes(137.0, 6.3, 3.3e-12);
  const Groups back = from_hamrock_dowson(there.W, there.U, there.G);
  check_relative("M", back.M, there.M, 1e-14);
  check_relative("L", back.L, there.L, 1e-14);
  check_relative("lambda", back.lambda, there.lambda, 1e-14);
  check_relative("alpha_bar", back.alpha_bar, there.alpha_bar, 1e-14);
  const Groups si = from_si(to_si(there, 0.0125, 117e9, 0.04));
  check_relative("W through SI", si.W, there.W, 1e-14);
  check_relative("U through SI", si.U, there.U, 1e-14);
  check_relative("G through SI", si.G, there.G, 1e-14);
  check_relative("H", H_from_moes_units(H_to_moes_units(0.3, 50.0), 50.0), 0.3, 1e-15);
  // The three scalings give one film.
  const SiContact contact = to_si(there, 0.0125, 117e9, 0.04);
  const Hertz dry = hertz(contact.load, contact.radius, contact.E_prime);
  const double h = 0.2 * dry.h_scale;
  check_relative("H from h/R", H_from_thickness_over_radius(h / contact.radius, there.W), 0.2, 1e-14);
  check_relative("H_M from its definition", H_to_moes_units(0.2, there.M),
                 h / contact.radius / std::sqrt(2.0 * there.U), 1e-14);
}

BOOST_AUTO_TEST_CASE(film_formulas_at_three_loads) {
  struct Row {
    double M, central_nvm, central_hd, minimum_hd;
  };
  // Moes' units, L = 10. The formula of Hamrock and Dowson depends weakly on U in addition to M and L: steel, E'
  // = 226 GPa, alpha = 22/GPa.
  const double U = 0.5 * std::pow(10.0 / (22e-9 * 226e9), 4.0);
  for (const Row& row : {Row{20, 4.265, 4.54, 2.59}, Row{100, 4.13, 4.08, 2.31}, Row{500, 3.90, 3.66, 2.05}}) {
    const Groups groups = from_moes(row.M, 10.0, U);
    check_digits("Nijenbanning-Venner-Moes", nijenbanning_venner_moes(row.M, 10.0), row.central_nvm, 0.005);
    const FilmThickness hd = hamrock_dowson(groups);
    check_digits("Hamrock-Dowson, central", hd.central / std::sqrt(2 * groups.U), row.central_hd, 0.005);
    check_digits("Hamrock-Dowson, minimum", hd.minimum / std::sqrt(2 * groups.U), row.minimum_hd, 0.005);
  }
  BOOST_TEST(std::isnan(hamrock_dowson(from_moes(20.0, 10.0)).central));
}

BOOST_AUTO_TEST_CASE(film_formula_tends_to_its_asymptotes) {
  // Evaluated by hand, so that a wrong coefficient is found.
  const Asymptotes one = asymptotes(1.0, 1.0);
  check_digits("H_RI(1)", one.rigid_isoviscous, 41.35, 0.005);
  check_digits("H_RP(1)", one.rigid_piezoviscous, 0.9089, 0.0005);
  check_digits("H_EI(1)", one.elastic_isoviscous, 2.419, 0.0005);
  check_digits("H_EP(1)", one.elastic_piezoviscous, 1.2474, 0.0005);
  const Asymptotes light = asymptotes(1e-3, 0.0);
  check_relative("rigid isoviscous", nijenbanning_venner_moes(1e-3, 0.0), light.rigid_isoviscous, 1e-3);
  const Asymptotes soft = asymptotes(1e5, 0.0);
  check_relative("elastic isoviscous", nijenbanning_venner_moes(1e5, 0.0), soft.elastic_isoviscous, 0.01);
  const Asymptotes hard = asymptotes(1e6, 50.0);
  check_relative("elastic piezoviscous", nijenbanning_venner_moes(1e6, 50.0), hard.elastic_piezoviscous, 0.02);
  BOOST_TEST(std::string(name(regime(1e-3, 0.0))) == "rigid isoviscous");
  BOOST_TEST(std::string(name(regime(1e5, 0.0))) == "elastic isoviscous");
  BOOST_TEST(std::string(name(regime(1000.0, 10.0))) == "elastic piezoviscous");
  BOOST_TEST(std::string(name(regime(6.0, 200.0))) == "rigid piezoviscous");
  // At (50, 10) the two piezoviscous asymptotes are 4.22 and 5.06.
  BOOST_TEST(regime_text(50.0, 10.0) == "rigid piezoviscous, passing into elastic piezoviscous");
  BOOST_TEST(regime_text(1000.0, 10.0) == "elastic piezoviscous, passing into rigid piezoviscous");
  BOOST_TEST(regime_text(1e5, 0.0) == "elastic isoviscous");
}

// A steel roller, R = 10 mm, 100 N/mm: b = sqrt(8 F' R/(pi E')) and p_h = 2 F'/(pi b) by hand, and the groups
// by their definitions in SI.
BOOST_AUTO_TEST_CASE(a_line_contact_in_SI_and_in_groups) {
  const Ellipse shape = line_contact();
  const double load = 1e5, R = 0.01, E_prime = 2.2637e11, eta0 = 0.02, u_s = 4.0, alpha = 2e-8;
  const Hertz dry = hertz(load, R, E_prime, shape);
  check_relative("half width [m]", dry.a, 1.06062e-4, 1e-5);
  check_relative("p_h [Pa]", dry.p_h, 6.00232e8, 1e-5);
  const Groups groups = from_si(
      {.load = load, .radius = R, .E_prime = E_prime, .u_s = u_s, .eta0 = eta0, .alpha = alpha, .shape = shape});
  check_relative("W", groups.W, load / (E_prime * R), 1e-14);
  check_relative("M", groups.M, groups.W / std::sqrt(2.0 * groups.U), 1e-14);
  check_relative("alpha_bar", groups.alpha_bar, alpha * dry.p_h, 1e-12);
  check_relative("lambda", groups.lambda, 6.0 * eta0 * u_s * R * R / (dry.a * dry.a * dry.a * dry.p_h), 1e-12);
  check_relative("film in Moes' units", H_to_moes_units(1.0, groups.M, shape),
                 dry.h_scale / R / std::sqrt(2.0 * groups.U), 1e-12);
  check_relative("load back", to_si(groups, R, E_prime, eta0).load, load, 1e-12);
}

// Values printed with the solutions of an independent program: Moes' formula and its four asymptotes.
BOOST_AUTO_TEST_CASE(moes_formula_of_a_line) {
  const Ellipse shape = line_contact();
  check_digits("(2, 0)", nijenbanning_venner_moes(2.0, 0.0, shape), 2.616, 5e-4);
  check_digits("(20, 5)", nijenbanning_venner_moes(20.0, 5.0, shape), 3.466, 5e-4);
  check_digits("(50, 10)", nijenbanning_venner_moes(50.0, 10.0, shape), 4.636, 5e-4);
  check_relative("rigid isoviscous", nijenbanning_venner_moes(1e-3, 0.0, shape), 3e3, 0.01);
  check_relative("elastic isoviscous", nijenbanning_venner_moes(1e5, 0.0, shape), 0.2621, 0.01);
}

BOOST_AUTO_TEST_SUITE_END()
