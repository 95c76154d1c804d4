// Balls and rollers on their races, gear teeth, and invalid bearings or gears, through the program.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <utility>

#include "support/columns.hpp"
#include "support/json.hpp"
#include "support/refused.hpp"
#include "support/text.hpp"

namespace {

using support::contains;

const std::string rest =
    "[contact]\nE_prime = 228e9\n[lubricant]\neta0 = 0.0168\nalpha = 1.52e-8\n[grid]\ncells = 64\n"
    "[discretization]\nwedge = upstream3\nface = logmean\n[domain]\nfar_field = closed\n";
const std::string shape = "[case]\nkind = ball_race\n[bearing]\ndiameter = 9.525e-3\npitch_diameter = 46e-3\n";
const std::string ball = shape + "load = 500\nrpm_inner = 3000\n";
const std::string radial = shape + "rpm_inner = 3000\nradial_load = 1000\n";
const std::string roller =
    "[case]\nkind = roller_race\n[bearing]\ndiameter = 10e-3\npitch_diameter = 50e-3\nlength = 10e-3\nload = 500\n"
    "rpm_inner = 3000\n";
const std::string gear =
    "[case]\nkind = gear_mesh\n[gear]\nmodule = 4e-3\nface_width = 20e-3\nrpm1 = 1500\nteeth1 = 24\nteeth2 = 48\n";
const std::string fzg =
    "[case]\nkind = gear_mesh\n[gear]\nmodule = 4.5e-3\nface_width = 14e-3\nrpm1 = 2250\ntorque1 = 135.5\nteeth1 = 16\n"
    "teeth2 = 24\n";
const std::string loaded_gear = gear + "power = 10e3\n";

nlohmann::json run(const support::TemporaryFolder& folder, const std::string& deck) {
  folder.write("d.ini", deck);
  const support::Ended ended = support::ehl(folder, "run d.ini --json --overwrite");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, deck << ended.err);
  return support::parsed(ended.out);
}

support::Ended checked(const std::string& machine) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", machine + rest);
  return support::ehl(folder, "check d.ini");
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_machines)

// [bearing] is another form of [contact] and [motion]: the run agrees with one that uses the numbers computed by hand
// in tests/unit/machines. The deck of the result reproduces it exactly.
BOOST_AUTO_TEST_CASE(a_ball_race_is_an_ordinary_contact) {
  const support::TemporaryFolder folder;
  const nlohmann::json race = run(folder, ball + rest);
  BOOST_TEST(std::abs(support::number_at(race, "/bearing/gamma") - 0.2070652173913043) < 1e-15);
  BOOST_TEST(std::abs(support::number_at(race, "/bearing/rpm_cage") - 1189.4021739130435) < 1e-10);
  BOOST_TEST(std::abs(support::number_at(race, "/bearing/u1") - 3.4579277706541630) < 1e-14);
  folder.write("again.ini", support::ehl(folder, "extract d.h5 deck").out);
  const nlohmann::json again = support::parsed(support::ehl(folder, "run again.ini --json").out);
  const nlohmann::json plain =
      run(folder, rest +
                      "[case]\nkind = lubricated\n[motion]\nu_m = 3.4579277706541630\n[contact]\nload = 500\n"
                      "radius_x = 3.7763519021739130e-3\nradius_y = 0.123825\n");
  for (const char* name : {"/Hc", "/Hm", "/p_h_Pa", "/hm_m"}) {
    BOOST_TEST_MESSAGE(name << " = " << support::number_at(race, name));
    // Speed and radius are products of rounded numbers, with an error of one unit in the last place each.
    BOOST_TEST(std::abs(support::number_at(plain, name) / support::number_at(race, name) - 1.0) < 1e-9, name);
    BOOST_TEST(support::number_at(again, name) == support::number_at(race, name), name);
  }
}

