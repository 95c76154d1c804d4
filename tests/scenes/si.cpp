// SI in, SI out: what a deck in SI shows, against Hertz' formulas in this file.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <sstream>

#include "support/json.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

namespace {

using support::contains;

constexpr double load = 20.0, radius = 0.010, E_prime = 1.2e11, u_m = 0.5;
const double a = std::cbrt(3.0 * load * radius / (2.0 * E_prime));  // Hertz [m]
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

// The rows of numbers below a header.
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

// Each number of one table is `factors` times that of the other; to the rounding of a product.
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

BOOST_AUTO_TEST_SUITE(si)

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
  // --at is in um too; the line of the grid nearest to 50 um.
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
  BOOST_TEST(refused.says({"--si", "d.h5", "not given in SI"}), refused.err);
}

BOOST_AUTO_TEST_SUITE_END()
