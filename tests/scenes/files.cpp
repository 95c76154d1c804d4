// A command never writes to a file that it reads, and never replaces a file that it did not write.
#include <boost/test/unit_test.hpp>
#include <string>

#include "support/program.hpp"
#include "support/text.hpp"

namespace {

const std::string small =
    "[contact]\nM = 20\nL = 5\n[lubricant]\nalpha = 2.2e-8\n[grid]\ncells = 32\n[multigrid]\ncycles = 2\n";

struct Scene {
  support::TemporaryFolder folder;
  Scene() { folder.write("d.ini", small); }
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }
  // The command ends with status 4, and the file `name` is unchanged.
  void keeps(const std::string& name, const std::string& arguments) const {
    const std::string before = folder.read(name);
    const int files = folder.entries();
    const support::Ended ended = ehl(arguments);
    BOOST_TEST(ended.status == 4, arguments << " ends with " << ended.status << "\n" << ended.err);
    BOOST_TEST(!ended.err.empty(), arguments);
    BOOST_TEST((folder.read(name) == before), arguments << " changed " << name);
    BOOST_TEST(folder.entries() == files, arguments);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(test_files)

BOOST_AUTO_TEST_CASE(a_sweep_keeps_its_inputs) {
  const Scene scene;
  // This holds even for a table of cases that looks like a table of this program.
  scene.folder.write("c.csv", "# ehl sweep, table 1\ncontact.M\n20\n30\n");
  scene.keeps("c.csv", "sweep d.ini --cases c.csv --output c.csv --overwrite --quiet");
  scene.keeps("c.csv", "sweep d.ini --cases c.csv --output c.csv --quiet");
  support::shell(scene.folder, "ln c.csv hard.csv; ln -s c.csv soft.csv");
  scene.keeps("c.csv", "sweep d.ini --cases c.csv --output hard.csv --overwrite --quiet");
  scene.keeps("c.csv", "sweep d.ini --cases c.csv --output soft.csv --overwrite --quiet");
  // The kept results would be written to map.h5, which the deck reads.
  BOOST_REQUIRE(scene.ehl("run d.ini --quiet --output map.h5").status == 0);
  scene.folder.write("rough.ini",
                     small + "[surface1]\nshape = map\nfile = map.h5\ndataset = /fields/H\nunit = 1e-3\ndx = 0.2\n");
  const std::string sweep = "sweep rough.ini --vary contact.M=20,30 --quiet --overwrite ";
  scene.keeps("map.h5", sweep + "--keep --output map.csv");
  // A file that is no table of this program, or stands where its folder would, is not replaced.
  scene.folder.write("notes.csv", "precious, 1\n");
  scene.keeps("notes.csv", "sweep d.ini --vary contact.M=20,30 --quiet --overwrite --output notes.csv");
  scene.keeps("notes.csv", "study d.ini --quiet --overwrite --output notes.csv");
  scene.folder.write("t.h5.parts", "precious");
  scene.keeps("t.h5.parts", "sweep d.ini --vary contact.M=20,30 --quiet --keep --output t.csv");
  // The result of a single run is not a file of kept results.
  BOOST_REQUIRE(scene.ehl("run d.ini --quiet --output r.h5").status == 0);
  scene.keeps("r.h5", "sweep d.ini --vary contact.M=20,30 --quiet --keep --overwrite --output r.csv");
}

BOOST_AUTO_TEST_CASE(results_and_pages_keep_what_is_none) {
  const Scene scene;
  scene.folder.write("f.h5", "precious");
  scene.folder.write("g.xmf", "precious");
  scene.folder.write("p.html", "<!DOCTYPE html>\nprecious");
  scene.keeps("f.h5", "run d.ini --quiet --overwrite --output f.h5");
  scene.keeps("g.xmf", "run d.ini --quiet --overwrite --output g.h5");
  BOOST_REQUIRE(scene.ehl("run d.ini --quiet --output r.h5").status == 0);
  BOOST_TEST(scene.ehl("run d.ini --quiet --overwrite --output r.h5").status == 0);
  scene.keeps("p.html", "report r.h5 --overwrite --output p.html");
}

// The key says that its value is a file, whatever the ending: a result records it, and a sweep notices another one.
BOOST_AUTO_TEST_CASE(every_file_that_a_deck_names_is_known) {
  const Scene scene;
  std::string heights;
  for (int row = 0; row < 8; ++row) heights += "0 1 0 2 0 1 0 " + std::to_string(row) + "\n";
  const std::string map = small + "[surface1]\nshape = map\nat_rest = yes\nunit = 1e-4\ndx = 0.5\nfile = ";
  const std::string timed = small + "[transient]\nend_time = 0.1\nrtol = 1e-1\noutput_interval = 0.1\nload = ";
  struct Named {
    std::string file, content, deck;
  };
  const Named all[] = {{"m.txt", heights, map}, {"m.asc", heights, map}, {"w.schedule", "0 1\n0.1 1.01\n", timed}};
  for (const Named& one : all) {
    scene.folder.write(one.file, one.content);
    scene.folder.write("n.ini", one.deck + one.file + "\n");
    BOOST_TEST(scene.ehl("run n.ini --quiet --overwrite").status == 0, one.file);
    const std::string recorded = scene.ehl("extract n.h5 files").out;
    BOOST_TEST(support::contains(recorded, one.file + ": " + std::to_string(one.content.size()) + " bytes"), recorded);
    const std::string sweep = "sweep n.ini --vary contact.L=5,6 --quiet --output " + one.file + ".csv";
    BOOST_TEST(scene.ehl(sweep).status == 0, one.file);
    scene.folder.write(one.file, "# again\n" + one.content);
    const support::Ended changed = scene.ehl(sweep);
    BOOST_TEST(changed.status == 4, one.file << " changed, and the sweep ends with " << changed.status);
    BOOST_TEST(changed.says({one.file}), changed.err);
  }
}

BOOST_AUTO_TEST_CASE(pictures_keep_what_is_none) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run d.ini --quiet --output r.h5").status == 0);
  scene.folder.write("p.png", "precious");
  scene.keeps("p.png", "plot r.h5 --figure centre_lines --output p.png");
  support::shell(scene.folder, "ln r.h5 r.svg");
  scene.keeps("r.h5", "plot r.h5 --figure centre_lines --output r.svg");
}

BOOST_AUTO_TEST_CASE(a_merge_keeps_its_parts_and_other_results) {
  const Scene scene;
  for (const char* part : {"1/2", "2/2"})
    BOOST_REQUIRE(
        scene.ehl(std::string("sweep d.ini --vary contact.M=20,30 --quiet --keep --output t.csv --shard ") + part)
            .status == 0);
  const std::string merge = "sweep --merge t.1of2.csv t.2of2.csv --output ";
  scene.keeps("t.1of2.csv", merge + "t.1of2.csv --overwrite");
  // The kept results of the whole sweep would replace another file, without being asked to.
  BOOST_REQUIRE(scene.ehl("run d.ini --quiet --output w.h5").status == 0);
  scene.keeps("w.h5", merge + "w.csv --overwrite");
  BOOST_TEST(scene.ehl(merge + "t.csv").status == 0);
  scene.keeps("t.h5", "sweep --merge t.1of2.csv t.2of2.csv --output t.csv");
}

BOOST_AUTO_TEST_SUITE_END()
