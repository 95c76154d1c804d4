#pragma once
// Lines of numbers as instruments and spreadsheets write them.
#include <string>
#include <utility>
#include <vector>

namespace ehl::program {

/// A line of the file that is no comment.
struct TextLine {
  int number = 0;  ///< from 1
  std::string text{};
};

/// How a file writes its numbers.
struct Writing {
  char separator = ' ';        ///< ' ': blanks
  bool decimal_comma = false;  ///< and no decimal point
  bool at_end = false;         ///< a separator stands at the end of every line
};

/// Lines between LF, CR LF or CR.
std::vector<std::string> lines_of(const std::string& text);

/// The separator of all lines of numbers together: between semicolons or tabs where there are some; between commas
/// where they are no decimal commas; else between blanks. Commas are decimal where no number has a point, every comma
/// stands between digits, and another separator is there.
Writing writing_of(const std::vector<TextLine>& lines);

/// The cells of a line, an empty one for what is missing between two separators.
std::vector<std::string> cells_of(const std::string& line, const Writing& writing);

/// A number; NaN where the cell is empty or a word for a missing point (BAD, NaN, ***). wrong: what else it is.
double height_of(const std::string& cell, const Writing& writing, std::string& wrong);

/// True where every cell is a number or says that a point is missing.
bool is_numbers(const std::string& line);

/// "name: value", "name = value", "name value": name in lower case, value; both empty where the line is none of them.
std::pair<std::string, std::string> entry_of(const std::string& line, bool by_blank);

/// Metres of a unit: m, mm, um, µm, nm, pm, A; NaN: another word.
double metres_of(const std::string& unit);

/// "64 µm", "2e-6 m" in metres; NaN: no length.
double length_of(const std::string& text);

/// What stands in brackets, "z [nm]", "x (um)"; empty: nothing.
std::string in_brackets(const std::string& text);

}  // namespace ehl::program
