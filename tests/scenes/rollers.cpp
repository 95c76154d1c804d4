// [roller] in use: what is refused, tables, the same roller in SI and dimensionless, what the result contains.
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/columns.hpp"
#include "support/program.hpp"
#include "support/refused.hpp"
#include "support/solved.hpp"
#include "support/text.hpp"

namespace {

using namespace support;

const std::string oil = "[lubricant]\nalpha = 1.7e-8\nz = 0.6\n";
const std::string short_grid = "[domain]\nx_inlet = -2.5\nx_outlet = 1.5\n[grid]\ncells = 128\n";
const std::string numbers = "[contact]\nkind = roller\nM = 20\nL = 5\nlength = 16\n" + oil + short_grid;

}  // namespace

BOOST_AUTO_TEST_SUITE(test_rollers)

BOOST_AUTO_TEST_CASE(bad_input) {
  const std::string roller = "[contact]\nkind = roller\n", profile = "[roller]\nprofile = logarithmic\n";
  const std::string numbers = roller + "M = 20\nL = 5\n", whole = numbers + "length = 40\n" + oil;
  const std::string bodies = "load = 1e3\nradius_x = 0.004\nE_prime = 226e9\n";
  const std::string rest = "[motion]\nu_m = 2\n[lubricant]\neta0 = 0.02\nalpha = 16e-9\n";
  const std::string si = roller + bodies + "length_m = 0.008\n" + rest, straight = "[roller]\nprofile = straight\n";
  const std::string crown = "[roller]\nprofile = crowned\n";
  const std::string short_domain = "[domain]\nx_inlet = -4.5\nx_outlet = 1.5\n";
  support::check_refused({
      {"no length", numbers + oil + profile, {"[contact] length"}},
      {"no length in SI", roller + bodies + rest + profile, {"[contact] length_m"}},
      {"length in SI", roller + bodies + "length = 40\n" + rest + profile, {"d.ini:6"}},
      {"length_m without SI", numbers + "length_m = 0.01\n" + oil + profile, {"d.ini:5"}},
      {"too short", numbers + "length = 3\n" + oil + profile, {"d.ini:5", "length = 3"}},
      {"length in mm", roller + bodies + "length_m = 8\n" + rest + profile, {"d.ini:6"}},
      {"length of a point", "[contact]\nM = 20\nL = 5\nlength = 40\n" + oil, {"d.ini:4", "length", "kind = roller"}},
      {"load per length", roller + "load_per_length = 1e5\n" + bodies + rest + profile, {"load_per_length"}},
      {"radius_y", roller + bodies + "radius_y = 1\nlength_m = 0.008\n" + rest + profile, {"d.ini:6", "[roller]"}},
      {"no profile", whole, {"d.ini:2", "kind = roller"}},
      {"profile of a line",
       "[contact]\nkind = line\nM = 20\nL = 5\n" + oil + profile,
       {"[roller] profile", "kind = roller"}},
      {"unknown profile", whole + "[roller]\nprofile = lundberg\n", {"profile = lundberg"}},
      {"tilt alone", whole + "[roller]\ntilt = 0.1\n", {"[roller] tilt", "profile"}},
      {"tilt without SI", whole + profile + "tilt_mrad = 1\n", {"tilt_mrad"}},
      {"far too much tilt", whole + profile + "tilt = 1000\n", {"tilt = 1000", "100"}},
      {"straight without ends", whole + straight, {"[roller] end_length", "end_radius"}},
      {"ends too long", whole + straight + "end_length = 21\nend_radius = 5\n", {"40"}},
      {"ends too long in SI", si + straight + "end_length_m = 5e-3\nend_radius = 5\n", {"end_length_m"}},
      {"no radius", whole + straight + "end_length = 2\nend_radius = 0\n", {"end_radius = 0"}},
      {"two radii", si + straight + "end_length = 2\nend_radius = 5\nend_radius_m = 0.1\n", {"end_radius"}},
      {"ends of another profile", whole + profile + "end_length = 2\n", {"end_length", "profile = straight"}},
      {"no crown", whole + "[roller]\nprofile = crowned\n", {"crown_radius"}},
      {"crown of another", whole + profile + "crown_radius = 100\n", {"crown_radius", "profile = crowned"}},
      {"design load", whole + profile + "design_load = 11\n", {"design_load = 11", "10"}},
      {"design load in kN", si + profile + "design_load_N = 3e6\n", {"design_load_N"}},
      {"no table", whole + "[roller]\nprofile = table\n", {"[roller] file"}},
      // Half of 8 mm is one R_x: a circle of smaller radius does not reach the ends.
      {"crown in micrometres", si + crown + "crown_radius_m = 1e-9\n", {"d.ini:14"}},
      {"small crown", si + crown + "crown_radius = 0.99\n", {"crown_radius = 0.99"}},
      {"ball", whole + crown + "crown_radius = 1e-3\n", {"crown_radius = 1e-3", "kind = point"}},
      {"round ball", whole + short_domain + crown + "crown_radius = 2\n", {"crown_radius = 2", "x_outlet"}},
      {"corner", si + straight + "end_length_m = 1e-3\nend_radius_m = 0.9e-3\n", {"d.ini:15", "0.225"}},
      {"edge", whole + straight + "end_length = 2\nend_radius = 1e-4\n", {"end_radius = 1e-4"}},
      // The roller touches on a wedge of sqrt(2 c 40/tilt) half widths, c = [1 + 2 ln(80)]/4: 2.794 for tilt =
      // 25, less than a tenth of 40.
      {"on its end", whole + profile + "tilt = 25\n", {"tilt = 25"}},
      {"a tilted domain", whole + short_domain + profile + "tilt = -2\n", {"tilt = -2"}},
      {"closed far field", whole + profile + "[domain]\nfar_field = closed\n", {"far_field = closed"}},
      {"y_half", whole + profile + "[domain]\ny_half = 30\n", {"y_half = 30"}},
      {"load path", whole + profile + "[continuation]\npath = load\n", {"path = load"}},
      {"in time", whole + profile + "[transient]\nend_time = 1\n", {"end_time"}},
      {"supply", whole + profile + "[supply]\nH_oil = 0.1\n", {"H_oil"}},
      {"dry", "[case]\nkind = dry\n" + roller, {"[contact] kind"}},
  });
}

