#include "base/signals.hpp"

#include <signal.h>

#include <atomic>

namespace ehl::program {
namespace {

// A signal handler takes no argument, so this flag is the one global variable of the program.
std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a handler may not wait");

}  // namespace

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = [](int) { stop.store(true); };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  ::sigaction(SIGUSR1, &action, nullptr);
  // The system reports that the limit of CPU time is reached every second, until the hard limit ends the process.
  action.sa_flags = 0;
  ::sigaction(SIGXCPU, &action, nullptr);
  // The terminal was closed. nohup sets this signal to be ignored; it is then left ignored and the run goes on.
  struct sigaction before {};
  if (::sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) ::sigaction(SIGHUP, &action, nullptr);
  ::signal(SIGXFSZ, SIG_IGN);
  ::signal(SIGPIPE, SIG_IGN);
}

void end_by_closed_pipe() {
  ::signal(SIGPIPE, SIG_DFL);
  ::raise(SIGPIPE);
}

bool stop_requested() { return stop.load(); }

}  // namespace ehl::program
