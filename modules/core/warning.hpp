#pragma once
// What a user must know about a case that is solved all the same.
#include <string>
#include <vector>

namespace ehl::core {

/// A warning. Its name is given where the warning is raised and never changes: tables and scripts count on it. The
/// sentence may be reworded.
struct Warning {
  std::string name{};  ///< one word, "map-lost"
  std::string text{};  ///< one sentence with the numbers and the remedy
};

using Warnings = std::vector<Warning>;

/// "the mesh loses ... [map-lost]", as reports, files and pages write a warning.
inline std::string with_name(const Warning& warning) { return warning.text + " [" + warning.name + "]"; }

/// Each of them as above.
inline std::vector<std::string> with_names(const Warnings& warnings) {
  std::vector<std::string> texts;
  for (const Warning& warning : warnings) texts.push_back(with_name(warning));
  return texts;
}

}  // namespace ehl::core
