#pragma once
#include <string>

namespace ehl::program {

/// The version of this build: its release, its source, and its compiler.
struct Version {
  std::string number{};  ///< of the release
  std::string commit{};  ///< of the source; "unknown" outside a repository
  bool dirty = false;    ///< the source contained changes that were not committed
  std::string compiler{};
};
/// The version of this program, written when it was built.
Version version();

}  // namespace ehl::program
