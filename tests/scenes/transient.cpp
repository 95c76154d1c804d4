// Decks in time through the program: what is refused, what comes out, what the result file contains.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/columns.hpp"
#include "support/refused.hpp"
#include "support/text.hpp"

namespace {

using support::contains;
using support::rows_of;

const std::string contact = "[contact]\nM = 50\nL = 10\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n";
const std::string grid = "[domain]\nfar_field = zero\nx_inlet = -4.5\nx_outlet = 1.5\ny_half = 3\n[grid]\ncells = 64\n";
const std::string steel =
    "[contact]\nload = 15\nradius_x = 0.0125\nE_prime = 110e9\n[motion]\nu1 = 0.045\nu2 = 0.135\n"
    "[lubricant]\neta0 = 0.25\nalpha = 22e-9\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(test_transient)

BOOST_AUTO_TEST_CASE(what_is_wrong_is_refused) {
  const std::string timed = "[transient]\nend_time = 1\n";
  const support::Slip slips[] = {
      {"no end", "[transient]\nrtol = 1e-3\n", {"d.ini:15", "rtol", "end_time"}},
      {"a surface at rest", "[surface1]\nshape = dimple\nheight = 0.1\nwidth = 1\n", {"[transient] end_time"}},
      {"no size", timed + "[surface1]\nshape = dimple\nheight = 0.1\n", {"[surface1] width"}},
      {"two heights",
       timed + "[surface1]\nshape = dimple\nheight = 0.1\nheight_m = 1e-7\nwidth = 1\n",
       {"[surface1] height"}},
      {"metres without SI", timed + "[surface1]\nshape = dimple\nheight_m = 1e-7\nwidth = 1\n", {"height_m"}},
      {"too small to see", timed + "[surface1]\nshape = dimple\nheight = 0.1\nwidth = 0.1\n", {"width = 0.1"}},
      {"an unknown shape", timed + "[surface2]\nshape = dimpel\n", {"shape = dimpel"}},
      {"an angle of a round thing",
       timed + "[surface1]\nshape = bump\nheight = 0.1\nwidth = 1\nangle = 3\n",
       {"angle = 3"}},
      {"seconds without SI", timed + "time_unit = seconds\n", {"time_unit = seconds"}},
      {"no points", timed + "load = 1:half\n", {"load = 1:half"}},
      {"back in time", timed + "load = 1:1 0.5:2\n", {"load = 1:1 0.5:2"}},
      {"thrice", timed + "load = 0.5:1 0.5:2 0.5:3\n", {"[transient] load"}},
      {"before time", timed + "load = -1:1 0.5:2\n", {"[transient] load"}},
      {"lifted", timed + "load = 0.1:1 0.5:-1\n", {"load"}},
      {"lifted by the wave", timed + "load_wave = 1.2 3\n", {"load_wave"}},
      {"never there", "[transient]\nend_time = 1e9\n", {"end_time = 1e9"}},
      {"half a wave", timed + "load_wave = 0.2\n", {"load_wave = 0.2"}},
      {"no period", timed + "load_wave = 0.2 0\n", {"load_wave"}},
      {"backwards", timed + "u1 = 0.2:1 0.5:-2\n", {"u1", "x_outlet = 4.5"}},
      {"half a probe", timed + "[output]\nprobe = 0 0, 0.7\n", {"[output] probe"}},
      {"words for a probe", timed + "[output]\nprobe = centre\n", {"probe = centre"}},
      {"a probe outside", timed + "[output]\nprobe = 0 0, 1.6 0\n", {"[output] probe"}},
      {"a probe aside", timed + "[output]\nprobe = 0 -3.1\n", {"[output] probe"}},
      {"a steady probe", "[output]\nprobe = 0 0\n", {"probe = 0 0", "end_time"}},
      {"from rest", timed + "u1 = 0:0 1:1\nu2 = 0:0 1:1\n", {"u1"}},
  };
  const support::TemporaryFolder folder;
  for (const support::Slip& slip : slips)
    support::check_refused(folder, {slip.name, contact + grid + slip.deck, slip.parts});
  // The domain that the refusal names is accepted.
  folder.write("d.ini", contact + grid + timed + "u1 = 0.2:1 0.5:-2\n");
  BOOST_TEST(support::ehl(folder, "check d.ini --set domain.x_outlet=4.5").status == 0);
  for (const char* table : {"t [s],load\n0,1\n", "t,load [N]\n0,1\n"}) {
    folder.write("units.csv", table);
    support::check_refused(folder, {table, contact + grid + timed + "load = units.csv\n", {"units.csv:1"}});
  }
  // What is no list is the name of a file.
  folder.write("d.ini", contact + grid + timed + "load = half\n");
  const support::Ended no_file = support::ehl(folder, "check d.ini");
  BOOST_TEST(no_file.status == 4, no_file.err);
  BOOST_TEST(no_file.says({"load = half"}), no_file.err);
  const std::string jump = timed + "load = 0.5:1 0.5:1.1\n[grid]\ncells = 64\n";
  support::check_refused(folder, {"a far field that cannot follow a jump",
                                  contact + jump + "[domain]\nfar_field = closed\n",
                                  {"far_field = closed"}});
  folder.write("d.ini", contact + jump);
  BOOST_TEST(contains(support::ehl(folder, "check d.ini").out, "[-4.5, 1.5] x [-3, 3]"));  // for far_field = zero
  folder.write("d.ini", contact + grid + timed + "load = none.csv\n");
  BOOST_TEST(support::ehl(folder, "run d.ini").status == 4);
  folder.write("d.ini", contact + "[grid]\naccuracy = 0.01\n" + timed);
  const support::Ended accuracy = support::ehl(folder, "run d.ini");
  BOOST_TEST(accuracy.status == 2);
  BOOST_TEST(accuracy.says({"accuracy"}));
}

// A load from a file, a dimple in metres, and times in seconds give the same run as Hertz radii and a/u_m.
BOOST_AUTO_TEST_CASE(units_agree) {
  const support::TemporaryFolder folder;
  const std::string fields = "[domain]\nx_inlet = -4.5\nx_outlet = 1.5\ny_half = 3\n[grid]\ncells = 64\n";
  folder.write("plain.ini", steel + fields +
                                "[transient]\nend_time = 0.5\nload = 0.1:1 0.2:1.1\n[surface1]\nshape = "
                                "dimple\nheight = 0.05\nwidth = 0.5\nx = -1\n");
  const support::Ended plain = support::ehl(folder, "run plain.ini --quiet");
  BOOST_TEST_REQUIRE(plain.status == 0, plain.err);
  const auto scale = [&](const char* name) {
    return rows_of(support::ehl(folder, std::string("extract plain.h5 /scales/") + name).out).at(0).at(0);
  };
  const double a = scale("a"), second = scale("time"), height = scale("h");
  BOOST_TEST(second == a / 0.09, boost::test_tools::tolerance(1e-12));
  std::ostringstream metres;
  metres.precision(17);
  metres << steel << fields << "[transient]\ntime_unit = seconds\nend_time = " << 0.5 * second
         << "\nload = load.csv\n[surface1]\nshape = dimple\nheight_m = " << 0.05 * height << "\nwidth_m = " << 0.5 * a
         << "\nx = -1\n";
  folder.write("metres.ini", metres.str());
  std::ostringstream table;
  table.precision(17);
  table << "time, load\n" << 0.1 * second << ", 1\n# up\n" << 0.2 * second << ", 1.1\n";
  folder.write("load.csv", table.str());
  BOOST_TEST_REQUIRE(support::ehl(folder, "run metres.ini --quiet").status == 0);
  const auto one = rows_of(support::ehl(folder, "extract plain.h5 /transient").out);
  const auto other = rows_of(support::ehl(folder, "extract metres.h5 /transient").out);
  BOOST_TEST_MESSAGE(one.back()[1] << " and " << other.back()[1]);
  BOOST_TEST(std::abs(one.back()[1] / other.back()[1] - 1.0) < 1e-6);
  BOOST_TEST(std::abs(one.back()[7] - 1.1) < 1e-12);
}

// Warnings about a dimple that starts too far upstream to arrive, and about a moving one on too few cells. Other
// dimples cause no warning.
BOOST_AUTO_TEST_CASE(a_feature_that_comes_late_or_is_coarse_is_told) {
  const support::TemporaryFolder folder;
  const std::string lines = "[surface1]\nshape = dimple\nheight = 0.02\nwidth = 0.5\n[transient]\nend_time = 0.3\n";
  folder.write("d.ini", contact + grid + lines);
  const support::Ended late = support::ehl(folder, "run d.ini --quiet");
  BOOST_TEST_REQUIRE(late.status == 0, late.err);
  // The speed is 1, and the front half a radius ahead: 4.5 a/u_m to the edge of the contact.
  for (const char* part : {"x = -6 a", "x = -5.7 a", "0.3 a/u_m", "4.5 a/u_m", "[late-feature]"})
    BOOST_TEST(contains(late.out, part), part << " is missing in\n" << late.out);
  const support::Ended checked = support::ehl(folder, "check d.ini");
  BOOST_TEST(contains(checked.out, "4.5 a/u_m"), checked.out);
  const support::Ended stands = support::ehl(folder, "check d.ini --set transient.u1=0:1 --set transient.u2=0:1");
  BOOST_TEST(contains(stands.out, "4.5 a/u_m"), stands.out);
  const support::Ended never =
      support::ehl(folder, "check d.ini --set 'transient.u1=0:1 0.1:0' --set 'transient.u2=0:1'");
  BOOST_TEST((contains(never.out, "[late-feature]") && !contains(never.out, "4.5 a/u_m")), never.out);
  const support::Ended there = support::ehl(folder, "run d.ini --quiet --overwrite --set surface1.x=-1.7");
  BOOST_TEST(!contains(there.out, "[late-feature]"));
  BOOST_TEST((contains(there.out, "5.3 cells") && contains(there.out, "[coarse-feature]")), there.out);
  const support::Ended fine =
      support::ehl(folder, "run d.ini --quiet --overwrite --set surface1.x=-1.7 --set surface1.width=0.8");
  BOOST_TEST(!contains(fine.out, "[coarse-feature]"));
}

// The numbers of every step, the fields at the times asked for, and the text of the summary.
BOOST_AUTO_TEST_CASE(a_load_step_and_what_is_kept) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", contact + grid + "[transient]\nend_time = 1\nload = 0.3:1 0.3:1.2\noutput_interval = 0.25\n");
  const support::Ended ended = support::ehl(folder, "run d.ini --quiet");
  BOOST_TEST_REQUIRE(ended.status == 0, ended.err);
  BOOST_TEST(contains(ended.out, "1 jumps"));
  const auto rows = rows_of(support::ehl(folder, "extract d.h5 /transient").out);
  BOOST_TEST_REQUIRE(rows.size() > 20u);
  double worst = 0.0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    BOOST_TEST(rows[k][0] > rows[k - 1][0]);
    worst = std::max(worst, rows[k][9]);
  }
  BOOST_TEST_MESSAGE(rows.size() << " steps, worst load error " << worst << " (allowed 1e-6)");
  BOOST_TEST(worst <= 1e-6);
  BOOST_TEST(rows.back()[0] == 1.0);
  const auto times = rows_of(support::ehl(folder, "extract d.h5 /transient/frames/time").out);
  BOOST_TEST_REQUIRE(times.size() == 5u);
  for (std::size_t k = 0; k < times.size(); ++k)
    BOOST_TEST(std::abs(times[k][0] - 0.25 * static_cast<double>(k)) < 1e-12);
  // The minimum film of the last field is that of the last row.
  double least = 1e9;
  for (const auto& row : rows_of(support::ehl(folder, "extract d.h5 /transient/frames/H --step 4").out))
    least = std::min(least, row.at(2));
  BOOST_TEST(std::abs(least / rows.back()[2] - 1.0) < 1e-9);
  const auto lines = rows_of(support::ehl(folder, "extract d.h5 /transient/frames/P --along x").out);
  BOOST_TEST(lines.size() == 5u * 65u);
  const support::Ended refused = support::ehl(folder, "extract d.h5 /transient/frames/P --step 5");
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(refused.says({"--step 5", "4"}));
  // The deck in the result describes the same case.
  BOOST_TEST(contains(support::ehl(folder, "extract d.h5 deck").out, "load = 0.3:1 0.3:1.2"));
}

