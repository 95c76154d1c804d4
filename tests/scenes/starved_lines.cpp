// [supply] on line contacts in use, steady and in time.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"

using namespace support;

namespace {

// a = 150 um, a^2/R = 2.25 um.
const char* const teeth = R"([contact]
kind = line
load_per_length = 2e5
radius_x = 0.010
E_prime = 226.4e9
[motion]
u1 = 5.5
u2 = 4.5
[lubricant]
eta0 = 0.0165
alpha = 1.8e-8
[grid]
cells = 256
)";

nlohmann::json solved(const TemporaryFolder& folder, const std::string& more) {
  folder.write("case.ini", std::string(teeth) + more);
  const Ended run = ehl(folder, "run case.ini --json --quiet --overwrite");
  BOOST_TEST_REQUIRE(run.status == 0, run.err);
  return nlohmann::json::parse(run.out);
}

void refused(const TemporaryFolder& folder, const std::string& more, const char* key) {
  folder.write("case.ini", std::string(teeth) + more);
  const Ended run = ehl(folder, "check case.ini");
  BOOST_TEST(run.status == 2, more);
  BOOST_TEST(run.says({"[supply]", key}), more << ": " << run.err);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_starved_lines)

// A layer of 200 nm at 5 m/s is a flow of 1e-6 m^2/s; only u1 h1 + u2 h2 counts.
BOOST_AUTO_TEST_CASE(one_supply_in_all_its_units) {
  const TemporaryFolder folder;
  const nlohmann::json one = solved(folder, "[supply]\nlayer_m = 200e-9\n");
  for (const char* supply : {"layer1_m = 100e-9\nlayer2_m = 100e-9\n", "layer1_m = 0\nlayer2_m = 222.22222222222e-9\n",
                             "flow_m2_per_s = 1e-6\n"}) {
    const double other = solved(folder, "[supply]\n" + std::string(supply))["Hc"];
    BOOST_TEST(std::abs(other / one["Hc"].get<double>() - 1.0) <= 1e-9, supply);
  }
  const auto& found = one["starvation"];
  BOOST_TEST(one["converged"] == true);
  BOOST_TEST(std::abs(found["mass_imbalance"].get<double>()) <= 1e-10);
  BOOST_TEST(found["oil_aside"] == 0.0);
  BOOST_TEST((found["gamma"].is_null() && found["factor_by_meniscus"].is_null() && found["flooded_inlet"].is_null()));
  BOOST_TEST(std::abs(found["supply_ratio"].get<double>() / found["factor_by_supply"].get<double>() - 1.0) <= 1e-12);
  BOOST_TEST(std::abs(found["starvation_factor"].get<double>() / found["factor_by_supply"].get<double>() - 1.0) <=
             1e-4);
  // Three units of the same flow, 1e-6 m^2/s.
  const double scale = one["a_m"].get<double>() * one["a_m"].get<double>() / 0.010 * 5.0;
  BOOST_TEST(std::abs(found["oil_in"].get<double>() * scale / 1e-6 - 1.0) <= 1e-9);
  const Ended text = ehl(folder, "run case.ini --quiet --overwrite");
  BOOST_TEST(text.out.find("rho0 u_m a^2/R = 1 rho0 mm^2/s") != std::string::npos, text.out);
  BOOST_TEST(ehl(folder, "extract case.h5 theta --along x").status == 0);
}

BOOST_AUTO_TEST_CASE(more_than_goes_through_is_told) {
  const TemporaryFolder folder;
  const nlohmann::json full = solved(folder, "[supply]\nlayer_m = 2e-6\n");
  BOOST_TEST(std::abs(full["starvation_factor"].get<double>() - 1.0) <= 1e-4);
  BOOST_TEST(full["starvation"]["factor_by_supply"] == 1.0);
  BOOST_TEST(full["warning_names"].dump().find("\"supply-left\"") != std::string::npos);
  BOOST_TEST(full["error_parts"]["domain"].get<double>() > 5e-4);  // only the domain limits the inlet
  BOOST_TEST(solved(folder, "[supply]\nH_oil = 0.02\n")["error_parts"]["domain"] == 0.0);
}

// Oil is conserved while the load falls, and twice the layer gives twice the film.
BOOST_AUTO_TEST_CASE(in_time) {
  const TemporaryFolder folder;
  const std::string layer = "[supply]\nH_oil = 0.02\n[transient]\nend_time = 12\n";
  const nlohmann::json load = solved(folder, layer + "load = 0:1 1:0.5\n")["transient"];
  BOOST_TEST(load["completed"] == true);
  BOOST_TEST(std::abs(load["oil_lost"].get<double>()) <= 1e-9);
  const nlohmann::json more = solved(folder, layer + "supply = 0:1 1:2\n")["transient"];
  BOOST_TEST(std::abs(more["oil_lost"].get<double>()) <= 1e-9);
  const double grows = more["Hc"].get<double>() / solved(folder, "[supply]\nH_oil = 0.02\n")["Hc"].get<double>();
  BOOST_TEST_MESSAGE("the film grows by " << grows << " (2, of the same pressure at the centre to 0.5 %)");
  BOOST_TEST(std::abs(grows - 2.0) <= 0.01);
}

BOOST_AUTO_TEST_CASE(what_a_line_does_not_have) {
  const TemporaryFolder folder;
  refused(folder, "[supply]\nflow_m3_per_s = 1e-9\n", "flow_m2_per_s");
  refused(folder, "[supply]\nprofile = track.csv\n", "profile");
  refused(folder, "[supply]\nlayer_m = 1e-7\npasses = 3\n", "passes");
  refused(folder, "[supply]\nflow_m2_per_s = 0\n", "flow_m2_per_s");
  refused(folder, "[supply]\nlayer_m = -1e-7\n", "layer_m");
  refused(folder, "[supply]\nlayer_m = 1e-7\nflow_m2_per_s = 1e-6\n", "flow_m2_per_s");
  folder.write("point.ini", "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\n[supply]\nflow_m2_per_s = 1e-6\n");
  const Ended point = ehl(folder, "check point.ini");
  BOOST_TEST(point.status == 2);
  BOOST_TEST(point.says({"flow_m2_per_s"}), point.err);
}

BOOST_AUTO_TEST_SUITE_END()
