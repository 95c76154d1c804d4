#pragma once
// The progress of a run, on stderr.
#include <cstddef>
#include <functional>
#include <string>

namespace ehl::program {

/// On a terminal: a bar that is redrawn in place. Otherwise: one line every few seconds.
class Progress {
 public:
  /// Is called with the share of the work that is done and a text on the present step. out: false: stop.
  using Listener = std::function<bool(double fraction, const std::string& text)>;

  explicit Progress(bool quiet);
  /// Calls the listener and prints nothing.
  explicit Progress(Listener listener);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// in: the share of the work that is done; a text on the present step; at_once: show it even if the last one was
  /// shown a moment ago.
  /// out: false if the user asked to stop.
  bool show(double fraction, const std::string& text, bool at_once = false);

  /// Reports that one of many cases has ended, as a line that stays above the bar.
  void count(std::size_t done, std::size_t cases, const std::string& text);

  /// Removes the bar.
  void clear();

 private:
  void draw(double fraction, const std::string& text);

  Listener listener_{};
  bool quiet_;
  bool terminal_;
  bool drawn_ = false;
  double last_time_ = 0.0;
};

}  // namespace ehl::program
