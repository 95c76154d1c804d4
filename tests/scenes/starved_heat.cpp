// Starved contacts with heat, from end to end.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/heated.hpp"
#include "support/json.hpp"
#include "support/program.hpp"

BOOST_AUTO_TEST_SUITE(test_starved_heat)

using support::check_close;
using support::number_at;

namespace {

constexpr double radius = 9.525e-3;

struct Scene : support::HeatedScene {
  Scene()
      : HeatedScene(
            "[contact]\nload = 30\nradius_x = 9.525e-3\nE_prime = 226e9\n[motion]\nu_m = 2\nsrr = 0.5\n"
            "[lubricant]\neta0 = 0.04\nalpha = 20e-9\n"
            "[domain]\nfar_field = zero\nx_inlet = -4.5\nx_outlet = 1.5\ny_half = 3\n[grid]\ncells = 64\n"
            "[shear]\nlaw = eyring\ntau_0 = 5e6\n[friction]\ncavitated = none\n"
            "[thermal]\nT_oil = 40\nbeta = 0.042\nsolid1 = steel\nsolid2 = steel\n") {}
};

}  // namespace

// With more oil than the domain takes, the contact equals the flooded one with heat, except for the effect of a
// hot wake through the bodies.
BOOST_AUTO_TEST_CASE(a_thick_layer_is_a_full_inlet) {
  const Scene scene;
  const auto flooded = scene.run(""), thick = scene.run("--set supply.layer_m=1e-3");
  for (const char* name : {"/Hc", "/Hm", "/thermal/mu", "/thermal/T_film_max", "/thermal/T1_max", "/thermal/T2_max"})
    check_close(name, number_at(thick, name), number_at(flooded, name), 1e-4);
  check_close("factor", number_at(thick, "/starvation_factor"), 1.0, 2e-4);
}

BOOST_AUTO_TEST_CASE(little_oil) {
  const Scene scene;
  const auto flooded = scene.run("");
  double before = number_at(flooded, "/Hc");
  for (const std::string layer : {"200e-9", "100e-9", "20e-9"}) {
    const auto found = scene.run("--set supply.layer_m=" + layer);
    const double r = number_at(found, "/starvation/supply_ratio"), factor = number_at(found, "/starvation_factor");
    BOOST_TEST_MESSAGE("r = " << r << ": factor " << factor << ", Hc " << number_at(found, "/Hc") << ", mu "
                              << number_at(found, "/thermal/mu") << " (flooded " << number_at(flooded, "/thermal/mu")
                              << "), film " << number_at(found, "/thermal/T_film_max") << " K, oil "
                              << number_at(found, "/mass_imbalance") << ", heat "
                              << number_at(found, "/thermal/heat_imbalance"));
    BOOST_TEST(std::abs(number_at(found, "/mass_imbalance")) <= 1e-10);
    BOOST_TEST(std::abs(number_at(found, "/thermal/heat_imbalance")) < 1e-3);
    BOOST_TEST(number_at(found, "/Hc") < before);
    BOOST_TEST(factor < r);
    before = number_at(found, "/Hc");
    // A thin layer passes unchanged.
    if (r < 0.2) check_close("factor", factor, r, 5e-3);
  }
}

BOOST_AUTO_TEST_CASE(half_is_the_whole) {
  const Scene scene;
  // The profile is uneven by 1e-8, which prevents the use of symmetry.
  scene.folder.write("track.csv", "y,h\n-1e-3,100e-9\n1e-3,100.000001e-9\n");
  const auto half = scene.run("--set supply.layer_m=100e-9"), whole = scene.run("--set supply.profile=track.csv");
  for (const char* name : {"/Hc", "/thermal/mu", "/thermal/T_film_max", "/thermal/heat_1"})
    check_close(name, number_at(whole, name), number_at(half, name), 1e-6);
}

