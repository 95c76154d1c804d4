// Lines of the report with unusual numbers: large, negative or very small.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <sstream>

#include "case/plausible.hpp"
#include "report/contact_lines.hpp"
#include "report/film_lines.hpp"
#include "support/text.hpp"

using namespace ehl;

namespace {

using support::contains;

program::Physics example_physics() {
  program::Physics physics;
  physics.groups = contact::from_moes(2.0 / 3.0, 5.0);
  return physics;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_report)

// "1994" and "3.602e+04" are separate numbers, and no name shifts its row.
BOOST_AUTO_TEST_CASE(columns_of_formulas_stand_apart) {
  const std::vector<program::Formula> formulas{{"Nijenbanning, Venner, Moes 1994", "nvm", 36020.0, -1.234e-7},
                                               {"Dowson, Higginson 1968; Toyoda 1979 (U = 1e-11)", "dh", 0.1, 0.2}};
  for (const bool in_si : {false, true}) {
    program::Physics physics = example_physics();
    if (in_si) {
      physics.si.emplace();
      physics.si->hertz = {.a = 1e-4, .p_h = 0.0, .approach = 0.0, .h_scale = 1.0, .b = 0.0};
      physics.si->contact.u_s = 1.0;
    }
    std::istringstream lines(program::formula_lines(formulas, physics, 1e-3, 0.05));
    std::string head, large, named;
    std::getline(lines, head) && std::getline(lines, large) && std::getline(lines, named);
    BOOST_TEST(head.size() == large.size(), head << "\n" << large);
    BOOST_TEST(head.size() == named.size(), head << "\n" << named);
    BOOST_TEST(contains(large, "Moes 1994 "), large);
    BOOST_TEST(contains(large, " 3.602e+04 "), large);
    BOOST_TEST(contains(named, "(U = 1e-11) "), named);
  }
}

// A negative film means that the mesh does not resolve it.
BOOST_AUTO_TEST_CASE(nothing_is_told_of_a_film_below_zero) {
  program::Physics physics = example_physics();
  physics.si.emplace();
  physics.si->hertz.h_scale = 1e-6;
  const std::vector<program::Formula> formulas{{"made up", "", 0.2, 0.1}};
  const std::string lines = program::formula_lines(formulas, physics, 0.1, -0.05);
  BOOST_TEST(contains(lines, "+100.0 %"), lines);
  BOOST_TEST(std::ranges::count(lines, '%') == 1, lines);
  BOOST_TEST(program::hardly_a_film(261e-9, -55.7e-9).empty());
  BOOST_TEST(program::hardly_a_film(261e-9, 0.5e-9).size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_strict_accuracy_is_told_with_its_digits) {
  steady::Solution solution;
  solution.accuracy.asked = 1e-6;
  BOOST_TEST(contains(program::error_lines({}, solution), "0.0001 %"));
}

BOOST_AUTO_TEST_SUITE_END()
