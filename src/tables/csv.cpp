#include "tables/csv.hpp"

#include <fmt/core.h>

#include <cmath>
#include <span>

#include "base/version.hpp"
#include "deck/text.hpp"
#include "results/atomic_file.hpp"

namespace ehl::program {
namespace {

std::string plain(std::string text, const std::string& instead_of_comma) {
  for (char& c : text) {
    if (c == '"') c = '\'';
    if (c == '#' || static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  for (std::size_t at = text.find(','); at != std::string::npos; at = text.find(',', at + 1))
    text.replace(at, 1, instead_of_comma);
  return deck::trimmed(text);
}

}  // namespace

std::string csv_cell(const Value& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return plain(*word, ";");
  const double number = results::number(value);
  return std::isfinite(number) ? deck::shortest(number) : "NaN";
}

Value csv_value(const std::string& cell, const Value& like) {
  if (std::holds_alternative<std::string>(like)) return cell;
  const deck::ReadNumber read = deck::read_number(cell);
  const bool known = read.status == deck::ReadNumber::Status::number;
  if (std::holds_alternative<double>(like) && (known || cell == "NaN")) return known ? read.value : std::nan("");
  if (std::holds_alternative<int>(like) && known) return static_cast<int>(read.value);
  if (std::holds_alternative<bool>(like) && (cell == "0" || cell == "1")) return cell == "1";
  throw core::FileError("this is not a number: '" + cell.substr(0, 40) + "'");
}

std::string csv_names(const std::vector<results::Quantity>& row) {
  std::string line;
  for (const results::Quantity& one : row) line += (line.empty() ? "" : ",") + one.name;
  return line;
}

std::string csv_row(const std::vector<results::Quantity>& row) {
  std::string line;
  for (const results::Quantity& one : row)
    line += &one == &row.back() ? '"' + plain(std::get<std::string>(one.value), ",") + '"' : csv_cell(one.value) + ",";
  return line;
}

std::string csv_units(const std::vector<results::Quantity>& row) {
  std::string line;
  for (const results::Quantity& one : row)
    if (!one.unit.empty() && one.unit != "-")
      line += fmt::format("{}{} [{}]", line.empty() ? "# units: " : ", ", one.name, one.unit);
  return line;
}

std::vector<std::string> csv_cells(const std::string& line, std::size_t columns) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (std::size_t comma = 0; cells.size() + 1 < columns && (comma = line.find(',', begin)) != std::string::npos;
       begin = comma + 1)
    cells.push_back(line.substr(begin, comma - begin));
  const std::string last = line.substr(begin);
  const bool sentence = last.size() >= 2 && last.front() == '"' && last.back() == '"';
  cells.push_back(sentence ? last.substr(1, last.size() - 2) : last);
  return cells;
}

void write_table(const std::string& path, const std::string& text, bool overwrite) {
  results::write_atomically(path, std::as_bytes(std::span(text)), overwrite);
}

std::string size_and_hash(const std::string& text) {
  return fmt::format("{} bytes, {:016x}", text.size(), deck::hash(text));
}

std::string deck_text_line(const std::string& deck_text) { return "# deck text: " + size_and_hash(deck_text); }

std::string file_line(const deck::NamedFile& file) { return "# file: " + deck::fingerprint(file); }

std::string this_program() {
  const Version built = version();
  return "ehl " + built.number + ", commit " + built.commit + (built.dirty ? " with changes" : "") + ", " +
         built.compiler;
}

}  // namespace ehl::program
