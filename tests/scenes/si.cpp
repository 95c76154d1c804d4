// SI in, SI out: what a deck in SI shows, compared with the Hertz formulas in this file.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "support/json.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

namespace {

using support::contains;

constexpr double load = 20.0, radius = 0.010, E_prime = 1.2e11, u_m = 0.5;
const double a = std::cbrt(3.0 * load * radius / (2.0 * E_prime));  // Hertz radius [m]
const double p_h = 3.0 * load / (2.0 * std::numbers::pi * a * a);   // [Pa]
const double h_scale = a * a / radius;

const std::string steel =
    "[case]\ntitle = steel\n[contact]\nload = 20\nradius_x = 0.010\nE_prime = 1.2e11\n[motion]\nu_m = 0.5\n"
    "[lubricant]\neta0 = 0.08\nalpha = 2e-8\n[domain]\nx_inlet = -4\ny_half = 3\n[grid]\ncells = 64\n";
const std::string plain = "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\n[grid]\ncells = 64\n";

struct Scene {
  support::TemporaryFolder folder;
  Scene() {
    folder.write("s.ini", steel);
    folder.write("d.ini", plain);
  }
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }
};

// The rows of numbers below the heading.
std::vector<std::vector<double>> rows_of(const std::string& text) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    std::istringstream numbers(line);
    rows.emplace_back();
    for (std::string word; numbers >> word;) rows.back().push_back(std::stod(word));
  }
  return rows;
}

// Each number of one table equals that of the other times the factor of its column, to the rounding of a product.
void check_scaled(const std::string& si, const std::string& own, const std::vector<double>& factors) {
  const auto scaled = rows_of(si), unscaled = rows_of(own);
  BOOST_REQUIRE(!unscaled.empty());
  BOOST_REQUIRE(scaled.size() == unscaled.size());
  double worst = 0.0;
  for (std::size_t row = 0; row < unscaled.size(); ++row)
    for (std::size_t k = 0; k < factors.size(); ++k) {
      const double wanted = factors[k] * unscaled[row].at(k);
      worst = std::max(worst, std::abs(scaled[row].at(k) - wanted) / std::max(std::abs(wanted), 1e-300));
    }
  BOOST_TEST(worst < 1e-12, "off by " << worst);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_si)

BOOST_AUTO_TEST_CASE(extract_in_SI) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run s.ini --set transient.end_time=0.02 --set transient.output_interval=0.01").status == 0);
  const auto both = [&](const std::string& what, const std::vector<double>& factors) {
    const support::Ended si = scene.ehl("extract s.h5 " + what + " --si");
    BOOST_TEST(si.status == 0, si.err);
    check_scaled(si.out, scene.ehl("extract s.h5 " + what).out, factors);
    return si.out;
  };
  const double um = 1e6 * a, nm = 1e9 * h_scale, GPa = 1e-9 * p_h, ms = 1e3 * a / u_m;
  BOOST_TEST(contains(both("H", {um, um, nm}), "/fields/H [nm]"));
  BOOST_TEST(contains(both("P --along x", {um, GPa}), "[GPa]"));
  BOOST_TEST(contains(both("/transient/frames/H --along y", {ms, um, nm}), "# units: ms um nm"));
  BOOST_TEST(contains(both("levels", {1, 1, 1, nm, nm, 0, 0, nm, GPa}), "nm"));
  BOOST_TEST(contains(both("transient", {ms, nm, nm, um, um, GPa, nm, 1, 1}), "# units: ms nm nm um um GPa nm"));
  BOOST_TEST(contains(both("Hc", {nm}), "[nm]"));
  // --at is in um too; the grid line nearest to 50 um is taken.
  const double hx = rows_of(scene.ehl("extract s.h5 /grid/x --si").out)[1][0] + 4.0 * um;
  const std::string column = scene.ehl("extract s.h5 H --along y --at x=50 --si").out;
  const double at = std::stod(column.substr(column.find("at x = ") + 7));
  BOOST_TEST(std::abs(at - 50.0) <= 0.5 * hx, at << " um");
  BOOST_TEST(scene.ehl("extract s.h5 H --at y=500 --si").status == 2);  // the domain ends at 3 a = 407 um
}

