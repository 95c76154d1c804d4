#include "tables/children.hpp"

#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <utility>

#include "base/memory_file.hpp"
#include "base/progress.hpp"
#include "base/signals.hpp"
#include "base/text_format.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"

namespace ehl::program {
namespace {

constexpr int look_up_interval = 100;  // ms: between two looks at the reports of the children and at a request to stop
constexpr int look_up_blindly = 5;     // ms: the same if the system cannot notify the parent of the end of a process
constexpr char whole = '\n';           // the last byte of a text that arrived completely

/// Memory shared between a child and its parent. It holds one text, which may be read while it is half overwritten.
class Board {
 public:
  Board() : memory_(::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {}
  ~Board() {
    if (memory_ != MAP_FAILED) ::munmap(memory_, size);
  }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  void write(const std::string& text) {
    if (memory_ == MAP_FAILED) return;  // without shared memory there are no reports
    std::strncpy(static_cast<char*>(memory_), text.c_str(), size - 1);
  }
  std::string read() const {
    if (memory_ == MAP_FAILED) return {};
    const char* text = static_cast<const char*>(memory_);
    return {text, ::strnlen(text, size)};
  }

 private:
  static constexpr std::size_t size = 256;
  void* memory_;
};

struct Child {
  std::size_t task = 0;
  pid_t process = -1;
  std::shared_ptr<MemoryFile> text{};
  double began = 0.0;
  std::shared_ptr<Board> board{};
  int ends = -1;  // becomes readable when the process ends; -1 if the system does not support this
};

/// The working children; the destructor ends them all.
class Children {
 public:
  Children() = default;
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;
  ~Children() {
    for (const Child& child : working) {
      ::kill(child.process, SIGKILL);
      ::close(child.ends);
      while (::waitpid(child.process, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
  }
  std::vector<Child> working{};
};

[[noreturn]] void be_child(std::size_t task, const MemoryFile& file, pid_t parent, Board& board,
                           const ChildrenCalls& calls) {
  // Only the parent handles Ctrl-C; a child ends when it receives SIGTERM.
  ::signal(SIGINT, SIG_IGN);
  ::signal(SIGTERM, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  int status = 0;
  std::string text;
  try {
    text = calls.task(task, [&board](const std::string& says) { board.write(says); }) + whole;
  } catch (const std::bad_alloc&) {
    text = "out of memory";
    status = 1;
  } catch (const std::exception& error) {
    text = error.what();
    status = 1;
  }
  try {
    file.hold(text);
  } catch (const core::FileError&) {
    status = 1;
  }
  ::_exit(status);  // not exit(): buffers and exit functions belong to the parent
}

Child start(std::size_t task, const ChildrenCalls& calls) {
  std::fflush(nullptr);
  auto text = std::make_shared<MemoryFile>();
  auto board = std::make_shared<Board>();
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process == 0) be_child(task, *text, parent, *board, calls);
  if (process > 0)
    return {task,        process,          std::move(text),
            core::now(), std::move(board), static_cast<int>(::syscall(SYS_pidfd_open, process, 0))};
  throw core::FileError(std::string("the process for a case cannot be started: ") + std::strerror(errno));
}

ChildEnd end_of(const Child& child, int status) {
  ChildEnd end{child.task, false, child.text->text(), WEXITSTATUS(status), ""};
  ::close(child.ends);
  if (WIFSIGNALED(status)) end.status = 128 + WTERMSIG(status);
  end.complete = end.status == 0 && end.text.ends_with(whole);
  if (end.complete) {
    end.text.pop_back();
  } else if (end.status > 128) {
    end.reason = std::string("the process of the case was ended by a signal: ") + ::strsignal(end.status - 128);
    if (end.status == 128 + SIGKILL) end.reason += " (by a user, or because memory ran out)";
  } else {
    end.reason = end.text.empty() ? "the process of the case ended without a message" : end.text;
  }
  return end;
}

// Waits until a child has ended, but not longer than the interval.
void wait_for_an_end(const Children& children) {
  std::vector<pollfd> ends;
  bool blind = false;
  for (const Child& child : children.working) {
    ends.push_back({child.ends, POLLIN, 0});
    blind = blind || child.ends < 0;
  }
  ::poll(ends.data(), ends.size(), blind ? look_up_blindly : look_up_interval);
}

void take_ended(Children& children, const ChildrenCalls& calls) {
  for (std::size_t k = 0; k < children.working.size();) {
    const Child child = children.working[k];
    int status = 0;
    // If SIGCHLD is ignored the process leaves no exit status; its text alone then shows how it ended.
    if (::waitpid(child.process, &status, WNOHANG) == 0) {
      ++k;
      continue;
    }
    children.working.erase(children.working.begin() + static_cast<std::ptrdiff_t>(k));
    calls.ended(end_of(child, status));
  }
}

}  // namespace

bool run_in_children(const std::vector<std::size_t>& tasks, int at_once, const ChildrenCalls& calls) {
  Children children;
  std::size_t next = 0;
  while (next < tasks.size() || !children.working.empty()) {
    if (calls.stop()) return false;
    while (next < tasks.size() && children.working.size() < static_cast<std::size_t>(at_once))
      children.working.push_back(start(tasks[next++], calls));
    wait_for_an_end(children);
    take_ended(children, calls);
    if (calls.waits && !children.working.empty()) {
      const Child& oldest = children.working.front();
      calls.waits({oldest.task, core::now() - oldest.began, oldest.board->read()});
    }
  }
  return true;
}

bool run_watched(const WatchedTasks& all) {
  const double began = core::now();
  const std::size_t count = all.tasks.size();
  std::size_t done = 0;
  Progress progress(all.quiet);
  ChildrenCalls calls;
  calls.stop = stop_requested;
  calls.task = all.task;
  calls.waits = [&](const ChildAtWork& child) {
    const double seconds_each = done == 0 ? 0.0 : (core::now() - began) / static_cast<double>(done);
    const std::string left =
        done == 0 ? "" : ", " + about_seconds(seconds_each * static_cast<double>(count - done)) + " left";
    progress.show(static_cast<double>(done) / static_cast<double>(count),
                  fmt::format("{}/{}{}  {}, {:.0f} s so far{}", done, count, left, all.name(child.task), child.seconds,
                              child.says.empty() ? "" : ": " + child.says));
  };
  calls.ended = [&](const ChildEnd& end) {
    const std::string status = all.ended(end);
    progress.count(++done, count, all.name(end.task) + "  " + status);
  };
  const bool finished = run_in_children(all.tasks, all.at_once, calls);
  progress.clear();
  return finished;
}

}  // namespace ehl::program
