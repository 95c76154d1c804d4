#pragma once
#include <string>

namespace ehl::program {

/// What was built, from which source, by what.
struct Version {
  std::string number{};  ///< of the release
  std::string commit{};  ///< of the source; "unknown" outside a repository
  bool dirty = false;    ///< the source had changes that no commit holds
  std::string compiler{};
};
Version version();

}  // namespace ehl::program
