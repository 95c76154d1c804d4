#pragma once
// Tables in text files from spreadsheets, instruments, R and Python.
#include <string>
#include <variant>
#include <vector>

#include "deck/file.hpp"

namespace ehl::deck {

/// Cells of a file. The separator is semicolon, tab, comma or blank, the same for the whole file; a cell may be quoted.
/// A comma with another separator is a decimal comma and becomes a point. Lines end with LF, CRLF or CR. An empty last
/// cell after a trailing separator is dropped. # begins a comment.
struct TextTable {
  Row heading{};               ///< the first line if none of its cells is a number; else without cells
  Row units{};                 ///< a line with only units below the heading; else without cells
  std::vector<Row> remarks{};  ///< comments above the first row, which may contain the heading
  std::vector<Row> rows{};
};

/// errors: core::FileError if the file cannot be read, is larger than `largest` bytes, contains a NUL character, is not
/// text, or mixes decimal commas and decimal points.
TextTable read_text_table(const std::string& path, std::uintmax_t largest, const std::string& note = {});

/// A cell of a heading, "eta [mPa s]", "SRR (%)", "p / MPa": name, and unit or empty.
struct HeadingCell {
  std::string name{};
  std::string unit{};
};
HeadingCell heading_cell(const std::string& cell);

/// A column that a reader requests.
struct Column {
  std::vector<std::string> names{};  ///< the first for messages; letter case, blanks, _ and - are ignored
  std::string unit{};  ///< of the returned values: an SI unit of units.hpp, or the name of a scale, "a/u_m"
  bool required = true;
  std::string meaning{};  ///< added in messages: "over that of [contact]"
};

/// The requested values of one row.
struct ColumnRow {
  std::string place{};           ///< "oil.csv:12"
  std::vector<double> values{};  ///< one per requested column; NaN if the file lacks it
};

/// The requested columns of a table.
struct ColumnTable {
  std::vector<bool> present{};  ///< columns that the file has
  std::vector<ColumnRow> rows{};
};

/// The columns, or what is wrong with the file: "oil.csv:1: ...".
using ReadColumns = std::variant<ColumnTable, std::string>;

/// Reads columns by the names and units of the heading, in any order, and converts them. Without a heading the columns
/// have the requested order and units; a column without unit in the heading has the requested unit. A comment counts as
/// heading if it names the requested columns. errors: core::FileError as above.
ReadColumns read_columns(const std::string& path, const std::vector<Column>& wanted, const std::string& note = {});

/// Conversion of a unit. in: from, the unit of the heading, may be empty; to, the requested unit. out: factor and
/// offset; wrong: what is wrong, or empty.
struct Conversion {
  double factor = 1.0, offset = 0.0;
  std::string wrong{};
};
Conversion conversion(const std::string& from, const std::string& to);

}  // namespace ehl::deck