// A run that cannot continue says so, ends with status 3 and keeps its results.
BOOST_AUTO_TEST_CASE(too_few_steps) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", contact + grid + "[transient]\nend_time = 1\nload = 1:1.1\nload_wave = 0.1 2\nmax_steps = 7\n");
  const support::Ended ended = support::ehl(folder, "run d.ini --quiet");
  BOOST_TEST(ended.status == 3);
  BOOST_TEST(ended.says({"7 steps"}));
  BOOST_TEST(rows_of(support::ehl(folder, "extract d.h5 /transient").out).size() == 8u);
  BOOST_TEST(contains(support::ehl(folder, "extract d.h5 transient_ended").out, "7 steps"));
  BOOST_TEST(contains(support::ehl(folder, "extract d.h5 converged").out, "\n0\n"));
  const support::Ended resumed = support::ehl(folder, "resume d.h5");
  BOOST_TEST((resumed.status == 2 && resumed.says({"7 steps"})), resumed.err);
  BOOST_TEST(support::ehl(folder, "report d.h5 --output page.html").status == 0);
  BOOST_TEST(contains(folder.read("page.html"), "7 steps"));
  const nlohmann::json json = nlohmann::json::parse(support::ehl(folder, "run d.ini --quiet --json --overwrite").out);
  BOOST_TEST(json["converged"] == false);
  BOOST_TEST(contains(json["failed_check"].get<std::string>(), "7 steps"));
  BOOST_TEST(json["transient"]["start_converged"] == true);
  BOOST_TEST(json["transient"]["completed"] == false);
}

