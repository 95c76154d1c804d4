#pragma once
// Reads lines of numbers in the forms that instruments and spreadsheets write.
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ehl::program {

/// Most heights of a map, as of one in HDF5.
inline constexpr std::size_t most_heights = 100'000'000;

/// A line of the file that is not a comment.
struct TextLine {
  int number = 0;  ///< line number, from 1
  std::string text{};
};

/// The format of the numbers in a file.
struct Writing {
  char separator = ' ';        ///< ' ': blanks
  bool decimal_comma = false;  ///< a comma instead of the decimal point
  bool at_end = false;         ///< every line ends with a separator
};

/// Splits a text at LF, CR LF or CR.
std::vector<std::string> lines_of(const std::string& text);

/// The format of all lines of numbers together. The separator is a semicolon or a tab if one occurs; else a comma,
/// unless commas are decimal; else a blank. Commas are decimal if no number has a point, every comma lies between
/// digits, and there is another separator.
Writing writing_of(const std::vector<TextLine>& lines);

/// The cells of a line; an empty cell if nothing stands between two separators.
std::vector<std::string> cells_of(const std::string& line, const Writing& writing);

/// Calls `take` with the numbers of every line; NaN where a cell is empty or has a word for a missing point (BAD, NaN,
/// ***). in: the name of the file for messages; take: returns what is wrong with its line. out: what is wrong with the
/// file: "map.txt:12: ...", a cell that is no number, or commas that may be decimal or separate thousands; else empty.
std::string read_numbers(const std::vector<TextLine>& lines, const std::string& name,
                         const std::function<std::string(const std::vector<double>& row)>& take);

/// True if every cell is a number or marks a missing point.
bool is_numbers(const std::string& line);

/// Splits "name: value", "name = value" or, with by_blank, "name value". out: the name in lower case, and the value;
/// both empty for any other line.
std::pair<std::string, std::string> entry_of(const std::string& line, bool by_blank);

/// The unit in metres: m, mm, um, µm, nm, pm, A; NaN for another word.
double metres_of(const std::string& unit);

/// A length with its unit, "64 µm" or "2e-6 m", in metres; NaN if the text is no length.
double length_of(const std::string& text);

/// The text in brackets, "z [nm]" or "x (um)"; empty if there are none.
std::string in_brackets(const std::string& text);

}  // namespace ehl::program
