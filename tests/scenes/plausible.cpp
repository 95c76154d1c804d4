// Decks with possible but improbable values, and the predictions of `ehl check`.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "support/columns.hpp"
#include "support/refused.hpp"
#include "support/text.hpp"

namespace {

using support::contains;

// A ball of 20 mm on a flat disc.
std::string ball(const std::string& E_prime, const std::string& u_m, const std::string& eta0,
                 const std::string& more = "") {
  return "[contact]\nload = 20\nradius_x = 0.01\nE_prime = " + E_prime + "\n[lubricant]\neta0 = " + eta0 +
         "\nalpha = 20e-9\n[motion]\nu_m = " + u_m + "\n" + more;
}
const std::string moes = "[contact]\nM = 50\nL = 10\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n";

std::string heights() {
  std::string text;
  for (int j = 0; j < 16; ++j)
    for (int i = 0; i < 16; ++i) text += std::to_string((5 * i + 3 * j * j) % 7) + (i < 15 ? "," : "\n");
  return text;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_plausible)

BOOST_AUTO_TEST_CASE(units_that_were_mistaken_are_told) {
  const support::TemporaryFolder folder;
  const auto warnings = [&](const std::string& deck) {
    folder.write("d.ini", deck);
    const support::Ended ended = support::ehl(folder, "check d.ini");
    BOOST_TEST(ended.status == 0, ended.err);
    std::string lines;
    std::istringstream all(ended.out);
    for (std::string line; std::getline(all, line);)
      if (line.starts_with("warning: ")) lines += line + "\n";
    return lines;
  };
  BOOST_TEST(contains(warnings(ball("123e9", "0.01", "250")), "250 Pa s"));
  BOOST_TEST(contains(warnings(ball("123e9", "500", "0.001")), "500 m/s"));
  BOOST_TEST(contains(warnings(ball("123e9", "0.5", "0.08", "srr = 3\n")), "srr = 3"));
  BOOST_TEST(contains(warnings(ball("123e9", "100", "0.5")), "10 um"));
  BOOST_TEST(!warnings(ball("123e9", "1e-3", "0.005")).empty());
  BOOST_TEST(contains(
      warnings(
          "[case]\nkind = ball_race\n[bearing]\ndiameter = 9.525e-3\npitch_diameter = 46\nrace = inner\nconformity = "
          "0.52\nload = 500\nrpm_inner = 3000\n[contact]\nE1 = 208e9\nnu1 = 0.3\nE2 = 208e9\nnu2 = 0.3\n"
          "[lubricant]\nfluid = mineral-vg68\ntemperature = 70\n"),
      "[bearing]"));
  BOOST_TEST(warnings(ball("123e9", "0.5", "0.08")).empty());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_is_refused) {
  const support::TemporaryFolder folder;
  folder.write("map.csv", heights());
  const auto map = [](const char* unit, const char* dx) {
    return moes + "[surface1]\nshape = map\nfile = map.csv\nat_rest = yes\nunit = " + unit + "\ndx = " + dx + "\n";
  };
  support::check_refused(folder, {"moduli in MPa", ball("123e3", "0.5", "0.08"), {"d.ini:4", "E_prime = 123e3"}});
  support::check_refused(folder, {"a load that flattens the bodies",
                                  "[contact]\nkind = line\nload_per_length = 1e8\nradius_x = 0.01\nE_prime = 227e9\n"
                                  "[lubricant]\neta0 = 0.04\nalpha = 20e-9\n[motion]\nu_m = 5\n",
                                  {"d.ini:3", "load_per_length = 1e8"}});
  support::check_refused(folder, {"a map of a few cells", map("0.001", "1e-3"), {"d.ini:12", "dx = 1e-3"}});
  support::check_refused(folder, {"a map of kilometres", map("0.001", "1e3"), {"d.ini:12", "dx = 1e3"}});
  support::check_refused(folder, {"heights of another unit", map("1e3", "0.1"), {"d.ini:11", "unit = 1e3"}});
}

BOOST_AUTO_TEST_CASE(a_key_can_be_taken_out) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", moes + "[grid]\ncells = 64\n");
  const auto check = [&](const std::string& options) { return support::ehl(folder, "check d.ini " + options); };
  BOOST_TEST(check("--set grid.accuracy=0.01").says({"--unset grid.cells"}));
  BOOST_TEST(contains(check("--unset grid.cells").out, "257 x 321 nodes"));
  BOOST_TEST(check("--set grid.accuracy=0.01 --unset grid.cells").status == 0);
  BOOST_TEST(check("--unset grid.coarsest").says({"--unset grid.coarsest"}));
  BOOST_TEST(check("--unset grid.cels").says({"--unset grid.cels", "cells"}));
  BOOST_TEST(check("--unset cells").status == 2);
}

