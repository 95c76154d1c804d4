// Sweeps from end to end: the table, what ends one case, what ends all of them, and how a sweep is continued.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <sstream>

#include "support/json.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

namespace {

// This deck is solved within a tenth of a second.
const std::string small =
    "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\nz = 0.68\n[domain]\nx_inlet = -4.5\ny_half = 3\n"
    "[grid]\ncells = 64\n";

using support::contains;

using Row = support::NamedRow;

struct Scene {
  support::TemporaryFolder folder;
  Scene() { folder.write("d.ini", small); }
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }
  std::vector<Row> table(const std::string& name = "d_sweep.csv") const {
    return support::named_rows(folder.read(name));
  }
};

// Starts a sweep, waits until its table has `rows` complete rows, and sends a signal to it.
std::string cut_short(const std::string& arguments, int rows, const std::string& signal,
                      const std::string& table = "d_sweep.csv") {
  return std::string("'") + EHL_PROGRAM + "' " + arguments + " & pid=$!; for k in $(seq 500); do [ \"$(grep -c '\"$' " +
         table + ")\" -ge " + std::to_string(rows) + " ] 2>/dev/null && break; sleep 0.02; done; kill -" + signal +
         " $pid; wait $pid";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_sweep)

BOOST_AUTO_TEST_CASE(a_row_is_what_a_run_gives) {
  const Scene scene;
  const support::Ended ended = scene.ehl("sweep d.ini --vary contact.M=20,50 --vary contact.L=5,10 --threads 2");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err << scene.folder.read("d_sweep.csv"));
  BOOST_TEST(contains(ended.err, "4/4"));
  const std::vector<Row> rows = scene.table();
  BOOST_REQUIRE(rows.size() == 4u);
  BOOST_TEST((rows[0].at("contact.M") == "20" && rows[0].at("contact.L") == "5"));
  BOOST_TEST((rows[3].at("contact.M") == "50" && rows[3].at("contact.L") == "10"));
  const nlohmann::json json =
      support::parsed(scene.ehl("run d.ini --set contact.M=50 --set contact.L=10 --json --threads 1").out);
  for (const char* name : {"Hc", "Hm", "P_max", "residual", "load_error", "M", "L"}) {
    const double value = support::number_at(json, std::string("/") + name);
    BOOST_TEST(value == std::stod(rows[3].at(name)), name << " is " << value << " in a run");
  }
  BOOST_TEST((rows[3].at("nx") == "64" && rows[3].at("status") == "converged" && rows[3].at("exit_status") == "0"));
  BOOST_TEST(scene.ehl("sweep d.ini --vary contact.M=20 --output one.csv --quiet").err.empty());

  // With two grids, the adjoint error estimates decide which value is the best one.
  const std::string finer = " --set contact.M=20 --set grid.cells=128 --quiet";
  BOOST_TEST(scene.ehl("sweep d.ini --vary contact.L=10 --output two.csv" + finer).status == 0);
  const Row two = scene.table("two.csv")[0];
  const nlohmann::json run = support::parsed(scene.ehl("run d.ini --json --overwrite" + finer).out);
  for (const char* name : {"Hc_best", "error_Hc_best", "Hm_best", "error_Hm_best"}) {
    const double value = support::number_at(run, std::string("/") + name);
    BOOST_TEST((value > 0.0 && value == std::stod(two.at(name))), name << " is " << value << " in a run");
  }
}

// A row has no columns for a run in time or for stresses.
BOOST_AUTO_TEST_CASE(what_a_row_leaves_out_is_told) {
  const Scene scene;
  const auto told = [&](const std::string& asked, const std::string& section) {
    const support::Ended ended = scene.ehl("sweep d.ini --vary contact.M=20 --quiet --overwrite" + asked);
    BOOST_TEST(ended.status == 0, ended.err);
    const std::size_t at = ended.err.find(section);
    BOOST_REQUIRE_MESSAGE(at != std::string::npos, ended.err);
    const std::string said = ended.err.substr(at, ended.err.find('\n', at) - at);
    BOOST_TEST(contains(scene.folder.read("d_sweep.csv"), "# " + said), "the table does not say " << said);
  };
  told(" --set transient.end_time=1 --set transient.load_wave='0.1 2'", "[transient]");
  told(" --set subsurface.depth=1", "[subsurface]");
}

