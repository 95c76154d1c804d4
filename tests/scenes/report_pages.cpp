// `ehl report` in use: pages show the numbers of the files with their error bars, mark what did not converge,
// and wrong files are refused.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "support/program.hpp"
#include "support/text.hpp"

namespace {

using support::contains;

const std::string steel =
    "[case]\ntitle = <b>steel</b> & glass\n[contact]\nload = 20\nradius_x = 0.010\nE_prime = 1.2e11\n[motion]\nu_m = "
    "0.5\n[lubricant]\neta0 = 0.08\nalpha = 2e-8\n[domain]\nx_inlet = -4\ny_half = 3\n[grid]\ncells = 128\n";

struct Scene {
  support::TemporaryFolder folder;
  Scene() { folder.write("s.ini", steel); }
  support::Ended ehl(const std::string& arguments) const { return support::ehl(folder, arguments); }

  std::string page(const std::string& files) const {
    const support::Ended ended = ehl("report " + files + " --output page.html --overwrite");
    BOOST_TEST(ended.status == 0, ended.err);
    BOOST_TEST(ended.out == "page.html\n");
    return folder.read("page.html");
  }
  // A number of the summary, dimensionless or in SI.
  double number(const std::string& file, const std::string& name) const {
    std::istringstream lines(ehl("extract " + file + " " + name).out);
    for (std::string line; std::getline(lines, line);)
      if (!line.starts_with('#')) return std::stod(line);
    return std::nan("");
  }
};

struct Said {
  double value = std::nan("");
  double bar = std::nan("");
};

// Reads "<td>central film h<sub>c</sub></td><td>261.217 ± 0.095 nm</td>".
Said said_of(const std::string& page, const std::string& words) {
  const std::size_t cell = page.find("<td>", page.find("<td>" + words + "</td>") + 4);
  BOOST_REQUIRE(cell != std::string::npos);
  const std::size_t bar = page.find("± ", cell);
  return {std::stod(page.substr(cell + 4)), std::stod(page.substr(bar + std::string("± ").size()))};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_report_pages)

BOOST_AUTO_TEST_CASE(a_run_has_its_numbers_with_their_error_bars) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run s.ini").status == 0);
  const std::string page = scene.page("s.h5");
  const double nm = 1e9 * scene.number("s.h5", "/scales/h");
  const struct {
    const char *words, *value, *error;
  } lines[] = {{"central film h<sub>c</sub>", "Hc_best", "error_Hc_best"},
               {"minimum film h<sub>m</sub>", "Hm_best", "error_Hm_best"}};
  for (const auto& line : lines) {
    const Said said = said_of(page, line.words);
    const double value = nm * scene.number("s.h5", line.value), bar = value * scene.number("s.h5", line.error);
    BOOST_TEST_MESSAGE(line.value << ": the page says " << said.value << " ± " << said.bar << ", the file " << value
                                  << " ± " << bar);
    // The bar has two digits, and the value has the same last digit.
    BOOST_TEST(std::abs(said.bar - bar) <= 0.051 * bar);
    BOOST_TEST(std::abs(said.value - value) <= 0.051 * bar);
  }
  BOOST_TEST(contains(page, "&lt;b&gt;steel&lt;/b&gt; &amp; glass"));
  BOOST_TEST(!contains(page, "<b>steel"));
  for (const char* part : {"p<sub>h</sub> = 0.5", "<svg ", "data:image/png;base64,", "x_inlet = -4", "<td>commit</td>",
                           "<td>threads</td>", "@media print", "default-src 'none'"})
    BOOST_TEST(contains(page, part), part);
  for (const char* part : {"http:", "https:", "file:", "src=", ">nan", " nan", ">inf"})
    BOOST_TEST(!contains(page, part), part);
}

BOOST_AUTO_TEST_CASE(what_did_not_converge_is_never_shown_as_if_it_had) {
  const Scene scene;
  BOOST_REQUIRE(scene
                    .ehl("run s.ini --set multigrid.tolerance=1e-12 --set multigrid.max_cycles=2 --set "
                         "continuation.path=off --set multigrid.polish=off")
                    .status == 3);
  const std::string page = scene.page("s.h5");
  BOOST_TEST(!contains(page, "±</td>"));
  BOOST_TEST(!contains(page, "± 0"));
  BOOST_TEST(contains(page, "<td><span class=\"bad\">"));
  // This also holds on a page with another file.
  BOOST_REQUIRE(scene.ehl("run s.ini --output good.h5").status == 0);
  const std::string both = scene.page("good.h5 s.h5");
  const std::string comparison = both.substr(both.find("Comparison"), both.find("</table>") - both.find("Comparison"));
  const std::string bad_row = comparison.substr(comparison.find("s.h5"));
  BOOST_TEST(contains(comparison, "±"));
  BOOST_TEST(!contains(bad_row, "±"));
  BOOST_TEST(contains(bad_row, "class=\"bad\""));
}

BOOST_AUTO_TEST_CASE(a_sweep_has_curves_rows_and_what_failed) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("sweep s.ini --vary motion.u_m=0.2,0.5,1 --vary contact.load=20,40 --output t.csv").status ==
                0);
  const std::string page = scene.page("t.csv");
  for (const char* part : {"F = 40 N", "Hamrock, Dowson 1977", "motion.u_m = 0.2,0.5,1"})
    BOOST_TEST(contains(page, part), part);
  // One row loses its status: its films disappear from the table, and it is counted as not converged.
  std::string table = scene.folder.read("t.csv");
  const std::size_t first = table.find(",converged,");
  table.replace(first, std::string(",converged,").size(), ",not-converged,");
  scene.folder.write("t.csv", table);
  const std::string lost = scene.page("t.csv");
  BOOST_TEST(contains(lost, "1 not-converged"));
  const auto bars = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(" ± "); at != std::string::npos; at = text.find(" ± ", at + 1)) ++count;
    return count;
  };
  BOOST_TEST(bars(lost) + 2 == bars(page));  // h_c and h_m of that row
}

