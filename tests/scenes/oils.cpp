// Oils at a temperature: by name, by a data sheet, by alpha*. Valid decks are compared with known numbers,
// invalid ones are refused.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "results/read.hpp"
#include "support/json.hpp"
#include "support/refused.hpp"

using ehl::results::ResultFile;

namespace {

// A steel ball of 3/4 inch on a glass disc, 20 N.
const std::string ball =
    "[contact]\nload = 20\nradius_x = 9.525e-3\nE_prime = 124e9\n[motion]\nu_m = 0.5\n[grid]\ncells = "
    "64\n[lubricant]\n";
const std::string moes = "[contact]\nM = 50\nL = 10\n[grid]\ncells = 64\n[lubricant]\n";
const std::string data_sheet = "kv40 = 68\nkv100 = 8.530\ndensity15 = 881\n";

struct Said {
  double eta0, alpha_star, temperature, rho0, Hc;
};

Said run(const support::TemporaryFolder& folder, const std::string& deck) {
  folder.write("d.ini", deck);
  const support::Ended ended = support::ehl(folder, "run d.ini --json --overwrite");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, deck << ended.err);
  const nlohmann::json json = support::parsed(ended.out);
  const ResultFile file(folder / "d.h5");
  const bool si = file.kind("/scales/eta0") != ResultFile::Kind::missing;
  return {si ? file.numbers("/scales/eta0").values.at(0) : std::nan(""), support::number_at(json, "/alpha_star"),
          support::number_at(json, "/temperature"), support::number_at(json, "/rho0"), support::number_at(json, "/Hc")};
}

std::vector<double> pressures(const support::TemporaryFolder& folder) {
  return ResultFile(folder / "d.h5").numbers("/fields/P").values;
}

bool near(double value, double known, double tolerance) { return std::abs(value / known - 1.0) < tolerance; }

}  // namespace

BOOST_AUTO_TEST_SUITE(test_oils)

BOOST_AUTO_TEST_CASE(a_grade_has_the_viscosity_of_its_name) {
  const support::TemporaryFolder folder;
  // The default temperature is 40 C. The densities are 1.7 and 5.9 % below those at 15 C.
  const Said at_40 = run(folder, ball + "fluid = mineral-vg68\n");
  BOOST_TEST_MESSAGE("ISO VG 68 at 40 C: " << 1e3 * at_40.eta0 << " mPa s, " << at_40.rho0 << " kg/m^3");
  BOOST_TEST(at_40.temperature == 40);
  BOOST_TEST(near(at_40.rho0, 865, 2e-3));
  BOOST_TEST(near(at_40.eta0, 68e-6 * at_40.rho0, 1e-9));
  const Said at_100 = run(folder, ball + "fluid = mineral-vg68\ntemperature = 100\n");
  BOOST_TEST(near(at_100.rho0, 828, 2e-3));
  BOOST_TEST(near(at_100.eta0, 8.53e-6 * at_100.rho0, 1e-9));
  // In Roelands' law with constant z, alpha is proportional to ln(eta0) + 9.67; alpha* is
  // slightly smaller for thin oils.
  const double ratio = (std::log(at_100.eta0) + 9.67) / (std::log(at_40.eta0) + 9.67);
  BOOST_TEST(near(at_100.alpha_star / at_40.alpha_star, ratio, 0.06));
}

BOOST_AUTO_TEST_CASE(alpha_star_comes_out_as_it_was_stated) {
  const support::TemporaryFolder folder;
  for (const auto& [oil, alpha_star] : {std::pair<std::string, double>{"fluid = pao4\n", 11.05e-9},
                                        {"fluid = mineral-vg32\n", 16.93e-9},
                                        {"eta0 = 0.08\nalpha_star = 20e-9\n", 20e-9},
                                        {"viscosity = barus\neta0 = 0.08\nalpha_star = 20e-9\n", 20e-9},
                                        {data_sheet + "temperature = 80\nalpha_star = 15e-9\n", 15e-9}}) {
    const Said said = run(folder, ball + oil);
    BOOST_TEST_MESSAGE(oil << "alpha* " << said.alpha_star / alpha_star - 1.0 << " off (tolerance 1e-9)");
    BOOST_TEST(near(said.alpha_star, alpha_star, 1e-9), oil);
  }
  // Without a given viscosity, z is free and the slope is found.
  for (const char* z : {"", "z = 0.5\n"})
    BOOST_TEST(near(run(folder, moes + "alpha_star = 20e-9\n" + z).alpha_star, 20e-9, 1e-9));
  // With M and L, p_h = alpha_bar/alpha*, as for every law that has its own alpha*.
  const std::string check = support::ehl(folder, "check d.ini").out;
  BOOST_TEST(check.find("p_h = 671.2 MPa") != std::string::npos, check);
}

