#include "tables/children.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "core/errors.hpp"

namespace ehl::program {
namespace {

constexpr int look_up_interval = 200;  // ms between looks at stop()
constexpr char whole = '\n';           // the last byte of a text that arrived whole

struct Child {
  std::size_t task = 0;
  pid_t process = -1;
  int pipe = -1;
  std::string text{};
};

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// The children at work; none survives it.
class Children {
 public:
  Children() = default;
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;
  ~Children() {
    for (const Child& child : working) {
      ::kill(child.process, SIGKILL);
      ::close(child.pipe);
      wait_for(child.process);
    }
  }
  std::vector<Child> working{};
};

void write_all(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(descriptor, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) ::_exit(1);
    done += static_cast<std::size_t>(written);
  }
}

[[noreturn]] void be_child(std::size_t task, int pipe, pid_t parent, const ChildrenCalls& calls) {
  // The parent decides what Ctrl-C means; a child that is told to end, ends.
  ::signal(SIGINT, SIG_IGN);
  ::signal(SIGTERM, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  int status = 0;
  std::string text;
  try {
    text = calls.task(task) + whole;
  } catch (const std::bad_alloc&) {
    text = "out of memory";
    status = 1;
  } catch (const std::exception& error) {
    text = error.what();
    status = 1;
  }
  write_all(pipe, text);
  ::_exit(status);  // not exit: buffers and exit functions are the parent's
}

Child start(std::size_t task, const ChildrenCalls& calls) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw core::FileError(std::string("no pipe to a child: ") + std::strerror(errno));
  std::fflush(nullptr);
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process < 0) {
    const int error = errno;
    ::close(ends[0]);
    ::close(ends[1]);
    throw core::FileError(std::string("no process for a case: ") + std::strerror(error));
  }
  if (process == 0) {
    ::close(ends[0]);
    be_child(task, ends[1], parent, calls);
  }
  ::close(ends[1]);
  return {task, process, ends[0], ""};
}

// Reads what there is. Returns false at its end.
bool read_some(Child& child) {
  std::array<char, 4096> bytes{};
  const ssize_t count = ::read(child.pipe, bytes.data(), bytes.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  child.text.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0;
}

ChildEnd end_of(const Child& child) {
  ::close(child.pipe);
  ChildEnd end{child.task, false, child.text, wait_for(child.process), ""};
  end.complete = end.status == 0 && end.text.ends_with(whole);
  if (end.complete) {
    end.text.pop_back();
  } else if (end.status > 128) {
    end.reason = std::string("the process of the case was ended by a signal: ") + ::strsignal(end.status - 128);
    if (end.status == 128 + SIGKILL) end.reason += " (by somebody, or because memory ran out)";
  } else {
    end.reason = end.text.empty() ? "the process of the case ended without a word" : end.text;
  }
  return end;
}

void listen(Children& children, const ChildrenCalls& calls) {
  std::vector<pollfd> pipes;
  for (const Child& child : children.working) pipes.push_back({child.pipe, POLLIN, 0});
  if (::poll(pipes.data(), pipes.size(), look_up_interval) <= 0) return;
  for (const pollfd& ready : pipes) {
    if (ready.revents == 0) continue;
    const auto child = std::find_if(children.working.begin(), children.working.end(),
                                    [&](const Child& one) { return one.pipe == ready.fd; });
    if (read_some(*child)) continue;
    const Child ended = *child;
    children.working.erase(child);
    calls.ended(end_of(ended));
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
    listen(children, calls);
  }
  return true;
}

}  // namespace ehl::program
