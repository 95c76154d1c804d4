// The film formula fitted to solutions of this program: compared with solutions not used in the fit, and its limits.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "contact/film_formulas.hpp"
#include "contact/film_map.hpp"
#include "contact/groups.hpp"

using namespace ehl;

namespace {

struct Solved {
  double M, ratio, L, Hc, Hm;
};

// Rows of tests/reference/film_map_held_out.csv: M, radius_ratio, L, Hc, error_Hc, Hm, error_Hm.
std::vector<Solved> held_out() {
  std::ifstream file(EHL_HELD_OUT);
  std::vector<Solved> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'M') continue;
    std::istringstream cells(line);
    double value[7] = {};
    char comma = ',';
    for (double& one : value) cells >> one >> comma;
    rows.push_back({value[0], value[1], value[2] * contact::alpha_star_of_film_map() / 2.2e-8, value[3], value[5]});
  }
  return rows;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_contact_film_map)

BOOST_AUTO_TEST_CASE(solutions_that_no_fit_has_seen) {
  const std::vector<Solved> rows = held_out();
  BOOST_REQUIRE(rows.size() >= 100u);
  double square_c = 0.0, square_m = 0.0, most_c = 0.0, most_m = 0.0;
  for (const Solved& one : rows) {
    const contact::Ellipse shape = contact::ellipse(one.ratio, 0.0);
    const auto map = contact::film_map(one.M, one.L, shape);
    BOOST_REQUIRE(map.has_value());
    const double off_c = std::log(contact::H_from_moes_units(map->central, one.M, shape) / one.Hc);
    const double off_m = std::log(contact::H_from_moes_units(map->minimum, one.M, shape) / one.Hm);
    square_c += off_c * off_c;
    square_m += off_m * off_m;
    most_c = std::max(most_c, std::abs(off_c));
    most_m = std::max(most_m, std::abs(off_m));
  }
  const double rms_c = std::sqrt(square_c / static_cast<double>(rows.size()));
  const double rms_m = std::sqrt(square_m / static_cast<double>(rows.size()));
  BOOST_TEST_MESSAGE("of " << rows.size() << " held-out solutions: Hc rms " << 100.0 * rms_c << " %, at most "
                           << 100.0 * most_c << " %; Hm " << 100.0 * rms_m << " %, " << 100.0 * most_m << " %");
  BOOST_TEST(rms_c < 0.01);
  BOOST_TEST(rms_m < 0.02);
  const contact::MapScatter told = contact::scatter_of_film_map();
  BOOST_TEST(told.rms_central == rms_c, boost::test_tools::tolerance(0.05));
  BOOST_TEST(told.rms_minimum == rms_m, boost::test_tools::tolerance(0.05));
  BOOST_TEST(told.largest_central == most_c, boost::test_tools::tolerance(0.02));
  BOOST_TEST(told.largest_minimum == most_m, boost::test_tools::tolerance(0.02));
}

// A circular contact at such a low load that the bodies are rigid, with an isoviscous oil: M^2 H_M = 35.51, also the
// result of the closed form of the far field. The minimum is then at the centre.
BOOST_AUTO_TEST_CASE(the_rigid_limit) {
  const auto map = contact::film_map(0.2, 0.0, {});
  BOOST_TEST_MESSAGE("M^2 H_M = " << 0.04 * map->central
                                  << " at M = 0.2, the limit 35.51; Hm/Hc = " << map->minimum / map->central);
  BOOST_TEST(0.04 * map->central == 35.51, boost::test_tools::tolerance(0.01));
  BOOST_TEST(map->minimum == map->central, boost::test_tools::tolerance(0.005));
}

BOOST_AUTO_TEST_CASE(the_same_contact_named_in_two_ways) {
  // Entrainment along R_y of an ellipse equals entrainment along R_x of the ellipse with exchanged radii.
  const contact::Ellipse across = contact::ellipse(0.5, 90.0);
  const contact::AlongEntrainment at = contact::along_entrainment(across, 100.0, 10.0);
  const auto one = contact::film_map(100.0, 10.0, across);
  const auto other = contact::film_map(at.M, at.L, contact::ellipse(at.radius_ratio, 0.0));
  BOOST_REQUIRE((one && other));
  BOOST_TEST(one->central == at.film * other->central, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(one->minimum == at.film * other->minimum, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(outside_the_solutions_it_says_nothing) {
  const contact::Ellipse circle{};
  BOOST_TEST(contact::film_map(2000.0, 23.4, circle).has_value());
  BOOST_TEST(!contact::film_map(2001.0, 23.4, circle).has_value());
  BOOST_TEST(!contact::film_map(0.19, 5.0, circle).has_value());
  BOOST_TEST(!contact::film_map(100.0, 23.5, circle).has_value());
  BOOST_TEST(!contact::film_map(100.0, 10.0, contact::ellipse(0.09, 0.0)).has_value());
  BOOST_TEST(!contact::film_map(100.0, 10.0, contact::ellipse(0.5, 45.0)).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
