#pragma once
// Reads the columns that `ehl extract` prints.
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace support {

/// The rows of numbers below a heading whose lines begin with "#".
inline std::vector<std::vector<double>> rows_of(const std::string& text) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    rows.emplace_back();
    for (std::string word; words >> word;) rows.back().push_back(std::atof(word.c_str()));
  }
  return rows;
}

}  // namespace support
