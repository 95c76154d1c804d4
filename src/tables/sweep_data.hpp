#pragma once
// The table of a sweep or a study, read back by people's names: for figures and pages.
#include <map>
#include <string>
#include <vector>

namespace ehl::program {

struct SweepData {
  std::string path{};
  std::vector<std::string> varied{};             ///< keys that the sweep varied, "motion.u_m", the slowest first
  std::vector<std::string> columns{};            ///< those and the quantities
  std::vector<std::vector<std::string>> rows{};  ///< cells
  std::map<std::string, std::string> units{};    ///< of the columns that have one
  std::vector<std::string> comments{};           ///< the lines above them, "deck: ball.ini"

  bool has(const std::string& column) const;
  const std::string& cell(std::size_t row, const std::string& column) const;
  /// NaN where the cell is no number.
  double number(std::size_t row, const std::string& column) const;
  /// The different words of a column, in the order in which they come.
  std::vector<std::string> words(const std::string& column) const;
  /// True where every word of a column is a number.
  bool is_numeric(const std::string& column) const;
};

/// How the first line of such a table begins today: sweep_mark, study_mark or time_study_mark. errors: core::FileError:
/// unreadable, none of them.
std::string mark_of(const std::string& path);

/// A table that begins so, or an older one, whose columns get the names of today; nothing is known of what varied.
/// errors: core::FileError: unreadable, another table, a damaged row.
SweepData read_table(const std::string& path, const std::string& mark);

/// errors: as above.
SweepData read_sweep(const std::string& path);

}  // namespace ehl::program
