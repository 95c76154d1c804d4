// Runs in time that are stopped or killed, and then continued.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "support/columns.hpp"
#include "support/program.hpp"
#include "support/stopped.hpp"
#include "support/text.hpp"

namespace {

using support::before_the_first_step;
using support::between_two_steps;
using support::rows_of;
using support::stopped;
using support::stopped_where;

const std::string swinging =
    "[contact]\nM = 50\nL = 10\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n[domain]\nx_inlet = -4.5\nx_outlet = 1.5\n"
    "y_half = 3\n[grid]\ncells = 64\n[transient]\nend_time = 6\noutput_interval = 0.2\nload_wave = 0.2 2\nload = 1:1 "
    "1:1.1\n";

const std::string swinging_line =
    "[contact]\nkind = line\nM = 50\nL = 10\n[lubricant]\nalpha = 1.7e-8\n[grid]\ncells = 512\n[transient]\n"
    "rtol = 3e-5\nend_time = 6\noutput_interval = 0.2\nload_wave = 0.2 2\n";

// Hc at time T, interpolated linearly between the rows.
double Hc_at(const std::vector<std::vector<double>>& rows, double T) {
  const auto after = std::ranges::find_if(rows, [T](const auto& row) { return row[0] >= T; });
  if (after == rows.begin() || after == rows.end()) return rows.back()[1];
  const auto& a = after[-1];
  const auto& b = after[0];
  return a[1] + (b[1] - a[1]) * (T - a[0]) / (b[0] - a[0]);
}

// A run that is stopped and continued twice has the film of an uninterrupted run, within the
// tolerance of the integration.
void goes_on_to_the_same_film(const std::string& deck) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  BOOST_TEST_REQUIRE(support::ehl(folder, "run d.ini --quiet --output whole.h5").status == 0);
  const auto whole = rows_of(support::ehl(folder, "extract whole.h5 /transient").out);
  const support::Ended complete = support::ehl(folder, "resume whole.h5");
  BOOST_TEST(complete.status == 2);
  BOOST_TEST(complete.says({"whole.h5"}));

  support::Ended ended = stopped_where(folder, "run d.ini --quiet --output parts.h5", between_two_steps);
  BOOST_TEST(ended.status == 130);
  BOOST_TEST_REQUIRE(ended.says({"ehl resume parts.h5"}), ended.err);
  BOOST_TEST(support::ehl(folder, "report parts.h5 --output page.html").status == 0);
  BOOST_TEST(support::contains(folder.read("page.html"), "`ehl resume`"));
  const double first = rows_of(support::ehl(folder, "extract parts.h5 /transient").out).back()[0];
  ended = stopped(folder, "resume parts.h5 --quiet", "INT", 0.35);
  BOOST_TEST((ended.status == 130 || ended.status == 0), ended.err);
  if (ended.status == 130) ended = support::ehl(folder, "resume parts.h5 --quiet");
  BOOST_TEST(ended.status == 0, ended.err);
  const auto parts = rows_of(support::ehl(folder, "extract parts.h5 /transient").out);
  BOOST_TEST_REQUIRE(parts.size() > 20u);
  double worst = 0.0;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    BOOST_TEST(parts[k][0] > parts[k - 1][0]);
    worst = std::max(worst, std::abs(parts[k][1] / Hc_at(whole, parts[k][0]) - 1.0));
  }
  BOOST_TEST_MESSAGE("stopped at " << first << "; largest difference of Hc " << worst << " (allowed 1e-3)");
  BOOST_TEST(first < 6.0);
  BOOST_TEST(worst < 1e-3);
  BOOST_TEST(parts.back()[0] == 6.0);
  // Every field is stored once, at its time; those from before the stop are identical bit for bit.
  for (const char* field : {"P", "H"})
    BOOST_TEST((support::ehl(folder, std::string("extract whole.h5 --step 1 ") + field).out ==
                support::ehl(folder, std::string("extract parts.h5 --step 1 ") + field).out));
  const auto times = rows_of(support::ehl(folder, "extract parts.h5 /transient/frames/time").out);
  BOOST_TEST_REQUIRE(times.size() == 31u);
  for (std::size_t k = 0; k < times.size(); ++k)
    BOOST_TEST(std::abs(times[k][0] - 0.2 * static_cast<double>(k)) < 1e-9);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_resume)