// The fields that a run in time keeps need memory and time in proportion to the number of nodes.
BOOST_AUTO_TEST_CASE(fields_of_a_run_in_time_are_foretold) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", moes + "[grid]\ncells = 128\n[transient]\nend_time = 1\nload = 0:1 1:1.1\n");
  const auto needs = [&](const std::string& interval) {
    const std::string told = support::ehl(folder, "check d.ini --set transient.output_interval=" + interval).out;
    const std::size_t at = told.find("about ", told.find("\nneeds ")), and_at = told.find(" and ", at);
    const double bytes = std::stod(told.substr(at + 6)) * (told.find(" GB", at) < and_at ? 1e9 : 1e6);
    return std::pair{bytes, std::stod(told.substr(and_at + 5))};
  };
  const auto [bytes, seconds] = needs("2e-4");
  const auto [few_bytes, few_seconds] = needs("0.5");
  constexpr double nodes_and_fields = 129.0 * 161.0 * 5e3;
  constexpr double two_digits = 0.05;  // as printed
  BOOST_TEST(bytes - few_bytes == 5 * 8 * nodes_and_fields, boost::test_tools::tolerance(two_digits));
  BOOST_TEST(seconds - few_seconds == 5.5e-7 * nodes_and_fields, boost::test_tools::tolerance(two_digits));
}

// The grid for an accuracy, predicted to within one level. Its solution is reported even if the
// run stops before that grid.
BOOST_AUTO_TEST_CASE(an_accuracy_is_foretold_and_may_be_interrupted) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", moes);
  folder.write("e.ini", ball("123e9", "0.5", "0.08") + "[grid]\naccuracy = 0.01\n");
  for (const char* set :
       {"d.ini --set grid.accuracy=0.02", "d.ini --set grid.accuracy=0.005",
        "d.ini --set grid.accuracy=0.001 --set domain.x_inlet=-4.5 --set domain.x_outlet=1.5 --set domain.y_half=3",
        "e.ini --set contact.radius_ratio=0.4"}) {
    const std::string told = support::ehl(folder, std::string("check ") + set).out;
    const std::string mark = "about ";
    const double predicted = std::stod(told.substr(told.find(mark, told.find("accuracy  ")) + mark.size()));
    BOOST_TEST(support::ehl(folder, std::string("run --quiet --overwrite --output d.h5 ") + set).status == 0);
    const double cells = support::rows_of(support::ehl(folder, "extract d.h5 /levels/nx").out).back()[0];
    BOOST_TEST_MESSAGE(set << ": " << predicted << " nodes predicted, " << cells << " cells taken");
    BOOST_TEST(std::abs(std::log2((predicted - 1.0) / cells)) <= 1.0, set);
  }
  const std::string line = std::string("'") + EHL_PROGRAM +
                           "' run d.ini --threads 1 --overwrite --set grid.accuracy=1e-4 2>said & p=$!; "
                           "while ! grep -q '1025 x' said; do sleep 0.05; done; kill -INT $p; wait $p";
  const support::Ended ended = support::shell(folder, line);
  BOOST_TEST(ended.status == 130, folder.read("said"));
  BOOST_TEST(contains(support::ehl(folder, "extract d.h5 converged").out, "\n0\n"));
}

BOOST_AUTO_TEST_SUITE_END()
