// The rules of the source tree: dependencies, use of libraries, sizes.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "structure/house.hpp"

BOOST_AUTO_TEST_SUITE(test_structure)

namespace fs = std::filesystem;
using namespace house;

namespace {

const fs::path root = EHL_SOURCE_DIR;
constexpr int longest_file = 300;

std::vector<Module> declared() { return read_modules(read_text(root / "modules/CMakeLists.txt")); }

void report(const std::vector<std::string>& offences) {
  for (const std::string& offence : offences) BOOST_ERROR(offence);
  BOOST_TEST(offences.empty());
}

std::vector<SourceFile> all_sources() {
  std::vector<SourceFile> files = read_sources(root, "modules");
  for (const char* folder : {"src", "tests"}) {
    const std::vector<SourceFile> more = read_sources(root, folder);
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

// The lines, without their comments, on which a text stands.
std::vector<std::string> places_of(const std::string& text, const std::vector<SourceFile>& files) {
  std::vector<std::string> places;
  for (const SourceFile& file : files) {
    std::istringstream lines(file.text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (line.substr(0, line.find("//")).find(text) != std::string::npos)
        places.push_back(file.path.string() + ":" + std::to_string(number));
    }
  }
  return places;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_reader_reads) {
  const auto modules = read_modules(
      "# ehl_add_module(no SOURCES a)\nfunction(ehl_add_module name)\nendfunction()\n"
      "ehl_add_module(core SOURCES a.cpp)\n"
      "ehl_add_module(kernel SOURCES b.cpp\n  DEPENDS core LIBRARIES x::y)\n");
  BOOST_REQUIRE(modules.size() == 2);
  BOOST_TEST(modules[1].name == "kernel");
  BOOST_TEST(modules[1].depends == std::vector<std::string>{"core"}, boost::test_tools::per_element());
  const auto includes = read_includes("// text\n#include <vector>\n  # include \"core/grid.hpp\"  // why\n");
  BOOST_REQUIRE(includes.size() == 2);
  BOOST_TEST((includes[1].line == 3 && includes[1].quoted && includes[1].path == "core/grid.hpp"));
}

BOOST_AUTO_TEST_CASE(the_reader_finds_offences) {
  const std::vector<Module> modules = {{"core", {}}, {"kernel", {"core"}}, {"mlmi", {"kernel", "multigrid"}}};
  BOOST_TEST(order_offences(modules).size() == 1);
  const SourceFile upwards{"modules/kernel/a.cpp", "kernel", "#include \"mlmi/deformation.hpp\"\n"};
  const SourceFile undeclared{"modules/mlmi/a.cpp", "mlmi", "#include \"core/grid.hpp\"\n"};
  const SourceFile homeless{"modules/core/a.cpp", "core", "#include \"grid.hpp\"\n"};
  const SourceFile clean{"modules/kernel/b.cpp", "kernel", "#include \"core/grid.hpp\"\n#include <cmath>\n"};
  BOOST_TEST(include_offences(modules, {upwards, undeclared, homeless, clean}).size() == 3);
  const SourceFile wrong_door{"modules/multigrid/a.cpp", "multigrid",
                              "#include <hdf5.h>\n#include <fftw3.h>\n#include <sunlinsol/sunlinsol_spfgmr.h>\n"
                              "#include <boost/program_options.hpp>\n"};
  const SourceFile right_door{"modules/mlmi/a.cpp", "mlmi", "#include <fftw3.h>\n"};
  BOOST_TEST(door_offences({wrong_door, right_door}).size() == 4);
  const SourceFile beside_the_door{"modules/newton/solve.cpp", "newton",
                                   "#include <sunlinsol/sunlinsol_spfgmr.h>\n#include <Eigen/SparseLU>\n"};
  const SourceFile through_the_door{"modules/newton/gmres.cpp", "newton", "#include <sunlinsol/sunlinsol_spfgmr.h>\n"};
  BOOST_TEST(door_offences({beside_the_door, through_the_door}).size() == 2);
}

BOOST_AUTO_TEST_CASE(the_reader_knows_effects) {
  const std::vector<Module> modules = {
      {"core", {}}, {"steady", {"core"}}, {"effects/heat", {"core"}}, {"effects/wear", {"core", "effects/heat"}}};
  const SourceFile neighbour{"modules/effects/wear/a.cpp", "effects/wear",
                             "#include \"effects/heat/a.hpp\"\n#include \"effects/wear/a.hpp\"\n"};
  const SourceFile undeclared{"modules/effects/heat/a.cpp", "effects/heat", "#include \"effects/wear/a.hpp\"\n"};
  const SourceFile from_below{"modules/steady/a.cpp", "steady", "#include \"effects/heat/a.hpp\"\n"};
  const SourceFile program{"src/run.cpp", "src", "#include \"effects/heat/a.hpp\"\n"};
  BOOST_TEST(include_offences(modules, {neighbour, program}).empty());
  BOOST_TEST(include_offences(modules, {undeclared, from_below}).size() == 2);
  BOOST_TEST(effect_offences(modules, {neighbour, undeclared, program}).empty());
  BOOST_TEST(effect_offences(modules, {from_below}).size() == 1);
  // Declaring a forbidden dependency does not make it legal.
  const std::vector<Module> upside_down = {{"core", {}}, {"effects/heat", {"core"}}, {"steady", {"effects/heat"}}};
  BOOST_TEST(effect_offences(upside_down, {}).size() == 2);
}

BOOST_AUTO_TEST_CASE(no_module_below_the_effects_knows_one_of_them) {
  const auto modules = declared();
  report(effect_offences(modules, read_sources(root, "modules")));
}

BOOST_AUTO_TEST_CASE(dependencies_point_downwards) {
  const auto modules = declared();
  BOOST_TEST_MESSAGE(modules.size() << " modules declared");
  BOOST_TEST(modules.size() >= 3);
  report(order_offences(modules));
}

BOOST_AUTO_TEST_CASE(a_module_includes_only_what_it_declares) {
  const auto modules = declared();
  const auto files = all_sources();
  BOOST_TEST_MESSAGE(files.size() << " files read");
  BOOST_TEST(files.size() > 20);
  report(include_offences(modules, files));
}

BOOST_AUTO_TEST_CASE(every_folder_is_a_declared_module_and_every_source_is_built) {
  const std::string list = read_text(root / "modules/CMakeLists.txt");
  const auto modules = declared();
  std::vector<std::string> offences;
  for (const SourceFile& file : read_sources(root, "modules")) {
    const bool known = std::ranges::find(modules, file.owner, &Module::name) != modules.end();
    if (!known) offences.push_back(file.path.string() + ": " + file.owner + " is not in modules/CMakeLists.txt");
    const std::string name = file.path.filename().string();
    if (file.path.extension() == ".cpp" && list.find(name) == std::string::npos)
      offences.push_back(file.path.string() + " is not built");
  }
  report(offences);
}

// Tests may use these libraries: a result file is best checked with the HDF5 library itself.
BOOST_AUTO_TEST_CASE(libraries_come_in_through_their_doors) {
  report(door_offences(read_sources(root, "modules")));
  report(door_offences(read_sources(root, "src")));
}

BOOST_AUTO_TEST_CASE(the_program_has_no_module_below_it) {
  std::vector<std::string> offences;
  for (const SourceFile& file : read_sources(root, "modules")) {
    for (const Include& include : read_includes(file.text)) {
      if (include.path.starts_with("src/") || include.path.find("..") != std::string::npos)
        offences.push_back(file.path.string() + ":" + std::to_string(include.line) + " includes " + include.path);
    }
  }
  report(offences);
}

BOOST_AUTO_TEST_CASE(files_stay_short) {
  std::vector<std::string> offences;
  int longest = 0;
  for (const SourceFile& file : all_sources()) {
    const int lines = line_count(file.text);
    longest = std::max(longest, lines);
    if (lines > longest_file) offences.push_back(file.path.string() + ": " + std::to_string(lines) + " lines");
  }
  BOOST_TEST_MESSAGE("longest file: " << longest << " lines (limit " << longest_file << ")");
  report(offences);
}

// The other pages are bounded by their paragraphs (wording.py).
BOOST_AUTO_TEST_CASE(the_front_page_stays_short) {
  const int lines = line_count(read_text(root / "README.md"));
  BOOST_TEST_MESSAGE("README.md: " << lines << " lines");
  BOOST_TEST((0 < lines && lines <= 150));
}

BOOST_AUTO_TEST_CASE(the_wings_of_the_program_point_one_way) {
  const SourceFile upward{"src/case/a.cpp", "src", "#include \"base/json.hpp\"\n#include \"report/report.hpp\"\n"};
  const SourceFile entrance{"src/main.cpp", "src", "#include \"commands/commands.hpp\"\n"};
  BOOST_TEST(wing_offences({upward, entrance}).size() == 1);
  const std::vector<SourceFile> files = read_sources(root, "src");
  for (const SourceFile& file : files)
    BOOST_TEST((file.path == "src/main.cpp" || file.path.parent_path().parent_path() == "src" ||
                file.path.parent_path() == "src/case/numbers"),
               file.path);
  report(wing_offences(files));
}

// Run, sweep, study and the C interface take one way from a case to its numbers, so that each solver is called once.
BOOST_AUTO_TEST_CASE(the_program_calls_each_solver_at_one_place) {
  const SourceFile twice{"src/run/a.cpp", "src", "steady::solve(a);\n// steady::solve(b)\nx = steady::solve(c);\n"};
  BOOST_TEST(places_of("steady::solve(", {twice}).size() == 2);
  const std::vector<SourceFile> files = read_sources(root, "src");
  for (const char* solver : {"steady::solve(", "heat::solve_coupled(", "dry::solve(", "transient::march("}) {
    const std::vector<std::string> places = places_of(solver, files);
    BOOST_TEST(places.size() == 1, solver << " stands at " << places.size() << " places");
    for (const std::string& place : places) BOOST_TEST_MESSAGE(solver << "...) at " << place);
  }
}

BOOST_AUTO_TEST_CASE(headers_are_guarded_and_in_their_namespace) {
  std::vector<std::string> offences;
  for (const SourceFile& file : read_sources(root, "modules")) {
    if (file.path.extension() == ".hpp" && !file.text.starts_with("#pragma once\n"))
      offences.push_back(file.path.string() + " does not begin with #pragma once");
    const std::string space = "namespace ehl::" + fs::path(file.owner).filename().string();
    if (file.text.find(space) == std::string::npos) offences.push_back(file.path.string() + " is not in " + space);
  }
  report(offences);
}

BOOST_AUTO_TEST_CASE(every_module_says_what_it_is) {
  std::vector<std::string> offences;
  const auto files = read_sources(root, "modules");
  for (const Module& module : declared()) {
    bool described = fs::exists(root / "modules" / module.name / "README.md");
    for (const SourceFile& file : files)
      described = described || (file.owner == module.name && file.text.starts_with("#pragma once\n//"));
    if (!described) offences.push_back(module.name + " has neither a README.md nor a header that says what it is");
  }
  report(offences);
}

BOOST_AUTO_TEST_CASE(nothing_is_left_for_later) {
  // Composed here, so that this file does not find its own text.
  const std::vector<std::string> reminders = {std::string("TO") + "DO", std::string("FIX") + "ME"};
  BOOST_TEST(has_word("// " + reminders[0] + ": later", reminders[0]));
  BOOST_TEST(!has_word(reminders[0] + "S", reminders[0]));
  std::vector<std::string> offences;
  for (const char* folder : {"modules", "src", "tests", "inputs", "postprocess"}) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file()) continue;
      const std::string text = read_text(entry.path());
      for (const std::string& reminder : reminders) {
        if (has_word(text, reminder))
          offences.push_back(fs::relative(entry.path(), root).string() + " holds a reminder: " + reminder);
      }
    }
  }
  report(offences);
}