// For an accuracy the domain grows only along X, because the roller ends at its sides. The film is that of a longer
// domain with a finer grid.
BOOST_AUTO_TEST_CASE(to_an_accuracy) {
  const TemporaryFolder folder;
  const std::string profile = "[roller]\nprofile = crowned\ncrown_radius = 15\n";
  const std::string open = numbers.substr(0, numbers.find("[domain]")) + profile;
  const nlohmann::json found = solved_json(folder, open + "[grid]\naccuracy = 0.01\n", "--output found.h5");
  BOOST_TEST(found["accuracy"]["met"].get<bool>());
  BOOST_TEST(found["P_max_converging"] == true);
  BOOST_TEST(found["roller"]["error_P_end"].get<double>() < 0.1);
  const auto ends = [&](const char* axis) {
    const auto nodes = rows_of(support::ehl(folder, std::string("extract found.h5 /grid/") + axis).out);
    return std::pair(nodes.front()[0], nodes.back()[0]);
  };
  BOOST_TEST((ends("y") == std::pair(-8.0, 8.0)));
  const nlohmann::json truth =
      solved_json(folder, open + "[domain]\nx_inlet = -10.5\nx_outlet = 1.5\n[grid]\ncells = 1024\n");
  for (const char* film : {"Hc_best", "Hm_best"}) {
    const double error = found[film].get<double>() / truth[film].get<double>() - 1.0;
    BOOST_TEST_MESSAGE(film << " off by " << error << " (asked 0.01), inlet from " << ends("x").first);
    BOOST_TEST(std::abs(error) < 0.01, film);
  }
}

// A crown carries its load in an ellipse that is wider than the line contact of the mean load. Domain and film are
// chosen for it, and the ends carry nothing. If the domain ended inside the contact, Hm would be far too small.
BOOST_AUTO_TEST_CASE(a_strong_crown_gets_a_wider_domain) {
  const TemporaryFolder folder;
  const std::string contact = "[contact]\nkind = roller\nM = 20\nL = 5\nlength = 40\n" + oil;
  const std::string crown = "[roller]\nprofile = crowned\ncrown_radius = 10\n";
  const nlohmann::json found = solved_json(folder, contact + crown, "--output found.h5");
  const auto x = rows_of(support::ehl(folder, "extract found.h5 /grid/x").out);
  constexpr double hertz = 1.859;  // half width of the ellipse, by elliptic integrals
  BOOST_TEST(x.back()[0] > 1.3 * hertz);
  BOOST_TEST(-x.front()[0] > 1.3 * hertz);
  const nlohmann::json wider =
      solved_json(folder, contact + crown + "[domain]\nx_inlet = -9\nx_outlet = 3.6\n[grid]\ncells = 512\n");
  const double Hm = found["Hm_best"], bar = found["error_Hm_best"], truth = wider["Hm_best"];
  BOOST_TEST_MESSAGE("Hm " << Hm << " +- " << bar << ", on a wider and finer grid " << truth);
  BOOST_TEST(std::abs(truth / Hm - 1.0) < bar);
}

