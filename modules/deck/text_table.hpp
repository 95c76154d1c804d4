#pragma once
// Tables in text files as people's programs write them: spreadsheets, instruments, R, Python.
#include <string>
#include <variant>
#include <vector>

#include "deck/file.hpp"

namespace ehl::deck {

/// The cells of a file. Cells stand between semicolons, tabs, commas or blanks, whichever the whole file uses; a cell
/// may be quoted. A comma beside another separator is a decimal comma and reads as a point here. Lines end with LF,
/// CRLF or CR; an empty last cell that a trailing separator leaves is dropped; # begins a comment.
struct TextTable {
  Row heading{};               ///< the first line where none of its cells is a number; no cells: there is none
  Row units{};                 ///< a line of units alone below the heading; no cells: there is none
  std::vector<Row> remarks{};  ///< comments above the first row, which may hold the heading
  std::vector<Row> rows{};
};

/// errors: core::FileError where the file cannot be read, is larger than `largest` bytes, holds a NUL character or is
/// not text; decimal commas beside decimal points.
TextTable read_text_table(const std::string& path, std::uintmax_t largest, const std::string& note = {});

/// A cell of a heading, "eta [mPa s]", "SRR (%)", "p / MPa": the name and the unit; no unit: empty.
struct HeadingCell {
  std::string name{};
  std::string unit{};
};
HeadingCell heading_cell(const std::string& cell);

/// A column that a reader takes.
struct Column {
  std::vector<std::string> names{};  ///< the first for messages; letter case, blanks, _ and - do not count
  std::string unit{};  ///< of the values returned: an SI unit of units.hpp, or a scale's own name, "a/u_m"
  bool required = true;
  std::string meaning{};  ///< added in messages: "over that of [contact]"
};

struct ColumnRow {
  std::string place{};           ///< "oil.csv:12"
  std::vector<double> values{};  ///< one per column that was asked for; NaN where the file does not have it
};

struct ColumnTable {
  std::vector<bool> present{};  ///< which columns the file has
  std::vector<ColumnRow> rows{};
};

/// The columns, or what is wrong with the file: "oil.csv:1: ...".
using ReadColumns = std::variant<ColumnTable, std::string>;

/// Numbers by the names and units of the file's heading, in any order, converted. Without a heading the columns stand
/// in the order in which they are asked for and have the unit in which they are returned; so has a column whose heading
/// names no unit. A heading in a comment counts where it names the columns asked for. errors: core::FileError as above.
ReadColumns read_columns(const std::string& path, const std::vector<Column>& wanted, const std::string& note = {});

/// A value of a column in the key's or column's unit. in: the cell; the unit of the heading, may be empty.
/// out: factor and offset. what is wrong, or empty.
struct Conversion {
  double factor = 1.0, offset = 0.0;
  std::string wrong{};
};
Conversion conversion(const std::string& from, const std::string& to);

}  // namespace ehl::deck
