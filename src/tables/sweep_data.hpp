#pragma once
// The table of a sweep or a study, read back by the names of its columns, for figures and pages.
#include <map>
#include <string>
#include <vector>

namespace ehl::program {

struct SweepData {
  std::string path{};
  std::vector<std::string> varied{};             ///< keys that the sweep varied, "motion.u_m", the slowest first
  std::vector<std::string> columns{};            ///< the varied keys and the quantities
  std::vector<std::vector<std::string>> rows{};  ///< the cells
  std::map<std::string, std::string> units{};    ///< units of the columns that have one
  std::vector<std::string> comments{};           ///< the comment lines above the table, "deck: ball.ini"

  bool has(const std::string& column) const;
  const std::string& cell(std::size_t row, const std::string& column) const;
  /// The number in a cell; NaN if the cell is not a number.
  double number(std::size_t row, const std::string& column) const;
  /// The distinct values of a column, in order of appearance.
  std::vector<std::string> words(const std::string& column) const;
  /// True if every value of a column is a number.
  bool is_numeric(const std::string& column) const;
};

/// The kind of a table in the present version: sweep_mark, study_mark, time_study_mark or asperity_mark. errors:
/// core::FileError if the file cannot be read or is no such table.
std::string mark_of(const std::string& path);

/// Reads a table that begins with `mark`, or an older version of it, whose columns get the present names; the varied
/// keys of an older table are not known.
/// errors: core::FileError if the file cannot be read, is another table, or has a damaged row.
SweepData read_table(const std::string& path, const std::string& mark);

/// errors: as above.
SweepData read_sweep(const std::string& path);

}  // namespace ehl::program