BOOST_AUTO_TEST_CASE(the_reader_knows_the_operator) {
  const auto found = [](const std::string& text) {
    return operator_offences({{"modules/multigrid/a.cpp", "multigrid", text}}, {"modules/reynolds/flux.hpp"}).size();
  };
  BOOST_TEST(found("const double w = 0.5 / (grid.hx() * grid.hx());") == 1U);
  BOOST_TEST(found("w = 0.5 * (state_.eps(i, j) + state_.eps(i + 1, j));") == 1U);
  BOOST_TEST(found("return {U * 1.5 / hx, U * -2.0 / hx, U * 0.5 / hx};") == 1U);
  BOOST_TEST(found("r = transported(w, Q) - poiseuille(e, P);") == 1U);
  BOOST_TEST(found("const double s = 1.5 * load; x = 0.5 * (a + b); eps_bar = eps * 2;") == 0U);
}

BOOST_AUTO_TEST_CASE(the_discrete_operator_stands_in_two_files) {
  const std::vector<std::string> homes{"modules/reynolds/flux.hpp", "modules/reynolds/row.hpp"};
  for (const std::string& home : homes) BOOST_REQUIRE(fs::exists(root / home));
  for (const std::string& path : operator_offences(read_sources(root, "modules"), homes))
    BOOST_ERROR(path << " forms a part of the discrete operator, which stands in flux.hpp and row.hpp of reynolds");
}

BOOST_AUTO_TEST_SUITE_END()
