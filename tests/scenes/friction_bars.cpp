// Error bars of friction, against four times the cells, and the places where they are reported.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "support/columns.hpp"
#include "support/heated.hpp"
#include "support/text.hpp"

using support::contains;
using support::number_at;

namespace {

const std::string newtonian, eyring = "[shear]\nlaw = eyring\ntau_0 = 5e6\n",
                             carreau = "[shear]\nlaw = carreau\nG = 5e6\nn = 0.5\n";
constexpr const char* none = "";
constexpr const char* limited = "limit = 0.06\n";

struct Contact {
  std::string shape;
  double M, L;
  std::string law, limit;
  int cells;
};

std::string deck_of(const Contact& contact, double srr = 0.1) {
  return "[contact]\n" + contact.shape + "M = " + std::to_string(contact.M) + "\nL = " + std::to_string(contact.L) +
         "\na_over_R = 0.01\n[motion]\nsrr = " + std::to_string(srr) + "\n[lubricant]\nalpha = 2e-8\n" + contact.law +
         "[friction]\ncavitated = striated\n" + contact.limit;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_friction_bars)

// One of the 24 bars may be too small. A bar that is wide enough always holds, therefore half of the bars must be no
// wider than twenty times the error.
BOOST_AUTO_TEST_CASE(bars_hold_against_four_times_the_cells) {
  const std::string line = "kind = line\n", across = "radius_ratio = 0.3\n";
  const std::vector<Contact> contacts{{"", 10, 5, newtonian, none, 128},       {"", 50, 10, eyring, none, 128},
                                      {"", 200, 8, carreau, limited, 128},     {across, 20, 8, eyring, none, 128},
                                      {across, 100, 5, carreau, none, 128},    {line, 5, 5, newtonian, none, 256},
                                      {line, 20, 10, newtonian, limited, 256}, {line, 20, 10, eyring, none, 256},
                                      {line, 50, 15, eyring, limited, 512},    {line, 100, 8, carreau, none, 512},
                                      {line, 200, 4, newtonian, none, 512},    {line, 30, 3, carreau, limited, 256}};
  std::vector<double> ratios;
  for (const Contact& contact : contacts) {
    const support::HeatedScene scene(deck_of(contact));
    const auto on = [&](int cells) { return scene.run("--threads 1 --set grid.cells=" + std::to_string(cells)); };
    const nlohmann::json now = on(contact.cells), fine = on(4 * contact.cells);
    for (const std::string value : {"mu", "mu_rolling"}) {
      const double bar = number_at(now, "/friction/error_" + value);
      const double error = std::abs(number_at(now, "/friction/" + value) / number_at(fine, "/friction/" + value) - 1.0);
      BOOST_TEST_MESSAGE(contact.shape << "(" << contact.M << ", " << contact.L << ") on " << contact.cells
                                       << " cells: " << value << " " << error << " off, bar " << bar);
      BOOST_TEST(std::isfinite(bar));
      ratios.push_back(bar / error);
    }
  }
  std::ranges::sort(ratios);
  BOOST_TEST_MESSAGE("bar over error: " << ratios.front() << " at least, " << ratios[ratios.size() / 2]
                                        << " in the median (at most 20)");
  BOOST_TEST(ratios[1] >= 1.0);
  BOOST_TEST(ratios[ratios.size() / 2] <= 20.0);
}

// In JSON, text and tables. A friction coefficient that is zero on every grid has the error 0.
BOOST_AUTO_TEST_CASE(bars_are_reported) {
  const Contact contact{"kind = line\n", 20, 5, eyring, none, 256};
  const support::HeatedScene scene(deck_of(contact));
  const nlohmann::json found = scene.run("--set grid.cells=256");
  const double bar = number_at(found, "/friction/error_mu_rolling");
  BOOST_TEST(bar > 0.0);
  BOOST_TEST(contains(scene.ehl("run d.ini --set grid.cells=256 --quiet --overwrite").out, " +- "));
  BOOST_REQUIRE(scene.ehl("sweep d.ini --vary motion.srr=0,0.1 --set grid.cells=256 --overwrite").status == 0);
  const auto rows = support::named_rows(scene.folder.read("d_sweep.csv"));
  BOOST_TEST(std::stod(rows[0].at("mu")) == 0.0);
  BOOST_TEST(std::stod(rows[0].at("error_mu")) == 0.0);
  BOOST_TEST(std::abs(std::stod(rows[1].at("error_mu_rolling")) / bar - 1.0) < 1e-4);
}

// [thermal] and [friction] report the same friction with the same error bar.
BOOST_AUTO_TEST_CASE(heat_and_friction_report_the_same_bar) {
  const std::string ball =
      "[contact]\nload = 30\nradius_x = 9.525e-3\nE_prime = 226e9\n[motion]\nu_m = 2\nsrr = 0.1\n[lubricant]\neta0 = "
      "0.04\nalpha = 2e-8\n[thermal]\nT_oil = 40\nbeta = 0.04\nsolid1 = steel\nsolid2 = steel\n";
  const support::HeatedScene scene(ball + eyring + "[friction]\ncavitated = none\n");
  const nlohmann::json found = scene.run("--set grid.cells=128");
  BOOST_TEST(number_at(found, "/thermal/error_mu") > 0.0);
  BOOST_TEST(number_at(found, "/thermal/error_mu") == number_at(found, "/friction/error_mu"));
}

BOOST_AUTO_TEST_SUITE_END()
