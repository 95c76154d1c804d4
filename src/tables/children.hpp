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

struct ChildrenCalls {
  std::function<std::string(std::size_t)> task{};  ///< in the child; may throw, crash or be killed
  std::function<void(const ChildEnd&)> ended{};    ///< in the parent, in the order in which tasks end
  std::function<bool()> stop{};                    ///< in the parent, several times a second: true ends it all
};

/// Runs the tasks, `at_once` at a time, each in a forked process with memory of its own. Ctrl-C reaches the parent
/// only; when it stops, children that still work are killed and their tasks do not count as ended. A child outlives its
/// parent by nothing. in: task numbers; at_once >= 1. No other thread may be running. out: false when it was stopped.
/// errors: core::FileError when the system gives no process or pipe.
bool run_in_children(const std::vector<std::size_t>& tasks, int at_once, const ChildrenCalls& calls);

/// How the rows of a table are computed in children. A row has a status and a reason.
template <class Row>
struct RowCalls {
  std::function<Row(const Row& planned)> compute{};       ///< in the child
  std::string (*write)(const Row&) = nullptr;             ///< for the way from the child,
  Row (*read)(const std::string&) = nullptr;              ///< and back
  std::function<std::string(const Row& planned)> name{};  ///< of the task, for people
};

/// The rows, computed. One whose process died is as planned, with the status "failed" and the reason.
/// in: rows as planned; how many at a time. errors: core::Interrupted; those above.
template <class Row>
std::vector<Row> computed_rows(std::vector<Row> rows, int at_once, bool quiet, const RowCalls<Row>& how) {
  std::vector<std::size_t> tasks(rows.size());
  std::iota(tasks.begin(), tasks.end(), std::size_t{0});
  Progress progress(quiet);
  std::size_t done = 0;
  ChildrenCalls calls;
  calls.stop = stop_requested;
  calls.task = [&](std::size_t k) { return how.write(how.compute(rows[k])); };
  calls.ended = [&](const ChildEnd& end) {
    Row& row = rows[end.task];
    const std::string name = how.name(row);
    if (end.complete) {
      row = how.read(end.text);
    } else {
      row.status = "failed";
      row.reason = end.reason;
    }
    progress.count(++done, rows.size(), name + "  " + row.status);
  };
  const bool finished = run_in_children(tasks, at_once, calls);
  progress.clear();
  if (!finished) throw core::Interrupted();
  return rows;
}

}  // namespace ehl::program
