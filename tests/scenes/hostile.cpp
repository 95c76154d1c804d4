// Hostile surroundings of a run: outputs that cannot be written, names that are commands, files that are pipes.
#include <boost/test/unit_test.hpp>
#include <filesystem>

#include "support/program.hpp"
#include "support/text.hpp"

namespace {

using support::contains;

// This deck is solved within a tenth of a second.
const std::string small =
    "[case]\ntitle = small\n[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\nz = 0.68\n[domain]\nx_inlet = "
    "-4.5\ny_half = 3\n[grid]\ncells = 64\n";
const std::string program = std::string("'") + EHL_PROGRAM + "' ";

struct Scene {
  support::TemporaryFolder folder;
  Scene() { folder.write("d.ini", small); }
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }
  support::Ended shell(const std::string& line) const { return support::shell(folder, line); }
  bool there(const std::string& name) const { return std::filesystem::exists(folder / name); }
  // The command is refused with this status and message, and changes no file.
  void refused(const std::string& arguments, int status, const std::vector<std::string>& parts) const {
    const int before = folder.entries();
    const support::Ended ended = ehl(arguments);
    BOOST_TEST(ended.status == status, arguments << " ends with " << ended.status << "\n" << ended.err);
    BOOST_TEST(ended.says(parts), arguments << " says\n" << ended.err);
    BOOST_TEST(folder.entries() == before);
  }
};

const bool gnuplot_is_there = std::system("command -v gnuplot >/dev/null") == 0;

}  // namespace

BOOST_AUTO_TEST_SUITE(test_hostile)

BOOST_AUTO_TEST_CASE(a_result_is_kept_where_nothing_can_be_printed) {
  const Scene scene;
  BOOST_TEST(scene.shell(program + "run d.ini --quiet --output full.h5 >/dev/full").status == 4);
  BOOST_TEST(scene.shell(program + "run d.ini --quiet --output closed.h5 >&-").status == 4);
  scene.shell(program + "run d.ini --output pipe.h5 2>&1 | true");
  for (const char* name : {"full", "closed", "pipe"}) {
    const support::Ended ended = scene.ehl(std::string("extract ") + name + ".h5 converged");
    BOOST_TEST(contains(ended.out, "\n1\n"), name << ".h5: " << ended.err);
  }
}

// If standard error is closed, the table must not get its descriptor and receive the messages.
BOOST_AUTO_TEST_CASE(closed_descriptors_are_no_files) {
  const Scene scene;
  scene.shell(program + "sweep d.ini --vary contact.M=20,30 --output s.csv >&- 2>&- <&-");
  BOOST_TEST(!contains(scene.folder.read("s.csv"), "ehl: "), scene.folder.read("s.csv"));
  BOOST_TEST(support::named_rows(scene.folder.read("s.csv")).size() == 2u);
}

BOOST_AUTO_TEST_CASE(what_is_read_is_not_overwritten) {
  const Scene scene;
  const std::string swinging = small + "[transient]\nend_time = 0.2\nload = swing.csv\n";
  scene.folder.write("t.ini", swinging);
  scene.folder.write("swing.csv", "0, 1\n1, 1.1\n");
  scene.refused("run d.ini --overwrite --output d.ini", 4, {"d.ini"});
  scene.refused("run t.ini --overwrite --output swing.csv", 4, {"swing.csv"});
  scene.refused("sweep t.ini --vary contact.M=20,30 --overwrite --output swing.csv", 4, {"swing.csv"});
  scene.refused("study t.ini --overwrite --output swing.csv", 4, {"swing.csv"});
  scene.shell("ln -s swing.csv other.csv");
  scene.refused("run t.ini --overwrite --output other.csv", 4, {"other.csv"});
  BOOST_TEST(scene.folder.read("d.ini") == small);
  BOOST_TEST(scene.folder.read("swing.csv") == "0, 1\n1, 1.1\n");
}

BOOST_AUTO_TEST_CASE(names_in_a_table_are_no_commands) {
  if (!gnuplot_is_there) return;
  const Scene scene;
  const std::string evil = "x';touch${IFS}pwned;'";
  scene.folder.write("s.csv", "# ehl sweep, table 1\n# deck: d.ini\n# vary: " + evil +
                                  " = 1\nmotion.srr,status,mu,Hc\n" +
                                  "0.1,converged,0.01,0.2\n0.2,converged,0.02,0.2\n");
  scene.ehl("plot s.csv --figure traction_curve");
  std::string time = "# ehl study in time, table 1\n# title: t\n# reference error Hc: 1e-5\n";
  time += "# reference error " + evil + ": 1e-5\n# reference: r\n# times: t\n# machine: m\n";
  time += "rtol,steps,seconds,status,error_Hc\n1e-3,20,1,complete,1e-3\n1e-4,30,2,complete,1e-4\n";
  scene.folder.write("t.csv", time);
  scene.ehl("plot t.csv --figure time_precision");
  BOOST_TEST(!scene.there("pwned"));
}