// With a profile, rollers and teeth have ends and become [contact] kind = roller. By hand, the roller has the radius 10
// (1 - 0.2)/2 = 4 mm and the speed pi/120 0.05 (1 - 0.2^2) 3000 = 1.2 pi m/s. At the pitch point, the teeth have rho =
// 8 mm sin 20 and 16 mm sin 20, the force torque/(8 mm cos 20), and the speed 500 pi rho.
BOOST_AUTO_TEST_CASE(with_a_profile_they_have_ends) {
  const support::TemporaryFolder folder;
  const double alpha = std::acos(-1.0) / 9.0;
  const std::string common =
      "[contact]\nE_prime = 228e9\n[lubricant]\neta0 = 0.0168\nalpha = 1.52e-8\n[grid]\ncells = 32\n[roller]\nprofile "
      "= logarithmic\n";
  const std::string race =
      "[case]\nkind = roller_race\n[bearing]\ndiameter = 10e-3\npitch_diameter = 50e-3\nlength = 1e-3\nload = 50\n"
      "rpm_inner = 3000\n";
  const std::string teeth =
      "[case]\nkind = gear_mesh\n[gear]\nmodule = 1e-3\nface_width = 1e-3\nrpm1 = 15000\nteeth1 = 16\nteeth2 = "
      "32\ntorque1 = 0.4\nshift1 = 0\nshift2 = 0\n";
  const auto plain = [](double load, double radius, double speed) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "[motion]\nu_m = %.17g\n[contact]\nkind = roller\nload = %.17g\nlength_m = 1e-3\nradius_x = %.17g\n",
                  speed, load, radius);
    return std::string(text);
  };
  const double rho = 8e-3 * std::sin(alpha);
  const std::pair<std::string, std::string> pairs[] = {
      {race, plain(50.0, 4e-3, 3.7699111843077517)},
      {teeth, plain(0.4 / (8e-3 * std::cos(alpha)), 2.0 * rho / 3.0, 9.0 * alpha * 500.0 * rho)}};
  for (const auto& [machine, contact] : pairs) {
    const nlohmann::json from = run(folder, common + machine), direct = run(folder, common + contact);
    for (const char* name : {"/Hc", "/Hm", "/p_h_Pa", "/roller/P_end", "/roller/H_end"}) {
      BOOST_TEST_MESSAGE(name << " = " << support::number_at(from, name));
      BOOST_TEST(std::abs(support::number_at(direct, name) / support::number_at(from, name) - 1.0) < 1e-9, name);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_radial_load_is_shared) {
  const support::Ended ended = checked(radial + "elements = 9\n");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  // 1000 N 4.3852080/9 = 487.245 N.
  for (const char* part : {"F = 487.245 N", "4.38521", "R_x = 3.776 mm", "R_y = 123.8 mm"})
    BOOST_TEST(contains(ended.out, part), part << " is missing in\n" << ended.out);
}

// Around the bearing, the load of a ball falls from its maximum under the radial load to zero at
// the end of the loaded zone.
BOOST_AUTO_TEST_CASE(a_sweep_goes_around) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", radial + "elements = 9\n" + rest);
  const support::Ended ended =
      support::ehl(folder, "sweep d.ini --vary bearing.azimuth=0,60,120 --output around.csv --quiet");
  BOOST_TEST(ended.status == 3, ended.err);  // one case is refused
  const std::string table = folder.read("around.csv");
  for (const char* part : {"bearing_load_factor", "bearing.azimuth", "h_c_nm"})
    BOOST_TEST(contains(table, part), part << " is missing in\n" << table);
}

