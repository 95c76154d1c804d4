#pragma once
// The contents behind an `ehl_result` of the C interface.
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

namespace ehl::program {

/// An entry whose numbers and texts stay at the same address until the result is freed.
struct HeldEntry {
  results::Entry entry{};
  std::string error{};             ///< path of the number that is its error; empty: it has none
  const double* values = nullptr;  ///< values of a numeric entry
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
  std::optional<results::Content> content{};  ///< the content of a case that was run
  // The objects that the entries and the content point to.
  std::optional<Case> input{};
  Computed computed{};
};

/// The case of a deck. in: text: the deck; nullptr: the deck is read from the file `name`. errors: core::InputError,
/// core::FileError.
Case case_from(const char* text, const std::string& name, const std::vector<std::string>& overrides, int threads);

/// These three fill the result. An error is recorded in the result; only std::bad_alloc is thrown.
void run_into(HeldResult& result, const std::function<Case()>& read, Progress::Listener listener);
void check_into(HeldResult& result, const std::function<Case()>& read);
/// in: number: the number of a case in the file of a sweep with --keep.
void open_into(HeldResult& result, const std::string& path, std::optional<std::size_t> number);
/// Writes the result file of a case that was run. out: the status.
int save(HeldResult& result, const std::string& path, bool overwrite);

}  // namespace ehl::program