BOOST_AUTO_TEST_CASE(a_data_sheet_says_what_the_name_says) {
  const support::TemporaryFolder folder;
  run(folder, ball + "fluid = mineral-vg68\ntemperature = 80\n");
  const std::vector<double> by_name = pressures(folder);
  run(folder, ball + data_sheet + "temperature = 80\nalpha_star = 18.99e-9\nalpha_temperature = 40\n");
  BOOST_TEST((by_name == pressures(folder)), "the same bits");
}

BOOST_AUTO_TEST_CASE(the_deck_that_a_result_keeps_says_the_same_again) {
  const support::TemporaryFolder folder;
  for (const std::string& deck :
       {ball + "fluid = pao4\ntemperature = 80\n", ball + data_sheet + "temperature = 25\nalpha_star = 2e-8\n",
        ball + data_sheet + "temperature = 25\nalpha_star = 2e-8\nalpha_temperature = 100\n",
        ball + data_sheet + "temperature = 60\nalpha = 2e-8\n", ball + "eta0 = 0.1\nalpha_star = 2e-8\n",
        moes + "alpha_star = 2e-8\n", moes + "fluid = mineral-vg460\ntemperature = 120\n"}) {
    run(folder, deck);
    const std::vector<double> first = pressures(folder);
    run(folder, ResultFile(folder / "d.h5").text("/deck"));
    BOOST_TEST((first == pressures(folder)), deck);
  }
}

// Values that follow from other keys are only remarks in the deck of a result. With another temperature, the oil is
// that of the first deck, and a circle with another radius remains a circle.
BOOST_AUTO_TEST_CASE(the_deck_that_a_result_keeps_may_be_changed) {
  const support::TemporaryFolder folder;
  const auto contact_and_oil = [&] {
    const support::Ended ended =
        support::ehl(folder, "check d.ini --set lubricant.temperature=80 --set contact.radius_x=0.01");
    BOOST_TEST(ended.status == 0, ended.err);
    return ended.out.substr(0, ended.out.find("\nregime"));
  };
  const std::string sheet = data_sheet + "alpha_star = 2e-8\nalpha_temperature = 40\n";
  for (const std::string& oil : {std::string("fluid = pao4\n"), sheet}) {
    run(folder, ball + oil + "temperature = 40\n");
    const std::string first = contact_and_oil();
    folder.write("d.ini", ResultFile(folder / "d.h5").text("/deck"));
    BOOST_TEST(contact_and_oil() == first);
  }
}

BOOST_AUTO_TEST_CASE(a_sweep_over_temperature_thins_the_film) {
  const support::TemporaryFolder folder;
  double last = 1e9;
  for (const char* T : {"20", "40", "80", "100"}) {  // at 120 C 64 cells would be too coarse for the film
    const Said said = run(folder, ball + "fluid = pao8\ntemperature = " + T + "\n");
    BOOST_TEST(said.Hc < last);
    last = said.Hc;
  }
  folder.write("d.ini", ball + "fluid = pao8\n");
  const support::Ended swept = support::ehl(folder, "sweep d.ini --vary lubricant.temperature=40:80:2 --output t.csv");
  BOOST_TEST(swept.status == 0, swept.err);
}

BOOST_AUTO_TEST_CASE(a_bulk_modulus_falls_with_temperature) {
  const support::TemporaryFolder folder;
  // Squalane (Bair 2006): K00 = 8.658 GPa, beta_K = 6.332e-3 1/K; at 298 K 1.312 GPa (Liu et al. 2023).
  const std::string oil = ball + "eta0 = 0.0276\nalpha = 1.9e-8\ndensity = tait\nK0_prime = 11.74\n";
  run(folder, oil + "K00 = 8.658e9\nbeta_K = 6.332e-3\ntemperature = 25\n");
  const std::string kept = ResultFile(folder / "d.h5").text("/deck");
  const double K0 = std::stod(kept.substr(kept.find("\n# K0 = ") + 8));
  BOOST_TEST_MESSAGE("K0 of squalane at 25 C: " << K0 << " Pa, known 1.312e9");
  BOOST_TEST(near(K0, 1.312e9 * std::exp(-0.15 * 6.332e-3), 1e-4));
  const std::vector<double> first = pressures(folder);
  run(folder, kept);
  BOOST_TEST((first == pressures(folder)));
  support::check_refused(
      {{"no beta_K", oil + "K00 = 8.658e9\ntemperature = 25\n", {"[lubricant] beta_K"}},
       {"no temperature", oil + "K00 = 8.658e9\nbeta_K = 6e-3\n", {"[lubricant] temperature"}},
       {"another K0", oil + "K0 = 1e9\nK00 = 8.658e9\nbeta_K = 6.332e-3\ntemperature = 25\n", {"d.ini:14"}},
       {"softer than a gas", oil + "K00 = 8.658e9\nbeta_K = 0.1\ntemperature = 25\n", {"d.ini:16"}},
       {"without a law",
        ball + "eta0 = 0.1\nalpha = 1e-8\nK00 = 8.658e9\nbeta_K = 6e-3\ntemperature = 25\n",
        {"d.ini:12", "density = tait"}}});
}

