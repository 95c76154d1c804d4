#include "report/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "commands/signals.hpp"
#include "core/timer.hpp"

namespace ehl::program {
namespace {

constexpr double bar_interval = 0.05;  // s: smooth for the eye
constexpr double line_interval = 5.0;  // s: a log stays short
constexpr int bar_width = 30;

}  // namespace

ProgressReport::ProgressReport(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressReport::~ProgressReport() {
  if (line_open_) std::fputs("\r\x1b[K", stderr);
}

bool ProgressReport::show(const steady::Progress& progress) {
  if (stop_requested()) return false;
  const double now = core::now();
  const bool new_level = progress.level != last_level_;
  const bool due = now - last_time_ > (terminal_ ? bar_interval : line_interval);
  if (quiet_ || !(new_level || due)) return true;
  last_level_ = progress.level;
  last_time_ = now;
  // A continuation solves for other loads first.
  char load[32] = "";
  if (progress.load_ratio != 1.0) std::snprintf(load, sizeof load, "  load %.3g %%", 100.0 * progress.load_ratio);
  const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
  if (terminal_) {
    const auto filled = static_cast<std::size_t>(fraction * bar_width);
    const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
    std::fprintf(stderr, "\r[%s] %3.0f %%  %d x %d%s  cycle %d/%d  residual %.1e  Hc %.4f\x1b[K", bar.c_str(),
                 100.0 * fraction, progress.nx + 1, progress.ny + 1, load, progress.cycle,
                 std::max(progress.cycle, progress.cycles), progress.residual, progress.Hc);
    std::fflush(stderr);
    line_open_ = true;
  } else {
    std::fprintf(stderr, "ehl: %3.0f %%  %d x %d%s  cycle %d/%d  residual %.1e  Hc %.4f\n", 100.0 * fraction,
                 progress.nx + 1, progress.ny + 1, load, progress.cycle, std::max(progress.cycle, progress.cycles),
                 progress.residual, progress.Hc);
  }
  return true;
}

}  // namespace ehl::program
