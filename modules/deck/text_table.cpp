#include "deck/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "core/errors.hpp"
#include "deck/commas.hpp"
#include "deck/text.hpp"

namespace ehl::deck {
namespace {

struct Line {
  int number = 0;
  std::string text{}, remark{};
};

// Position of the first of the characters `wanted` outside quotes; npos: none.
std::size_t outside_quotes(const std::string& text, const char* wanted, std::size_t from = 0) {
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '"') quoted = !quoted;
    if (!quoted && k >= from && std::string_view(wanted).find(text[k]) != std::string_view::npos) return k;
  }
  return std::string::npos;
}

std::vector<Line> lines_of(const std::string& content) {
  std::vector<Line> lines;
  int number = 0;
  for (std::size_t begin = 0; begin < content.size();) {
    const std::size_t end = std::min(content.find_first_of("\r\n", begin), content.size());
    const std::string whole = content.substr(begin, end - begin);
    begin = end + (content.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    const std::size_t remark = outside_quotes(whole, "#");
    Line line{++number, trimmed(whole.substr(0, remark)), {}};
    if (remark != std::string::npos) line.remark = trimmed(whole.substr(remark + 1));
    if (!line.text.empty() || !line.remark.empty()) lines.push_back(line);
  }
  return lines;
}

std::string unquoted(std::string cell) {
  cell = trimmed(cell);
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
  cell = cell.substr(1, cell.size() - 2);
  for (std::size_t at = cell.find("\"\""); at != std::string::npos; at = cell.find("\"\"", at + 1)) cell.erase(at, 1);
  return trimmed(cell);
}

std::vector<std::string> cells_between(const std::string& text, char separator) {
  if (separator == ' ') {
    std::vector<std::string> cells;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(outside_quotes(text, " \t", begin), text.size());
      if (end > begin) cells.push_back(unquoted(text.substr(begin, end - begin)));
      begin = end + 1;
    }
    return cells;
  }
  std::vector<std::string> cells;
  const char wanted[] = {separator, '\0'};
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
    end = outside_quotes(text, wanted, begin);
    cells.push_back(unquoted(text.substr(begin, end == std::string::npos ? end : end - begin)));
  }
  return cells;
}

bool is_number(const std::string& cell) { return read_number(cell).status != ReadNumber::Status::not_a_number; }

// True for "1,5 2,5": decimal commas in a line whose cells are separated by blanks.
bool has_decimal_commas_between_blanks(const std::string& text) {
  const std::vector<std::string> words = cells_between(text, ' ');
  return words.size() > 1 && std::ranges::all_of(words, [](const std::string& word) {
           return std::ranges::count(word, ',') <= 1 && !word.ends_with(',') && !word.starts_with(',') &&
                  std::isdigit(static_cast<unsigned char>(word.back())) != 0;
         });
}

// Separator of a file, the same in all its lines.
char separator_of(const std::vector<Line>& lines) {
  const auto any = [&](const char* which) {
    return std::ranges::any_of(lines,
                               [&](const Line& line) { return outside_quotes(line.text, which) != line.text.npos; });
  };
  if (any(";")) return ';';
  const bool comma = any(",");
  const auto comma_before_tab = [](const Line& line) { return line.text.find(",\t") != std::string::npos; };
  if (any("\t") && (!comma || !std::ranges::any_of(lines, comma_before_tab))) return '\t';
  if (!comma) return ' ';
  return std::ranges::any_of(lines, [](const Line& line) { return has_decimal_commas_between_blanks(line.text); })
             ? ' '
             : ',';
}

bool is_heading_row(const std::vector<std::string>& cells) {
  return !cells.empty() && std::ranges::none_of(cells, is_number) &&
         std::ranges::any_of(cells, [](const std::string& cell) { return !cell.empty(); });
}

// Replaces decimal commas by points. errors: numbers that are not written alike, or that have two meanings.
void read_decimal_commas(TextTable& table) {
  std::string decimal, point;
  std::pair<std::string, std::string> thousands, either;  // place and cell
  for (const Row& row : table.rows)
    for (const std::string& cell : row.cells) {
      const Commas commas = commas_of(cell);
      if (commas == Commas::none && cell.find('.') != std::string::npos && is_number(cell)) point = row.place;
      if (commas == Commas::decimal) decimal = row.place;
      if (commas == Commas::thousands && thousands.first.empty()) thousands = {row.place, cell};
      if (commas == Commas::either && either.first.empty()) either = {row.place, cell};
    }
  if (!thousands.first.empty())
    throw core::FileError(thousands.first + ": " + deck::quoted(thousands.second) +
                          ": write numbers without separators of thousands");
  if (const std::string& comma = decimal.empty() ? either.first : decimal; !comma.empty() && !point.empty())
    throw core::FileError(comma + ": a decimal comma, but " + point +
                          " has a decimal point: write all numbers of a file alike");
  if (decimal.empty() && !either.first.empty())
    throw core::FileError(either.first + ": " + two_meanings(either.second));
  for (Row& row : table.rows)
    for (std::string& cell : row.cells)
      if (const Commas commas = commas_of(cell); commas == Commas::decimal || commas == Commas::either)
        std::ranges::replace(cell, ',', '.');
}

// Drops the empty last cell of each row after a trailing separator.
void drop_trailing(TextTable& table) {
  const auto ends_empty = [](const Row& row) { return row.cells.size() > 1 && row.cells.back().empty(); };
  if (table.rows.empty() || !std::ranges::all_of(table.rows, ends_empty)) return;
  const std::size_t columns = table.rows.front().cells.size();
  for (Row& row : table.rows) row.cells.pop_back();
  for (Row* row : {&table.heading, &table.units})
    if (row->cells.size() == columns && row->cells.back().empty()) row->cells.pop_back();
}

}  // namespace

TextTable read_text_table(const std::string& path, std::uintmax_t largest, const std::string& note) {
  const std::string content = content_of(path, largest, note);
  if (content.find('\0') != std::string::npos)
    throw core::FileError(path + ": contains a NUL character, so it is not a text file in UTF-8" + note);
  std::vector<Line> lines = lines_of(content);
  const char separator = separator_of(lines);
  TextTable table;
  for (const Line& line : lines) {
    Row row{fmt::format("{}:{}", path, line.number), cells_between(line.text, separator)};
    if (line.text.empty()) {
      if (table.rows.empty()) table.remarks.push_back({row.place, cells_between(line.remark, separator)});
      continue;
    }
    const bool text_alone = table.rows.empty() && is_heading_row(row.cells);
    if (text_alone && table.heading.cells.empty())
      table.heading = row;
    else if (text_alone && table.units.cells.empty() && std::ranges::all_of(row.cells, [](const std::string& cell) {
               return cell.empty() || !heading_cell("x " + cell).unit.empty();
             }))
      table.units = row;
    else
      table.rows.push_back(row);
  }
  drop_trailing(table);
  if (separator != ',') read_decimal_commas(table);
  return table;
}

}  // namespace ehl::deck
