#include "tables/sweep_data.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "case/catalogue.hpp"
#include "case/numbers/names.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "tables/asperity_table.hpp"
#include "tables/csv.hpp"
#include "tables/study_report.hpp"
#include "tables/sweep_table.hpp"
#include "tables/time_study_report.hpp"

namespace ehl::program {
namespace {

// Reads a line "# units: h_c_nm [nm], seconds [s]".
std::map<std::string, std::string> units_of(const std::string& line) {
  std::map<std::string, std::string> units;
  for (std::size_t begin = 0, open = 0; (open = line.find(" [", begin)) != std::string::npos;) {
    const std::size_t close = std::min(line.find(']', open), line.size());
    units[deck::trimmed(line.substr(begin, open - begin))] = line.substr(open + 2, close - open - 2);
    begin = std::min(line.find_first_not_of("], ", close), line.size());
  }
  return units;
}

// The beginning that tables of all versions have in common: "# ehl sweep, table ".
std::string any_version(const std::string& mark) { return mark.substr(0, mark.rfind(' ') + 1); }

// Gives the columns of table 1 their present names.
void rename_older(const std::string& mark, SweepData& data) {
  const std::string before = "error_";
  for (std::string& column : data.columns) {
    if (mark != sweep_mark && column.starts_with(before)) column = "deviation_" + column.substr(before.size());
    if (mark == sweep_mark && column == id::error_Hc) column = id::mesh_error_Hc;
    if (mark == sweep_mark && column == id::error_Hm) column = id::mesh_error_Hm;
  }
}

}  // namespace

bool SweepData::has(const std::string& column) const { return std::ranges::find(columns, column) != columns.end(); }

const std::string& SweepData::cell(std::size_t row, const std::string& column) const {
  return rows[row][static_cast<std::size_t>(std::ranges::find(columns, column) - columns.begin())];
}

double SweepData::number(std::size_t row, const std::string& column) const {
  const deck::ReadNumber read = deck::read_number(cell(row, column));
  return read.status == deck::ReadNumber::Status::number ? read.value : std::nan("");
}

std::vector<std::string> SweepData::words(const std::string& column) const {
  std::vector<std::string> found;
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (std::ranges::find(found, cell(row, column)) == found.end()) found.push_back(cell(row, column));
  return found;
}

bool SweepData::is_numeric(const std::string& column) const {
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (!std::isfinite(number(row, column)) && cell(row, column) != "NaN") return false;
  return !rows.empty();
}

SweepData read_table(const std::string& path, const std::string& mark) {
  constexpr std::uintmax_t largest = 1'000'000'000;  // bytes
  std::ifstream file = deck::opened(path, largest);
  std::string line;
  if (!std::getline(file, line) || !line.starts_with(any_version(mark)))
    throw core::FileError(path + ": this is not a table of `ehl sweep` or `ehl study`");
  const bool older = !line.starts_with(mark);
  SweepData data{.path = path};
  const std::string units = "# units: ";
  while (std::getline(file, line) && line.starts_with('#')) {
    data.comments.push_back(deck::trimmed(line.substr(1)));
    if (line.starts_with(units)) data.units = units_of(line.substr(units.size()));
  }
  data.columns = csv_cells(line, line.size() + 2);
  if (older) rename_older(mark, data);
  if (!data.has(id::status)) throw core::FileError(path + ": the table is damaged: it has no column status");
  while (std::getline(file, line)) {
    data.rows.push_back(csv_cells(line, data.columns.size()));
    if (data.rows.back().size() != data.columns.size())
      throw core::FileError(path + ": the table is damaged: a row has " + std::to_string(data.rows.back().size()) +
                            " cells instead of " + std::to_string(data.columns.size()));
  }
  return data;
}

SweepData read_sweep(const std::string& path) {
  SweepData data = read_table(path, sweep_mark);
  data.varied.assign(data.columns.begin(), std::ranges::find(data.columns, id::status));
  std::erase(data.varied, "case");  // the numbers of the cases of a shard
  const deck::Catalogue keys = catalogue();
  for (const std::string& name : data.varied) {
    const std::size_t dot = name.find('.');
    const deck::Key* key = deck::find_key(keys, name.substr(0, dot), name.substr(std::min(dot, name.size() - 1) + 1));
    if (key != nullptr && !key->unit.empty()) data.units[name] = key->unit;
  }
  return data;
}

std::string mark_of(const std::string& path) {
  constexpr std::uintmax_t largest = 1'000'000'000;  // bytes
  std::ifstream file = deck::opened(path, largest);
  std::string first;
  if (!std::getline(file, first)) throw core::FileError(path + ": cannot be read, or is empty");
  for (const char* mark : {sweep_mark, study_mark, time_study_mark, asperity_mark})
    if (first.starts_with(any_version(mark))) return mark;
  throw core::FileError(path + ": this is not a table of `ehl sweep`, `ehl study` or `ehl asperities`");
}

}  // namespace ehl::program
