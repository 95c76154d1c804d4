#include "tables/warning_names.hpp"

#include <algorithm>
#include <vector>

#include "deck/text.hpp"

namespace ehl::program {

std::string names_of_warnings(const core::Warnings& warnings) {
  std::vector<std::string> found;
  for (const core::Warning& warning : warnings)
    if (std::ranges::find(found, warning.name) == found.end()) found.push_back(warning.name);
  return found.empty() ? "none" : deck::joined(found, " ");
}

std::string meaning_of_warnings() {
  return "warnings: names that end the sentences of `ehl run`, mesh: the film is not resolved; " +
         std::string(hardly_an_error) + ": the estimated error of Hc or Hm is 100 % or more; none";
}

}  // namespace ehl::program
