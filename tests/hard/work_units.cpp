// The work of a solution to the accuracy of its discretization, in the program's own work units, compared with the
// record in work_units.csv: a slower solver fails. The record also says which starts, strategies, rules and remedies
// each case uses.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "run/pipeline.hpp"
#include "steady/starts.hpp"

BOOST_AUTO_TEST_SUITE(test_work_units)

using namespace ehl;

namespace {

struct Row {
  std::string name{}, deck{}, settings{};
  double work_units = 0.0;  ///< of all levels, in evaluations of residual and deformation on the finest grid
  double factor = 0.0;      ///< convergence factor; NaN with a single cycle on the finest grid
  std::string tried{};      ///< strategies, each but the last with a failure
  std::string remedies{};   ///< what the cycles needed
  std::string rules{};      ///< rules for cycles and relaxations that apply with the first start
};

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    if (!part.empty() || separator == ',') parts.push_back(part);
  return parts;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

struct Table {
  std::string heading{};
  std::vector<Row> rows{};
};

Table read(const char* path) {
  std::ifstream file(path);
  Table table;
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> cells = parts_of(line, ',');
    if (line.starts_with("#") || line.starts_with("case,")) {
      table.heading += line + "\n";
      continue;
    }
    cells.resize(8);
    table.rows.push_back({cells[0], cells[1], cells[2], std::stod(cells[3]),
                          cells[4].empty() ? std::nan("") : std::stod(cells[4]), cells[5], cells[6], cells[7]});
  }
  return table;
}

void write(const char* path, const Table& table) {
  std::ofstream file(path);
  file << table.heading;
  file.precision(4);
  for (const Row& row : table.rows) {
    file << row.name << ',' << row.deck << ',' << row.settings << ',' << row.work_units << ',';
    if (!std::isnan(row.factor)) file << std::round(1e3 * row.factor) / 1e3;
    file << ',' << row.tried << ',' << row.remedies << ',' << row.rules << '\n';
  }
}

struct Measured {
  Row row{};
  double of_a_cycle = 0.0;  ///< work units of a cycle on the finest grid
};

Measured measure(const Row& row) {
  const program::Case input = program::read_case(EHL_INPUTS "/" + row.deck, parts_of(row.settings, ' '), 1);
  program::Progress silent(true);
  program::RunSettings settings{.progress = silent, .extent = program::Extent::film};
  program::Computed computed;
  program::solve_case(input, settings, computed);
  BOOST_TEST_REQUIRE(computed.unsolved.empty(), row.name << ": " << computed.unsolved);
  const steady::Solution& solution = computed.solution;
  BOOST_TEST(solution.converged, row.name << ": " << solution.failed_check);
  Measured measured{.row = {row.name, row.deck, row.settings}};
  const auto nodes = [](const steady::LevelRow& level) { return (level.nx + 1.0) * (level.ny + 1.0); };
  const steady::LevelRow& finest = solution.levels.back();
  for (const steady::LevelRow& level : solution.levels)
    measured.row.work_units += level.work_units * nodes(level) / nodes(finest);
  measured.row.factor = solution.cycle_factor;
  std::vector<std::string> tried;
  for (const steady::Attempt& attempt : solution.attempts) tried.push_back(attempt.path);
  measured.row.tried = joined(tried);
  measured.row.remedies = joined(solution.remedies);
  measured.row.rules = joined(steady::rules_of(input.scene, steady::starts_of(input.scene).front()));
  measured.of_a_cycle = finest.work_units / std::max(1, finest.cycles);
  return measured;
}

}  // namespace

// The tolerance is half a cycle of the finest grid and 0.03 of the convergence factor: less than any change of the
// method that a user would notice, more than what rounding does on another processor.
BOOST_AUTO_TEST_CASE(no_more_than_recorded) {
  Table table = read(EHL_WORK_UNITS);
  BOOST_TEST_REQUIRE(table.rows.size() >= 20u);
  constexpr double share_of_a_cycle = 0.5, of_factor = 0.03;
  bool faster = false, other = false;
  for (Row& row : table.rows) {
    const auto [now, of_a_cycle] = measure(row);
    const double allowed = share_of_a_cycle * of_a_cycle;
    BOOST_TEST_MESSAGE("  " << row.name << ": " << now.work_units << " work units (" << row.work_units << " + "
                            << allowed << "), factor " << now.factor << " (" << row.factor << " + " << of_factor
                            << "), " << now.tried << (now.remedies.empty() ? "" : "; with ") << now.remedies);
    BOOST_TEST(now.work_units <= row.work_units + allowed, row.name << ": more work than recorded");
    BOOST_TEST(!(now.factor > row.factor + of_factor), row.name << ": cycles converge more slowly than recorded");
    BOOST_TEST(now.tried == row.tried, row.name << ": other strategies than recorded, " << row.tried);
    faster = faster || now.work_units < row.work_units - allowed || now.factor < row.factor - of_factor;
    other = other || now.remedies != row.remedies || now.rules != row.rules;
    row = now;
  }
  if (faster || other) {
    write("work_units.csv", table);
    BOOST_TEST_MESSAGE((faster ? "some cases are faster" : "some cases need other rules or remedies")
                       << " than recorded: renew tests/hard/work_units.csv from the file of this name here");
  }
}

BOOST_AUTO_TEST_SUITE_END()
