// Contacts with heat from end to end: values of an independent program, balances, symmetries,
// limits, files, what is refused.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>

#include "results/read.hpp"
#include "support/heated.hpp"
#include "support/json.hpp"
#include "support/program.hpp"
#include "support/refused.hpp"
#include "support/text.hpp"

using ehl::results::ResultFile;
using support::check_close;
using support::number_at;

namespace {

const std::string contact = "[contact]\nload = 30\nradius_x = 9.525e-3\nE_prime = 226e9\n";
const std::string motion = "[motion]\nu_m = 2\nsrr = 1\n";
const std::string oil = "[lubricant]\neta0 = 0.04\nalpha = 20e-9\n";
const std::string method =
    "[domain]\nfar_field = zero\nx_inlet = -4.5\nx_outlet = 1.5\ny_half = 3\n[grid]\ncells = 64\n"
    "[discretization]\nwedge = upstream2\nface = mean\n[shear]\nlaw = eyring\ntau_0 = 5e6\n";
const std::string bodies = "solid1 = steel\nsolid2 = steel\n";
const std::string heat =
    "[thermal]\nT_oil = 40\nbeta = 0.042\nk = 0.14\nc = 2000\nrho = 860\nproperties = constant\n" + bodies;
const std::string base = contact + motion + oil + method + heat;

struct Scene : support::HeatedScene {
  explicit Scene(const std::string& deck = base) : HeatedScene(deck) {}
};

}  // namespace

BOOST_AUTO_TEST_SUITE(test_thermal)

// An independent program with columns of 16 intervals and the moving line source in the bodies, on the same grids.
BOOST_AUTO_TEST_CASE(ball_on_disc_of_another_program) {
  const Scene scene;
  struct Row {
    const char* srr;
    const char* cells;
    double mu, Hc, Hm, film, surface_1, surface_2;
  };
  constexpr Row rows[] = {{"0.1", "64", .030812, .21307, .12948, NAN, NAN, NAN},
                          {"0.1", "128", .030700, .22632, .13821, 4.98, 2.72, 2.83},
                          {"1", "64", .032500, .19881, .12420, NAN, NAN, NAN},
                          {"1", "128", .031937, .21209, .13236, 46.9, 20.7, 33.0}};
  for (const Row& row : rows) {
    const auto found = scene.run(std::string("--set thermal.solids=lines --set motion.srr=") + row.srr +
                                 " --set grid.cells=" + row.cells);
    const std::string name = std::string("srr = ") + row.srr + ", " + row.cells + " cells: ";
    check_close(name + "mu", number_at(found, "/thermal/mu"), row.mu, 5e-3);
    check_close(name + "Hc", number_at(found, "/Hc"), row.Hc, 2e-3);
    check_close(name + "Hm", number_at(found, "/Hm"), row.Hm, 2e-3);
    if (std::isnan(row.film)) continue;
    check_close(name + "film", number_at(found, "/thermal/T_film_max"), row.film, 2e-2);
    check_close(name + "surface 1", number_at(found, "/thermal/T1_max"), row.surface_1, 2e-2);
    check_close(name + "surface 2", number_at(found, "/thermal/T2_max"), row.surface_2, 2e-2);
  }
}

BOOST_AUTO_TEST_CASE(heat_goes_where_it_is_told) {
  const Scene scene;
  const auto found = scene.run("--set grid.cells=128");
  const auto at = [&](const char* name) { return number_at(found, std::string("/thermal/") + name); };
  // The power of sliding is mu F du, with 2 m/s. In addition, the pressure flow in the inlet dissipates a small
  // power, as in pure rolling.
  check_close("heat of sliding", at("heat_made"), at("mu") * 30 * 2, 0.05);
  BOOST_TEST(at("heat_made") > at("mu") * 60);
  BOOST_TEST(std::abs(at("heat_imbalance")) < 1e-3);
  check_close("heat led away", at("heat_1") + at("heat_2") + at("heat_carried"), at("heat_made"), 1e-3);
  // The faster surface takes more heat and stays colder.
  BOOST_TEST(at("heat_1") > at("heat_2"));
  BOOST_TEST(at("T1_max") < at("T2_max"));
  // The moving line source gives higher temperatures at these Peclet numbers, 10 and 30.
  const auto lines = scene.run("--set grid.cells=128 --set thermal.solids=lines");
  for (const char* surface : {"/thermal/T1_max", "/thermal/T2_max"}) {
    const double ratio = number_at(found, surface) / number_at(lines, surface);
    BOOST_TEST_MESSAGE(surface << " over that of lines: " << ratio);
    BOOST_TEST((ratio > 0.88 && ratio < 0.98));
  }
}

