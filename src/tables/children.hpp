#pragma once
// Independent tasks in child processes: a task that crashes does not end the others.
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

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

/// Tasks that the user watches.
struct WatchedTasks {
  std::vector<std::size_t> tasks{};
  int at_once = 1;
  bool quiet = false;  ///< shows no progress
  std::function<std::string(std::size_t)> name{};
  std::function<std::string(std::size_t, const Say&)> task{};  ///< as in ChildrenCalls
  /// In the parent, in the order of completion. out: how the task ended, in a word.
  std::function<std::string(const ChildEnd&)> ended{};
};

/// Runs the tasks and shows the progress, the remaining time and the task that has been working longest. Ctrl-C stops
/// them. out: false if they were stopped. errors: as above.
bool run_watched(const WatchedTasks& all);

}  // namespace ehl::program
