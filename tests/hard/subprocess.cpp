#include "hard/subprocess.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <fstream>
#include <iterator>
#include <system_error>

namespace hard {
namespace {

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> whole_environment(const std::vector<std::string>& added) {
  std::vector<std::string> all = added;  // if a name is set twice, the first setting counts
  for (char** setting = ::environ; *setting != nullptr; ++setting) all.emplace_back(*setting);
  return all;
}

pid_t start(std::vector<std::string> words, std::vector<std::string> environment, const std::string& folder) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  const int fresh = O_WRONLY | O_CREAT | O_TRUNC;
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "out", fresh, 0600);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "err", fresh, 0600);
  pid_t process = -1;
  const int error = ::posix_spawn(&process, words[0].c_str(), &actions, nullptr, pointers(words).data(),
                                  pointers(environment).data());
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), words[0]);
  return process;
}

double cpu_seconds(pid_t process) {
  clockid_t clock{};
  timespec used{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &used) != 0) return 0.0;
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

// Waits for the end without using processor time. On a busy machine only the program's own processor time counts, but a
// program that sleeps is limited by the wall clock. out: false if a limit was reached first.
bool ends_within(pid_t process, double limit) {
  constexpr int slice = 500;             // milliseconds between two looks at the clock
  constexpr double waiting_factor = 10;  // limit of wall-clock time divided by that of processor time
  // In Debian 12 the library declares pidfd_open only for C.
  const int descriptor = static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
  if (descriptor < 0) throw std::system_error(errno, std::generic_category(), "pidfd_open");
  pollfd waiting{descriptor, POLLIN, 0};
  bool ended = false;
  for (double waited = 0.0; !ended && waited < waiting_factor * limit && cpu_seconds(process) < limit;
       waited += 1e-3 * slice)
    ended = ::poll(&waiting, 1, slice) > 0;
  ::close(descriptor);
  return ended;
}

}  // namespace

Finished run_program(const std::vector<std::string>& words, const std::string& folder,
                     const std::vector<std::string>& environment, double limit) {
  const pid_t process = start(words, whole_environment(environment), folder);
  Finished finished;
  finished.hung = !ends_within(process, limit);
  if (finished.hung) ::kill(process, SIGKILL);
  int raw = 0;
  rusage usage{};
  while (::wait4(process, &raw, 0, &usage) < 0 && errno == EINTR) continue;
  for (const timeval& part : {usage.ru_utime, usage.ru_stime})
    finished.seconds += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
  if (WIFEXITED(raw)) finished.status = WEXITSTATUS(raw);
  if (WIFSIGNALED(raw) && !finished.hung) finished.signal = WTERMSIG(raw);
  finished.out = read_file(folder + "/out");
  finished.err = read_file(folder + "/err");
  return finished;
}

}  // namespace hard
