#include "tables/csv.hpp"

#include <cmath>
#include <cstdint>

#include "deck/text.hpp"
#include "report/text_format.hpp"
#include "report/version.hpp"

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

// Fowler, Noll and Vo's 64-bit hash (FNV-1a).
std::uint64_t hash(const std::string& text) {
  std::uint64_t value = 14695981039346656037ULL;
  for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return value;
}

}  // namespace

std::string csv_number(double value) { return std::isfinite(value) ? deck::shortest(value) : "NaN"; }

std::string csv_word(const std::string& text) { return plain(text, ";"); }

std::string csv_quoted(const std::string& text) {
  std::string result(1, '"');
  result += plain(text, ",");
  return result + '"';
}

std::vector<std::string> csv_cells(const std::string& line, std::size_t columns) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  while (cells.size() + 1 < columns) {
    const std::size_t comma = line.find(',', begin);
    if (comma == std::string::npos) break;
    cells.push_back(line.substr(begin, comma - begin));
    begin = comma + 1;
  }
  std::string last = line.substr(begin);
  if (last.size() >= 2 && last.front() == '"' && last.back() == '"') last = last.substr(1, last.size() - 2);
  cells.push_back(last);
  return cells;
}

std::string deck_text_line(const std::string& deck_text) {
  return formatted("# deck text: %zu bytes, %016llx", deck_text.size(),
                   static_cast<unsigned long long>(hash(deck_text)));
}

std::string this_program() {
  const Version built = version();
  return "ehl " + built.number + ", commit " + built.commit + (built.dirty ? " with changes" : "") + ", " +
         built.compiler;
}

}  // namespace ehl::program
