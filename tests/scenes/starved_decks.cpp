// [supply] in use: its units, what the result contains, what is refused.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "support/program.hpp"
#include "support/solved.hpp"

BOOST_AUTO_TEST_SUITE(test_starved_decks)

using namespace support;

namespace {

const char* const contact = R"([contact]
M = 20
L = 10
[lubricant]
alpha = 2.2e-8
[domain]
x_inlet = -2.5
x_outlet = 1.5
y_half = 2
far_field = zero
[discretization]
wedge = upstream2
face = mean
[grid]
cells = 64
)";

// A 20 mm ball on glass: a = 134.5 um, a^2/R = 1.81 um.
const char* const in_SI = R"([contact]
load = 20
radius_x = 0.010
E_prime = 123.2e9
[motion]
u1 = 0.8
u2 = 0.2
[lubricant]
eta0 = 0.080
alpha = 20e-9
[domain]
x_inlet = -2.5
x_outlet = 1.5
y_half = 2
far_field = zero
[grid]
cells = 64
)";

nlohmann::json supplied(const TemporaryFolder& folder, const std::string& deck, const std::string& supply) {
  return solved_json(folder, deck + "[supply]\n" + supply);
}

// The value in the last row of a table. The last line of its heading names the columns.
double last_of_column(const std::string& table, const std::string& name) {
  std::istringstream lines(table);
  std::string header, last;
  for (std::string line; std::getline(lines, line);) (line[0] == '#' ? header : last) = line;
  std::istringstream names(header.substr(1)), values(last);
  double value = std::nan("");
  for (std::string one; names >> one;) {
    values >> value;
    if (one == name) return value;
  }
  return std::nan("");
}

void refused(const TemporaryFolder& folder, const std::string& deck, const std::string& supply, const char* key) {
  folder.write("case.ini", deck + "[supply]\n" + supply);
  const Ended run = support::ehl(folder, "check case.ini");
  BOOST_TEST(run.status == 2, supply);
  BOOST_TEST(run.says({"[", key}), supply << ": " << run.err);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_starved_contact_tells_what_is_missing) {
  const TemporaryFolder folder;
  const auto report = supplied(folder, contact, "H_oil = 0.2\n");
  BOOST_TEST(report["converged"] == true);
  const double factor = report["starvation_factor"], imbalance = report["mass_imbalance"];
  const double r = report["starvation"]["supply_ratio"], meniscus = report["starvation"]["meniscus_X"];
  BOOST_TEST_MESSAGE("r = " << r << ": factor " << factor << " (0.48 at r = 0.5 and 0.63 at 0.7 elsewhere), meniscus "
                            << meniscus << ", imbalance " << imbalance);
  BOOST_TEST((factor > 0.4 && factor < r));
  BOOST_TEST((meniscus > -1.3 && meniscus < -1.0));
  BOOST_TEST(std::abs(imbalance) < 1e-3);
  BOOST_TEST(support::ehl(folder, "extract case.h5 theta --along x --at y=0").out.find("\n") != std::string::npos);
}

// Only u1 h1 + u2 h2 counts: R (0.8 h1 + 0.2 h2)/(0.5 a^2).
BOOST_AUTO_TEST_CASE(one_supply_in_all_its_units) {
  const TemporaryFolder folder;
  const double one = supplied(folder, in_SI, "layer_m = 160e-9\n")["Hc"];
  const double faster = supplied(folder, in_SI, "layer1_m = 100e-9\nlayer2_m = 0\n")["Hc"];
  const double slower = supplied(folder, in_SI, "layer1_m = 0\nlayer2_m = 400e-9\n")["Hc"];
  // u_m times the width, 4 a of 134.5 um, times the layer.
  const nlohmann::json scales = supplied(folder, in_SI, "layer_m = 160e-9\n");
  const double a = scales["a_m"];
  const std::string flow = std::to_string(0.5 * 4.0 * a * 160e-9 * 1e12) + "e-12";
  const double flowing = supplied(folder, in_SI, "flow_m3_per_s = " + flow + "\n")["Hc"];
  folder.write("track.csv", "y,h\n-3e-4,160e-9\n3e-4,160e-9\n");
  const double track = supplied(folder, in_SI, "profile = track.csv\n")["Hc"];
  BOOST_TEST_MESSAGE("Hc " << one << ", " << faster << ", " << slower << ", " << flowing << ", " << track);
  for (const double other : {faster, slower, track}) BOOST_TEST(std::abs(other / one - 1.0) <= 1e-9);
  BOOST_TEST(std::abs(flowing / one - 1.0) <= 1e-5);  // the flow is printed with six digits
}

