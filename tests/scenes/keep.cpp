// ehl sweep --keep: the result of every case in one file, even if the sweep is interrupted.
#include <boost/test/unit_test.hpp>
#include <string>

#include "support/program.hpp"
#include "support/text.hpp"

using support::contains;

namespace {

const std::string deck = "[contact]\nM = 20\nL = 5\n\n[lubricant]\nalpha = 2.2e-8\n\n[grid]\ncells = 64\n";
const std::string vary =
    "sweep d.ini --vary contact.M=5:40:6 --vary contact.L=2,5 --quiet --keep --threads 2 --output ";

std::string extracted(const support::TemporaryFolder& folder, const std::string& what) {
  const support::Ended ended = support::ehl(folder, "extract " + what);
  BOOST_TEST(ended.status == 0, ended.err);
  // Without the first line, which contains the name of the file.
  return ended.out.substr(ended.out.find('\n') + 1);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_keep)

BOOST_AUTO_TEST_CASE(every_case_is_the_result_of_a_run) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  BOOST_REQUIRE(support::ehl(folder, vary + "t.csv").status == 0);
  // Case 7 of M = 5, 12, 19, 26, 33, 40 and L = 2, 5: M = 26, L = 5.
  BOOST_REQUIRE(support::ehl(folder, "run d.ini --set contact.M=26 --threads 1 --quiet --output one.h5").status == 0);
  for (const std::string name : {"H", "P", "Hc"})
    BOOST_TEST(extracted(folder, "t.h5 " + name + " --case 7") == extracted(folder, "one.h5 " + name));
  BOOST_TEST(contains(extracted(folder, "t.h5 deck --case 7"), "M = 26"));
  // With more values the cases have other numbers, but none is computed again.
  const std::string more =
      "sweep d.ini --vary contact.M=2,5,12,19,26,33,40 --vary contact.L=2,5 --quiet --keep "
      "--output t.csv";
  const support::Ended ended = support::ehl(folder, more);
  BOOST_TEST(contains(ended.out, "14: 12 kept, 2 computed"), ended.out);
  BOOST_TEST(extracted(folder, "t.h5 H --case 9") == extracted(folder, "one.h5 H"));
}

BOOST_AUTO_TEST_CASE(killed_at_any_moment_it_goes_on) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  BOOST_REQUIRE(support::ehl(folder, vary + "whole.csv").status == 0);
  const std::string program = EHL_PROGRAM;
  for (const char* moment : {"0.05", "0.11", "0.17", "0.23", "0.31", "0.4"})
    // The test waits for the killed process: while it writes to disk, it ends with a delay and keeps its files locked.
    support::shell(folder, "'" + program + "' " + vary + "cut.csv & sleep " + moment + "; kill -KILL $!; wait $!");
  const support::Ended ended = support::ehl(folder, vary + "cut.csv");
  BOOST_TEST_MESSAGE("after six kills: " << ended.out.substr(0, ended.out.find('\n')));
  BOOST_REQUIRE(ended.status == 0);
  BOOST_TEST(support::shell(folder, "cmp whole.csv cut.csv").status == 0);
  for (int k = 0; k < 12; ++k) {
    const std::string H = " H --along x --case " + std::to_string(k);
    BOOST_TEST(extracted(folder, "whole.h5" + H) == extracted(folder, "cut.h5" + H), "case " << k);
  }
  BOOST_TEST(support::shell(folder, "ls -d *.part .*.part *.parts 2>/dev/null").out == "");
}

// The results of a sweep that was interrupted are files that every command reads.
BOOST_AUTO_TEST_CASE(what_an_interrupted_sweep_kept_are_results) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  // The last case takes long enough for the sweep to be killed while it works.
  const std::string cases = "sweep d.ini --vary contact.M=20,26 --vary grid.cells=64,1024 --quiet --keep --threads 1 ";
  const std::string program = EHL_PROGRAM;
  support::shell(folder,
                 "'" + program + "' " + cases +
                     "--output t.csv & while [ ! -e t.h5.parts ] || [ -z \"$(ls t.h5.parts)\" ]; do sleep 0.02; "
                     "done; kill -KILL $!; wait $!");
  const std::string kept = support::shell(folder, "ls t.h5.parts/*.h5 | head -n 1").out;
  BOOST_REQUIRE(!kept.empty());
  BOOST_REQUIRE(support::ehl(folder, "run d.ini --threads 1 --quiet --output one.h5").status == 0);
  BOOST_TEST(extracted(folder, kept.substr(0, kept.size() - 1) + " H") == extracted(folder, "one.h5 H"));
  // What a kill left half written is removed, and the sweep goes on.
  support::shell(folder, "printf half > t.h5.parts/.0123456789abcdef.h5.1.part");
  const std::string less = "sweep d.ini --vary contact.M=20,26 --vary grid.cells=64,128 --quiet --keep --output t.csv";
  BOOST_REQUIRE(support::ehl(folder, less + " --overwrite").status == 0);
  BOOST_TEST(extracted(folder, "t.h5 H --case 0") == extracted(folder, "one.h5 H"));
  BOOST_TEST(support::shell(folder, "ls -d t.h5.parts 2>/dev/null").out == "");
}

BOOST_AUTO_TEST_CASE(shards_are_merged_with_their_tables) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  BOOST_REQUIRE(support::ehl(folder, vary + "whole.csv").status == 0);
  for (const char* shard : {"1/3", "2/3", "3/3"})
    BOOST_REQUIRE(support::ehl(folder, vary + "t.csv --shard " + shard).status == 0);
  const support::Ended ended = support::ehl(folder, "sweep --merge t.1of3.csv t.2of3.csv t.3of3.csv --output t.csv");
  BOOST_TEST(contains(ended.out, "t.h5"), ended.out);
  for (int k = 0; k < 12; ++k) {
    const std::string H = " H --along x --case " + std::to_string(k);
    BOOST_TEST(extracted(folder, "whole.h5" + H) == extracted(folder, "t.h5" + H), "case " << k);
  }
  support::shell(folder, "rm t.2of3.h5");
  const support::Ended without =
      support::ehl(folder, "sweep --merge t.1of3.csv t.2of3.csv t.3of3.csv --output t.csv --overwrite");
  BOOST_TEST(without.status == 4);
  BOOST_TEST(without.says({"t.2of3.h5"}), without.err);
}

BOOST_AUTO_TEST_CASE(other_files_are_not_touched) {
  const support::TemporaryFolder folder;
  folder.write("d.ini", deck);
  BOOST_REQUIRE(support::ehl(folder, "run d.ini --quiet --output t.h5").status == 0);
  const support::Ended ended = support::ehl(folder, vary + "t.csv");
  BOOST_TEST(ended.status == 4);
  BOOST_TEST(ended.says({"t.h5"}), ended.err);
  BOOST_TEST(support::ehl(folder, "extract t.h5 Hc").status == 0);
  const support::Ended no_case = support::ehl(folder, "extract t.h5 Hc --case 0");
  BOOST_TEST(no_case.status != 0, no_case.err);
}

BOOST_AUTO_TEST_SUITE_END()
