// The reports of a sweep: error bars, names of warnings, refused cases.
#include <boost/test/unit_test.hpp>
#include <string>

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

}  // namespace

BOOST_AUTO_TEST_SUITE(test_sweep_reports)

// One name means one number in the report, the file and the table; the error of the mesh alone has its own name.
BOOST_AUTO_TEST_CASE(an_error_is_the_same_everywhere) {
  const Scene scene;
  const std::string cases = " --set contact.M=20 --set grid.cells=128 --set multigrid.max_cycles=3 --quiet";
  const nlohmann::json run = support::parsed(scene.ehl("run d.ini --json" + cases).out);
  BOOST_REQUIRE(scene.ehl("sweep d.ini --vary contact.L=10" + cases).status == 0);
  const Row row = scene.table()[0];
  const auto in_file = [&](const std::string& name) {
    const std::string text = scene.ehl("extract d.h5 " + name).out;
    return std::stod(text.substr(text.find('\n') + 1));
  };
  for (const std::string film : {"Hc", "Hm"}) {
    const double bar = support::number_at(run, "/error_" + film);
    const double mesh = support::number_at(run, "/error_parts/" + film + "/discretization");
    const double cycles = support::number_at(run, "/error_parts/" + film + "/algebraic");
    BOOST_TEST_MESSAGE(film << ": " << bar << " = " << mesh << " of the mesh and " << cycles << " of the cycles");
    BOOST_TEST(cycles > 0.0);
    BOOST_TEST(bar == mesh + cycles, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(std::stod(row.at("error_" + film)) == bar);
    BOOST_TEST(in_file("error_" + film) == bar);
    BOOST_TEST(in_file("mesh_error_" + film) == mesh);
  }
}

// A film whose error is as large as the film itself has converged, but the sweep warns of it.
BOOST_AUTO_TEST_CASE(poor_error_bars_are_told) {
  const Scene scene;
  const support::Ended ended = scene.ehl("sweep d.ini --vary contact.M=5,500 --set grid.cells=64 --quiet");
  BOOST_TEST(ended.status == 0, ended.err);
  BOOST_TEST(contains(ended.out, "contact.M=500"), ended.out);
  const std::vector<Row> rows = scene.table();
  BOOST_TEST(std::stod(rows[1].at("error_Hc")) >= 1.0);
  BOOST_TEST(contains(rows[1].at("warnings"), "error-100"), rows[1].at("warnings"));
  BOOST_TEST(!contains(rows[0].at("warnings"), "error-100"), rows[0].at("warnings"));
  // The name that ends a sentence of the text is that of JSON, of the result file, of the page and of the table.
  scene.folder.write("oil.ini",
                     "[contact]\nload = 300\nradius_x = 10e-3\nE1 = 210e9\nE2 = 210e9\nnu1 = 0.3\nnu2 = 0.3\n"
                     "[motion]\nu_m = 10\n[lubricant]\neta0 = 0.04\nalpha = 2.2e-8\n[grid]\ncells = 64\n");
  BOOST_REQUIRE(scene
                    .ehl("sweep oil.ini --vary contact.load=30,3000 --vary motion.srr=0,2.5 --vary "
                         "contact.Sq1=1e-9,1e-6 --quiet --output w.csv")
                    .status == 0);
  for (const Row& row : scene.table("w.csv")) {
    BOOST_TEST_MESSAGE(row.at("contact.load") << " N, srr " << row.at("motion.srr") << ": " << row.at("warnings"));
    BOOST_TEST(contains(row.at("warnings"), "yield") == (row.at("contact.load") == "3000"));
    BOOST_TEST(contains(row.at("warnings"), "backwards") == (row.at("motion.srr") == "2.5"));
    const std::string set = "--quiet --set contact.load=" + row.at("contact.load") +
                            " --set motion.srr=" + row.at("motion.srr") + " --set contact.Sq1=" + row.at("contact.Sq1");
    const std::string text = scene.ehl("run oil.ini --overwrite " + set).out;
    const std::string json = scene.ehl("run oil.ini --overwrite --json " + set).out;
    const std::string file = scene.ehl("extract oil.h5 /summary/warnings").out;
    BOOST_REQUIRE(scene.ehl("report oil.h5 --overwrite --output oil.html").status == 0);
    const std::string page = scene.folder.read("oil.html");
    std::istringstream names(row.at("warnings"));
    for (std::string name; names >> name;) {
      if (name == "none" || name == "error-100") continue;
      BOOST_TEST(contains(text, " [" + name + "]\n"), name << " of the table is not in\n" << text);
      BOOST_TEST(contains(file, " [" + name + "]\n"), name << " of the table is not in\n" << file);
      BOOST_TEST(contains(page, " [" + name + "]<"), name << " of the table is not in the page");
      BOOST_TEST(contains(json, '"' + name + '"'), name << " of the table is not in\n" << json);
    }
  }
}

// The order in which cases end varies, so the message names the first refused case by number. Here that one is slow.
BOOST_AUTO_TEST_CASE(the_first_refused_is_the_first_by_number) {
  const Scene scene;
  std::string heights;
  for (int row = 0; row < 1500; ++row) {
    for (int column = 0; column < 1500; ++column) heights += column == 0 ? "0" : ",0.125";
    heights += "\n";
  }
  scene.folder.write("large.csv", heights + "no number\n");
  scene.folder.write("small.csv", "no number\n1,2\nno,number\n");
  const support::Ended ended = scene.ehl(
      "sweep d.ini --vary surface1.file=large.csv,small.csv --set surface1.shape=map --set surface1.unit=0.01 --set "
      "surface1.dx=0.02 --threads 2 --quiet");
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(contains(ended.err, "surface1.file=large.csv: "), ended.err);
}

// The cases are counted before a list of them is made.
BOOST_AUTO_TEST_CASE(too_many_cases_are_refused_at_once) {
  const Scene scene;
  const support::Ended ended = support::shell(
      scene.folder, std::string("ulimit -t 1; '") + EHL_PROGRAM +
                        "' sweep d.ini --vary contact.M=2:2000:1000000:log --vary contact.L=1:25:1000000 --vary "
                        "grid.cells=64,128,256");
  BOOST_TEST(ended.status == 2, ended.err);
  BOOST_TEST(contains(ended.err, "3e+12"), ended.err);
}

BOOST_AUTO_TEST_SUITE_END()