// The oil that leaves a contact is brought to the next one. The film decreases from pass to pass; it decreases less if
// half of the oil is renewed or the track levels out. Oil is lost only at the sides.
BOOST_AUTO_TEST_CASE(passes_over_one_track) {
  const TemporaryFolder folder;
  const std::string supply = "H_oil = 0.3\npasses = 3\n";
  const auto plain = supplied(folder, contact, supply);
  const auto& track = plain["starvation"]["track"];
  BOOST_TEST_REQUIRE(track.size() == 3U);
  for (std::size_t k = 1; k < 3; ++k) {
    BOOST_TEST(track[k]["factor"].get<double>() < track[k - 1]["factor"].get<double>());
    BOOST_TEST(std::abs(track[k]["supply_ratio"].get<double>() / track[0]["supply_ratio"].get<double>() -
                        track[k - 1]["left"].get<double>() / 0.3) <= 1e-9);
    BOOST_TEST(std::abs(track[k]["oil_in"].get<double>() / track[0]["oil_in"].get<double>() - 1.0) <= 1e-4);
  }
  BOOST_TEST(std::abs(track[2]["Hc"].get<double>() - plain["Hc"].get<double>()) <= 1e-12);
  BOOST_TEST(plain["starvation"]["passes"] == 3);
  for (const char* table : {"passes", "tracks"})
    BOOST_TEST(support::ehl(folder, std::string("extract case.h5 ") + table).out.starts_with("# "), table);
  const double film = plain["Hc"];
  const double renewed = supplied(folder, contact, supply + "returning = surface1\n")["Hc"];
  const double level = supplied(folder, contact, supply + "pass_time = 1\nreflow_time = 0.1\n")["Hc"];
  const double first = track[0]["Hc"];
  BOOST_TEST_MESSAGE("Hc of the third pass " << film << ", half renewed " << renewed << ", levelled out " << level
                                             << "; of the first " << first);
  BOOST_TEST((film < renewed && renewed < first));
  BOOST_TEST(std::abs(level / first - 1.0) <= 1e-3);
  BOOST_TEST(supplied(folder, in_SI,
                      "layer1_m = 100e-9\nlayer2_m = 0\npasses = 2\nreturning = surface2\n")["converged"] == true);
}

BOOST_AUTO_TEST_CASE(passes_that_make_no_sense_are_refused) {
  const TemporaryFolder folder;
  refused(folder, contact, "H_oil = 0.2\npasses = 0\n", "whole number");
  refused(folder, contact, "H_oil = 0.2\npasses = 2.5\n", "whole number");
  refused(folder, contact, "H_oil = 0.2\npass_time = 1\n", "passes");
  refused(folder, contact, "H_oil = 0.2\npasses = 2\nreflow_time = 1\n", "pass_time");
  refused(folder, contact, "H_oil = 0.2\npasses = 2\nsplit = 0.4\n", "returning");
  refused(folder, contact, "H_oil = 0.2\npasses = 2\nreturning = surface1\nsplit = 1.4\n", "split");
}

// A heavy contact on few cells: behind the film the gap opens by many times the film thickness from node to node.
BOOST_AUTO_TEST_CASE(the_oil_content_is_never_negative) {
  const TemporaryFolder folder;
  const auto found = supplied(folder,
                              "[contact]\nM = 3000\nL = 5\nradius_ratio = 0.2\n[lubricant]\nalpha = 2.2e-8\nz = "
                              "0.68\n[grid]\ncells = 64\n",
                              "H_oil = 0.0021\n");
  const double least = found["verification"]["least_content"].get<double>();
  BOOST_TEST_MESSAGE("least content " << least << " at a supply of 0.0021 (at least a tenth of it)");
  BOOST_TEST(least >= 2.1e-4);
}