// If all cases are refused, the deck is wrong.
BOOST_AUTO_TEST_CASE(why_cases_are_refused_is_told) {
  const Scene scene;
  const support::Ended ended = scene.ehl("sweep d.ini --vary shear.tau_0=1e6,2e6 --quiet");
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(contains(ended.err, "shear.tau_0=1e6"), ended.err);
}

// One case is refused, one does not converge, one process is killed after two seconds of work: each has a row.
BOOST_AUTO_TEST_CASE(a_case_that_fails_is_a_row) {
  const Scene scene;
  const support::Ended ended =
      support::shell(scene.folder, std::string("ulimit -t 1; '") + EHL_PROGRAM +
                                       "' sweep d.ini --vary grid.cells=64,77,1024 --set multigrid.tolerance=1e-9");
  BOOST_TEST(ended.status == 3, ended.err);
  const std::vector<Row> rows = scene.table();
  BOOST_REQUIRE(rows.size() == 3u);
  BOOST_TEST(rows[0].at("status") == "converged");
  BOOST_TEST((rows[1].at("status") == "refused" && rows[1].at("exit_status") == "2"));
  BOOST_TEST(contains(rows[1].at("reason"), "cells = 77"), rows[1].at("reason"));
  BOOST_TEST((rows[2].at("status") == "failed" && std::stoi(rows[2].at("exit_status")) > 128));
  BOOST_TEST(contains(rows[2].at("reason"), "signal"), rows[2].at("reason"));

  const support::Ended few = scene.ehl(
      "sweep d.ini --vary multigrid.max_cycles=1,100 --set multigrid.tolerance=1e-13 --set multigrid.cycles=1 "
      "--output few.csv");
  BOOST_TEST(few.status == 3);
  const Row row = scene.table("few.csv")[0];
  BOOST_TEST((row.at("status") == "not-converged" && row.at("exit_status") == "3"));
  for (const char* name : {"Hc", "Hm", "P_max", "error_Hc", "error_Hm", "Hc_best", "error_Hm_best"})
    BOOST_TEST(row.at(name) == "NaN", name);
  BOOST_TEST(std::stod(row.at("residual")) > 1e-13);
  BOOST_TEST(row.at("reason").size() > 10);

  // Only the case whose process died is computed again.
  const support::Ended again = scene.ehl("sweep d.ini --vary grid.cells=64,77,1024 --set multigrid.tolerance=1e-9");
  BOOST_TEST(contains(again.out, "2 kept, 1 computed"), again.out);
  BOOST_TEST(scene.table()[2].at("status") == "converged");
}

BOOST_AUTO_TEST_CASE(a_sweep_cut_short_goes_on) {
  const std::string command = "sweep d.ini --vary contact.M=20:60:5 --vary contact.L=5,10 --set grid.cells=128";
  const Scene whole;
  BOOST_REQUIRE(whole.ehl(command).status == 0);
  BOOST_REQUIRE(whole.table().size() == 10u);
  struct End {
    std::string signal;
    int status;
  };
  for (const End& end : {End{"KILL", 137}, End{"TERM", 130}, End{"INT", 130}, End{"USR1", 130}}) {
    const Scene scene;
    const support::Ended cut = support::shell(scene.folder, cut_short(command, 3, end.signal));
    BOOST_TEST(cut.status == end.status, end.signal << ": " << cut.status << "\n" << cut.err);
    const std::size_t done = scene.table().size();
    BOOST_TEST_MESSAGE(end.signal << " after " << done << " of 10 rows");
    BOOST_TEST((done >= 3 && done < 10), end.signal << ": " << done << " rows");
    if (end.status == 130) BOOST_TEST(cut.says({std::to_string(done) + " of 10"}), cut.err);
    scene.folder.write("d_sweep.csv", scene.folder.read("d_sweep.csv") + "60,10,conv");  // an incomplete row
    const support::Ended rest = scene.ehl(command);
    BOOST_TEST(rest.status == 0, rest.err);
    const std::string counts = std::to_string(done) + " kept, " + std::to_string(10 - done) + " computed";
    BOOST_TEST(contains(rest.out, counts), rest.out);
    BOOST_TEST(scene.folder.read("d_sweep.csv") == whole.folder.read("d_sweep.csv"));
    BOOST_TEST(scene.folder.entries() == 2);  // no other files remain
  }
}

