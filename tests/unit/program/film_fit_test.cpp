// What a report says of the film that is fitted to our own solutions, against solutions with oils by name.
#include "report/film_fit.hpp"

#include <fmt/core.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "case/scene.hpp"
#include "contact/film_map.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"

using namespace ehl;
using support::contains;

namespace {

using Row = std::map<std::string, std::string>;

// Solved contacts; made by tests/bench/film_map_oils.py.
std::vector<Row> solved() {
  std::ifstream file(EHL_OILS);
  std::ostringstream text;
  text << file.rdbuf();
  return support::named_rows(text.str());
}

std::string lines_of(std::string words) {
  for (char& c : words)
    if (c == ' ') c = '\n';
  return words + "\n";
}

std::string deck_of(const Row& row) {
  return "[contact]\nload = " + row.at("load") + "\nradius_x = " + row.at("radius_x") +
         "\nradius_y = " + row.at("radius_y") + "\nE_prime = " + row.at("E_prime") +
         "\n[motion]\nu_m = " + row.at("u_m") + "\n[lubricant]\n" + lines_of(row.at("keys"));
}

program::Physics physics_of(const std::string& deck) {
  const support::TemporaryFolder folder;
  return program::read_case(folder.write("case.ini", deck), {}, 1).physics;
}

struct Scatter {
  double squares = 0.0, most = 0.0;
  int count = 0;
  void add(double ratio) {
    squares += std::log(ratio) * std::log(ratio);
    most = std::max(most, std::abs(std::log(ratio)));
    ++count;
  }
  double rms() const { return std::sqrt(squares / count); }
};

const std::string ball =
    "[contact]\nload = 20\nradius_x = 0.01\nE_prime = 2.3e11\n[motion]\nu_m = 1\n[lubricant]\neta0 = 0.04\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(test_program_film_fit)

// The numbers of the line are those of all solved contacts, each from the deck that a user would write.
BOOST_AUTO_TEST_CASE(the_accuracy_in_the_report_is_that_of_oils_by_name) {
  const std::vector<Row> rows = solved();
  BOOST_REQUIRE(rows.size() >= 100u);
  Scatter of_Hc, of_Hm;
  int claimed = 0;
  for (const Row& row : rows) {
    const program::Physics physics = physics_of(deck_of(row));
    const auto fit = program::fitted_film(physics);
    BOOST_REQUIRE_MESSAGE(fit.has_value(), row.at("oil") << " at " << row.at("load") << " N is outside the fit");
    of_Hc.add(fit->Hc / std::stod(row.at("Hc")));
    of_Hm.add(fit->Hm / std::stod(row.at("Hm")));
    const std::string line = program::fitted_film_line(physics);
    // Nothing is claimed if the density of the oil at p_h is too far from that of the oil of the fit.
    if (!contains(line, " % in h_c")) continue;
    ++claimed;
    const contact::MapScatter told = contact::scatter_of_other_oils();
    const auto percent = [](double share) { return fmt::format("{:.1f} %", 100.0 * share); };
    const auto whole = [](double share) { return fmt::format("{:.0f}", std::ceil(100.0 * share)); };
    for (const std::string& wanted : {percent(told.rms_central) + " in h_c", percent(told.rms_minimum) + " in h_m",
                                      whole(told.largest_central) + " and " + whole(told.largest_minimum) + " %"})
      BOOST_TEST(contains(line, wanted), wanted << " is missing in " << line);
  }
  const contact::MapScatter told = contact::scatter_of_other_oils();
  BOOST_TEST(claimed >= 95);
  BOOST_TEST_MESSAGE(rows.size() << " contacts, " << claimed << " of them with a claim: h_c off by "
                                 << 100.0 * of_Hc.rms() << " % rms, " << 100.0 * of_Hc.most << " % at most; h_m "
                                 << 100.0 * of_Hm.rms() << " and " << 100.0 * of_Hm.most << " %; printed are "
                                 << 100.0 * told.rms_central << ", " << 100.0 * told.largest_central << "; "
                                 << 100.0 * told.rms_minimum << ", " << 100.0 * told.largest_minimum);
  // The table has six digits of the loads and radii.
  const auto close = boost::test_tools::tolerance(0.02);
  BOOST_TEST(told.rms_central == of_Hc.rms(), close);
  BOOST_TEST(told.rms_minimum == of_Hm.rms(), close);
  BOOST_TEST(told.largest_central == of_Hc.most, close);
  BOOST_TEST(told.largest_minimum == of_Hm.most, close);
}

BOOST_AUTO_TEST_CASE(outside_of_the_fit_the_report_says_so) {
  // One contact has a larger M than the fit, the other a larger L*.
  for (const char* key : {"[contact]\nM = 3000\nL = 10\n[lubricant]\nalpha = 2.2e-8\n",
                          "[contact]\nM = 100\nL = 30\n[lubricant]\nalpha = 2.2e-8\n"}) {
    const program::Physics physics = physics_of(key);
    BOOST_TEST(!program::fitted_film(physics).has_value());
    const std::string line = program::fitted_film_line(physics);
    BOOST_TEST(contains(line, contact::range_of_film_map()), line);
  }
}

// Dowson and Higginson's oil of the fit is denser at p_h by more than a twentieth than one that keeps its density.
BOOST_AUTO_TEST_CASE(of_an_oil_of_another_density_no_accuracy_is_claimed) {
  const std::string heavy =
      "[contact]\nload = 300\nradius_x = 0.01\nE_prime = 2.3e11\n[motion]\nu_m = 1\n[lubricant]\n"
      "eta0 = 0.04\nalpha = 2e-8\n";
  for (const std::string& deck :
       {heavy + "density = incompressible\n", ball + "viscosity = isoviscous\ndensity = dowson-higginson\n"}) {
    const std::string line = program::fitted_film_line(physics_of(deck));
    BOOST_TEST((!line.empty() && !contains(line, " % in h_c")), line);
  }
  BOOST_TEST(contains(program::fitted_film_line(physics_of(heavy)), " % in h_c"));
}

BOOST_AUTO_TEST_SUITE_END()
