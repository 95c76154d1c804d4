#pragma once
// Independent tasks in child processes: a task that crashes does not end the others.
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
  bool complete = false;  ///< the task returned, and its text arrived completely
  std::string text{};     ///< what the task returned
  int status = 0;         ///< exit status as a shell reports it: 128 + signal if a signal ended the process
  std::string reason{};   ///< why the task is not complete
};

/// Reports the present step of a task while it works; each report replaces the one before.
using Say = std::function<void(const std::string&)>;

/// The child that has been working longest.
struct ChildAtWork {
  std::size_t task = 0;
  double seconds = 0.0;
  std::string says{};
};

struct ChildrenCalls {
  std::function<std::string(std::size_t, const Say&)> task{};  ///< runs in the child; it may throw, crash or be killed
  std::function<void(const ChildAtWork&)> waits{};             ///< in the parent, several times a second; may be empty
  std::function<void(const ChildEnd&)> ended{};                ///< in the parent, in the order of completion
  std::function<bool()> stop{};  ///< runs in the parent, several times a second; true stops all children
};

/// Runs the tasks in forked processes, `at_once` at a time. Each process has its own memory. Only the parent
/// receives Ctrl-C; when it stops, it kills the children that still work, and their tasks do not count as ended. A
/// child ends when its parent ends.
/// in: task numbers; at_once >= 1. No other thread may be running. out: false if it was stopped.
/// errors: core::FileError if the system cannot create a process.
bool run_in_children(const std::vector<std::size_t>& tasks, int at_once, const ChildrenCalls& calls);

/// One row per method of solution, computed in child processes. A row contains its method (`way`), a status and a
/// reason. It is sent to the parent as the text that text_of(row) makes and read_text(text, row) reads. If a process
/// died, its row has the status "failed" and the reason.
/// in: the methods; how many run at a time; name: the name of a method for the reader. errors: core::Interrupted;
/// core::FileError as above.
template <class Row, class Variant>
std::vector<Row> computed_rows(const std::vector<Variant>& variants, int at_once, bool quiet,
                               const std::function<Row(const Variant&)>& compute,
                               const std::function<std::string(const Variant&)>& name) {
  std::vector<Row> rows(variants.size());
  for (std::size_t k = 0; k < variants.size(); ++k) rows[k].variant = variants[k];
  std::vector<std::size_t> tasks(rows.size());
  std::iota(tasks.begin(), tasks.end(), std::size_t{0});
  Progress progress(quiet);
  std::size_t done = 0;
  ChildrenCalls calls;
  calls.stop = stop_requested;
  calls.task = [&](std::size_t k, const Say&) { return text_of(compute(variants[k])); };
  calls.waits = [&](const ChildAtWork& child) {
    progress.show(static_cast<double>(done) / static_cast<double>(rows.size()),
                  name(variants[child.task]) + ", " + std::to_string(static_cast<int>(child.seconds)) + " s so far");
  };
  calls.ended = [&](const ChildEnd& end) {
    Row& row = rows[end.task];
    if (end.complete) {
      read_text(end.text, row);
    } else {
      row.status = "failed";
      row.reason = end.reason;
    }
    progress.count(++done, rows.size(), name(variants[end.task]) + "  " + row.status);
  };
  const bool finished = run_in_children(tasks, at_once, calls);
  progress.clear();
  if (!finished) throw core::Interrupted();
  return rows;
}

}  // namespace ehl::program