BOOST_AUTO_TEST_CASE(extract_in_SI_needs_SI) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run d.ini").status == 0);
  const support::Ended refused = scene.ehl("extract d.h5 H --si");
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(refused.says({"--si", "d.h5"}), refused.err);
}

// The formula of Hamrock and Dowson for a circle, h/R.
double hamrock_dowson(double u, bool central) {
  const double U = 0.08 * u / (E_prime * radius), G = 2e-8 * E_prime, W = load / (E_prime * radius * radius);
  return central ? 2.69 * std::pow(U, 0.67) * std::pow(G, 0.53) * std::pow(W, -0.067) * (1.0 - 0.61 * std::exp(-0.73))
                 : 3.63 * std::pow(U, 0.68) * std::pow(G, 0.49) * std::pow(W, -0.073) * (1.0 - std::exp(-0.68));
}

BOOST_AUTO_TEST_CASE(sweep_in_SI) {
  const Scene scene;
  const support::Ended ended = scene.ehl(
      "sweep s.ini --set grid.cells=128 --set contact.Sq1=30e-9 --set contact.Sq2=40e-9 --vary motion.u_m=0.2,0.5 "
      "--output t.csv");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  const auto rows = support::named_rows(scene.folder.read("t.csv"));
  BOOST_REQUIRE(rows.size() == 2u);
  constexpr double rounding = 1e-10;  // in per cent, of a few products
  for (const support::NamedRow& row : rows) {
    const auto in = [&](const char* name) { return std::stod(row.at(name)); };
    const double u = in("motion.u_m");
    BOOST_TEST(in("a_um") == 1e6 * a, boost::test_tools::tolerance(rounding));
    BOOST_TEST(in("p_h_GPa") == 1e-9 * p_h, boost::test_tools::tolerance(rounding));
    BOOST_TEST(in("E_prime_GPa") == 120.0, boost::test_tools::tolerance(rounding));
    BOOST_TEST(in("eta0_mPa_s") == 80.0, boost::test_tools::tolerance(rounding));
    BOOST_TEST(in("u_m") == u, boost::test_tools::tolerance(rounding));
    BOOST_TEST(in("h_c_nm") == 1e9 * h_scale * in("Hc"), boost::test_tools::tolerance(rounding));
    BOOST_TEST(in("h_m_nm") == 1e9 * h_scale * in("Hm"), boost::test_tools::tolerance(rounding));
    BOOST_TEST(in("p_max_GPa") == 1e-9 * p_h * in("P_max"), boost::test_tools::tolerance(rounding));
    BOOST_TEST(in("hd_h_c_nm") == 1e9 * radius * hamrock_dowson(u, true), boost::test_tools::tolerance(rounding));
    BOOST_TEST(in("hd_h_m_nm") == 1e9 * radius * hamrock_dowson(u, false), boost::test_tools::tolerance(rounding));
    BOOST_TEST(in("hd_h_c_deviation") == in("hd_h_c_nm") / in("h_c_nm") - 1.0, boost::test_tools::tolerance(1e-8));
    BOOST_TEST(in("lambda_ratio") == in("h_m_nm") / 50.0, boost::test_tools::tolerance(rounding));  // Sq 30 and 40
    // One error bar, for mesh and cycles, in both units.
    BOOST_TEST(in("h_c_error_nm") == in("error_Hc") * in("h_c_nm"), boost::test_tools::tolerance(rounding));
  }
}

BOOST_AUTO_TEST_CASE(a_sweep_without_units_has_none) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("sweep d.ini --vary contact.L=5,10 --output t.csv").status == 0);
  BOOST_TEST(contains(scene.folder.read("t.csv"),
                      "\ncontact.L,status,exit_status,method,attempts,M,L,p_h,nx,ny,Hc,Hm,P_max,error_Hc,error_Hm,"
                      "Hc_best,error_Hc_best,Hm_best,error_Hm_best,"
                      "residual,load_error,cycle_factor,cycles,work_units,path,warnings,reason\n"));
}

// The number after a word in a text.
double after(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, word << " is missing in\n" << text);
  return std::stod(text.substr(at + word.size()));
}