// In time: each layer moves with its own surface, the oil is balanced, and the fields include the oil content.
BOOST_AUTO_TEST_CASE(supply_in_time) {
  const TemporaryFolder folder;
  const std::string slower = std::string(in_SI) +
                             "[transient]\nend_time = 0.3\noutput_interval = 0.1\nu1 = 0:1.6 0.2:0.8\n"
                             "u2 = 0:0.4 0.2:0.4\n";
  folder.write("both.ini", slower + "[supply]\nlayer_m = 200e-9\n");
  folder.write("first.ini", slower + "[supply]\nlayer1_m = 125e-9\nlayer2_m = 0\n");
  double in[2] = {};
  int k = 0;
  for (const char* deck : {"both", "first"}) {
    const Ended run = support::ehl(folder, std::string("run ") + deck + ".ini --json --quiet");
    BOOST_TEST_REQUIRE(run.status == 0, run.err);
    const nlohmann::json report = nlohmann::json::parse(run.out)["transient"];
    BOOST_TEST(report["worst_oil_error"].get<double>() <= 1e-10);
    BOOST_TEST(std::abs(report["oil_lost"].get<double>()) <= 1e-9);
    in[k] = last_of_column(support::ehl(folder, std::string("extract ") + deck + ".h5 transient").out, "oil_in");
    BOOST_TEST(
        support::ehl(folder, std::string("extract ") + deck + ".h5 transient/frames/theta --along x --at y=0").status ==
        0);
    ++k;
  }
  // The deck in the result, from which a stopped run continues.
  folder.write("again.ini", support::ehl(folder, "extract both.h5 deck").out);
  const Ended again = support::ehl(folder, "check again.ini");
  BOOST_TEST(again.status == 0, again.err);
  // If u1 falls from 1.6 to 0.8, both layers bring 1.2/2 of their oil, the first alone 0.8/1.6.
  BOOST_TEST_MESSAGE("oil in: " << in[1] / in[0] << " (5/6 with equal oil at the start)");
  BOOST_TEST(std::abs(in[1] / in[0] - 5.0 / 6.0) <= 1e-3);
}

// Layers too thick for the gap at the inlet: oil that does not fit at the start does not count as lost.
BOOST_AUTO_TEST_CASE(oil_is_counted_from_the_first_state) {
  const TemporaryFolder folder;
  folder.write("full.ini",
               "[contact]\nload = 18.19\nradius_x = 0.0979886\nE_prime = 2.06e11\n[motion]\nu_m = 1.475713e-4\n"
               "[lubricant]\neta0 = 0.052504\nviscosity = isoviscous\n[domain]\nx_inlet = -1.1944\nx_outlet = 2.0176\n"
               "[grid]\ncells = 64\n[supply]\nlayer1_m = 4.5557e-8\nlayer2_m = 9.1115e-8\n"
               "[transient]\nend_time = 0.3\nstop_film = 0.0236\nsupply = 0:1 0.0015756:0.396\n");
  const Ended run = support::ehl(folder, "run full.ini --json --quiet");
  BOOST_TEST_REQUIRE(run.status == 0, run.err);
  const double lost = nlohmann::json::parse(run.out)["transient"]["oil_lost"];
  BOOST_TEST_MESSAGE("oil lost since the start: " << lost);
  BOOST_TEST(std::abs(lost) <= 1e-10);
}