// Four solutions follow one another: isothermal and hot, starved and flooded. The progress covers all of them.
BOOST_AUTO_TEST_CASE(progress_never_goes_back) {
  const Scene scene;
  const support::Ended ended =
      support::ehl(scene.folder, "run d.ini --overwrite --set grid.cells=128 --set supply.layer_m=100e-9");
  std::vector<int> told;
  for (std::size_t at = ended.err.find(" %"); at != std::string::npos; at = ended.err.find(" %", at + 1))
    told.push_back(std::stoi(ended.err.substr(at - 3, 3)));
  BOOST_TEST_MESSAGE("reported " << told.size() << " times, the last " << (told.empty() ? 0 : told.back()) << " %");
  BOOST_TEST(told.size() >= 4);
  BOOST_TEST(std::ranges::is_sorted(told), ended.err);
}

// The first pass is the contact alone. The oil that a pass leaves is supplied to the next one, and oil is lost only at
// the sides. The last pass equals a single contact with the layer that the previous pass left.
BOOST_AUTO_TEST_CASE(passes_over_one_track) {
  const Scene scene;
  const auto alone = scene.run("--set supply.layer_m=200e-9");
  const auto found = scene.run("--set supply.layer_m=200e-9 --set supply.passes=3");
  const auto& track = found["starvation"]["track"];
  BOOST_TEST_REQUIRE(track.size() == 3U);
  check_close("first pass: Hc", number_at(track[0], "/Hc"), number_at(alone, "/Hc"), 1e-14);
  check_close("first pass: factor", number_at(track[0], "/factor"), number_at(alone, "/starvation_factor"), 1e-14);
  for (std::size_t k = 0; k < 3; ++k)
    BOOST_TEST(std::abs(number_at(track[k], "/mass_imbalance")) <= 1e-10, "oil of pass " << k + 1);
  for (std::size_t k = 1; k < 3; ++k) {
    BOOST_TEST(number_at(track[k], "/Hc") < number_at(track[k - 1], "/Hc"));
    check_close("what goes in", number_at(track[k], "/oil_in"),
                number_at(track[k - 1], "/oil_in") - number_at(track[k - 1], "/oil_aside"), 1e-9);
  }
  check_close("supply of the last", number_at(track[2], "/supply_ratio") / number_at(track[1], "/supply_ratio"),
              number_at(track[1], "/left") / number_at(track[0], "/left"), 1e-12);
  check_close("last pass: Hc", number_at(track[2], "/Hc"), number_at(found, "/Hc"), 1e-14);

  std::istringstream rows(support::ehl(scene.folder, "extract d.h5 tracks").out);
  const double a = number_at(found, "/a_m"), h_scale = a * a / radius;
  std::ostringstream csv;
  csv.precision(17);
  csv << "y,h\n";
  for (std::string row; std::getline(rows, row);) {
    double pass = 0.0, y = 0.0, layer = 0.0;
    if (std::istringstream(row) >> pass >> y >> layer && pass == 2.0) csv << a * y << ',' << h_scale * layer << '\n';
  }
  scene.folder.write("track.csv", csv.str());
  const auto given = scene.run("--set supply.profile=track.csv");
  for (const char* name : {"/Hc", "/Hm", "/starvation_factor", "/thermal/mu", "/thermal/T_film_max", "/thermal/heat_1"})
    check_close(name, number_at(given, name), number_at(found, name), 1e-9);
}

// A surface that brings fresh oil each time, and a track that levels out.
BOOST_AUTO_TEST_CASE(passes_with_fresh_oil) {
  const Scene scene;
  const std::string layer = "--set supply.layer_m=100e-9 --set supply.passes=3 ";
  const auto plain = scene.run(layer);
  const auto renewed = scene.run(layer + "--set supply.returning=surface1");
  const auto& track = renewed["starvation"]["track"];
  const double first = number_at(track[0], "/supply_ratio"), a = number_at(renewed, "/a_m");
  check_close("by the speeds, 2.5 and 1.5 m/s", number_at(track[2], "/supply_ratio") / first,
              0.375 + 0.625 * number_at(track[1], "/left") * a * a / radius / 100e-9, 1e-9);
  const auto levelled = scene.run(layer + "--set supply.pass_time=1 --set supply.reflow_time=0.01");
  BOOST_TEST(number_at(plain, "/Hc") < number_at(renewed, "/Hc"));
  BOOST_TEST(number_at(renewed, "/Hc") < number_at(track[0], "/Hc"));
  check_close("levelled", number_at(levelled, "/Hc"), number_at(track[0], "/Hc"), 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
