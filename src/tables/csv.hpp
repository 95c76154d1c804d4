#pragma once
// What the tables of `ehl sweep` and `ehl study` have in common: cells of a row, and lines that say where it is from.
#include <string>
#include <vector>

namespace ehl::program {

/// The shortest text that reads back as the number; NaN where it is not finite.
std::string csv_number(double value);

/// One word for every reader of tables: no comma, no quote, no comment, one line.
std::string csv_word(const std::string& text);

/// A sentence between quotes, which may hold commas.
std::string csv_quoted(const std::string& text);

/// The cells of a row; only the last one may hold commas. in: number of columns. out: fewer cells where the line has
/// fewer; a sentence without its quotes.
std::vector<std::string> csv_cells(const std::string& line, std::size_t columns);

/// "# deck text: 812 bytes, 6f0d...": enough to notice that a deck is another one.
std::string deck_text_line(const std::string& deck_text);

/// Version, commit and compiler of this program.
std::string this_program();

}  // namespace ehl::program
