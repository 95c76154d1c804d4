// A new effect touches at most three existing files, and the pipeline calls it at the stages of its record.
//
// The effect of this test touches one, src/case/effect_list.cpp, with two lines: this program links a copy of that file
// with these lines. Deck, check, run, sweep, JSON and result file know the effect from there. An effect with a module
// of its own touches modules/CMakeLists.txt too, and one that keeps fields src/case/computed.hpp.
#include "structure/toy_effect.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <sstream>

#include "case/catalogue.hpp"
#include "run/pipeline.hpp"
#include "structure/house.hpp"
#include "support/json.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"
#include "tables/sweep_row.hpp"

using namespace ehl;
using program::Computed;
using program::Extent;
using support::contains;

namespace {

const std::string plain =
    "[contact]\nM = 20\nL = 10\n[lubricant]\nalpha = 2.2e-8\n[domain]\nx_inlet = -4.5\ny_half = 3\n[grid]\ncells = "
    "64\n";

program::Case read(const std::vector<std::string>& overrides) {
  const support::TemporaryFolder folder;
  return program::read_case(folder.write("case.ini", plain), overrides, 1);
}

Computed solved(const program::Case& input, Extent extent) {
  program::Progress silent(true);
  program::RunSettings settings{.progress = silent, .extent = extent};
  Computed computed;
  program::solve_case(input, settings, computed);
  return computed;
}

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::istringstream text(house::read_text(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(test_toy_effect)

BOOST_AUTO_TEST_CASE(it_adds_two_lines_to_one_existing_file) {
  const std::vector<std::string> before = lines_of(EHL_SOURCE_DIR "/src/case/effect_list.cpp");
  std::vector<std::string> after = lines_of(EHL_TOY_LIST);
  const std::size_t added = after.size() - before.size();
  BOOST_TEST_MESSAGE(added << " lines added to one file (2 allowed)");
  BOOST_TEST(std::erase_if(after, [](const std::string& line) { return contains(line, "toy_effect()"); }) == 2u);
  BOOST_TEST(after == before, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_pipeline_obeys_its_stages) {
  program::ToyCalls& calls = program::toy_calls();
  calls = {};
  const program::Case input = read({"toy.steepest=0.1"});
  BOOST_TEST(calls.scene == 1);
  BOOST_TEST(contains(program::derived_of(input),
                      "acts in the scene that is solved and by equations that are solved with the film and after the "
                      "solution"));
  solved(input, Extent::film);
  BOOST_TEST((calls.film == 1 && calls.after_solution == 0));
  for (const Extent extent : {Extent::row, Extent::whole}) solved(input, extent);
  BOOST_TEST((calls.film == 3 && calls.after_solution == 2));
  solved(read({}), Extent::whole);
  BOOST_TEST((calls.scene == 1 && calls.film == 3 && calls.after_solution == 2));
}

BOOST_AUTO_TEST_CASE(its_number_is_in_every_result) {
  const program::Case input = read({"toy.steepest=0.1"});
  const Computed computed = solved(input, Extent::whole);
  const double slope = program::steepest(computed.solution);
  BOOST_TEST_MESSAGE("steepest pressure " << slope << " p_h/a");
  BOOST_TEST(support::number_at(support::parsed(program::json_of(input, computed)), "/toy/steepest_slope") == slope);
  BOOST_TEST(contains(program::printed(input, computed, false), "[steep]"));
  const results::Content content = program::whole_content(input, computed);
  const auto in_file = std::ranges::find(content.summary, "steepest_slope", &results::Quantity::name);
  BOOST_REQUIRE((in_file != content.summary.end()));
  BOOST_TEST(results::number(in_file->value) == slope);
  const program::SweepColumns columns = program::numbers::columns_of_sweep(input.deck, false);
  program::SweepRow row = program::row_of_solution(columns, input, computed);
  BOOST_TEST(results::number(program::in_row(row, "steepest_slope")) == slope);
}

// P = X/4 has the slope 1/4.
BOOST_AUTO_TEST_CASE(the_slope_of_a_plane) {
  steady::Solution plane;
  plane.grid = {8, 4, -2.0, 2.0, -1.0, 1.0};
  plane.P = core::Field(plane.grid);
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 4; ++j) plane.P(i, j) = 0.25 * plane.grid.X(i);
  BOOST_TEST(program::steepest(plane) == 0.25);
}

// Without its section the result has the same bits as in a program without the effect: no stage was called above, and
// an effect that is on changes only what its stages change.
BOOST_AUTO_TEST_CASE(it_changes_no_film) {
  const Computed with = solved(read({"toy.steepest=10"}), Extent::film), without = solved(read({}), Extent::film);
  for (int i = 0; i <= 64; ++i)
    for (int j = 0; j <= 64; ++j) BOOST_REQUIRE(with.solution.P(i, j) == without.solution.P(i, j));
}

BOOST_AUTO_TEST_SUITE_END()