// The isothermal film of a run with heat equals that of the deck without [thermal] bit for bit.
BOOST_AUTO_TEST_CASE(the_isothermal_contact_is_the_same) {
  const Scene hot, cold(contact + motion + oil + method + "[friction]\ncavitated = none\n");
  support::check_isothermal_beside(hot.run(""), cold.run(""));
}

BOOST_AUTO_TEST_CASE(swapped_bodies_mirror_the_film) {
  const Scene scene;
  const auto one = scene.run("--set thermal.solid2=glass --set thermal.T_body1=50");
  const auto other =
      scene.run("--set motion.srr=-1 --set thermal.solid1=glass --set thermal.solid2=steel --set thermal.T_body2=50");
  support::check_mirrored(one, other);
}

BOOST_AUTO_TEST_CASE(limits) {
  const Scene scene;
  BOOST_TEST(support::check_little_change(scene) < 5e-3);
  // An oil and bodies that conduct all heat away.
  std::string metal = "--set thermal.k=10 --unset thermal.solid1 --unset thermal.solid2";
  for (const std::string n : {"1", "2"})
    metal += " --set thermal.k" + n + "=3000 --set thermal.c" + n + "=5000 --set thermal.rho" + n + "=25000";
  const auto cool = scene.run(metal);
  BOOST_TEST(number_at(cool, "/thermal/T_film_max") < 2.0);
  check_close("mu", number_at(cool, "/thermal/mu"), number_at(cool, "/thermal/mu_isothermal"), 0.02);
}

// 2 GPa on few cells: the coarse grids have no solution with heat, so only the finest grid has one, or the run says
// that it has not. The result is that of the finest grid: its maximum temperature occurs in the field.
BOOST_AUTO_TEST_CASE(heavy_and_sliding) {
  const Scene scene;
  const support::Ended ended = scene.ehl(
      "run d.ini --json --quiet --output d.h5 --set contact.load=293.7 --set motion.u_m=3 --set grid.cells=128 "
      "--set motion.srr=2");
  const auto found = support::parsed(ended.out);
  BOOST_TEST((ended.status == 0 || ended.status == 3), ended.err);
  BOOST_TEST(found["converged"].get<bool>() == (ended.status == 0));
  const std::vector<double> T = ResultFile(scene.folder / "d.h5").numbers("/fields/T_max").values;
  BOOST_TEST(T.size() == 129u * 129u);
  BOOST_TEST(*std::max_element(T.begin(), T.end()) == number_at(found, "/thermal/T_film_max"));
}

// Pure rolling is part of a traction curve.
BOOST_AUTO_TEST_CASE(pure_rolling) {
  const Scene scene;
  const auto found = scene.run("--set motion.srr=0");
  BOOST_TEST(number_at(found, "/thermal/mu") == 0.0);
  BOOST_TEST(number_at(found, "/thermal/mu_isothermal") == 0.0);
  check_close("surfaces", number_at(found, "/thermal/T1_max"), number_at(found, "/thermal/T2_max"), 1e-9);
  // Inlet heating at 10 m/s with a Newtonian oil; an independent program gives 0.861 +- 1 %.
  const auto fast = scene.run(
      "--unset shear.law --unset shear.tau_0 --set motion.srr=0 --set motion.u_m=10 --set domain.x_inlet=-7.5 "
      "--set domain.y_half=4.5 --set grid.cells=96");
  check_close("film", number_at(fast, "/thermal/film_reduction"), 0.861, 0.015);
  // The formulas for the inlet of a line contact predict a larger reduction; L = 0.04 0.042 100/0.14 = 1.2.
  check_close("Wilson and Sheu", number_at(fast, "/thermal/wilson_sheu"), 1 / (1 + 0.241 * std::pow(1.2, 0.64)), 1e-6);
  check_close("Murch and Wilson", number_at(fast, "/thermal/murch_wilson"), 0.779, 2e-3);
}

