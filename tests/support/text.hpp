#pragma once
// Texts that a program writes: their parts, tables by the names of their columns, the reason of a refusal.
#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace support {

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A row of a table by the names of its columns.
using NamedRow = std::map<std::string, std::string>;

/// The rows of a CSV table without the lines that begin with "#". The last column may contain
/// commas, which are dropped.
inline std::vector<NamedRow> named_rows(const std::string& table) {
  std::vector<std::string> names;
  std::vector<NamedRow> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    if (names.empty()) {
      names = cells;
      continue;
    }
    rows.emplace_back();
    for (std::size_t k = 0; k < cells.size(); ++k) rows.back()[names[std::min(k, names.size() - 1)]] += cells[k];
  }
  return rows;
}

/// The message of the exception that the call throws; "(none)" if it throws none.
template <class Error = std::runtime_error, class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "(none)";
}

}  // namespace support