// Loaded ends cause a warning in all places where a user looks for warnings.
BOOST_AUTO_TEST_CASE(ends_that_bear_are_told) {
  const TemporaryFolder folder;
  const std::string deck = numbers + "[roller]\nprofile = logarithmic\ndesign_load = 1.2\n";
  const nlohmann::json found = solved_json(folder, deck, "--output a.h5");
  BOOST_TEST(contains(found["warning_names"].dump(), "roller-edge"));
  BOOST_TEST(contains(support::ehl(folder, "extract a.h5 /summary/roller_warnings").out, "[roller-edge]"));
  const Ended sweep = support::ehl(folder, "sweep case.ini --vary roller.design_load=1.2,3 --output s.csv");
  BOOST_REQUIRE(sweep.status == 0);
  BOOST_TEST(support::ehl(folder, "report a.h5 --output a.html").status == 0);
  BOOST_TEST(contains(folder.read("a.html"), "[roller-edge]"));
  const std::vector<NamedRow> rows = named_rows(folder.read("s.csv"));
  BOOST_TEST_REQUIRE(rows.size() == 2u);
  BOOST_TEST(std::stod(rows[0].at("P_end")) > std::stod(rows[1].at("P_end")));
  BOOST_TEST(rows[0].at("warnings") == "mesh roller-edge error-100");
  BOOST_TEST(rows[1].at("warnings") == "none");
}

// A crown that hardly relieves the ends causes a warning before anything is solved.
BOOST_AUTO_TEST_CASE(edges_that_cut_are_foretold) {
  const TemporaryFolder folder;
  for (const auto& [radius, cuts] : {std::pair{"500", true}, {"20", false}}) {
    folder.write("case.ini", numbers + "[roller]\nprofile = crowned\ncrown_radius = " + radius + "\n");
    BOOST_TEST(contains(support::ehl(folder, "check case.ini").out, "edge loading") == cuts, radius);
  }
}

// A table with the parabola of the crown equals the crown; a table that begins in the middle is mirrored.
BOOST_AUTO_TEST_CASE(a_table_is_the_profile_that_it_lists) {
  const TemporaryFolder folder;
  std::string half, whole;
  for (int k = -40; k <= 40; ++k) {
    const double y = 0.2 * k;
    const std::string row = std::to_string(y) + "," + std::to_string(y * y / 30.0) + "\n";
    whole += row;
    if (k >= 0) half += row;
  }
  folder.write("half.csv", "y,drop\n" + half);
  folder.write("whole.csv", whole);
  const nlohmann::json crown = solved_json(folder, numbers + "[roller]\nprofile = crowned\ncrown_radius = 15\n");
  for (const char* file : {"half.csv", "whole.csv"}) {
    const nlohmann::json table = solved_json(folder, numbers + "[roller]\nprofile = table\nfile = " + file + "\n");
    for (const char* name : {"P_middle", "P_end", "H_end"}) {
      const double given = crown["roller"][name], read = table["roller"][name];
      BOOST_TEST(std::abs(read / given - 1.0) < 2e-3, file << " " << name << ": " << read << ", " << given);
    }
    BOOST_TEST(std::abs(table["Hc"].get<double>() / crown["Hc"].get<double>() - 1.0) <
               2e-3);  // the spline is not exactly a parabola
  }
  folder.write("case.ini", numbers + "[roller]\nprofile = table\nfile = wrong.csv\n");
  for (const char* rows : {"0,0\n1,0\n2,0.1\n7,0.3\n", "-4,0\n0,0\n2,0.1\n9,0.3\n", "0,0\n4,0.1\n9,0.3\n",
                           "0,0\n4,0.1\n3,0.2\n9,0.3\n", "0,0\n4,a\n6,0.2\n9,0.3\n", "0,0\n1,0.1\n60,0.2\n81,0.3\n",
                           "0,0\n1,2e6\n2,5e6\n9,1e9\n", "0,0,1\n4,0,1\n6,0.2,1\n9,0.3,1\n"}) {
    folder.write("wrong.csv", rows);
    const Ended check = support::ehl(folder, "check case.ini");
    BOOST_TEST(check.status == 2, rows);
    BOOST_TEST(contains(check.err, "wrong.csv"), check.err);
  }
}

