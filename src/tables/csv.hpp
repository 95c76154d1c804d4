#pragma once
// The tables of `ehl sweep` and `ehl study` as CSV: comments with the origin of the table, and rows with one cell per
// column. Only the last cell of a row, a sentence in quotes, may contain commas.
#include <string>
#include <vector>

#include "base/column.hpp"
#include "core/errors.hpp"
#include "deck/file.hpp"

namespace ehl::program {

/// A cell that every reader of tables understands: no comma, no quote, no comment sign, one line. A number is the
/// shortest text that reads back as the same number, NaN if it is not finite; a count; 1 or 0; or one word.
std::string csv_cell(const Value& value);

/// The cells of a row, at most `columns` of them; the sentence comes without its quotes.
std::vector<std::string> csv_cells(const std::string& line, std::size_t columns);

/// The value of a cell, of the same type as `like`. errors: core::FileError.
Value csv_value(const std::string& cell, const Value& like);

/// The names and the values of a row; the last value is a sentence. The units of all quantities that are not pure
/// numbers: "# units: p_h [Pa], seconds [s]".
std::string csv_names(const std::vector<results::Quantity>& row);
std::string csv_row(const std::vector<results::Quantity>& row);
std::string csv_units(const std::vector<results::Quantity>& row);

/// A row as text.
template <class Row>
std::string csv_text(const std::vector<Column<Row>>& columns, const Row& row) {
  return csv_row(quantities_of(columns, row));
}

/// The row that a line contains; quantities that follow from others are not set. errors: core::FileError.
template <class Row>
Row csv_read(const std::vector<Column<Row>>& columns, const std::string& line) try {
  Row row;
  const std::vector<std::string> cells = csv_cells(line, columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].set) columns[k].set(row, csv_value(k < cells.size() ? cells[k] : "", columns[k].get(row)));
  return row;
} catch (const core::FileError& error) {
  throw core::FileError("this line is not a row of a study: " + line.substr(0, 120) + ": " + error.what());
}

/// A whole table: comments, the units and the names of the columns, the rows.
template <class Row>
std::string csv_table(const std::string& comments, const std::vector<Column<Row>>& columns,
                      const std::vector<Row>& rows) {
  const std::vector<results::Quantity> names = quantities_of(columns, Row{});
  std::string text = comments + csv_units(names) + "\n" + csv_names(names) + "\n";
  for (const Row& row : rows) text += csv_text(columns, row) + "\n";
  return text;
}

/// Writes a whole table to a file. errors: core::FileError.
void write_table(const std::string& path, const std::string& text, bool overwrite);

/// "812 bytes, 6f0d...": this identifies a text.
std::string size_and_hash(const std::string& text);
/// The line that identifies the text of the deck: "# deck text: 812 bytes, 6f0d...".
std::string deck_text_line(const std::string& deck_text);
/// The line that identifies a file named in the deck: "# file: oil.csv: 812 bytes, 6f0d...".
std::string file_line(const deck::NamedFile& file);

/// Version, commit and compiler of this program.
std::string this_program();

}  // namespace ehl::program
