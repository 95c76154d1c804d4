// Friction in other parts of the program: heat, the stresses below the surface, tables and pages.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "support/heated.hpp"
#include "support/text.hpp"

using support::check_close;
using support::contains;
using support::number_at;

namespace {

const std::string ball =
    "[contact]\nload = 100\nradius_x = 0.01\nE1 = 206e9\nE2 = 206e9\nnu1 = 0.3\nnu2 = 0.3\n[motion]\nu_m = 2\n"
    "srr = 0.1\n[lubricant]\neta0 = 0.05\nalpha = 2e-8\n[grid]\ncells = 64\n[domain]\nx_inlet = -4.5\nx_outlet = "
    "1.5\ny_half = 3\n";
const std::string heat = "[thermal]\nT_oil = 40\nbeta = 0.04\nsolid1 = steel\nsolid2 = steel\n";
const std::string eyring = "[shear]\nlaw = eyring\ntau_0 = 5e6\n";

using Scene = support::HeatedScene;

}  // namespace

BOOST_AUTO_TEST_SUITE(test_friction_elsewhere)

// A Newtonian oil at 1.3 GPa, for which the isothermal shear stress is unrealistically high.
BOOST_AUTO_TEST_CASE(heat_warns_of_stresses_that_no_oil_carries) {
  const Scene scene(ball + heat);
  const nlohmann::json found = scene.run("");
  BOOST_TEST(number_at(found, "/thermal/mu_isothermal") > 1.0);
  BOOST_TEST(contains(found["thermal"]["warning_names"].dump(), "isothermal-friction"));
  BOOST_REQUIRE(scene.ehl("sweep d.ini --vary motion.srr=0.1 --overwrite").status == 0);
  const auto rows = support::named_rows(scene.folder.read("d_sweep.csv"));
  BOOST_TEST(rows[0].at("warnings") != "0");
  // With a shear law there is no reason for the warning.
  scene.folder.write("d.ini", ball + heat + eyring);
  BOOST_TEST(!contains(scene.run("")["thermal"].dump(), "isothermal-friction"));
}

// The stresses use the force on surface 1 that [friction] computes, and say so.
BOOST_AUTO_TEST_CASE(stresses_below_take_the_computed_friction) {
  const std::string below = "[subsurface]\ndepth = 1\nplanes = 11\ncells = 64\n";
  const Scene scene(ball + eyring + "[friction]\ncavitated = striated\n" + below);
  const nlohmann::json computed = scene.run("");
  const double mu_1 = number_at(computed, "/friction/mu_1");
  BOOST_TEST(mu_1 < -0.01);
  BOOST_TEST(number_at(computed, "/subsurface/friction") == mu_1);
  const nlohmann::json given = scene.run("--set subsurface.friction=" + std::to_string(mu_1));
  check_close("von Mises", number_at(computed, "/subsurface/sigma_mises/value"),
              number_at(given, "/subsurface/sigma_mises/value"), 1e-5);
  scene.folder.write("d.ini", ball + eyring + below);
  const nlohmann::json without = scene.run("");
  BOOST_TEST(number_at(without, "/subsurface/friction") == 0.0);
  BOOST_TEST(number_at(without, "/subsurface/sigma_mises/value") !=
             number_at(computed, "/subsurface/sigma_mises/value"));
}

// A negative friction coefficient has an error bar as well.
BOOST_AUTO_TEST_CASE(pages_keep_the_bars_of_negative_friction) {
  const Scene scene(ball + heat + eyring);
  BOOST_REQUIRE(scene.ehl("sweep d.ini --vary motion.srr=-0.2,-0.1,-0.05 --set grid.cells=128 --overwrite").status ==
                0);
  BOOST_REQUIRE(scene.ehl("report d_sweep.csv --output page.html --overwrite").status == 0);
  const std::string page = scene.folder.read("page.html");
  const auto rows = support::named_rows(scene.folder.read("d_sweep.csv"));
  BOOST_TEST(std::stod(rows[0].at("mu")) < 0.0);
  BOOST_TEST(std::stod(rows[0].at("error_mu")) > 0.0);
  const std::size_t cell = page.find("<td>-0.0");
  BOOST_REQUIRE(cell != std::string::npos);
  BOOST_TEST(contains(page.substr(cell, page.find("</td>", cell) - cell), "±"), page.substr(cell, 60));
}

// The load of a roller is per length, on the page as in the file.
BOOST_AUTO_TEST_CASE(pages_have_the_unit_of_the_load) {
  const Scene scene(
      "[contact]\nkind = roller\nload = 300\nlength_m = 6e-3\nradius_x = 5e-3\nE_prime = 226e9\n[roller]\nprofile = "
      "logarithmic\n[motion]\nu_m = 1\n[lubricant]\neta0 = 0.05\nalpha = 2e-8\n[grid]\ncells = 64\n");
  BOOST_REQUIRE(scene.ehl("run d.ini --quiet --overwrite --output d.h5").status == 0);
  BOOST_REQUIRE(scene.ehl("report d.h5 --output page.html --overwrite").status == 0);
  const std::string page = scene.folder.read("page.html");
  BOOST_TEST(contains(page, "load 5e+04 N/m"), page.substr(page.find("load "), 60));
}

BOOST_AUTO_TEST_SUITE_END()