// Three jobs, of which the first is killed and repeated, the second is configured by the variables of a Slurm array:
// the merged table equals that of one run byte for byte.
BOOST_AUTO_TEST_CASE(shards_make_one_table) {
  const Scene scene;
  const std::string sweep = "sweep d.ini --vary contact.M,contact.L=20:5,30:10 --vary grid.cells=32,64,128 --quiet ";
  BOOST_REQUIRE(scene.ehl(sweep + "--output one.csv").status == 0);
  const std::string first = sweep + "--output t.csv --threads 1 --shard 1/3";
  BOOST_TEST(support::shell(scene.folder, cut_short(first, 1, "KILL", "t.1of3.csv")).status == 137);
  BOOST_TEST(scene.ehl("sweep --merge t.1of3.csv --output part.csv").status == 3);
  BOOST_TEST(scene.ehl(first).status == 0);
  const std::string array = "SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_ID=1 '";
  BOOST_TEST(support::shell(scene.folder, array + EHL_PROGRAM + "' " + sweep + "--output t.csv").status == 0);
  BOOST_TEST(scene.ehl(sweep + "--output t.csv --shard 3/3").status == 0);
  const support::Ended merged = scene.ehl("sweep --merge t.3of3.csv t.1of3.csv t.2of3.csv --output all.csv");
  BOOST_TEST(merged.status == 0, merged.err);
  BOOST_TEST(scene.folder.read("all.csv") == scene.folder.read("one.csv"));
  // A table that was merged without all parts can be continued as one run.
  BOOST_TEST(scene.ehl(sweep + "--output part.csv").status == 0);
  BOOST_TEST(scene.folder.read("part.csv") == scene.folder.read("one.csv"));
}

BOOST_AUTO_TEST_CASE(a_table_of_another_sweep_is_kept) {
  const Scene scene;
  const std::string command = "sweep d.ini --vary contact.M=20,50";
  BOOST_REQUIRE(scene.ehl(command).status == 0);
  const std::string before = scene.folder.read("d_sweep.csv");
  const auto refused = [&](const std::string& other, const std::string& part) {
    const support::Ended ended = scene.ehl(other);
    BOOST_TEST(ended.status == 4, other << " ends with " << ended.status);
    BOOST_TEST(ended.says({"d_sweep.csv", part}), ended.err);
    BOOST_TEST(scene.folder.read("d_sweep.csv") == before, other);
  };
  refused("sweep d.ini --vary contact.M=20,100", "vary: contact.M = 20,100");
  refused(command + " --set contact.L=5", "set: contact.L=5");
  scene.folder.write("d.ini", small + "# a comment\n");
  refused(command, "d_sweep.csv");
  BOOST_TEST(scene.ehl(command + " --overwrite").status == 0);
  BOOST_TEST(scene.folder.read("d_sweep.csv") != before);
  scene.folder.write("d_sweep.csv", "precious");
  BOOST_TEST(scene.ehl(command).status == 4);
  BOOST_TEST(scene.folder.read("d_sweep.csv") == "precious");
}

BOOST_AUTO_TEST_CASE(wrong_command_lines) {
  const Scene scene;
  for (const std::string line :
       {"d.ini", "d.ini --vary contact.MM=2,5", "d.ini --vary contact.M=2,-5",
        "d.ini --vary contact.M=2 --set contact.M=5", "d.ini --vary contact.M=2 --output t.h5",
        "d.ini --vary contact.M=2 --threads 0", "none.ini --vary contact.M=2", "d.ini --vary contact.M=2 --shard 3/2",
        "d.ini --cases d.ini", "--merge d.ini", "--merge d.ini --vary contact.M=2 --output t.csv"}) {
    const support::Ended ended = scene.ehl("sweep " + line);
    BOOST_TEST(ended.status == 2, line << " ends with " << ended.status);
    BOOST_TEST(!ended.err.empty(), line);
  }
  BOOST_TEST(scene.folder.entries() == 1);
  BOOST_TEST(scene.ehl("sweep d.ini --vary contact.M=2 --output none/t.csv").status == 4);
}

BOOST_AUTO_TEST_CASE(the_map_is_drawn) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("sweep d.ini --vary contact.M=20,50 --vary contact.L=5,10").status == 0);
  const support::Ended drawn = scene.ehl("plot d_sweep.csv --format svg");
  BOOST_TEST(drawn.status == 0, drawn.err);
  BOOST_TEST(contains(scene.folder.read("d_sweep_stability_map.svg"), "<svg"));
  const support::Ended other = scene.ehl("plot d_sweep.csv --figure centre_lines");
  BOOST_TEST(other.status == 2);
  scene.folder.write("x.csv", "a,b\n");
  BOOST_TEST(scene.ehl("plot x.csv").status == 4);
}

BOOST_AUTO_TEST_SUITE_END()
