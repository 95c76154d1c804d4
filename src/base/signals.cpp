#include "base/signals.hpp"

#include <signal.h>

#include <atomic>

namespace ehl::program {
namespace {

// A signal handler takes no argument: the one variable of the program that outlives its function.
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
  ::signal(SIGXFSZ, SIG_IGN);
  ::signal(SIGPIPE, SIG_IGN);
}

void end_by_closed_pipe() {
  ::signal(SIGPIPE, SIG_DFL);
  ::raise(SIGPIPE);
}

bool stop_requested() { return stop.load(); }

}  // namespace ehl::program
