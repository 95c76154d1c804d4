#pragma once
// The table of a sweep: a CSV file that grows by whole rows, and that a sweep cut short goes on with.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "deck/file.hpp"
#include "tables/shard.hpp"
#include "tables/sweep_range.hpp"
#include "tables/sweep_row.hpp"

namespace ehl::program {

/// How the first line of every table begins. Table 1 had in error_Hc the error of the mesh alone, and numbers of
/// warnings instead of their names.
constexpr char sweep_mark[] = "# ehl sweep, table 2";
/// How a line begins that names a program that worked on it.
constexpr char program_mark[] = "# program: ";
/// How the line of a table begins that has a part of the cases, and the column of their numbers.
constexpr char shard_mark[] = "# shard: ";
constexpr char case_column[] = "case,";

/// What a table is about. The same sweep is the same deck text, the same --set and --vary, and the same in the files
/// that they name.
struct SweepHeader {
  std::string program{};    ///< version, commit, compiler
  std::string deck{};       ///< its path, for the reader
  std::string deck_text{};  ///< what it says
  std::vector<std::string> set{};
  std::vector<Variation> variations{};
  SweepKind kind{};                      ///< columns that not every sweep has
  std::vector<deck::NamedFile> files{};  ///< that any of the cases names
  Shard shard{};                         ///< of a table that has a part of the cases
  int at_once = 1;                       ///< cases that share the memory
};

/// The files that the cases of a sweep name, sorted by name. in: path of the deck, --set, what varies.
/// errors: core::FileError where one is missing.
std::vector<deck::NamedFile> files_of_cases(const std::string& path, const std::vector<std::string>& set,
                                            const std::vector<Variation>& variations);

/// The header as lines of a file, each of which begins with #, but for the last, which names the columns.
std::string header_text(const SweepHeader& header);

/// An open table, locked against a second sweep. Rows of a shard begin with the number of their case.
class SweepTable {
 public:
  /// Opens or begins the table. A table of the same sweep with fewer values goes on with more. in: path; own: the cases
  /// of the shard; overwrite: begin anew whatever the file holds.
  /// errors: core::FileError: no room for a file there, in use by another sweep, a file of another kind or of another
  /// sweep, a damaged row (a last line without its end is dropped: the sweep was killed while writing it).
  SweepTable(const std::string& path, const SweepHeader& header, const std::vector<std::size_t>& own, bool overwrite);
  ~SweepTable();
  SweepTable(const SweepTable&) = delete;
  SweepTable& operator=(const SweepTable&) = delete;

  /// Adds the row of a case, whole, to the file. in: case number; its columns after the varied keys (sweep_row.hpp).
  /// errors: core::FileError.
  void append(std::size_t index, const std::string& text);

  /// The rows in the order of the cases, in place of the file as it grew. errors: core::FileError.
  void finish() const;

  /// Cases without a row, and those whose row says `failed`: a process that died says nothing about its case.
  std::vector<std::size_t> missing() const;

  /// Whether the row of a case has this status.
  bool has_status(std::size_t index, const std::string& status) const { return rows_[index].starts_with(status + ","); }

  /// A cell of the row of a case, by the name of its column, which is none of the varied keys; empty without a row.
  std::string cell(std::size_t index, const std::string& column) const;

  /// Rows of this status.
  std::size_t count(const std::string& status) const;

 private:
  void open();
  void read(const std::string& content);
  void check_same(const std::vector<std::string>& found, const std::vector<std::string>& own) const;
  void take_row(const std::string& line, const std::string& columns, const std::map<std::string, std::size_t>& cases);
  std::string start_of_row(std::size_t index) const;
  std::string line_of(std::size_t index) const;
  void write(const std::string& text) const;

  std::string path_;
  SweepHeader header_;
  std::vector<std::size_t> own_;
  std::vector<std::string> rows_;      ///< one per case, after the varied keys; empty where there is none yet
  SweepRow columns_;                   ///< their names
  std::vector<std::string> programs_;  ///< the lines of all programs that worked on it
  std::optional<std::string> lost_;    ///< a line that is the row of none of the cases
  int descriptor_ = -1;
};

}  // namespace ehl::program