// Second order: the error of upstream2 against the reference falls by a factor of four from grid to grid.
BOOST_AUTO_TEST_CASE(a_study_has_the_observed_orders) {
  const Scene scene;
  scene.folder.write("m.ini", "[contact]\nM = 20\nL = 5\n[lubricant]\nalpha = 2e-8\n[domain]\nx_inlet = -4\n");
  BOOST_REQUIRE(
      scene.ehl("study m.ini --levels 32:128 --evaluators fft --cycles run --repeat 1 --output t.csv").status == 0);
  const std::string page = scene.page("t.csv");
  const std::size_t way = page.find("<td>upstream2, fft, run</td>");
  BOOST_REQUIRE(way != std::string::npos);
  const auto rows = support::named_rows(scene.folder.read("t.csv"));
  double coarse = 0.0, fine = 0.0;
  for (const auto& row : rows)
    if (row.at("wedge") == "upstream2") (row.at("cells") == "64" ? coarse : fine) = std::stod(row.at("deviation_Hm"));
  // The third row of this method, ninth cell.
  std::size_t at = way;
  for (int row = 0; row < 2; ++row) at = page.find("<tr>", at + 1);
  for (int cell = 0; cell < 9; ++cell) at = page.find("<td>", at + 1);
  const double order = std::stod(page.substr(at + 4));
  BOOST_TEST_MESSAGE("order of Hm " << order << ", from the table " << std::log2(coarse / fine));
  BOOST_TEST(std::abs(order - std::log2(coarse / fine)) <= 0.051);
}

// Without gnuplot, or if it fails, the page has its numbers and says once what is missing.
BOOST_AUTO_TEST_CASE(a_page_without_gnuplot_has_its_numbers) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run s.ini").status == 0);
  const Said whole = said_of(scene.page("s.h5"), "central film h<sub>c</sub>");
  BOOST_REQUIRE(support::shell(scene.folder, "mkdir bin").status == 0);
  scene.folder.write("bin/gnuplot", "#!/bin/sh\nexit 1\n");
  BOOST_REQUIRE(support::shell(scene.folder, "chmod +x bin/gnuplot").status == 0);
  for (const char* path : {"none", "bin"}) {
    const support::Ended ended = support::shell(
        scene.folder, std::string("PATH=\"$PWD/") + path + "\" '" + EHL_PROGRAM + "' report s.h5 --overwrite");
    BOOST_TEST(ended.status == 0, ended.err);
    BOOST_TEST(ended.says({"s.h5", "gnuplot"}), ended.err);
    const std::string page = scene.folder.read("s_report.html");
    BOOST_TEST(said_of(page, "central film h<sub>c</sub>").value == whole.value);
    BOOST_TEST(!contains(page, "<svg"));
    const std::size_t first = page.find("<p class=\"warning\">");
    BOOST_TEST(first != std::string::npos);
    BOOST_TEST(page.find("<p class=\"warning\">", first + 1) == std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(wrong_files_are_refused_and_leave_nothing) {
  const Scene scene;
  BOOST_REQUIRE(scene.ehl("run s.ini").status == 0);
  const std::string whole = scene.folder.read("s.h5");
  scene.folder.write("cut.h5", whole.substr(0, whole.size() / 2));
  scene.folder.write("foreign.h5", "no HDF5 at all");
  scene.folder.write("foreign.csv", "a,b\n1,2\n");
  scene.folder.write("empty.csv", "");
  BOOST_REQUIRE(scene.ehl("sweep s.ini --set grid.cells=64 --vary motion.u_m=0.2,0.5,1 --output t.csv").status == 0);
  const std::string table = scene.folder.read("t.csv");
  scene.folder.write("cut.csv", table.substr(0, table.size() * 3 / 4));
  const auto before = scene.folder.entries();
  const struct {
    const char* arguments;
    int status;
    const char* file;
  } lines[] = {{"none.h5", 4, "none.h5"},
               {"cut.h5", 4, "cut.h5"},
               {"foreign.h5", 4, "foreign.h5"},
               {"s.ini", 4, "s.ini"},
               {"none.csv", 4, "none.csv"},
               {"foreign.csv", 4, "foreign.csv"},
               {"empty.csv", 4, "empty.csv"},
               {"cut.csv", 4, "cut.csv"},
               {"s.h5 none.h5", 4, "none.h5"},
               {"s.h5 --output page.pdf", 2, "page.pdf"},
               {"s.h5 --output none/page.html", 4, "none"},
               {"", 2, ""}};
  for (const auto& line : lines) {
    const support::Ended ended = scene.ehl(std::string("report ") + line.arguments);
    BOOST_TEST(ended.status == line.status, line.arguments << " ends with " << ended.status << ": " << ended.err);
    BOOST_TEST(ended.says({line.file}), line.arguments << " says\n" << ended.err);
    BOOST_TEST(scene.folder.entries() == before, line.arguments);
  }
  BOOST_TEST(scene.ehl("report s.h5").out == "s_report.html\n");
  const support::Ended again = scene.ehl("report s.h5");
  BOOST_TEST(again.status == 4);
  BOOST_TEST(again.says({"s_report.html"}), again.err);
  BOOST_TEST(scene.ehl("report s.h5 --overwrite").status == 0);
}

BOOST_AUTO_TEST_SUITE_END()