// The decks in inputs, including a profile with time: no step creates oil.
BOOST_AUTO_TEST_CASE(decks_in_time_conserve_oil) {
  const TemporaryFolder folder;
  folder.write("track.csv", "y,h\n-3,0.15\n0,0.3\n1,0.2\n3,0.2\n");
  for (const char* deck : {"impact.ini' --set grid.cells=64", "start_stop.ini' --set transient.end_time=3.5",
                           "start_stop.ini' --set transient.end_time=1 --set 'transient.supply=0:1 1:0.7' "
                           "--unset supply.H_oil --set supply.profile=track.csv"}) {
    const std::string words = std::string("run '") + EHL_INPUTS + "/starved/" + deck;
    const Ended run = support::ehl(folder, words + " --json --quiet --overwrite --output r.h5");
    BOOST_TEST_REQUIRE(run.status == 0, run.err);
    const nlohmann::json report = nlohmann::json::parse(run.out)["transient"];
    const double nowhere = report["worst_oil_error"], lost = report["oil_lost"];
    BOOST_TEST_MESSAGE(deck << ": oil from nowhere " << nowhere << " (allowed 1e-10), since the start " << lost
                            << " (1e-9), steps " << report["steps"]);
    BOOST_TEST(nowhere <= 1e-10);
    BOOST_TEST(std::abs(lost) <= 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const TemporaryFolder folder;
  refused(folder, contact, "H_oil = 0\n", "H_oil = 0");
  refused(folder, contact, "H_oil = -1\n", "H_oil = -1");
  refused(folder, contact, "layer_m = 1e-7\n", "layer_m");
  refused(folder, in_SI, "layer1_m = 1e-7\n", "layer2_m");
  refused(folder, in_SI, "layer1_m = 0\nlayer2_m = 0\n", "layer1_m");
  refused(folder, in_SI, "layer_m = 1e-7\nflow_m3_per_s = 1e-10\n", "flow_m3_per_s");
  const auto in_time = [](const char* keys) { return std::string(contact) + "[transient]\nend_time = 1\n" + keys; };
  refused(folder, in_time(""), "H_oil = 0.2\npasses = 2\n", "passes");
  refused(folder, in_time("cavitation = pressure\n"), "H_oil = 0.2\n", "cavitation");
  refused(folder, in_time("supply = 0:0.5 1:1\n"), "H_oil = 0.2\n", "[transient] supply");
  refused(folder, in_time("supply = 0:1 1:-1\n"), "H_oil = 0.2\n", "[transient] supply");
  refused(folder, "[case]\nkind = dry\n" + std::string(in_SI), "layer_m = 1e-7\n", "layer_m");
  folder.write("narrow.csv", "-1,0.2\n1,0.2\n");
  refused(folder, contact, "profile = narrow.csv\n", "profile = narrow.csv");
  folder.write("gap.csv", "-2,0.2\n0,\n2,0.2\n");
  refused(folder, contact, "profile = gap.csv\n", "gap.csv:2");
  folder.write("back.csv", "-2,0.2\n-2.5,0.3\n2,0.2\n");
  refused(folder, contact, "profile = back.csv\n", "back.csv:2");
  folder.write("case.ini", std::string(contact) + "[supply]\nH_oil = 0.2\n");
  const Ended closed = support::ehl(folder, "check case.ini --set domain.far_field=closed");
  BOOST_TEST(closed.status == 2);
  BOOST_TEST(closed.says({"far_field"}));
}

// Ellipses far from circular: coarse grids that do not capture the position of the oil give no error estimate, and a
// solution is found at once although no standard start leads to it.
BOOST_AUTO_TEST_CASE(ellipses_far_from_round) {
  const TemporaryFolder folder;
  const auto ellipse = [](const std::string& shape, int cells) {
    return "[contact]\nE_prime = 226e9\n" + shape + "[motion]\nu_m = 5\n[lubricant]\neta0 = 0.0165\nalpha = 1.8e-8\n" +
           "[grid]\ncells = " + std::to_string(cells) + "\n";
  };
  const std::string wide = "load = 255.5\nradius_x = 0.01\nradius_ratio = 0.01\n", layer = "layer_m = 3e-7\n";
  const nlohmann::json found = supplied(folder, ellipse(wide, 128), layer);
  const double truth = supplied(folder, ellipse(wide, 256), layer)["Hc"], Hc = found["Hc"], bar = found["error_Hc"];
  BOOST_TEST_MESSAGE("Hc changes by " << truth / Hc - 1.0 << " to twice the cells, error bar " << bar);
  BOOST_TEST(std::abs(truth / Hc - 1.0) < bar);
  BOOST_TEST(bar < 0.1);
  const nlohmann::json slender =
      supplied(folder, ellipse("load = 100\nradius_x = 0.2\nradius_y = 0.01\n", 256), "layer_m = 1e-7\n");
  BOOST_TEST(slender["attempts"].size() <= 3u);
}

BOOST_AUTO_TEST_SUITE_END()
