// The discrete Reynolds operator is implemented in two files only, its fluxes and its rows; typical expressions reveal
// a second implementation.
#include <algorithm>
#include <regex>

#include "structure/house.hpp"

namespace house {
namespace {

struct Pattern {
  std::string what;
  std::regex looks_like;
};

const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> all = {
      {"half a cell's 1/h^2", std::regex(R"(\b0\.5 / \([^;]*\bh[xy]\b)")},
      {"a mean of epsilon between nodes", std::regex(R"(\beps\w*(\([^()]*\))? \+ (\w+\.)?eps\w*\b)")},
      {"a mean of epsilon between nodes", std::regex(R"(\* half_over_h[xy]2)")},
      {"a row put together from its terms", std::regex(R"(\btransported\([^;]* - [^;]*\bpoiseuille\()")},
      {"a weight of the wedge", std::regex(R"(\b1\.5 (/ \w*\.?hx|\* (rho_H|q|Q)\b))")},
  };
  return all;
}

}  // namespace

std::vector<std::string> operator_offences(const std::vector<SourceFile>& files,
                                           const std::vector<std::string>& homes) {
  static const std::regex comment("//[^\n]*");
  std::vector<std::string> offences;
  for (const SourceFile& file : files) {
    const std::string path = file.path.generic_string();
    if (std::ranges::find(homes, path) != homes.end()) continue;
    const std::string code = std::regex_replace(file.text, comment, "");
    for (const Pattern& pattern : patterns()) {
      if (!std::regex_search(code, pattern.looks_like)) continue;
      offences.push_back(path);
      break;
    }
  }
  return offences;
}

}  // namespace house
