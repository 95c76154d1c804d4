#pragma once
// What `ehl extract` prints, as numbers.
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace support {

/// Rows of numbers under a header of "#".
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