BOOST_AUTO_TEST_CASE(slips) {
  const std::string sheet = ball + data_sheet;
  support::check_refused(
      {{"the grade alone", ball + "fluid = VG 68\n", {"d.ini:10"}},
       {"another temperature than the only one",
        ball + "fluid = squalane\ntemperature = 60\n",
        {"d.ini:11", "temperature = 60"}},
       {"an unknown temperature", ball + "fluid = mourier\ntemperature = 60\n", {"d.ini:11"}},
       {"kelvin", ball + "fluid = pao4\ntemperature = 313\n", {"d.ini:11"}},
       {"another viscosity", ball + "fluid = pao4\neta0 = 0.1\n", {"d.ini:11"}},
       {"the slope of a named oil", ball + "fluid = pao4\nalpha = 1e-8\n", {"d.ini:11"}},
       {"a temperature for eta0", ball + "eta0 = 0.1\nalpha = 1e-8\ntemperature = 40\n", {"d.ini:12"}},
       {"a temperature for a table",
        ball + "viscosity = table\ntable = t.csv\ntemperature = 40\n",
        {"d.ini:12", "temperature = 40"}},
       {"half a data sheet",
        ball + "kv40 = 68\nalpha = 1e-8\ntemperature = 40\n",
        {"[lubricant] kv100", "[lubricant] density15"}},
       {"no temperature", sheet + "alpha = 1e-8\n", {"[lubricant] temperature"}},
       {"no alpha", sheet + "temperature = 40\n", {"[lubricant] alpha"}},
       {"the wrong way round",
        ball + "kv40 = 8.5\nkv100 = 68\ndensity15 = 881\ntemperature = 40\nalpha = 1e-8\n",
        {"d.ini:11", "kv100 = 68"}},
       {"thicker than tar",
        ball + "kv40 = 1e5\nkv100 = 1\ndensity15 = 881\ntemperature = -40\nalpha = 1e-8\n",
        {"d.ini:13"}},
       {"in m^2/s", ball + "kv40 = 68e-6\n", {"d.ini:10"}},
       {"in g/cm^3", ball + "density15 = 0.88\n", {"d.ini:10"}},
       {"a data sheet of yasutomi", sheet + "viscosity = yasutomi\n", {"d.ini:10"}},
       {"both alphas", ball + "eta0 = 0.1\nalpha = 1e-8\nalpha_star = 1e-8\n", {"d.ini:12"}},
       {"alpha* of isoviscous oil", ball + "viscosity = isoviscous\neta0 = 0.1\nalpha_star = 1e-8\n", {"d.ini:12"}},
       {"alpha* of a law that has one",
        ball + "viscosity = doolittle\neta0 = 0.1\ndoolittle_B = 4\ndoolittle_R0 = 0.6\nK0 = 1e9\nK0_prime = 11\n"
               "alpha_star = 1e-8\n",
        {"d.ini:16"}},
       {"another z", ball + "eta0 = 0.1\nalpha_star = 1.5e-8\nz = 0.6\n", {"d.ini:12", "z = 0.6"}},
       {"no z gives it", ball + "eta0 = 0.1\nalpha_star = 1e-7\n", {"d.ini:11"}},
       {"alpha_temperature alone", sheet + "temperature = 40\nalpha = 1e-8\nalpha_temperature = 40\n", {"d.ini:15"}},
       {"alpha_temperature without a data sheet",
        ball + "eta0 = 0.1\nalpha_star = 1e-8\nalpha_temperature = 40\n",
        {"d.ini:12"}}});
}

BOOST_AUTO_TEST_SUITE_END()
