// Contacts with heat in practice: unusual conditions, a fit to a measured curve, pictures.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <tuple>
#include <utility>

#include "support/heated.hpp"
#include "support/json.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

using support::number_at;

namespace {

std::string deck_of(const std::string& cells) {
  return "[contact]\nload = 30\nradius_x = 9.525e-3\nE_prime = 226e9\n[motion]\nu_m = 2\nsrr = 1\n"
         "[lubricant]\neta0 = 0.04\nalpha = 20e-9\n[grid]\ncells = " +
         cells +
         "\n[shear]\nlaw = eyring\ntau_0 = 5e6\n[thermal]\nT_oil = 40\nbeta = 0.042\nsolid1 = steel\nsolid2 = steel\n";
}

struct Scene {
  support::TemporaryFolder folder;
  explicit Scene(const std::string& deck) { folder.write("d.ini", deck); }
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }
  // in: changes to the deck.
  nlohmann::json run(const std::string& changes) const {
    const support::Ended ended = ehl("run d.ini --json --quiet --overwrite --output d.h5 " + changes);
    BOOST_TEST(ended.status == 0, changes << ": " << ended.err);
    return support::parsed(ended.out);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(test_heat_in_use)

// Below a wide contact, the surface temperature of a body at rest responds so strongly to the heat that the iteration
// diverges without damping. A body that moves slowly is as hot.
BOOST_AUTO_TEST_CASE(a_body_at_rest_below_a_wide_contact) {
  const Scene scene(deck_of("64"));
  const auto hottest = [&](const std::string& speeds) {
    return number_at(scene.run("--set contact.radius_ratio=0.05 --set contact.load=100 --unset motion.u_m --unset "
                               "motion.srr --set motion.u1=4 --set motion.u2=" +
                               speeds),
                     "/thermal/T2_max");
  };
  const double at_rest = hottest("0"), creeping = hottest("1e-4");
  BOOST_TEST_MESSAGE("at rest " << at_rest << " K, creeping " << creeping << " K");
  BOOST_TEST(std::abs(creeping / at_rest - 1.0) < 0.01);
}

// Points of a map over load, speed and sliding that are difficult for the fixed-point iteration between film and heat:
// chattering, loss of the film, a recirculating inlet.
BOOST_AUTO_TEST_CASE(far_from_the_base_case) {
  const Scene scene(deck_of("128"));
  for (const char* point : {"contact.load=4.59 --set motion.u_m=20 --set motion.srr=2",
                            "contact.load=293.7 --set motion.u_m=3 --set "
                            "motion.srr=2",
                            "contact.load=573.6 --set motion.u_m=8 --set motion.srr=1"}) {
    const nlohmann::json result = scene.run(std::string("--set ") + point);
    BOOST_TEST_MESSAGE(point << ": mu " << number_at(result, "/thermal/mu") << ", film "
                             << number_at(result, "/thermal/T_film_max") << " K");
    BOOST_TEST(number_at(result, "/thermal/T_film_max") < 400.0);
    BOOST_TEST(std::abs(number_at(result, "/thermal/heat_imbalance")) < 1e-3);
  }
}

// A thick film with a recirculating inlet changes little in each iteration, but much in total. Many iterations must
// agree with the automatic stopping criterion.
BOOST_AUTO_TEST_CASE(an_inlet_that_recirculates) {
  const Scene scene(
      "[contact]\nload = 14.2\nradius_x = 12.5e-3\nE_prime = 226e9\n[motion]\nu_m = 5.1\nsrr = 0.46\n"
      "[lubricant]\neta0 = 0.0295\nalpha = 19.6e-9\n[grid]\ncells = 128\n[shear]\nlaw = eyring\ntau_0 = 3.3e6\n"
      "[thermal]\nT_oil = 71.5\nbeta = 0.04\nsolid1 = si3n4\nsolid2 = bk7\n");
  const nlohmann::json usual = scene.run(""), settled = scene.run("--set multigrid.tolerance=1e-6");
  for (const auto& [name, tolerance] : {std::pair{"/Hc", 1e-4}, {"/thermal/mu", 1e-4}, {"/thermal/T_film_max", 3e-4}}) {
    const double off = number_at(usual, name) / number_at(settled, name) - 1;
    BOOST_TEST_MESSAGE(name << ": " << off << " off (tolerance " << tolerance << ")");
    BOOST_TEST(std::abs(off) < tolerance);
  }
}

// The error bars of friction and surface temperatures on 128 cells contain the result on 512 cells.
BOOST_AUTO_TEST_CASE(bars_of_friction_and_temperatures) {
  const Scene scene(deck_of("128"));
  for (const std::string point :
       {"--set contact.load=36.7 --set motion.u_m=8 --set motion.srr=0.5", "--set motion.u_m=5"}) {
    const nlohmann::json coarse = scene.run(point), fine = scene.run(point + " --set grid.cells=512");
    for (const std::string name : {"mu", "T_film_max", "T1_max", "T2_max"}) {
      const double error = std::abs(number_at(coarse, "/thermal/" + name) / number_at(fine, "/thermal/" + name) - 1);
      const double bar = number_at(coarse, "/thermal/error_" + name);
      BOOST_TEST_MESSAGE(point << ": " << name << " " << error << " off, bar " << bar);
      // Under a pressure spike that the mesh does not resolve, the film temperature has no error
      // bar, and a warning says so.
      if (name == "T_film_max" && std::isnan(bar)) {
        BOOST_TEST(coarse["thermal"]["warning_names"].dump().find("\"spike\"") != std::string::npos);
        continue;
      }
      BOOST_TEST(error <= bar);
      BOOST_TEST(bar < 0.06);
    }
  }
}

// Pure rolling is part of a traction curve: the pressure flow thins the oil there too, with and without heat.
BOOST_AUTO_TEST_CASE(pure_rolling_with_the_flow_s_thinning) {
  const std::string thin = "--set shear.flow=on --set shear.tau_0=1e6 --set motion.srr=";
  const std::string cold = " --unset thermal.T_oil --unset thermal.beta --unset thermal.solid1 --unset thermal.solid2";
  const Scene scene(deck_of("128"));
  const nlohmann::json rolling = scene.run(thin + "0" + cold), creeping = scene.run(thin + "1e-4" + cold);
  const double Hc = number_at(rolling, "/Hc"), Hc_without = number_at(rolling, "/shear/Hc_without");
  BOOST_TEST_MESSAGE("Hc " << Hc << " of " << Hc_without << " (-3.7 % +- .3)");
  BOOST_TEST(std::abs(Hc / Hc_without - 1 + 0.037) < 0.003);
  BOOST_TEST(number_at(rolling, "/shear/mu") == 0.0);
  BOOST_TEST(std::abs(number_at(creeping, "/Hc") / Hc - 1) < 1e-4);
  BOOST_TEST(number_at(creeping, "/shear/mu") > 0.0);
  const nlohmann::json warm = scene.run(thin + "0");
  BOOST_TEST(number_at(warm, "/thermal/mu") == 0.0);
  BOOST_TEST(number_at(warm, "/Hc") < Hc);  // the inlet is heated as well

  for (const char* change : {"--unset grid.cells --set grid.accuracy=0.01", "--set multigrid.polish=always",
                             "--unset shear.law --unset shear.tau_0"}) {
    const support::Ended refused = scene.ehl("check d.ini " + thin + "0" + cold + " " + change);
    BOOST_TEST(refused.status == 2, change);
    BOOST_TEST(support::contains(refused.err, "[shear] flow"), refused.err);
  }
}

// The program's own friction serves as measured values: the fit must find the stress that produced them.
BOOST_AUTO_TEST_CASE(a_fit_finds_the_stress_that_made_the_curve) {
  const Scene scene(deck_of("64"));
  BOOST_REQUIRE(scene.ehl("sweep d.ini --vary motion.srr=0.05,0.2,0.5,1 --output made.csv --threads 2").status == 0);
  std::string measured = "srr,mu\n";
  for (const support::NamedRow& row : support::named_rows(scene.folder.read("made.csv")))
    measured += row.at("motion.srr") + "," + row.at("mu") + "\n";
  scene.folder.write("measured.csv", measured);
  const support::Ended ended =
      scene.ehl("fit d.ini --measured measured.csv --free shear.tau_0 --set shear.tau_0=9e6 --threads 2 --quiet");
  BOOST_TEST(ended.status == 0, ended.err << ended.out);
  const std::string key = "shear.tau_0  = ";
  const std::size_t at = ended.out.find(key);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, ended.out);
  BOOST_TEST_MESSAGE(ended.out);
  const double tau_0 = std::stod(ended.out.substr(at + key.size()));
  BOOST_TEST(std::abs(tau_0 / 5e6 - 1) < 5e-3, tau_0);
  const support::Ended drawn = scene.ehl("plot made.csv --measured measured.csv --format svg");
  BOOST_TEST(drawn.status == 0, drawn.err);
  BOOST_TEST(support::contains(scene.folder.read("made_traction_curve.svg"), "measured"));

  for (const auto& [name, text, words] :
       {std::tuple{"per_cent", "5,0.03\n20,0.04\n", std::vector<std::string>{"per_cent.csv:1"}},
        {"one", "0.1,0.03\n", std::vector<std::string>{"--measured"}},
        {"odd", "0.1,0.03\n0.2,0.03,0.001\n", std::vector<std::string>{"odd.csv:2"}}}) {
    scene.folder.write(std::string(name) + ".csv", text);
    const support::Ended refused =
        scene.ehl("fit d.ini --measured " + std::string(name) + ".csv --free shear.tau_0 --quiet");
    BOOST_TEST(refused.status != 0);
    BOOST_TEST(refused.says(words), refused.err);
  }
  BOOST_TEST(scene.ehl("fit d.ini --measured measured.csv --free shear.G --quiet").says({"shear.G"}));
}

BOOST_AUTO_TEST_CASE(pictures_of_heat) {
  const Scene scene(deck_of("64") + "fields = T_mid, T_max, T1, T2, section\n");
  scene.run("");
  const support::Ended drawn = scene.ehl(
      "plot d.h5 --format svg --figure temperature_map --figure temperature_lines --figure temperature_section");
  BOOST_TEST(drawn.status == 0, drawn.err);
  BOOST_TEST(drawn.err.empty(), drawn.err);  // gnuplot prints no warning
  BOOST_REQUIRE(scene.ehl("sweep d.ini --vary motion.u_m=1,4 --vary motion.srr=0,0.3,1 --threads 2").status == 0);
  const support::Ended map = scene.ehl("plot d_sweep.csv --format svg --figure traction_map");
  BOOST_TEST(map.status == 0, map.err);
  BOOST_TEST(map.err.empty(), map.err);
  BOOST_TEST(support::contains(scene.folder.read("d_sweep_traction_map.svg"), "<svg"));
}

// A Newtonian oil, from 1 GPa to a glass at 3 GPa: the shear stress that no oil carries is the reason, which more cells
// do not cure. The cure that the message names does.
BOOST_AUTO_TEST_CASE(a_stress_that_no_oil_carries_is_the_reason) {
  const support::HeatedScene scene(
      "[contact]\nkind = line\nload_per_length = 2.5e6\nradius_x = 0.01\nE_prime = 226e9\n[motion]\nu_m = 2\nsrr = "
      "0.5\n[lubricant]\neta0 = 0.1\nalpha = 2.3e-8\n[thermal]\nT_oil = 40\nbeta = 0.045\nsolid1 = steel\nsolid2 = "
      "steel\n");
  for (const char* load : {"4e5", "1.8e6", "2.5e6"}) {
    const std::string run = "run d.ini --quiet --overwrite --set grid.cells=256 --set contact.load_per_length=";
    const support::Ended ended = scene.ehl(run + load);
    BOOST_TEST_MESSAGE(ended.err);
    BOOST_TEST(ended.status == 3);
    BOOST_TEST(ended.says({"[shear] law"}));
    BOOST_TEST(ended.err.find("use more cells") == std::string::npos);
    BOOST_TEST(scene.ehl(run + load + " --set shear.law=eyring --set shear.tau_0=5e6").status == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
