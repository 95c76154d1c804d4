// All commands from end to end: what they print, which files they leave, how they end.
#include <hdf5.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "support/json.hpp"
#include "support/program.hpp"
#include "support/text.hpp"

namespace {

// This deck is solved within a tenth of a second.
const std::string small =
    "[case]\ntitle = small\n[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\nz = 0.68\n[domain]\nx_inlet = "
    "-4.5\ny_half = 3\n[grid]\ncells = 64\n";

using support::contains;

struct Scene {
  support::TemporaryFolder folder;
  Scene() { folder.write("d.ini", small); }
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(test_commands)

BOOST_AUTO_TEST_CASE(run_prints_a_table_and_writes_a_result) {
  const Scene scene;
  const support::Ended ended = scene.ehl("run d.ini");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  for (const char* part : {"65 x 65", "d.h5"})
    BOOST_TEST(contains(ended.out, part), part << " is missing in\n" << ended.out);
  BOOST_TEST(!contains(ended.out, "nan"));
  BOOST_TEST(!ended.err.empty());           // the progress
  BOOST_TEST(scene.folder.entries() == 3);  // the deck, d.h5 and d.xmf
  BOOST_TEST(scene.ehl("run d.ini --overwrite --quiet").err.empty());
}

BOOST_AUTO_TEST_CASE(json_is_json_and_nothing_else) {
  const Scene scene;
  const support::Ended ended = scene.ehl("run d.ini --json --output sub.h5");
  BOOST_TEST(ended.status == 0);
  BOOST_TEST(support::is_json(ended.out), ended.out);
  BOOST_TEST(contains(ended.out, "\"converged\":true"));
}

// The number of coarsenings refers to the finest grid: six fit 64 cells, although they do not fit
// the first grid of 32 cells.
BOOST_AUTO_TEST_CASE(coarsenings_fit_the_finest_grid) {
  const Scene scene;
  const support::Ended most = scene.ehl("run d.ini --set deformation.coarsenings=6");
  BOOST_TEST(most.status == 0, most.err);
  BOOST_TEST(contains(most.out, "6 coarsenings"), most.out);
}

BOOST_AUTO_TEST_CASE(an_existing_result_is_kept) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run d.ini --quiet").status == 0);
  const std::string precious = scene.folder.read("d.h5");
  const support::Ended ended = scene.ehl("run d.ini");
  BOOST_TEST(ended.status == 4);
  BOOST_TEST(ended.says({"d.h5"}), ended.err);
  BOOST_TEST((scene.folder.read("d.h5") == precious));
  BOOST_TEST(std::ranges::count(ended.err, '\n') == 1, ended.err);  // refused before the computation: no progress
}

// The deck in the result is valid, even if a choice makes other keys unused.
BOOST_AUTO_TEST_CASE(the_deck_in_the_result_is_a_deck) {
  const Scene scene;
  scene.folder.write("e.ini",
                     "[contact]\nM = 20\nL = 10\n[lubricant]\nviscosity = barus\nalpha = 2e-8\n[grid]\ncells = "
                     "64\n[domain]\nx_inlet = -4.5\n[continuation]\npath = off\n[deformation]\nmethod = fft\n");
  BOOST_REQUIRE(scene.ehl("run e.ini").status == 0);
  scene.folder.write("own.ini", scene.ehl("extract e.h5 deck").out);
  const support::Ended own = scene.ehl("check own.ini");
  BOOST_TEST(own.status == 0, own.err);
}

// Reference: (20,10), Roelands z = 0.68, upstream2, n = 64, fully converged: Hc = 0.4195678, Hm = 0.2866922.
BOOST_AUTO_TEST_CASE(the_result_holds_the_published_film) {
  const Scene scene;
  const support::Ended ended = scene.ehl(
      "run d.ini --set deformation.method=fft --set multigrid.tolerance=1e-10 --set discretization.wedge=upstream2 "
      "--set domain.far_field=zero");
  BOOST_REQUIRE_MESSAGE(ended.status == 0, ended.err);
  const auto value = [&](const std::string& name) {
    const support::Ended extracted = scene.ehl("extract d.h5 " + name);
    return std::stod(extracted.out.substr(extracted.out.find('\n')));
  };
  BOOST_TEST_MESSAGE("Hc " << value("Hc") << " (0.4195678), Hm " << value("Hm") << " (0.2866922)");
  BOOST_TEST(value("Hc") == 0.4195678, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(value("Hm") == 0.2866922, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(value("converged") == 1.0);
}

// The deck in a result gives the same result with any number of threads: for a grid that was given, for one found for
// an accuracy, and for a slender ellipse, whose domain is narrower than that of a circle.
BOOST_AUTO_TEST_CASE(the_deck_in_a_result_gives_the_same_result) {
  const Scene scene;
  const std::string slender =
      "[contact]\nM = 27\nL = 14\nradius_ratio = 3.3\n[lubricant]\nalpha = 2.2e-8\nz = 0.68\n"
      "[grid]\ncells = 128\n[motion]\nangle = ";
  for (const char* angle : {"0", "30", "90"}) scene.folder.write(std::string("s") + angle + ".ini", slender + angle);
  for (const char* deck :
       {"d.ini", "d.ini --unset grid.cells --set grid.accuracy=0.02", "s0.ini", "s30.ini", "s90.ini"}) {
    const support::Ended first =
        scene.ehl(std::string("run ") + deck + " --quiet --overwrite --output one.h5 --threads 1");
    BOOST_REQUIRE_MESSAGE(first.status == 0, deck << ": " << first.err);
    scene.folder.write("again.ini", scene.ehl("extract one.h5 deck").out);
    const support::Ended again = scene.ehl("run again.ini --quiet --overwrite --output two.h5 --threads 2");
    BOOST_REQUIRE_MESSAGE(again.status == 0, deck << ": " << again.err);
    for (const char* field : {"P", "H"}) {
      const auto values = [&](const std::string& file) {
        const std::string out = scene.ehl("extract " + file + " " + field).out;
        return out.substr(out.find('\n'));
      };
      BOOST_TEST((values("one.h5") == values("two.h5")), deck << ": " << field << " differs");
    }
  }
}

BOOST_AUTO_TEST_CASE(not_converged) {
  const Scene scene;
  const std::string few = " --set multigrid.tolerance=1e-13 --set multigrid.max_cycles=1 --set multigrid.cycles=1";
  const support::Ended ended = scene.ehl("run d.ini" + few);
  BOOST_TEST(ended.status == 3);
  BOOST_TEST(contains(scene.ehl("extract d.h5 converged").out, "\n0\n"));
  const support::Ended json = scene.ehl("run d.ini --json --overwrite" + few);
  BOOST_TEST(json.status == 3);
  BOOST_TEST(support::is_json(json.out));
  BOOST_TEST(contains(json.out, "\"converged\":false"));
}

// The run is long enough to be interrupted; the shell sends the signal of Ctrl-C.
BOOST_AUTO_TEST_CASE(interrupted) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run d.ini --quiet").status == 0);
  const std::string old = scene.folder.read("d.h5");
  const std::string slow = std::string("'") + EHL_PROGRAM +
                           "' run d.ini --overwrite --set grid.cells=1024 --set multigrid.tolerance=1e-13 & p=$!; " +
                           support::until_it_handles_signals + "kill -TERM $p; wait $p";
  const support::Ended ended = support::shell(scene.folder, slow);
  BOOST_TEST(ended.status == 130, ended.status << "\n" << ended.err);
  BOOST_TEST((scene.folder.read("d.h5") == old));
  BOOST_TEST(scene.folder.entries() == 3);  // with the deck and the .xmf
}

BOOST_AUTO_TEST_CASE(files_that_cannot_be_written) {
  const Scene scene;
  for (const char* output : {"none/r.h5", ".", "/dev/null", "/proc/r.h5"}) {
    const support::Ended ended = scene.ehl(std::string("run d.ini --overwrite --output ") + output);
    BOOST_TEST(ended.status == 4, output << " ends with " << ended.status);
    BOOST_TEST(ended.says({output}), ended.err);
  }
  // A limit of 10 kB on the size of files acts like a full disk, which is noticed only when the result is written.
  const support::Ended full =
      support::shell(scene.folder, std::string("ulimit -f 10; '") + EHL_PROGRAM + "' run d.ini");
  BOOST_TEST(full.status == 4, full.err);
  BOOST_TEST(full.says({"d.h5"}), full.err);
  BOOST_TEST(scene.folder.entries() == 1);  // no incomplete file

  const support::Ended pipe = support::shell(scene.folder, std::string("'") + EHL_PROGRAM + "' keys >/dev/full");
  BOOST_TEST(pipe.status == 4, pipe.err);
}

BOOST_AUTO_TEST_CASE(files_that_are_no_results) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run d.ini").status == 0);
  const std::string whole = scene.folder.read("d.h5");
  scene.folder.write("cut.h5", whole.substr(0, whole.size() / 2));
  scene.folder.write("text.h5", "hello");
  H5Fclose(H5Fcreate((scene.folder / "foreign.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  for (const char* name : {"cut.h5", "text.h5", "foreign.h5", "missing.h5", "."})
    for (const std::string command : {"extract ", "plot "}) {
      const support::Ended ended = scene.ehl(command + name + (command == "plot " ? "" : " P"));
      BOOST_TEST(ended.status == 4, command << name << " ends with " << ended.status);
      BOOST_TEST(ended.says({name}), ended.err);
    }
  // Damage to the numbers or the headers: the program may do anything but crash.
  for (std::size_t at = 0; at < whole.size(); at += whole.size() / 60) {
    std::string damaged = whole;
    for (std::size_t k = at; k < std::min(at + 24, whole.size()); ++k) damaged[k] = '\xff';
    scene.folder.write("damaged.h5", damaged);
    for (const char* dataset : {"P", "levels", "deck"}) {
      const support::Ended ended = scene.ehl(std::string("extract damaged.h5 ") + dataset);
      BOOST_TEST((ended.status == 0 || ended.status == 2 || ended.status == 4),
                 "damaged at " << at << ", " << dataset << ": " << ended.status << "\n"
                               << ended.err);
    }
  }
}

BOOST_AUTO_TEST_CASE(extract) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run d.ini").status == 0);
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  const std::string whole = scene.ehl("extract d.h5 P").out;
  BOOST_TEST(lines(whole) == 3 + 65 * 65 + 64);  // heading, nodes, blank lines between scans
  BOOST_TEST(contains(whole, "\n# x y P\n-4.5 -3 0.000"));
  const std::string line = scene.ehl("extract d.h5 H --along y --at x=0.7").out;
  BOOST_TEST(contains(line, "# along y at x = 0.65625\n# y H\n-3 "), line.substr(0, 300));  // the nearest grid line
  BOOST_TEST(lines(line) == 4 + 65);
  BOOST_TEST(scene.ehl("extract d.h5 H --along x").out == scene.ehl("extract d.h5 H --at y=0").out);
  BOOST_TEST(lines(scene.ehl("extract d.h5 H --matrix").out) == 3 + 66);
  BOOST_TEST(contains(scene.ehl("extract d.h5 levels").out, "\n# level nx ny Hc Hm "));
  BOOST_TEST(contains(scene.ehl("extract d.h5 scales").out, "\nM 20 "));
  BOOST_TEST(contains(scene.ehl("extract d.h5 /provenance/threads").out, "2"));
  for (const char* wrong :
       {"Q", "P --along z", "P --along x --at x=0", "P --at y=9", "levels --along x", "P --matrix --along x"})
    BOOST_TEST(scene.ehl(std::string("extract d.h5 ") + wrong).status == 2, wrong);
}

BOOST_AUTO_TEST_CASE(plot) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run d.ini").status == 0);
  const support::Ended one = scene.ehl("plot d.h5 --figure centre_lines --format svg");
  BOOST_TEST(one.status == 0, one.err);
  BOOST_TEST(contains(scene.folder.read("d_centre_lines.svg"), "<svg"));
  const support::Ended nothing = scene.ehl("plot d.h5 --figure roughness");
  BOOST_TEST(nothing.status == 2);
  BOOST_TEST(nothing.says({"roughness", "/fields/S"}), nothing.err);
  const support::Ended unknown = scene.ehl("plot d.h5 --figure centre_line");
  BOOST_TEST(unknown.status == 2);
  BOOST_TEST(unknown.says({"centre_lines", "interferogram"}), unknown.err);
  BOOST_TEST(scene.ehl("plot d.h5 --format jpeg").status == 2);
  const support::Ended without =
      support::shell(scene.folder, std::string("PATH=/none '") + EHL_PROGRAM + "' plot d.h5");
  BOOST_TEST(without.status == 4, without.err);
}

BOOST_AUTO_TEST_CASE(keys_and_check) {
  const Scene scene;
  scene.folder.write("own.ini", scene.ehl("keys --deck").out);
  const support::Ended own = scene.ehl("check own.ini");
  BOOST_TEST(own.status == 0, own.err);
  BOOST_TEST(contains(own.out, "M = 50, L = 10"));
  BOOST_TEST(contains(own.out, "alpha_bar = 13.42"));
  // Mourier et al. 2006: the groups of this deck.
  const std::string mourier =
      support::ehl(scene.folder, std::string("check '") + EHL_INPUTS + "/mourier2006_smooth.ini'").out;
  for (const char* part : {"M = 63.78", "L = 5.788", "z = 0.5205"}) BOOST_TEST(contains(mourier, part), mourier);
  for (const auto& entry : std::filesystem::directory_iterator(EHL_INPUTS))
    if (entry.path().extension() == ".ini") {
      const support::Ended ended = scene.ehl("check '" + entry.path().string() + "'");
      BOOST_TEST(ended.status == 0, ended.err);
    }
  for (const char* help : {"help", "--help", "run --help", "help plot", "version"}) {
    const support::Ended ended = scene.ehl(help);
    BOOST_TEST(ended.status == 0, help);
    BOOST_TEST(!ended.out.empty(), help);
  }
}

BOOST_AUTO_TEST_SUITE_END()