BOOST_AUTO_TEST_CASE(names_of_files_and_titles_are_no_commands) {
  if (!gnuplot_is_there) return;
  const Scene scene;
  scene.shell("mkdir \"it's\"");
  const auto draws = [&](const std::string& name) {
    const support::Ended made =
        scene.ehl("run d.ini --quiet --output \"" + name + ".h5\" --set \"case.title='a' `b`\"");
    BOOST_TEST(made.status == 0, made.err);
    const support::Ended drawn = scene.ehl("plot \"" + name + ".h5\" --figure centre_lines");
    BOOST_TEST(drawn.status == 0, name << ": " << drawn.err);
    BOOST_TEST(scene.there(name + "_centre_lines.png"), name);
  };
  draws("|touch pwned");
  draws("< cat");
  draws("it's/r");
  BOOST_TEST(!scene.there("pwned_centre_lines.png"));
}

// A program that is stopped ends the processes that it started.
BOOST_AUTO_TEST_CASE(plot_ends_with_its_gnuplot) {
  if (!gnuplot_is_there) return;
  const Scene scene;
  scene.shell("mkdir scripts");
  scene.folder.write("scripts/slow.gp",
                     "# figure: slow\n# needs: /fields/P\nsystem(\"echo $PPID > gnuplot; sleep 20\")\n");
  BOOST_TEST_REQUIRE(scene.ehl("run d.ini --quiet").status == 0);
  for (const char* signal : {"INT", "KILL"}) {
    const support::Ended ended = scene.shell(
        "rm -f gnuplot; export EHL_POSTPROCESS=scripts; " + program +
        "plot d.h5 & p=$!; while ! test -s gnuplot; do sleep 0.05; done; kill -" + signal +
        " $p; wait $p; echo ended with $?; sleep 0.2; grep -q 'State:.[^Z]' /proc/$(cat gnuplot)/status && echo alive");
    BOOST_TEST(contains(ended.out, signal == std::string("INT") ? "ended with 130" : "ended with 137"), ended.out);
    BOOST_TEST(!contains(ended.out, "alive"), signal << ": gnuplot goes on");
  }
}

BOOST_AUTO_TEST_CASE(pipes_and_broken_files_are_refused) {
  const Scene scene;
  scene.folder.write("t.ini", small + "[transient]\nend_time = 0.2\nload = pipe.csv\n");
  scene.shell("mkfifo pipe.ini pipe.csv pipe.h5");
  const auto refused = [&](const std::string& arguments, int status, const std::string& file) {
    const support::Ended ended = scene.shell("timeout 5 " + program + arguments);
    BOOST_TEST(ended.status == status, arguments << " ends with " << ended.status);
    BOOST_TEST(ended.says({file}), ended.err);
  };
  refused("check pipe.ini", 2, "pipe.ini");
  refused("check t.ini", 4, "pipe.csv");
  refused("extract pipe.h5 P", 4, "pipe.h5");
  refused("plot pipe.csv", 4, "pipe.csv");
  // A file that can be opened but not read must not count as an empty table.
  scene.shell("rm pipe.csv && ln -s /proc/self/mem pipe.csv");
  refused("check t.ini", 4, "pipe.csv");
}

BOOST_AUTO_TEST_CASE(names_and_texts_that_are_no_text) {
  const Scene scene;
  scene.folder.write("a\nb.ini", small);
  scene.folder.write("latin.ini", "[case]\ntitle = \xD6l\n" + small.substr(small.find("[contact]")));
  scene.refused("check \"$(printf 'a\\nb.ini')\"", 2, {"a\\x0ab.ini"});
  scene.refused("run latin.ini", 2, {"latin.ini:2: [case] title"});
  scene.refused("run d.ini --output \"$(printf '\\326l.h5')\"", 2, {"--output"});
}

