#pragma once
// Independent tasks in processes of their own: one that dies takes nothing with it.
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/signals.hpp"
#include "core/errors.hpp"

namespace ehl::program {

/// How a task ended.
struct ChildEnd {
  std::size_t task = 0;
  bool complete = false;  ///< the task returned, and its text arrived whole
  std::string text{};     ///< what the task returned
  int status = 0;         ///< as a shell gives it: 128 + signal when a signal ended the process
  std::string reason{};   ///< why it is not complete
};

/// What a task says of itself while it works; the last counts.
using Say = std::function<void(const std::string&)>;

/// The child that has been at work longest.
struct ChildAtWork {
  std::size_t task = 0;
  double seconds = 0.0;
  std::string says{};
};

struct ChildrenCalls {
  std::function<std::string(std::size_t, const Say&)> task{};  ///< in the child; may throw, crash or be killed
  std::function<void(const ChildAtWork&)> waits{};             ///< in the parent, several times a second; may be empty
  std::function<void(const ChildEnd&)> ended{};                ///< in the parent, in the order in which tasks end
  std::function<bool()> stop{};  ///< in the parent, several times a second: true ends it all
};

/// Runs the tasks, `at_once` at a time, each in a forked process with memory of its own. Ctrl-C reaches the parent
/// only; when it stops, children that still work are killed and their tasks do not count as ended. A child outlives its
/// parent by nothing. in: task numbers; at_once >= 1. No other thread may be running. out: false when it was stopped.
/// errors: core::FileError when the system gives no process.
bool run_in_children(const std::vector<std::size_t>& tasks, int at_once, const ChildrenCalls& calls);

/// A row for each way, computed in children. A row has its way, a status and a reason, and comes back as the text that
/// text_of(row) makes and read_text(text, row) reads. One whose process died has the status "failed" and the reason.
/// in: ways; how many at a time; name: of a way, for people. errors: core::Interrupted; those above.
template <class Row, class Way>
std::vector<Row> computed_rows(const std::vector<Way>& ways, int at_once, bool quiet,
                               const std::function<Row(const Way&)>& compute,
                               const std::function<std::string(const Way&)>& name) {
  std::vector<Row> rows(ways.size());
  for (std::size_t k = 0; k < ways.size(); ++k) rows[k].way = ways[k];
  std::vector<std::size_t> tasks(rows.size());
  std::iota(tasks.begin(), tasks.end(), std::size_t{0});
  Progress progress(quiet);
  std::size_t done = 0;
  ChildrenCalls calls;
  calls.stop = stop_requested;
  calls.task = [&](std::size_t k, const Say&) { return text_of(compute(ways[k])); };
  calls.waits = [&](const ChildAtWork& child) {
    progress.show(static_cast<double>(done) / static_cast<double>(rows.size()),
                  name(ways[child.task]) + ", " + std::to_string(static_cast<int>(child.seconds)) + " s so far");
  };
  calls.ended = [&](const ChildEnd& end) {
    Row& row = rows[end.task];
    if (end.complete) {
      read_text(end.text, row);
    } else {
      row.status = "failed";
      row.reason = end.reason;
    }
    progress.count(++done, rows.size(), name(ways[end.task]) + "  " + row.status);
  };
  const bool finished = run_in_children(tasks, at_once, calls);
  progress.clear();
  if (!finished) throw core::Interrupted();
  return rows;
}

}  // namespace ehl::program