// F' = F/length and derived numbers by hand: a^2 = 8 F' R/(pi E'), the moment F y.
BOOST_AUTO_TEST_CASE(a_roller_in_SI) {
  const TemporaryFolder folder;
  const std::string bodies =
      "[contact]\nkind = roller\nload = 240\nlength_m = 1.5e-3\nradius_x = 0.004\nE_prime = 226e9\n[motion]\nu1 = 1.5\n"
      "u2 = 1.5\n[lubricant]\neta0 = 0.02\nalpha = 16e-9\nz = 0.6\n";
  const std::string profile = "[roller]\nprofile = logarithmic\ndesign_load_N = 720\ntilt_mrad = 0.2\n";
  const nlohmann::json found = solved_json(folder, bodies + profile + short_grid);
  const double per_length = 240.0 / 1.5e-3;
  const double a = std::sqrt(8.0 * per_length * 0.004 / (3.14159265358979 * 226e9));
  const nlohmann::json& roller = found["roller"];
  BOOST_TEST(std::abs(found["a_m"].get<double>() / a - 1.0) < 1e-12);
  BOOST_TEST(std::abs(found["p_h_Pa"].get<double>() / (2.0 * per_length / (3.14159265358979 * a)) - 1.0) < 1e-12);
  BOOST_TEST(std::abs(roller["length_m"].get<double>() / 1.5e-3 - 1.0) < 1e-12);
  BOOST_TEST(std::abs(roller["moment"].get<double>() / (240.0 * roller["load_centre_m"].get<double>()) - 1.0) < 1e-12);
  BOOST_TEST(roller["moment"].get<double>() < 0.0);
  // The pressure spike grows from grid to grid, so the pressures have no error bars.
  BOOST_TEST(found["P_max_converging"] == false);
  BOOST_TEST(roller["error_P_end"].is_null());
  BOOST_TEST(roller["error_H_end"].get<double>() < 0.3);
  // A dimensionless deck of this roller: the design load relative to the load, the tilt in a/R.
  const std::string groups = "[contact]\nkind = roller\nM = " + std::to_string(found["M"].get<double>()) +
                             "\nL = " + std::to_string(found["L"].get<double>()) +
                             "\nlength = " + std::to_string(1.5e-3 / a) + "\n[lubricant]\nalpha = 16e-9\nz = 0.6\n";
  const nlohmann::json plain =
      solved_json(folder, groups + "[roller]\nprofile = logarithmic\ndesign_load = 3\ntilt = " +
                              std::to_string(0.2e-3 * 0.004 / a) + "\n" + short_grid);
  for (const char* name : {"P_middle", "P_end", "load_centre"}) {
    const double here = roller[name], there = plain["roller"][name];
    BOOST_TEST(std::abs(here / there - 1.0) < 1e-3, name << ": " << here << ", " << there);
  }
}

// A table in mm read as metres covers only the first thousandth of the roller. A table whose drops are in mm describes
// ends that lie outside the roller.
BOOST_AUTO_TEST_CASE(a_table_in_millimetres) {
  const TemporaryFolder folder;
  folder.write("case.ini",
               "[contact]\nkind = roller\nload = 2000\nlength_m = 12e-3\nradius_x = 4e-3\nE_prime = 226e9\n[motion]\n"
               "u_m = 3\n[lubricant]\neta0 = 0.02\nalpha = 16e-9\n[roller]\nprofile = table\nfile = mm.csv\n");
  for (const char* rows : {"0,0\n1,0\n2,1e-6\n6,4e-6\n", "0,0\n1e-3,0\n2e-3,1e-6\n5e-3,4e-6\n",
                           "0,0\n1e-3,0\n2e-3,1e-3\n6e-3,4\n", "0,0\n1e-3,0.5e-3\n2e-3,2e-3\n6e-3,3.9e-3\n"}) {
    folder.write("mm.csv", rows);
    const Ended check = support::ehl(folder, "check case.ini");
    BOOST_TEST(check.status == 2, rows);
    BOOST_TEST(check.says({"case.ini:14", "file = mm.csv"}), check.err);
  }
}

// The deck of the result gives the same film, and all suitable figures are drawn.
BOOST_AUTO_TEST_CASE(the_result_is_drawn_and_runs_again) {
  const TemporaryFolder folder;
  const nlohmann::json first =
      solved_json(folder, numbers + "[roller]\nprofile = logarithmic\ndesign_load = 2\n", "--output a.h5");
  const Ended deck = support::ehl(folder, "extract a.h5 /deck");
  const nlohmann::json again = solved_json(folder, deck.out, "--output b.h5");
  BOOST_TEST(first["Hc"] == again["Hc"]);
  BOOST_TEST(first["roller"]["P_end"] == again["roller"]["P_end"]);
  const Ended plot = support::ehl(folder, "plot a.h5");
  BOOST_TEST(plot.status == 0, plot.err);
  BOOST_TEST(contains(plot.out, "roller"), plot.out);
  BOOST_TEST(plot.err.empty(), plot.err);
}

BOOST_AUTO_TEST_CASE(a_roller_is_not_called_circular) {
  const TemporaryFolder folder;
  folder.write("case.ini", numbers + "[roller]\nprofile = logarithmic\n");
  const std::string words = support::ehl(folder, "check case.ini").out;
  BOOST_TEST(!contains(words, "circular"), words);
}

BOOST_AUTO_TEST_SUITE_END()