BOOST_AUTO_TEST_CASE(a_point_contact_goes_on) { goes_on_to_the_same_film(swinging); }
BOOST_AUTO_TEST_CASE(a_line_contact_goes_on) { goes_on_to_the_same_film(swinging_line); }

// The program is killed at many moments, mostly while it writes. Then there is either no file or one that
// can be read and continued.
BOOST_AUTO_TEST_CASE(killed_at_any_moment_leaves_a_file_that_goes_on) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", swinging + "[output]\ncheckpoint = 1e-3\n");
  int found = 0, kills = 0;
  for (; kills < 20 || (found < 10 && kills < 100); ++kills) {
    stopped(folder, "run d.ini --quiet --overwrite", "KILL", 0.05 + 0.02 * kills);
    if (support::shell(folder, "test -e d.h5").status != 0) continue;
    ++found;
    const support::Ended read = support::ehl(folder, "extract d.h5 /checkpoint/y");
    BOOST_TEST(read.status == 0, "kill " << kills << ": " << read.err);
    BOOST_TEST(rows_of(read.out).size() == 2u * 65u * 33u + 1u);
    BOOST_TEST(rows_of(support::ehl(folder, "extract d.h5 /summary/converged").out).at(0).at(0) == 0.0, kills);
    BOOST_TEST(support::ehl(folder, "extract d.h5 failed_check").out.size() > 1u, kills);
  }
  BOOST_TEST_MESSAGE(found << " of " << kills << " kills left a file");
  BOOST_TEST(found >= 10);
  BOOST_TEST(support::ehl(folder, "resume d.h5 --quiet").status == 0);
  BOOST_TEST(rows_of(support::ehl(folder, "extract d.h5 /summary/converged").out).at(0).at(0) == 1.0);
  // A complete run has no checkpoint.
  BOOST_TEST(support::ehl(folder, "resume d.h5").status == 2);
}

// The run is stopped while its steady start is solved: there is no time to continue from, and the file says so.
BOOST_AUTO_TEST_CASE(stopped_before_the_first_step) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", swinging);
  // The steady contact has ten times the load of the first state, so that the solution takes
  // longer than the signal's delay.
  const std::string lighter = " --set grid.cells=256 --set 'transient.load=0:0.1 1:0.1 2:0.2'";
  const support::Ended ended = stopped_where(folder, "run d.ini --quiet" + lighter, before_the_first_step);
  BOOST_TEST_REQUIRE(ended.says({"before the first step"}), ended.err);
  BOOST_TEST(support::ehl(folder, "resume d.h5").status == 2);
}

// The load is in a file next to the deck; both are in a folder other than the working directory and the result.
BOOST_AUTO_TEST_CASE(finds_the_files_of_the_deck_again) {
  const support::TemporaryFolder folder;
  BOOST_TEST_REQUIRE(support::shell(folder, "mkdir decks").status == 0);
  const std::string here = swinging.substr(0, swinging.find("load = 1:1"));
  folder.write("decks/d.ini", here + "load = swing.csv\n");
  const support::Ended missing = support::ehl(folder, "check decks/d.ini");
  BOOST_TEST(missing.status == 4, missing.err);
  BOOST_TEST(missing.says({"decks/d.ini:17: [transient] load = swing.csv", "/decks"}), missing.err);
  folder.write("decks/swing.csv", "time, load\n0, 1\n2, 1.1\n");
  const support::Ended ended = stopped_where(folder, "run decks/d.ini --quiet", between_two_steps);
  BOOST_TEST_REQUIRE(ended.status == 130, ended.err);
  const support::Ended on = support::ehl(folder, "resume d.h5 --quiet");
  BOOST_TEST(on.status == 0, on.err);
}

BOOST_AUTO_TEST_CASE(what_cannot_go_on_is_refused) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", "[contact]\nM = 50\nL = 10\n[lubricant]\nalpha = 1.7e-8\nz = 0.6\n[grid]\ncells = 64\n");
  BOOST_TEST_REQUIRE(support::ehl(folder, "run d.ini --quiet").status == 0);
  const support::Ended steady = support::ehl(folder, "resume d.h5");
  BOOST_TEST(steady.status == 2);
  BOOST_TEST(steady.says({"d.h5"}));
  BOOST_TEST(support::ehl(folder, "resume none.h5").status == 4);
  BOOST_TEST(support::ehl(folder, "resume d.ini").status == 4);
}

BOOST_AUTO_TEST_SUITE_END()
