#pragma once
// The tables of `ehl sweep` and `ehl study` as CSV: what comments say where a table is from, and rows by their columns.
// Only the last cell of a row, a sentence between quotes, may hold commas.
#include <string>
#include <vector>

#include "base/column.hpp"
#include "core/errors.hpp"
#include "deck/file.hpp"

namespace ehl::program {

/// A number (the shortest text that reads back as it; NaN where it is not finite), a count, 1 or 0, or one word for
/// every reader of tables: no comma, no quote, no comment, one line.
std::string csv_cell(const Value& value);

/// The cells of a row, no more than there are columns; a sentence without its quotes.
std::vector<std::string> csv_cells(const std::string& line, std::size_t columns);

/// What a cell says, as a value of the same kind as `like`. errors: core::FileError.
Value csv_value(const std::string& cell, const Value& like);

/// A row: its names, its values, of which the last is a sentence, and "# units: p_h [Pa], seconds [s]" of what is no
/// pure number.
std::string csv_names(const std::vector<results::Quantity>& row);
std::string csv_row(const std::vector<results::Quantity>& row);
std::string csv_units(const std::vector<results::Quantity>& row);

/// A row as text.
template <class Row>
std::string csv_text(const std::vector<Column<Row>>& columns, const Row& row) {
  return csv_row(quantities_of(columns, row));
}

/// The row again, without what follows from the rest. errors: core::FileError.
template <class Row>
Row csv_read(const std::vector<Column<Row>>& columns, const std::string& line) try {
  Row row;
  const std::vector<std::string> cells = csv_cells(line, columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].set) columns[k].set(row, csv_value(k < cells.size() ? cells[k] : "", columns[k].get(row)));
  return row;
} catch (const core::FileError& error) {
  throw core::FileError("this line is no row of a study: " + line.substr(0, 120) + ": " + error.what());
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

/// A whole table as a file. errors: core::FileError.
void write_table(const std::string& path, const std::string& text, bool overwrite);

/// "812 bytes, 6f0d...": enough to notice that a text is another one.
std::string size_and_hash(const std::string& text);
/// "# deck text: 812 bytes, 6f0d...".
std::string deck_text_line(const std::string& deck_text);
/// "# file: oil.csv: 812 bytes, 6f0d...", the same of a file that a deck names.
std::string file_line(const deck::NamedFile& file);

/// Version, commit and compiler of this program.
std::string this_program();

}  // namespace ehl::program