BOOST_AUTO_TEST_CASE(report_in_SI) {
  const Scene scene;
  const support::Ended ended = scene.ehl("run s.ini --quiet");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  const auto json = support::parsed(scene.ehl("run s.ini --quiet --json --overwrite").out);
  const auto film = [&](const char* name) { return 1e9 * h_scale * support::number_at(json, name); };
  constexpr double digits = 0.005;  // half a unit of the last printed digit
  BOOST_TEST(std::abs(after(ended.out, "h_c = ") - film("/Hc")) <= digits);
  BOOST_TEST(std::abs(after(ended.out, "h_m = ") - film("/Hm")) <= digits);
  BOOST_TEST(std::abs(after(ended.out, "\np_max        ") - 1e-9 * p_h * support::number_at(json, "/P_max")) <= 5e-5);
  BOOST_TEST(std::abs(after(ended.out, "um; P = ") - support::number_at(json, "/P_max")) <= 5e-6);
  BOOST_TEST(std::abs(after(ended.out, "65 x 69 ") - film("/Hc")) <= digits);
  BOOST_TEST(contains(ended.out, "h_c [nm]  h_m [nm] "));
  BOOST_TEST(std::abs(after(ended.out, "p_h = ") - 1e-9 * p_h) <= 5e-5);
  BOOST_TEST(std::abs(after(ended.out, "Hertz        a = ") - 1e6 * a) <= 0.05);
  const double formula = 1e9 * radius * hamrock_dowson(u_m, true);
  std::istringstream line(ended.out.substr(ended.out.find("Hamrock, Dowson 1977") + 20));
  double printed = 0.0, deviation = 0.0;
  line >> printed >> deviation;
  BOOST_TEST(std::abs(printed - formula) <= 0.05);
  BOOST_TEST(std::abs(deviation - 100.0 * (formula / film("/Hc") - 1.0)) <= 0.05);
  BOOST_TEST(support::number_at(json, "/R_m") == radius);
  BOOST_TEST(support::number_at(json, "/formulas/1/hc_m") == 1e-9 * formula, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(std::abs(100.0 * support::number_at(json, "/formulas/1/deviation_hc") - deviation) <= 0.05);
  BOOST_TEST(contains(scene.ehl("check s.ini").out, "a = 135.7 um, p_h = 0.5184 GPa"));
}

BOOST_AUTO_TEST_CASE(times_in_the_unit_of_the_deck) {
  const Scene scene;
  const double ms = 1e3 * a / u_m;
  const support::Ended own = scene.ehl("run s.ini --quiet --set transient.end_time=0.02");
  BOOST_REQUIRE_MESSAGE(own.status == 0, own.err);
  BOOST_TEST(after(own.out, "time 0 to ") == 0.02);
  BOOST_TEST(std::abs(after(own.out, "0.02 a/u_m (") - 0.02 * ms) <= 5e-7);
  const support::Ended seconds =
      scene.ehl("run s.ini --overwrite --set transient.time_unit=seconds --set transient.end_time=5e-6");
  BOOST_REQUIRE_MESSAGE(seconds.status == 0, seconds.err);
  BOOST_TEST(contains(seconds.out, "time 0 to 0.005 ms ("), seconds.out);
  BOOST_TEST(std::abs(after(seconds.out, "0.005 ms (") - 0.005 / ms) <= 5e-7);
  const auto json = support::parsed(
      scene.ehl("run s.ini --overwrite --quiet --json --set transient.end_time=0.02 --set transient.load=0.02:1.1")
          .out);
  BOOST_TEST(support::number_at(json, "/transient/end_time_s") == 0.02 * 1e-3 * ms,
             boost::test_tools::tolerance(1e-10));
  BOOST_TEST(support::number_at(json, "/transient/Hc_m") == h_scale * support::number_at(json, "/transient/Hc"),
             boost::test_tools::tolerance(1e-10));
  BOOST_TEST(support::number_at(json, "/transient/largest_P_max_Pa") ==
                 p_h * support::number_at(json, "/transient/largest_P_max"),
             boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(studies_in_SI) {
  const Scene scene;
  const support::Ended steady = scene.ehl(
      "study s.ini --levels 64:128 --wedges upstream2 --evaluators mlmi8 --cycles run --repeat 1 --quiet --output "
      "a.csv");
  BOOST_REQUIRE_MESSAGE(steady.status == 0, steady.err);
  const auto rows = support::named_rows(scene.folder.read("a.csv"));
  BOOST_REQUIRE(rows.size() == 2u);
  for (const support::NamedRow& row : rows)
    for (const auto& [si, own] : {std::pair("h_c_nm", "Hc"), {"h_m_nm", "Hm"}})
      BOOST_TEST(std::stod(row.at(si)) == 1e9 * h_scale * std::stod(row.at(own)), boost::test_tools::tolerance(1e-10));
  BOOST_TEST(contains(steady.out, "h_c [nm]  h_m [nm] "), steady.out);
  const support::Ended timed =
      scene.ehl("study s.ini --set transient.end_time=0.02 --rtol 1e-2 --repeat 1 --quiet --output b.csv");
  BOOST_REQUIRE_MESSAGE(timed.status == 0, timed.err);
  const auto row = support::named_rows(scene.folder.read("b.csv")).at(0);
  BOOST_TEST(std::stod(row.at("time_ms")) == 0.02 * 1e3 * a / u_m, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(std::stod(row.at("time")) == 0.02, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(roughness) {
  const Scene scene;
  const std::string rough = " --set contact.Sq1=30e-9 --set contact.Sq2=40e-9";
  const support::Ended ended = scene.ehl("run s.ini --json --quiet" + rough);
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  const auto json = support::parsed(ended.out);
  const double ratio = support::number_at(json, "/hm_m") / 50e-9;
  BOOST_TEST(support::number_at(json, "/lambda_ratio") == ratio, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(support::number_at(json, "/Sq_m") == 50e-9, boost::test_tools::tolerance(1e-10));
  BOOST_TEST_REQUIRE((ratio > 2.0 && ratio < 3.0));
  BOOST_TEST(contains(json["warning_names"].dump(), "\"lambda\""), json["warnings"].dump());
  const support::Ended smoother = scene.ehl("run s.ini --overwrite --quiet --set contact.Sq1=30e-9");
  BOOST_TEST(contains(smoother.out, "S_q = 30.0 nm"), smoother.out);
  BOOST_TEST(!contains(smoother.out, "[lambda]"), smoother.out);
  BOOST_TEST(!contains(scene.ehl("run s.ini --overwrite --quiet").out, "S_q"));
  const support::Ended dimensionless = scene.ehl("check d.ini --set contact.Sq1=30e-9");
  BOOST_TEST(dimensionless.status == 2);
  BOOST_TEST(dimensionless.says({"Sq1", "SI"}), dimensionless.err);
}

BOOST_AUTO_TEST_CASE(roughness_of_a_map) {
  const Scene scene;
  std::string map;
  for (int l = 0; l < 40; ++l)
    for (int k = 0; k < 40; ++k)
      map += std::string(k > 0 ? "," : "") + (k % 8 == 3 || k % 8 == 4 ? "30" : "-10") + (k == 39 ? "\n" : "");
  scene.folder.write("map.csv", map);
  const std::string still =
      "s.ini --set motion.srr=2 --set surface2.shape=map --set surface2.file=map.csv --set "
      "surface2.unit_m=1e-9 --set surface2.dx_m=6e-6";
  const support::Ended ended = scene.ehl("check " + still);
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  // Two of eight rows are 30 nm high, the others 10 nm deep: Sq = sqrt((900 + 3 x 100)/4) = 17.3 nm, Sa = 15 nm.
  BOOST_TEST(contains(ended.out, "Sq 17.3 nm ("), ended.out);
  BOOST_TEST(contains(ended.out, ", Sa 15.0 nm ("), ended.out);
  const support::Ended twice = scene.ehl("check " + still + " --set contact.Sq2=1e-8");
  BOOST_TEST(twice.status == 2);
  BOOST_TEST(twice.says({"Sq2", "surface2"}), twice.err);
  BOOST_TEST(scene.ehl("check " + still + " --set contact.Sq1=1e-8").status == 0);
}

BOOST_AUTO_TEST_SUITE_END()