// The columns of probes compared with the fields, at nodes and between them. The other columns are identical bit for
// bit with and without probes.
BOOST_AUTO_TEST_CASE(probes_show_the_fields) {
  const support::TemporaryFolder folder;
  const std::string deck = contact + grid +
                           "[transient]\nend_time = 0.5\nload = 0.1:1 0.2:1.1\n[surface1]\nshape = dimple\nheight = "
                           "0.05\nwidth = 0.5\nx = -0.6\n";
  folder.write("d.ini", deck);
  BOOST_TEST_REQUIRE(support::ehl(folder, "run d.ini --quiet").status == 0);
  const auto plain = rows_of(support::ehl(folder, "extract d.h5 /transient").out);
  // The probes are nodes and points between nodes, and their mirror images in Y. Node (56, 28) is (0.75, -0.375).
  folder.write("p.ini", deck + "[output]\nprobe = 0 0, 0.75 -0.375, 0.75 0.375, 0.7 0.1, 0.7 -0.1, 1.45 0\n");
  const support::Ended ended = support::ehl(folder, "run p.ini --quiet");
  BOOST_TEST_REQUIRE(ended.status == 0, ended.err);
  for (const char* line : {"P at (0.75, -0.375) ", "H at (1.45, 0) "}) BOOST_TEST(contains(ended.out, line), ended.out);
  const support::Ended table = support::ehl(folder, "extract p.h5 /transient");
  BOOST_TEST(contains(table.out, "not_solved P_1 H_1 P_2 H_2 P_3 H_3 P_4 H_4 P_5 H_5 P_6 H_6\n"));
  const auto rows = rows_of(table.out);
  BOOST_TEST_REQUIRE(rows.size() == plain.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    BOOST_TEST_REQUIRE(rows[k].size() == plain[k].size() + 12u);
    for (std::size_t c = 0; c < plain[k].size(); ++c) BOOST_TEST(rows[k][c] == plain[k][c]);
    BOOST_TEST(rows[k][16] == rows[k][1]);   // H at the centre
    BOOST_TEST(rows[k][17] == rows[k][19]);  // P at a node and at its mirror image
    BOOST_TEST(std::abs(rows[k][21] - rows[k][23]) < 1e-12);
    BOOST_TEST(rows[k][25] == 0.0);  // cavitated
  }
  // Between nodes: the bilinear value of the four surrounding nodes, up to the curvature term h^2/8 P'' = 0.003.
  for (const std::size_t quantity : {0u, 1u}) {
    const std::string name = quantity == 0 ? "P" : "H";
    double bilinear = 0.0, node = 0.0;
    for (const auto& row : rows_of(support::ehl(folder, "extract p.h5 /transient/frames/" + name + " --step 1").out)) {
      constexpr double h = 6.0 / 64.0;
      bilinear += row.at(2) * std::max(0.0, 1.0 - std::abs(row.at(0) - 0.7) / h) *
                  std::max(0.0, 1.0 - std::abs(row.at(1) - 0.1) / h);
      if (std::abs(row.at(0) - 0.75) + std::abs(row.at(1) - 0.375) < 1e-9) node = row.at(2);
    }
    BOOST_TEST_MESSAGE(name << " at (0.7, 0.1): " << rows.back()[21 + quantity] << ", bilinear " << bilinear
                            << " (allowed 5e-3)");
    BOOST_TEST(std::abs(rows.back()[21 + quantity] - bilinear) < 5e-3);
    BOOST_TEST(rows.back()[19 + quantity] == node);
  }
}