// Rollers and teeth by hand: R = D (1 - gamma)/2, u = (pi/120) d_m (1 - gamma^2) n with gamma = 0.2; at the pitch point
// rho = m z sin(alpha)/2, pure rolling, and the normal force torque/(m z cos(alpha)/2).
BOOST_AUTO_TEST_CASE(rollers_and_teeth_are_line_contacts) {
  const support::TemporaryFolder folder;
  const auto line = [&](double load_per_length, double radius, double speed) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "[motion]\nu_m = %.17g\n[contact]\nkind = line\nload_per_length = %.17g\nradius_x = %.17g\n", speed,
                  load_per_length, radius);
    return run(folder, rest + text);
  };
  const double pi = std::acos(-1.0), alpha = pi / 9.0, omega = 1500.0 * pi / 30.0;
  const double rho1 = 48e-3 * std::sin(alpha), rho2 = 2.0 * rho1;
  const double force = 10e3 / omega / (48e-3 * std::cos(alpha));
  const std::pair<nlohmann::json, nlohmann::json> pairs[] = {
      {run(folder, roller + rest), line(500.0 / 10e-3, 4e-3, pi / 120.0 * 50e-3 * 0.96 * 3000.0)},
      {run(folder, loaded_gear + rest), line(force / 20e-3, rho1 * rho2 / (rho1 + rho2), omega * rho1)}};
  for (const auto& [machine, plain] : pairs)
    for (const char* name : {"/Hc", "/Hm", "/p_h_Pa", "/hm_m"}) {
      BOOST_TEST_MESSAGE(name << " = " << support::number_at(machine, name));
      BOOST_TEST(std::abs(support::number_at(plain, name) / support::number_at(machine, name) - 1.0) < 1e-9, name);
    }
}

// Along the path of contact: films in nm with the formulas of a line contact. Its pictures cause no message from
// gnuplot, as a map of a line contact would.
BOOST_AUTO_TEST_CASE(teeth_along_their_path) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", loaded_gear + rest);
  BOOST_REQUIRE_EQUAL(support::ehl(folder, "sweep d.ini --vary gear.position=0:1:5 --output path.csv --quiet").status,
                      0);
  const std::string table = folder.read("path.csv");
  for (const char* part : {"h_m_nm", "dh_h_c_nm", "moes_h_c_deviation", "load_N_per_m", "gear_sliding_speed"})
    BOOST_TEST(contains(table, part), part << " is missing in\n" << table);
  BOOST_REQUIRE_EQUAL(support::ehl(folder, "run d.ini --output d.h5 --quiet").status, 0);
  for (const char* file : {"path.csv", "d.h5"}) {
    const support::Ended drawn = support::ehl(folder, std::string("plot ") + file);
    BOOST_TEST(drawn.status == 0, file);
    BOOST_TEST(drawn.err.empty(), file << ": " << drawn.err);
  }
  const support::Ended refused = support::ehl(folder, "plot d.h5 --figure film_contours");
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(contains(refused.err, "film_contours"), refused.err);
}

// With a contact ratio of 2.476 at least two pairs of teeth touch everywhere. Each carries the full
// load if the deck says so.
BOOST_AUTO_TEST_CASE(no_pair_is_alone) {
  const support::Ended ended = checked(
      "[case]\nkind = gear_mesh\n[gear]\nmodule = 4e-3\nface_width = 20e-3\nrpm1 = 1500\nteeth1 = 60\n"
      "teeth2 = 100\naddendum = 1.4\npower = 10e3\nsharing = none\n");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  for (const char* part : {"one pair carries the whole load", "AGMA", "nan"})
    BOOST_TEST(!contains(ended.out, part), part << " stands in\n" << ended.out);
}