BOOST_AUTO_TEST_CASE(a_flood_of_slips_is_cut) {
  const Scene scene;
  std::string deck;
  for (int k = 0; k < 90000; ++k) deck += "[s" + std::to_string(k) + "]\n";
  scene.folder.write("f.ini", deck);
  const support::Ended ended = scene.ehl("check f.ini");
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.says({"f.ini:1: [s0]", "f.ini: 89980 "}));
  BOOST_TEST(ended.err.size() < 10000u);
}

BOOST_AUTO_TEST_CASE(the_process_has_its_name) {
  const Scene scene;
  const std::string line = program + "run d.ini --set grid.cells=1024 --quiet & p=$!; " +
                           support::until_it_handles_signals + "cat /proc/$p/comm; kill -9 $p";
  BOOST_TEST(scene.shell(line).out == "ehl\n");
}

// A table whose meaning is ambiguous is refused.
BOOST_AUTO_TEST_CASE(schedules_and_tables_mean_what_they_say) {
  const Scene scene;
  scene.folder.write("t.ini", small + "[transient]\nend_time = 0.2\nload = swing.csv\n");
  const auto load = [&](const std::string& text) {
    scene.folder.write("swing.csv", text);
    return scene.ehl("check t.ini");
  };
  BOOST_TEST(load("time; load\n0; 1\n1; 1.1\n").status == 0);
  BOOST_TEST(load("\xEF\xBB\xBF"
                  "0, 1\n1, 1.1\n")
                 .status == 0);
  // If the first row were skipped, the load would begin at 1.3.
  const support::Ended mark = scene.ehl("run t.ini --quiet --output a.h5");
  BOOST_TEST(mark.status == 0, mark.err);
  BOOST_TEST(contains(scene.ehl("extract a.h5 /transient/load").out, "\n1\n"));
  // Decimal commas, trailing separators and milliseconds are understood.
  BOOST_TEST(load("0;1,0\n1;1,1\n2;1,2\n").status == 0);
  BOOST_TEST(load("0;1;\n1;1.1;\n").status == 0);
  BOOST_TEST(load("t [a/u_m];load [%]\n0;100\n1;110\n").status == 0);
  scene.refused("check t.ini --set transient.time_unit=seconds", 2, {"time_unit = seconds"});
  for (const char* wrong : {"0, 1.O\n1, 1.1\n2, 1.2\n", "O, 1\n1, 1.1\n2, 1.2\n", "0,1,0\n1,1,1\n",
                            "t [ms], load\n0,1\n1,1.1\n", "t, load [N]\n0,1\n1,1.1\n", "t, speed\n0,1\n1,1.1\n"}) {
    const support::Ended ended = load(wrong);
    BOOST_TEST(ended.status == 2, wrong << " ends with " << ended.status);
    BOOST_TEST(ended.says({"[transient] load = swing.csv: swing.csv:1"}), wrong << ended.err);
  }
  const std::string oil =
      small.substr(0, small.find("alpha")) + "viscosity = table\ntable = oil.csv\n[grid]\ncells = 64\n";
  scene.folder.write("o.ini", oil);
  scene.folder.write("oil.csv", "0;0,01\n1e8;0.1\n1e9;5\n2e9;50\n");
  scene.refused("check o.ini", 4, {"oil.csv:1", "oil.csv:2"});
  scene.folder.write("oil.csv", "0,0.01,800,7\n1e8,0.1,820,7\n1e9,5,900,7\n2e9,50,950,7\n");
  scene.refused("check o.ini", 2, {"oil.csv:1"});
}

// A deck with a changed table is another case.
BOOST_AUTO_TEST_CASE(files_belong_to_the_identity) {
  const Scene scene;
  scene.folder.write("t.ini", small.substr(0, small.find("alpha")) + "viscosity = table\ntable = oil.csv\n" +
                                  "[domain]\nx_inlet = -4.5\ny_half = 3\n[grid]\ncells = 32\n");
  scene.folder.write("oil.csv", "0,0.01\n1e8,0.1\n1e9,5\n2e9,50\n");
  const std::string sweep = "sweep t.ini --quiet --vary contact.M=20,30 --output s.csv";
  scene.ehl(sweep);
  BOOST_TEST(scene.ehl(sweep).status == scene.ehl(sweep).status);
  scene.folder.write("oil.csv", "0,0.01\n1e8,0.2\n1e9,5\n2e9,50\n");
  const support::Ended other = scene.ehl(sweep);
  BOOST_TEST(other.status == 4);
  BOOST_TEST(other.says({"oil.csv"}), other.err);
}

BOOST_AUTO_TEST_SUITE_END()
