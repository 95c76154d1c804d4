// Oils by name, laws of liquids and tables in decks: valid ones are compared with each other, invalid ones are refused.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>

#include "results/read.hpp"
#include "support/json.hpp"
#include "support/refused.hpp"

using ehl::results::ResultFile;

namespace {

// p_h = 0.97 GPa.
const std::string contact =
    "[contact]\nload = 60\nradius_x = 12.7e-3\nE_prime = 226e9\n[motion]\nu_m = 1\n[grid]\ncells = 64\n[lubricant]\n";
const std::string yasutomi =
    "viscosity = yasutomi\ntemperature = 25\nTg0 = -83.2\nA1 = 188.95\nA2 = 0.719e-9\nb1 = 8.2e-9\nb2 = -0.53\n"
    "C1 = 16.09\nC2 = 17.38\neta_g = 1e12\n";
const std::string moes = "[contact]\nM = 50\nL = 10\n[grid]\ncells = 64\n[lubricant]\n";

// A table of Barus' law, alpha = 12 1/GPa, up to `rows` tenths of a gigapascal.
std::string barus_table(int rows) {
  std::string text = "# Barus\np, eta, rho\n";
  for (int k = 0; k < rows; ++k) {
    char line[96];
    std::snprintf(line, sizeof line, "%.9g, %.17g, %.9g\n", 1e8 * k, 0.0156 * std::exp(1.2 * k), 850.0 + 10.0 * k);
    text += line;
  }
  return text;
}

struct Slip {
  std::string name;
  std::string oil;
  std::string table;
  std::vector<std::string> parts;  ///< parts of the message
};

void check_all(const std::string& before, const std::vector<Slip>& slips) {
  for (const Slip& slip : slips) {
    const support::TemporaryFolder folder;
    if (!slip.table.empty()) folder.write("t.csv", slip.table);
    support::check_refused(folder, {slip.name, before + slip.oil, slip.parts});
  }
}

double json_number(const std::string& json, const std::string& name) {
  return support::number_at(support::parsed(json), "/" + name);
}

// The cycles on all levels together.
int cycles_of(const std::string& json) {
  const nlohmann::json report = support::parsed(json);
  int sum = 0;
  for (const nlohmann::json& level : report.at("levels")) sum += level.at("cycles").get<int>();
  return sum;
}

std::vector<double> pressures(const support::TemporaryFolder& folder, const std::string& name) {
  return ResultFile(folder / name).numbers("/fields/P").values;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_fluids)

BOOST_AUTO_TEST_CASE(names_and_contradictions) {
  check_all(contact, {{"unknown fluid", "fluid = squalene\n", "", {"d.ini:10", "fluid = squalene"}},
                      {"another constant", "fluid = squalane\neta0 = 0.02\n", "", {"d.ini:11", "fluid = squalane"}},
                      {"another law", "fluid = squalane\nviscosity = barus\n", "", {"d.ini:11"}},
                      {"a key of another law", "fluid = squalane\nz = 0.6\n", "", {"d.ini:11", "z = 0.6"}},
                      {"another alpha", "fluid = squalane\nalpha = 2e-8\n", "", {"d.ini:11"}},
                      {"temperature without influence",
                       "viscosity = barus\neta0 = 0.1\nalpha = 1e-8\ntemperature = 40\n",
                       "",
                       {"d.ini:13", "temperature = 40"}},
                      {"bulk modulus without influence",
                       "eta0 = 0.1\nalpha = 1e-8\nK0 = 1e9\n",
                       "",
                       {"d.ini:12", "K0 = 1e9", "density = tait"}},
                      {"no bulk modulus", "eta0 = 0.1\nalpha = 1e-8\ndensity = tait\n", "", {"[lubricant] K0_prime"}},
                      {"negative", "viscosity = doolittle\neta0 = 0.1\nK0 = -1\n", "", {"d.ini:12", "K0 = -1"}},
                      {"occupied more than all",
                       "viscosity = doolittle\ndoolittle_R0 = 1.2\n",
                       "",
                       {"d.ini:11", "doolittle_R0 = 1.2"}},
                      {"half a law", "viscosity = yasutomi\n", "", {"[lubricant] Tg0", "C1"}},
                      {"below the glass transition",
                       "Tg0 = 30\n" + yasutomi.substr(0, yasutomi.find("Tg0")) + yasutomi.substr(yasutomi.find("A1")),
                       "",
                       {"d.ini:12", "temperature = 25"}}});
}

BOOST_AUTO_TEST_CASE(tables) {
  const std::string oil = "viscosity = table\ntable = t.csv\n";
  const std::string both = "viscosity = table\ndensity = table\ntable = t.csv\n";
  const std::string rows = "0, 1, 850\n1e9, 2, 860\n2e9, 3, 870\n";
  check_all(
      contact,
      {{"few rows", oil, rows, {"d.ini:11", "t.csv"}},
       {"no ambient pressure", oil, "1e8, 1\n1e9, 2\n", {"t.csv:1", "p = 1e+08", "p = 0"}},
       {"pressure falls", oil, rows + "1.5e9, 4, 880\n", {"t.csv:4", "p = 1.5e+09"}},
       {"viscosity falls", oil, rows + "3e9, 2, 880\n", {"t.csv:4", "eta = 2"}},
       {"viscosity not positive", oil, "0, -1\n", {"t.csv:1", "eta = -1"}},
       {"density falls", both, rows + "3e9, 4, 865\n", {"t.csv:4", "rho = 865"}},
       {"density not positive", both, "0, 1, 0\n", {"t.csv:1", "rho = 0"}},
       {"no density", both, "0, 1\n", {"t.csv:1"}},
       {"text", oil, "0, 1\n1e9, much\n", {"t.csv:2"}},
       {"not finite", oil, "0, 1\n1e9, inf\n", {"t.csv:2"}},
       {"in gigapascals",
        oil,
        "p, eta, rho\n0, 0.05, 850\n0.5, 5, 900\n1, 300, 930\n2, 1e5, 960\n",
        {"d.ini:11", "9.723e+08 Pa"}},
       {"ends too low", oil, barus_table(9), {"d.ini:11", "8e+08 Pa", "9.723e+08 Pa"}},
       {"no table", "viscosity = table\n", "", {"[lubricant] table"}},
       {"table without influence", "eta0 = 0.1\nalpha = 1e-8\ntable = t.csv\n", rows, {"d.ini:12", "table = t.csv"}},
       {"another viscosity", oil + "eta0 = 1\n", barus_table(20), {"d.ini:12", "eta0 = 1", "0.0156"}}});
  // The names and units in the heading count: every form of the table gives the same film, and one of them that of the
  // cells that the program chooses.
  const support::TemporaryFolder folder;
  const std::string thin =
      "[contact]\nload = 20\nradius_x = 0.0127\nE_prime = 1.2e11\n[motion]\nu_m = 0.01\n" + ("[lubricant]\n" + both);
  folder.write("u.ini", thin);
  const auto film_of = [&](const std::string& more) {
    const std::string run = "run u.ini --json --quiet --overwrite --set lubricant.table=ways.csv";
    return 1e9 * support::number_at(support::parsed(support::ehl(folder, run + more).out), "/hc_m");
  };
  double of_first = std::nan("");
  for (const char* text :
       {"p [Pa],eta [mPa s],rho "
        "[kg/m^3]\n0,40,870\n1e8,250,912\n2e8,1200,941\n4e8,20000,985\n8e8,3e6,1045\n1.2e9,3e8,1090\n",
        "p [Pa],rho [kg/m^3],eta [Pa "
        "s]\n0,870,0.04\n1e8,912,0.25\n2e8,941,1.2\n4e8,985,20\n8e8,1045,3000\n1.2e9,1090,3e5\n",
        "p [MPa];eta [mPa s];rho "
        "[g/cm3]\n0;40;0,870\n100;250;0,912\n200;1200;0,941\n400;20000;0,985\n800;3e6;1,045\n1200;3e8;1,090\n"}) {
    folder.write("ways.csv", text);
    const double h_c = film_of(" --set grid.cells=128");
    if (std::isnan(of_first)) of_first = h_c;
    BOOST_TEST_MESSAGE(text << "h_c = " << h_c << " nm, of the first form " << of_first << " nm (tolerance 0.01 nm)");
    BOOST_TEST(std::abs(h_c - of_first) < 0.01);
  }
  const double h_c = film_of("");
  BOOST_TEST_MESSAGE("h_c = " << h_c << " nm, 12.96 nm wanted");
  BOOST_TEST(std::abs(h_c - 12.96) < 0.01);
  folder.write("d.ini", contact + oil);
  BOOST_TEST(support::ehl(folder, "check d.ini").status == 4);  // a file that does not exist
}

BOOST_AUTO_TEST_CASE(mouriers_oil_is_the_deck_with_its_keys) {
  const support::TemporaryFolder folder;
  const std::string ball =
      "[contact]\nload = 15\nradius_x = 12.5e-3\nE_prime = 110e9\n[motion]\nu_m = 0.09\n[grid]\n"
      "cells = 64\n[lubricant]\n";
  folder.write("named.ini", ball + "fluid = mourier\n");
  folder.write("keys.ini", ball + "viscosity = roelands\neta0 = 0.25\nalpha = 22e-9\n");
  BOOST_REQUIRE(support::ehl(folder, "run named.ini").status == 0);
  BOOST_REQUIRE(support::ehl(folder, "run keys.ini").status == 0);
  BOOST_TEST((pressures(folder, "named.h5") == pressures(folder, "keys.h5")), "the same bits");
  // If the deck gives M and L, alpha determines the Hertz pressure, as for single keys.
  folder.write("named.ini", moes + "fluid = mourier\n");
  folder.write("keys.ini", moes + "viscosity = roelands\neta0 = 0.25\nalpha = 22e-9\n");
  BOOST_REQUIRE(support::ehl(folder, "run named.ini --overwrite").status == 0);
  BOOST_REQUIRE(support::ehl(folder, "run keys.ini --overwrite").status == 0);
  BOOST_TEST((pressures(folder, "named.h5") == pressures(folder, "keys.h5")), "the same bits");
}

BOOST_AUTO_TEST_CASE(a_table_of_barus_makes_the_film_of_barus) {
  const support::TemporaryFolder folder;
  folder.write("t.csv", barus_table(25));
  folder.write("table.ini", contact + "viscosity = table\ntable = t.csv\n");
  folder.write("barus.ini", contact + "viscosity = barus\neta0 = 0.0156\nalpha = 12e-9\n");
  const std::string table = support::ehl(folder, "run table.ini --json").out;
  const std::string barus = support::ehl(folder, "run barus.ini --json").out;
  for (const char* name : {"Hc", "Hm", "alpha_star", "alpha_film", "L", "alpha_bar"}) {
    const double gap = json_number(table, name) / json_number(barus, name) - 1.0;
    BOOST_TEST_MESSAGE(name << ": " << json_number(barus, name) << ", of the table " << gap << " off (tolerance 1e-9)");
    BOOST_TEST(std::abs(gap) < 1e-9);
  }
  BOOST_TEST(std::abs(json_number(barus, "alpha_film") / 12e-9 - 1.0) < 1e-12);
}

BOOST_AUTO_TEST_CASE(each_law_is_solved_in_as_many_cycles_as_roelands) {
  const support::TemporaryFolder folder;
  folder.write("t.csv", barus_table(60));
  const std::vector<std::string> oils{"viscosity = roelands\neta0 = 0.0156\nalpha = 19e-9\nz = 0.6\n",
                                      "fluid = squalane\n",
                                      yasutomi + "density = tait\nK0 = 1.5e9\nK0_prime = 10.545\n",
                                      "fluid = pao10\n",
                                      "viscosity = barus\neta0 = 0.0156\nalpha = 12e-9\ndensity = murnaghan\nK0 = "
                                      "1.2e9\nK0_prime = 11\n",
                                      "viscosity = table\ndensity = table\ntable = t.csv\n"};
  for (const char* load : {"60", "480"}) {  // 0.97 and 1.9 GPa
    double least_factor = 0.0;
    int fewest = 0;
    for (const std::string& oil : oils) {
      folder.write("d.ini", contact + oil);
      const std::string run = "run d.ini --json --overwrite --set grid.cells=128 --set contact.load=";
      const support::Ended ended = support::ehl(folder, run + load);
      BOOST_TEST(ended.status == 0, oil << ended.err);
      BOOST_TEST(ended.out.find("\"method\":\"full multigrid\"") != std::string::npos, oil << ended.out);
      const double factor = json_number(ended.out, "cycle_factor");
      const int cycles = cycles_of(ended.out);
      if (fewest == 0) {
        fewest = cycles;
        least_factor = factor;
      }
      BOOST_TEST_MESSAGE(load << " N, " << oil.substr(0, oil.find('\n')) << ": " << cycles
                              << " cycles on all levels, convergence factor " << factor << ", Hc "
                              << json_number(ended.out, "Hc"));
      BOOST_TEST(factor < 1.3 * least_factor);
      BOOST_TEST(cycles <= fewest + 2);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_deck_that_a_result_keeps_says_the_same_again) {
  const support::TemporaryFolder folder;
  folder.write("t.csv", barus_table(25));
  for (const std::string& oil : {std::string("fluid = squalane\n"), std::string("fluid = mineral-vg68\n"), yasutomi,
                                 std::string("viscosity = table\ndensity = table\ntable = t.csv\n")}) {
    folder.write("d.ini", contact + oil);
    BOOST_REQUIRE(support::ehl(folder, "run d.ini --overwrite").status == 0);
    folder.write("again.ini", ResultFile(folder / "d.h5").text("/deck"));
    const support::Ended again = support::ehl(folder, "run again.ini --overwrite");
    BOOST_TEST(again.status == 0, oil << again.err);
    BOOST_TEST((pressures(folder, "d.h5") == pressures(folder, "again.h5")), oil);
  }
}

BOOST_AUTO_TEST_CASE(decks_of_the_inputs_are_taken) {
  const support::TemporaryFolder folder;
  for (const char* name : {"data_sheet", "squalane", "yasutomi", "table"}) {
    const support::Ended ended =
        support::ehl(folder, std::string("check '") + EHL_INPUTS + "/fluids/" + name + ".ini'");
    BOOST_TEST(ended.status == 0, ended.err);
    BOOST_TEST(ended.out.find("alpha_film = ") != std::string::npos, ended.out);
  }
}

BOOST_AUTO_TEST_CASE(in_moes_groups_alpha_star_gives_the_pressure) {
  // p_h = alpha_bar/alpha*, with alpha_bar = (L/pi)(3M/2)^(1/3) = 13.42 at (50, 10), and alpha* =
  // 17.78 1/GPa for squalane.
  const support::TemporaryFolder folder;
  folder.write("d.ini", moes + "fluid = squalane\n");
  const support::Ended ended = support::ehl(folder, "run d.ini --json");
  BOOST_TEST(ended.status == 0, ended.err);
  const double p_h = json_number(ended.out, "alpha_bar") / json_number(ended.out, "alpha_star");
  BOOST_TEST_MESSAGE("p_h = " << p_h << " Pa");
  BOOST_TEST(std::abs(p_h / (13.42 / 17.78e-9) - 1.0) < 1e-3);
  const std::string said = support::ehl(folder, "check d.ini").out;
  BOOST_TEST(said.find("p_h = 755.1 MPa") != std::string::npos, said);
}

BOOST_AUTO_TEST_SUITE_END()
