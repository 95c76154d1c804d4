#pragma once
// The table of a sweep: a CSV file that grows by whole rows. An interrupted sweep continues it.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "deck/file.hpp"
#include "tables/shard.hpp"
#include "tables/sweep_range.hpp"
#include "tables/sweep_row.hpp"

namespace ehl::program {

/// The beginning of the first line of every table. In table 1, error_Hc was the error of the mesh alone, and warnings
/// were numbers instead of names.
constexpr char sweep_mark[] = "# ehl sweep, table 2";
/// The beginning of a line that names a program that computed rows of this table.
constexpr char program_mark[] = "# program: ";
/// The beginning of the line that a table of one shard contains, and the column of the case numbers in it.
constexpr char shard_mark[] = "# shard: ";
constexpr char case_column[] = "case,";

/// The subject of a table. Two sweeps are the same if the deck text, --set, --vary, and the contents of the
/// files they name are the same.
struct SweepHeader {
  std::string program{};    ///< version, commit, compiler
  std::string deck{};       ///< path of the deck, for the reader
  std::string deck_text{};  ///< the text of the deck
  std::vector<std::string> set{};
  std::vector<Variation> variations{};
  SweepColumns columns{};                ///< of a row, after the varied keys
  bool timing = false;                   ///< with seconds and memory
  std::vector<std::string> left_out{};   ///< what a reader of the table must know
  std::vector<deck::NamedFile> files{};  ///< the files that any of the cases names
  Shard shard{};                         ///< the part of the cases that this table holds
  int at_once = 1;                       ///< cases that share the memory
};

/// The files that the cases of a sweep name, sorted by name. in: path of the deck, --set, the variations. errors:
/// core::FileError if a file is missing.
std::vector<deck::NamedFile> files_of_cases(const std::string& path, const std::vector<std::string>& set,
                                            const std::vector<Variation>& variations);

/// The heading of the file: lines that begin with #, and a last line with the names of the columns.
std::string header_text(const SweepHeader& header);

/// An open table, locked against a second sweep. Each row of a shard begins with the number of its case.
class SweepTable {
 public:
  /// Opens or creates the table. A table of the same sweep with fewer values is extended.
  /// in: path; own: the cases of the shard; overwrite: discard the contents of the file.
  /// errors: core::FileError if the file cannot be created, is in use by another sweep, is of another kind
  /// or of another sweep, or has a damaged row. An incomplete last line is dropped: the sweep was killed
  /// while it wrote that line.
  SweepTable(const std::string& path, const SweepHeader& header, const std::vector<std::size_t>& own, bool overwrite);
  ~SweepTable();
  SweepTable(const SweepTable&) = delete;
  SweepTable& operator=(const SweepTable&) = delete;

  /// Appends the row of a case to the file in one call. in: number of the case; text: its columns after the varied keys
  /// (sweep_row.hpp). errors: core::FileError.
  void append(std::size_t index, const std::string& text);

  /// Rewrites the file with the rows in the order of the cases. errors: core::FileError.
  void finish() const;

  /// The cases without a row and the cases that failed: a process that died has no result.
  std::vector<std::size_t> missing() const;

  /// True if the row of a case has this status.
  bool has_status(std::size_t index, const std::string& status) const { return rows_[index].starts_with(status + ","); }

  /// One cell in the row of a case. in: the name of a column that is not a varied key. out:
  /// empty if the case has no row.
  std::string cell(std::size_t index, const std::string& column) const;

  /// The number of rows with this status.
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
  std::vector<std::string> rows_;      ///< one per case, without the varied keys; empty if the case has no row yet
  SweepRow columns_;                   ///< the names of the columns
  std::vector<std::string> programs_;  ///< the lines of all programs that computed rows
  std::optional<std::string> lost_;    ///< a line that belongs to none of the cases
  int descriptor_ = -1;
};

}  // namespace ehl::program
