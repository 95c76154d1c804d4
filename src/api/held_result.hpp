#pragma once
// What stands behind a result of the C interface.
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "case/computed.hpp"
#include "case/scene.hpp"
#include "results/entries.hpp"
#include "results/one_line.hpp"

namespace ehl::program {

/// Numbers and texts that stay where they are until the result goes.
struct HeldEntry {
  results::Entry entry{};
  std::string error{};             ///< path of its error; empty: none
  const double* values = nullptr;  ///< of numbers
  std::ptrdiff_t strides[3] = {};
};

struct HeldResult {
  int status = 0;
  std::vector<std::string> messages{};
  std::vector<std::string> warnings{};
  std::string report{};
  std::string json{};
  std::deque<HeldEntry> entries{};
  std::map<std::string, const HeldEntry*> by_path{};
  std::optional<results::Content> content{};  ///< of a case that was run
  // What the entries and the content point to.
  std::optional<Case> input{};
  Computed computed{};
  std::optional<results::OneLine> line{};
};

/// A case from a deck. in: its text, or nullptr: the file `name`. errors: core::InputError, core::FileError.
Case case_from(const char* text, const std::string& name, const std::vector<std::string>& overrides, int threads);

/// Fill the result; what goes wrong is in it. None throws but std::bad_alloc.
void run_into(HeldResult& result, const std::function<Case()>& read, Progress::Listener listener);
void check_into(HeldResult& result, const std::function<Case()>& read);
/// in: number: of a case of a sweep with --keep.
void open_into(HeldResult& result, const std::string& path, std::optional<std::size_t> number);
/// Writes the file of a case that was run. out: the status.
int save(HeldResult& result, const std::string& path, bool overwrite);

}  // namespace ehl::program