// An error in a derived number names the numbers that were given, and causes no further errors.
BOOST_AUTO_TEST_CASE(errors_name_what_was_given) {
  const support::TemporaryFolder folder;
  folder.write("gear.ini", loaded_gear + rest);
  folder.write("ball.ini", ball + rest);
  folder.write("mm.ini",
               "[gear]\nmodule = 4\nface_width = 20e-3\nrpm1 = 1500\nteeth1 = 24\nteeth2 = 48\npower = "
               "10e3\n[case]\nkind = gear_mesh\n" +
                   rest);
  folder.write("line.ini",
               "[contact]\nkind = line\nload_per_length = 2e5\nradius_x = 0.01\nE_prime = 228e9\n[motion]\nu_m = 5\n"
               "[lubricant]\neta0 = 0.0168\nalpha = 1.52e-8\n");
  struct Wrong {
    std::string command;
    std::vector<std::string> parts;
  };
  for (const auto& [command, parts] :
       std::vector<Wrong>{{"check gear.ini --set gear.module=4",
                           {"command line: [gear] module = 4: ", "[contact] load_per_length = ", "M = "}},
                          {"check mm.ini", {"mm.ini:1: [gear]: ", "[contact] load_per_length = ", "M = "}},
                          {"check line.ini --set contact.load_per_length=1000",
                           {"command line: [contact] load_per_length = 1000: ", "M = "}},
                          {"check line.ini --set lubricant.alpha=1e-6 --set lubricant.viscosity=barus",
                           {"command line: [lubricant] alpha = 1e-6: ", "L = "}},
                          {"check line.ini --set contact.kind=Line", {"command line: [contact] kind = Line", "line"}},
                          {"check gear.ini --set contact.length_m=0.01", {"[contact] length_m = 0.01", "[gear]"}},
                          {"sweep gear.ini --vary gear.position=0.5,1.2", {"[gear] position = 1.2"}},
                          {"sweep ball.ini --vary bearing.conformity=0.52,0.4", {"[bearing] conformity = 0.4"}}}) {
    const support::Ended ended = support::ehl(folder, command);
    BOOST_TEST(ended.status == 2, command);
    BOOST_TEST(ended.says(parts), command << " says\n" << ended.err);
    BOOST_TEST(std::ranges::count(ended.err, '\n') == 1, command << " says\n" << ended.err);
  }
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_refused) {
  const auto refused = [](const std::string& name, const std::string& deck, std::vector<std::string> parts) {
    return support::Slip{name, deck + rest, std::move(parts)};
  };
  support::check_refused(
      {refused("no kind", "[bearing]\ndiameter = 1e-3\n", {"d.ini:2", "diameter"}),
       refused("no gears", "[gear]\nmodule = 1e-3\n", {"d.ini:2", "module", "kind = gear_mesh"}),
       refused("a ball's profile", ball + "[roller]\nprofile = logarithmic\n", {"d.ini:9", "profile", "roller_race"}),
       refused("two kinds", roller + "[contact]\nkind = roller\n", {"d.ini:10", "kind = roller"}),
       refused("unknown", "[case]\nkind = ball_bearing\n", {"kind = ball_bearing", "ball_race"}),
       refused("a load twice", ball + "[contact]\nload = 3\n", {"d.ini:9", "load = 3"}),
       refused("another radius", ball + "[contact]\nradius_ratio = 3\n", {"radius_ratio = 3"}),
       refused("in Moes", ball + "[contact]\nM = 3\n", {"d.ini:9", "M = 3"}),
       refused("another speed", ball + "[motion]\nu_m = 3\n", {"d.ini:9", "u_m = 3"}),
       refused("no diameter", "[case]\nkind = ball_race\n[bearing]\npitch_diameter = 1\n",
               {"diameter", "load", "rpm_inner"}),
       refused("negative", ball + "conformity = -1\n", {"conformity = -1"}),
       refused("tight groove", ball + "conformity = 0.5\n", {"conformity = 0.5"}),
       refused("steep", ball + "contact_angle = 90\n", {"contact_angle = 90"}),
       refused("no race", ball + "race = middle\n", {"race = middle"}),
       refused("a long ball", ball + "length = 1\n", {"length = 1", "roller_race"}),
       refused("two loads", ball + "radial_load = 1\nelements = 9\n", {"radial_load = 1"}),
       refused("how many", radial, {"elements"}),
       refused("two balls", radial + "elements = 2\n", {"elements = 2"}),
       refused("too many", radial + "elements = 16\n", {"elements = 16"}),
       refused("few of one", ball + "elements = 9\n", {"elements = 9"}),
       refused("no place", ball + "azimuth = 9\n", {"azimuth = 9"}),
       refused("unloaded", radial + "elements = 9\nazimuth = 120\n", {"azimuth = 120"}),
       refused("beside the load", radial + "elements = 8\nazimuth = 90\n", {"azimuth = 90"}),
       refused("axial", radial + "elements = 9\ncontact_angle = 15\n", {"radial_load"}),
       refused("three speeds", ball + "rpm_outer = 0\nrpm_cage = 1200\n", {"rpm_cage = 1200"}),
       refused("as one", ball + "rpm_outer = 3000\n", {"rpm_inner = 3000"}),
       refused(
           "a big ball",
           "[case]\nkind = ball_race\n[bearing]\ndiameter = 50e-3\npitch_diameter = 46e-3\nload = 5\nrpm_inner = 3\n",
           {"diameter = 50e-3"}),
       refused("a big ball at the outer race",
               "[case]\nkind = ball_race\n[bearing]\ndiameter = 50e-3\npitch_diameter = 46e-3\nrace = outer\nload = 5\n"
               "rpm_inner = 3\n",
               {"diameter = 50e-3"}),
       refused("as one, but for rounding", shape + "load = 5\nrpm_inner = 3000.1\nrpm_cage = 3000.1\n",
               {"rpm_inner = 3000.1"}),
       refused("the cage alone", shape + "load = 5\nrpm_cage = 5\n", {"rpm_cage = 5"}),
       refused("a roller's groove", roller + "conformity = 0.52\n", {"conformity = 0.52"}),
       refused("a roller's angle", roller + "contact_angle = 5\n", {"contact_angle = 5"}),
       refused("a heavy load", gear + "torque1 = 3e5\n", {"[gear]", "load_per_length"}),
       refused("no power", gear, {"power"}),
       refused("both", loaded_gear + "torque1 = 5\n", {"torque1 = 5"}),
       refused("half a tooth", loaded_gear + "pressure_angle = 0\n", {"pressure_angle = 0"}),
       refused("off the path", loaded_gear + "position = 1.1\n", {"position = 1.1"}),
       refused("no pitch point",
               "[case]\nkind = gear_mesh\n[gear]\nmodule = 4.5e-3\nface_width = 14e-3\nrpm1 = 2250\ntorque1 = 100\n"
               "teeth1 = 40\nteeth2 = 40\nshift1 = 1.2\nshift2 = -1.2\n",
               {"[gear] position", "-0.1394"}),
       refused("no rule", loaded_gear + "sharing = half\n", {"sharing = half"}),
       refused("shifted", loaded_gear + "shift1 = -2\nshift2 = -2\n", {"shift1 = -2"}),
       refused("pointed", fzg + "shift1 = 1.4\nshift2 = -0.5\n", {"d.ini:10", "shift1 = 1.4"}),
       refused("pointed without shift", loaded_gear + "addendum = 1.6\nsharing = none\npressure_angle = 25\n",
               {"d.ini:7", "teeth1 = 24"}),
       refused("short", loaded_gear + "addendum = 0.3\n", {"addendum = 0.3"}),
       refused("long", loaded_gear + "addendum = 1.25\n", {"sharing"}),
       refused("interference",
               "[case]\nkind = gear_mesh\n[gear]\nmodule = 4e-3\nface_width = 1\nrpm1 = 1\nteeth1 = 8\nteeth2 = 100\n"
               "power = 1\n",
               {"teeth1 = 8"})});
}

// The error is reported alone, without advice on an axial load, which a cylindrical roller does not carry.
BOOST_AUTO_TEST_CASE(the_angle_of_a_roller_is_told_once) {
  const support::Ended ended = checked(
      "[case]\nkind = roller_race\n[bearing]\ndiameter = 10e-3\npitch_diameter = 50e-3\nlength = 10e-3\n"
      "radial_load = 500\nelements = 9\nrpm_inner = 3000\ncontact_angle = 30\n");
  BOOST_TEST(ended.says({"d.ini:10", "contact_angle = 30", "no influence"}), ended.err);
  BOOST_TEST((std::ranges::count(ended.err, '\n') == 1 && !support::contains(ended.err, "axial load")), ended.err);
}

BOOST_AUTO_TEST_SUITE_END()
