#include "case/map_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/constants.hpp"
#include "deck/commas.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

using deck::ReadNumber;

bool digit(char c) { return c >= '0' && c <= '9'; }

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool says_missing(const std::string& cell) {
  const std::string word = lower(cell);
  if (word.find_first_not_of('*') == std::string::npos || word.find_first_not_of('-') == std::string::npos) return true;
  return std::ranges::any_of(std::initializer_list<const char*>{"nan", "-nan", "bad", "na", "n/a", "null", "void",
                                                                "nodata", "no data", "missing", "invalid"},
                             [&](const char* one) { return word == one; });
}

// True if every comma lies between two digits, and no number contains two commas.
bool commas_are_decimal(const std::string& line) {
  int in_number = 0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] != ',') {
      if (!digit(line[k])) in_number = 0;
      continue;
    }
    if (k == 0 || k + 1 == line.size() || !digit(line[k - 1]) || !digit(line[k + 1]) || ++in_number > 1) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return lines;
}

Writing writing_of(const std::vector<TextLine>& lines) {
  const auto any = [&](char c) {
    return std::ranges::any_of(lines, [&](const TextLine& line) { return line.text.find(c) != std::string::npos; });
  };
  Writing writing;
  const bool blanks = std::ranges::any_of(
      lines, [](const TextLine& line) { return line.text.find_first_of(" \t") != std::string::npos; });
  writing.separator = any(';') ? ';' : ' ';
  const bool decimal = any(',') && !any('.') &&
                       std::ranges::all_of(lines, [](const TextLine& line) { return commas_are_decimal(line.text); });
  writing.decimal_comma = decimal && (writing.separator == ';' || blanks);
  if (writing.separator == ' ' && any(',') && !writing.decimal_comma)
    writing.separator = ',';
  else if (writing.separator == ' ' && any('\t'))
    writing.separator = '\t';
  if (writing.separator != ' ')
    writing.at_end = std::ranges::all_of(lines, [&](const TextLine& line) {
      const std::size_t last = line.text.find_last_not_of(writing.separator == '\t' ? " " : " \t");
      return last != std::string::npos && line.text[last] == writing.separator;
    });
  return writing;
}

std::vector<std::string> cells_of(const std::string& line, const Writing& writing) {
  std::vector<std::string> cells;
  if (writing.separator == ' ') {
    constexpr const char* blanks = " \t";
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string::npos;) {
      const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
      cells.push_back(line.substr(at, end - at));
      at = line.find_first_not_of(blanks, end);
    }
    return cells;
  }
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = line.find(writing.separator, begin);
    cells.push_back(deck::trimmed(line.substr(begin, end == std::string::npos ? end : end - begin)));
  }
  if (writing.at_end && cells.size() > 1) cells.pop_back();
  return cells;
}

namespace {

// The number in a cell; NaN if it marks a missing point. out: wrong: the cell, if it is neither.
double height_of(const std::string& cell, const Writing& writing, std::string& wrong) {
  if (cell.empty() || says_missing(cell)) return core::unknown;
  std::string number = cell;
  if (writing.decimal_comma) std::ranges::replace(number, ',', '.');
  const ReadNumber read = deck::read_number(number);
  if (read.status != ReadNumber::Status::number)
    wrong = deck::quoted(cell) +
            (read.status == ReadNumber::Status::not_finite || read.status == ReadNumber::Status::out_of_reach
                 ? " is not a finite number"
                 : " is not a number");
  return read.value;
}

// What is wrong if every comma of the file may be a decimal comma or a separator of thousands, "1,234"; else empty.
std::string undecided_commas(const std::vector<TextLine>& lines, const Writing& writing, const std::string& name) {
  if (!writing.decimal_comma) return {};
  std::string undecided;
  for (const TextLine& line : lines)
    for (const std::string& cell : cells_of(line.text, writing)) {
      const deck::Commas commas = deck::commas_of(cell);
      if (commas == deck::Commas::decimal) return {};
      if (commas == deck::Commas::either && undecided.empty())
        undecided = name + ":" + std::to_string(line.number) + ": " + deck::two_meanings(cell);
    }
  return undecided;
}

}  // namespace

std::string read_numbers(const std::vector<TextLine>& lines, const std::string& name,
                         const std::function<std::string(const std::vector<double>& row)>& take) {
  const Writing writing = writing_of(lines);
  if (std::string wrong = undecided_commas(lines, writing, name); !wrong.empty()) return wrong;
  std::vector<double> row;
  for (const TextLine& line : lines) {
    const std::vector<std::string> cells = cells_of(line.text, writing);
    std::string wrong;
    row.clear();
    for (std::size_t k = 0; k < cells.size() && wrong.empty(); ++k) {
      row.push_back(height_of(cells[k], writing, wrong));
      if (!wrong.empty())
        wrong = fmt::format("column {}: {}; a missing point is an empty cell, NaN, BAD or ***", k + 1, wrong);
    }
    if (wrong.empty()) wrong = take(row);
    if (!wrong.empty()) return fmt::format("{}:{}: {}", name, line.number, wrong);
  }
  return {};
}

bool is_numbers(const std::string& line) {
  const Writing writing = writing_of({{1, line}});
  const std::vector<std::string> cells = cells_of(line, writing);
  bool number = false;
  for (const std::string& cell : cells) {
    const ReadNumber::Status status = [&] {
      std::string text = cell;
      std::ranges::replace(text, ',', '.');
      return deck::read_number(text).status;
    }();
    number |= status == ReadNumber::Status::number || status == ReadNumber::Status::trailing_text;
  }
  // A first line with one number among its cells is a row of heights, not a heading.
  return number || (cells.size() > 1 && std::ranges::all_of(cells, [](const std::string& cell) {
                      return cell.empty() || says_missing(cell);
                    }));
}

std::pair<std::string, std::string> entry_of(const std::string& line, bool by_blank) {
  std::size_t at = line.find_first_of(":=");
  if (at == std::string::npos && by_blank) at = line.find_first_of(" \t");
  if (at == std::string::npos) return {};
  return {lower(deck::trimmed(line.substr(0, at))), deck::trimmed(line.substr(at + 1))};
}

double metres_of(const std::string& unit) {
  struct Unit {
    const char* name;
    double metres;
  };
  constexpr Unit units[] = {{"m", 1.0},       {"metre", 1.0},      {"meter", 1.0},      {"mm", 1e-3},
                            {"um", 1e-6},     {"\xC2\xB5m", 1e-6}, {"\xCE\xBCm", 1e-6}, {"\xB5m", 1e-6},
                            {"micron", 1e-6}, {"microns", 1e-6},   {"nm", 1e-9},        {"pm", 1e-12},
                            {"A", 1e-10},     {"\xC3\x85", 1e-10}};
  const std::string word = deck::trimmed(unit);
  for (const Unit& one : units)
    if (word == one.name) return one.metres;
  return core::unknown;
}

double length_of(const std::string& text) {
  const ReadNumber read = deck::read_number(text);
  if (read.status != ReadNumber::Status::trailing_text) return core::unknown;
  const std::size_t at = text.rfind(read.trailing);
  const ReadNumber number = deck::read_number(deck::trimmed(text.substr(0, at)));
  return number.value * metres_of(read.trailing);
}

std::string in_brackets(const std::string& text) {
  const std::size_t open = text.find_first_of("[(");
  const std::size_t close = text.find_first_of("])", open == std::string::npos ? 0 : open);
  if (open == std::string::npos || close == std::string::npos) return {};
  return deck::trimmed(text.substr(open + 1, close - open - 1));
}

}  // namespace ehl::program
