#include "base/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/signals.hpp"
#include "core/timer.hpp"

namespace ehl::program {
namespace {

constexpr double bar_interval = 0.05;  // s: the bar moves smoothly
constexpr double line_interval = 5.0;  // s: a log file stays short
constexpr int bar_width = 30;
constexpr const char* clear_line = "\r\x1b[K";

}  // namespace

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::Progress(Listener listener) : listener_(std::move(listener)), quiet_(true), terminal_(false) {}

void Progress::clear() {
  if (drawn_) std::fputs(clear_line, stderr);
  drawn_ = false;
}

void Progress::draw(double fraction, const std::string& text) {
  const auto filled = static_cast<std::size_t>(std::clamp(fraction, 0.0, 1.0) * bar_width);
  const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
  std::fprintf(stderr, "%s[%s] %s", clear_line, bar.c_str(), text.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

bool Progress::show(double fraction, const std::string& text, bool at_once) {
  if (listener_) return listener_(std::clamp(fraction, 0.0, 1.0), text);
  if (stop_requested()) return false;
  const double now = core::now();
  if (quiet_ || !(at_once || now - last_time_ > (terminal_ ? bar_interval : line_interval))) return true;
  last_time_ = now;
  const std::string line = fmt::format("{:3.0f} %  ", 100.0 * std::clamp(fraction, 0.0, 1.0)) + text;
  if (terminal_)
    draw(fraction, line);
  else
    std::fprintf(stderr, "ehl: %s\n", line.c_str());
  return true;
}

void Progress::count(std::size_t done, std::size_t cases, const std::string& text) {
  if (quiet_) return;
  const std::string so_far = std::to_string(done) + "/" + std::to_string(cases);
  std::fprintf(stderr, "%sehl: %s  %s\n", terminal_ ? clear_line : "", so_far.c_str(), text.c_str());
  if (terminal_) draw(static_cast<double>(done) / static_cast<double>(cases), so_far);
}

}  // namespace ehl::program