// The disk becomes full while a run in time writes (a limit on the size of files has the same effect). The run
// ends with status 4, names the file and the reason, leaves only the last good checkpoint, and continues from it
// when there is space again.
BOOST_AUTO_TEST_CASE(full_disk_keeps_the_last_checkpoint) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", contact + grid +
                            "[transient]\nend_time = 2\nload_wave = 0.2 2\noutput_interval = 0.02\n[output]\n"
                            "checkpoint = 1e-3\nprobe = 0 0, 0.7 0.1\n");
  const std::string run = std::string("'") + EHL_PROGRAM + "' run d.ini --quiet";
  // Blocks of 512 bytes: enough for about ten of the hundred fields.
  const support::Ended ended = support::shell(folder, "ulimit -f 2000\n" + run);
  BOOST_TEST(ended.status == 4);
  BOOST_TEST(ended.says({"d.h5"}), ended.err);
  BOOST_TEST_REQUIRE(support::shell(folder, "test -e d.h5").status == 0);
  BOOST_TEST(support::shell(folder, "ls -A").out == "d.h5\nd.ini\nd.xmf\n", support::shell(folder, "ls -A").out);
  const auto before = rows_of(support::ehl(folder, "extract d.h5 /transient").out);
  const auto fields = rows_of(support::ehl(folder, "extract d.h5 /transient/frames/time").out);
  BOOST_TEST_MESSAGE("the last checkpoint has " << before.size() << " rows, to time " << before.back()[0] << ", and "
                                                << fields.size() << " fields");
  BOOST_TEST((before.size() > 5u && fields.size() > 1u && fields.size() < 101u));
  BOOST_TEST(rows_of(support::ehl(folder, "extract d.h5 /checkpoint/y").out).size() == 2u * 65u * 33u + 1u);
  // A repetition ends in the same way and does no harm.
  const std::string resume = std::string("'") + EHL_PROGRAM + "' resume d.h5 --quiet";
  BOOST_TEST(support::shell(folder, "ulimit -f 2000\n" + resume).status == 4);
  BOOST_TEST(rows_of(support::ehl(folder, "extract d.h5 /transient").out).size() >= before.size());
  BOOST_TEST(support::ehl(folder, "resume d.h5 --quiet").status == 0);
  const auto whole = rows_of(support::ehl(folder, "extract d.h5 /transient").out);
  BOOST_TEST(whole.back()[0] == 2.0);
  for (std::size_t k = 0; k < before.size(); ++k) BOOST_TEST(whole[k] == before[k]);
  BOOST_TEST(whole.back().size() == 19u);
  BOOST_TEST(rows_of(support::ehl(folder, "extract d.h5 /transient/frames/time").out).size() == 101u);
}

BOOST_AUTO_TEST_SUITE_END()