BOOST_AUTO_TEST_CASE(results_hold_it) {
  const Scene scene;
  const auto found = scene.run("--set thermal.fields=T_mid,T_max,T1,T2,section --set grid.cells=128");
  const ResultFile file(scene.folder / "d.h5");
  const double most = number_at(found, "/thermal/T_film_max");
  double largest = 0.0;
  for (const double T : file.numbers("/fields/T_max").values) largest = std::max(largest, T);
  BOOST_TEST(largest == most);
  BOOST_TEST(file.numbers("/thermal_section/T").values.size() == 17u * 129u);
  // u varies from u2 = 0.5 to u1 = 1.5 u_m.
  const std::vector<double> u = file.numbers("/thermal_section/u").values;
  BOOST_TEST(u.front() == 0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(u.back() == 1.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(file.numbers("/summary/heat_1").values.at(0) == number_at(found, "/thermal/heat_1"));
  BOOST_TEST(found["thermal"]["levels"].size() == 2u);
  // The deck in the result is the same contact.
  scene.folder.write("again.ini", file.text("/deck"));
  const auto again = support::parsed(scene.ehl("run again.ini --json --quiet --output again.h5").out);
  BOOST_TEST(number_at(again, "/thermal/mu") == number_at(found, "/thermal/mu"));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_is_refused) {
  const auto with = [](const std::string& more) { return base + more; };
  const auto of_oil = [](const std::string& lubricant, const std::string& thermal) {
    return contact + motion + "[lubricant]\n" + lubricant + method + "[thermal]\n" + thermal;
  };
  const std::string warm = "T_oil = 40\nbeta = 0.042\n";
  const auto thermal = [&](const std::string& keys) { return contact + motion + oil + method + "[thermal]\n" + keys; };
  support::check_refused({
      {"polish", with("[multigrid]\npolish = always\n"), {"polish"}},
      {"dry", "[case]\nkind = dry\n" + contact + "[thermal]\nT_oil = 40\n", {"T_oil", "kind = dry"}},
      {"no speeds", "[contact]\nM = 50\nL = 10\n[lubricant]\nalpha = 2e-8\n" + heat, {"T_oil"}},
      {"against the entrainment", contact + "[motion]\nu_m = 2\nsrr = 3\n" + oil + method + heat, {"srr"}},
      {"isoviscous", of_oil("eta0 = 0.04\nviscosity = isoviscous\n", warm + bodies), {"viscosity"}},
      {"no slope", thermal("T_oil = 40\n" + bodies), {"beta", "vogel_B"}},
      {"two ways", thermal(warm + "vogel_B = 900\nvogel_C = -100\n" + bodies), {"vogel_B"}},
      {"half a way", thermal("T_oil = 40\nT_second = 100\n" + bodies), {"eta_second"}},
      {"thickens", thermal("T_oil = 40\nT_second = 100\neta_second = 0.1\n" + bodies), {"eta_second"}},
      {"Vogel's pole", thermal("T_oil = -39\nvogel_B = 900\nvogel_C = -42\n" + bodies), {"vogel_C"}},
      {"data sheet", of_oil("fluid = mineral-vg68\n", "beta = 0.04\n" + bodies), {"beta", "kv40"}},
      {"two temperatures",
       of_oil("fluid = mineral-vg68\ntemperature = 60\n", "T_oil = 40\n" + bodies),
       {"T_oil", "60"}},
      {"kelvin", thermal("T_oil = 313\nbeta = 0.042\n" + bodies), {"T_oil = 313"}},
      {"body in kelvin", thermal(warm + "T_body1 = 353\n" + bodies), {"T_body1"}},
      {"no temperature", thermal("beta = 0.042\n" + bodies), {"T_oil"}},
      {"no body", thermal(warm), {"solid1", "solid2"}},
      {"unknown solid", thermal(warm + "solid1 = stel\nsolid2 = steel\n"), {"solid1"}},
      {"twice", thermal(warm + bodies + "k1 = 46\n"), {"k1"}},
      {"half a body", thermal(warm + "solid2 = steel\nk1 = 46\n"), {"c1", "rho1"}},
      {"negative", thermal(warm + bodies + "k = -0.14\n"), {"k = -0.14"}},
      {"kilojoules", thermal(warm + bodies + "c = 2\n"), {"c = 2"}},
      {"grams", thermal(warm + bodies + "rho = 0.86\n"), {"rho"}},
      {"even", thermal(warm + bodies + "nodes = 16\n"), {"nodes"}},
      {"word", thermal(warm + bodies + "convection = yes\n"), {"convection"}},
      {"expansion", thermal(warm + bodies + "expansion = 0.65\n"), {"expansion"}},
      {"volume", thermal(warm + bodies + "occupied_expansion = 1e-4\n"), {"occupied_expansion"}},
      {"section alone", contact + motion + oil + method + "[thermal]\nk = 0.14\n", {"[thermal]"}},
  });
  // All errors are reported together.
  support::check_refused(
      {{"all", thermal("T_oil = 313\nk = -1\nsolid1 = wood\nnodes = 2\n"), {"T_oil", "k = -1", "nodes"}}});
  const Scene scene;
  const support::Ended study = scene.ehl("study d.ini --levels 32:64 --cycles 1V,run");
  BOOST_TEST(study.status == 2);
  BOOST_TEST(study.says({"--cycles 1V,run"}), study.err);
}

// The accuracy asked for holds against a run with four times the cells.
BOOST_AUTO_TEST_CASE(to_an_accuracy) {
  const Scene scene(contact + motion + oil +
                    "[domain]\nfar_field = zero\nx_inlet = -4.5\nx_outlet = 1.5\ny_half = 3\n" +
                    "[shear]\nlaw = eyring\ntau_0 = 5e6\n" + heat);
  const auto found = scene.run("--set grid.accuracy=0.005");
  const auto fine = scene.run("--set grid.cells=512");
  BOOST_TEST(found["accuracy"]["met"].get<bool>());
  for (const char* name : {"/Hc", "/Hm"}) check_close(name, number_at(found, name), number_at(fine, name), 0.005);
  check_close("mu", number_at(found, "/thermal/mu"), number_at(fine, "/thermal/mu"), 0.01);
  BOOST_TEST(found["thermal"]["levels"].back()["Hc"].get<double>() == number_at(found, "/Hc"));
  BOOST_TEST(number_at(found, "/thermal/Hc_isothermal") > 1.05 * number_at(found, "/Hc"));
}

// Films with heat: upstream2 is of second order and more accurate than upstream1.
BOOST_AUTO_TEST_CASE(a_study_of_films_with_heat) {
  const Scene scene;
  const support::Ended ended = scene.ehl(
      "study d.ini --levels 32:128 --wedges upstream1,upstream2 --evaluators fft --repeat 1 --reference 128 --output "
      "study.csv "
      "--quiet");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  std::map<std::string, double> error;
  for (const support::NamedRow& row : support::named_rows(scene.folder.read("study.csv"))) {
    BOOST_TEST(row.at("cycles") == "run");
    error[row.at("wedge") + row.at("nx")] = std::stod(row.at("deviation_Hc"));
    if (row.at("wedge") == "upstream2" && row.at("nx") == "128")
      check_close("Hc", std::stod(row.at("Hc")), number_at(scene.run("--set grid.cells=128"), "/Hc"), 1e-3);
  }
  for (const auto& [name, value] : error) BOOST_TEST_MESSAGE(name << " cells: Hc " << value << " off");
  BOOST_TEST(error["upstream264"] / error["upstream2128"] > 3);
  BOOST_TEST(error["upstream1128"] > 1.5 * error["upstream2128"]);
}

BOOST_AUTO_TEST_CASE(sweep_makes_a_traction_curve) {
  const Scene scene;
  const support::Ended ended = scene.ehl("sweep d.ini --vary motion.srr=0,0.1,0.4,1,2 --output curve.csv --threads 2");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  std::vector<double> mu, film;
  for (const support::NamedRow& row : support::named_rows(scene.folder.read("curve.csv"))) {
    BOOST_TEST(row.at("status") == "converged", row.at("reason"));
    mu.push_back(std::stod(row.at("mu")));
    film.push_back(std::stod(row.at("T_film_max")));
    BOOST_TEST(std::stod(row.at("mu_isothermal")) >= mu.back());
  }
  BOOST_REQUIRE(mu.size() == 5u);
  BOOST_TEST(mu[0] == 0.0);
  // The curve rises, has a maximum and falls; the film temperature rises monotonically.
  BOOST_TEST((mu[1] > 0.02 && mu[2] > mu[1] && mu[3] < mu[2] && mu[4] < mu[3]));
  for (std::size_t k = 1; k < film.size(); ++k) BOOST_TEST(film[k] > film[k - 1]);
}

BOOST_AUTO_TEST_SUITE_END()
