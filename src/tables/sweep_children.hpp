#pragma once
// Independent tasks in processes of their own: one that dies takes nothing with it.
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

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

}  // namespace ehl::program
