#include "tables/study_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "commands/machine.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/text.hpp"
#include "steady/solve.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

// A column, how it is written and how it is read: one list for both.
struct Column {
  std::string name;
  std::string text;
  std::string* word = nullptr;
  double* number = nullptr;
  int* whole = nullptr;
  bool* flag = nullptr;
};

Column word(const std::string& name, std::string& value) {
  return {.name = name, .text = csv_word(value), .word = &value};
}
Column number(const std::string& name, double& value) {
  return {.name = name, .text = csv_number(value), .number = &value};
}
Column whole(const std::string& name, int& value) {
  return {.name = name, .text = std::to_string(value), .whole = &value};
}
Column flag(const std::string& name, bool& value) { return {.name = name, .text = value ? "1" : "0", .flag = &value}; }

std::vector<Column> columns_of(StudyPoint& point) {
  return {whole("cells", point.way.cells),
          word("wedge", point.way.wedge),
          word("evaluator", point.way.evaluator),
          word("cycles", point.way.cycles),
          word("status", point.status),
          whole("nx", point.nx),
          whole("ny", point.ny),
          number("Hc", point.Hc),
          number("Hm", point.Hm),
          number("error_Hc", point.error_Hc),
          number("error_Hm", point.error_Hm),
          number("estimate_Hc", point.estimate_Hc),
          number("estimate_Hm", point.estimate_Hm),
          number("residual", point.residual),
          word("cycles_by_level", point.cycles_by_level),
          whole("attempts", point.attempts),
          number("work_units", point.work_units),
          number("seconds", point.seconds),
          number("seconds_most", point.seconds_most),
          number("peak_memory", point.peak_memory),
          flag("at_reference_Hc", point.at_reference_Hc),
          flag("at_reference_Hm", point.at_reference_Hm),
          flag("front_Hc", point.front_Hc),
          flag("front_Hm", point.front_Hm),
          {.name = "reason", .text = csv_quoted(point.reason), .word = &point.reason}};
}

bool read_into(const std::string& cell, const Column& column) {
  if (column.word != nullptr) {
    *column.word = cell;
    return true;
  }
  if (column.flag != nullptr) {
    *column.flag = cell == "1";
    return cell == "0" || cell == "1";
  }
  const bool unknown = cell == "NaN" && column.number != nullptr;
  const deck::ReadNumber read = deck::read_number(cell);
  if (!unknown && read.status != deck::ReadNumber::Status::number) return false;
  if (column.number != nullptr) *column.number = unknown ? StudyPoint::unknown : read.value;
  if (column.whole != nullptr) *column.whole = static_cast<int>(read.value);
  return true;
}

// Work of the levels below in units of the finest grid.
double whole_work(const steady::Solution& solution) {
  const auto nodes = [](const steady::LevelRow& row) { return (row.nx + 1.0) * (row.ny + 1.0); };
  double work = 0.0;
  for (const steady::LevelRow& row : solution.levels) work += row.work_units * nodes(row);
  return work / nodes(solution.levels.back());
}

}  // namespace

std::string study_columns() {
  StudyPoint point;
  std::vector<std::string> names;
  for (const Column& column : columns_of(point)) names.push_back(column.name);
  return deck::joined(names, ",");
}

std::string study_text(const StudyPoint& point) {
  StudyPoint copy = point;
  std::vector<std::string> texts;
  for (const Column& column : columns_of(copy)) texts.push_back(column.text);
  return deck::joined(texts, ",");
}

StudyPoint study_point(const std::string& row) {
  StudyPoint point;
  const std::vector<Column> columns = columns_of(point);
  const std::vector<std::string> cells = csv_cells(row, columns.size());
  bool good = cells.size() == columns.size();
  for (std::size_t k = 0; good && k < cells.size(); ++k) good = read_into(cells[k], columns[k]);
  if (!good) throw core::FileError("this line is no row of a study: " + row.substr(0, 120));
  return point;
}

StudyPoint point_of_solution(const StudyCase& way, const steady::Solution& solution, double seconds) {
  StudyPoint point;
  point.way = way;
  point.seconds = seconds;
  point.seconds_most = seconds;
  point.status = "not-converged";
  point.reason = solution.failed_check;
  point.attempts = static_cast<int>(solution.attempts.size());
  if (solution.levels.empty()) return point;
  const steady::LevelRow& finest = solution.levels.back();
  if (solution.converged) point.status = "converged";
  // Cut off at the planned number of cycles with a film that can be looked at: as wanted, and not converged.
  else if (way.cycles != "run" && solution.end == steady::CyclesEnd::limit && finest.Hm > 0.0)
    point.status = "stopped";
  point.nx = finest.nx;
  point.ny = finest.ny;
  point.Hc = finest.Hc;
  point.Hm = finest.Hm;
  point.estimate_Hc = finest.error_Hc;
  point.estimate_Hm = finest.error_Hm;
  point.residual = finest.residual;
  std::vector<std::string> cycles;
  for (const steady::LevelRow& row : solution.levels) cycles.push_back(std::to_string(row.cycles));
  point.cycles_by_level = deck::joined(cycles, ";");
  point.work_units = whole_work(solution);
  return point;
}

StudyPoint measure(Case input, const StudyCase& way) {
  use_way(way, input.scene);
  const double began = core::now();
  StudyPoint point;
  try {
    const steady::Solution solution = steady::solve(input.scene);
    point = point_of_solution(way, solution, core::now() - began);
  } catch (const core::SolverError& error) {
    point.way = way;
    point.status = "not-converged";
    point.reason = error.what();
    point.seconds = point.seconds_most = core::now() - began;
  }
  if (point.nx == 0) {
    point.nx = input.scene.grid.nx;
    point.ny = input.scene.grid.ny;
  }
  point.peak_memory = peak_memory();
  return point;
}

void add_repetition(const StudyPoint& again, StudyPoint& point) {
  point.seconds = std::fmin(point.seconds, again.seconds);
  point.seconds_most = std::fmax(point.seconds_most, again.seconds_most);
  point.peak_memory = std::fmax(point.peak_memory, again.peak_memory);
}

}  // namespace ehl::program
