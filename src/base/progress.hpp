#pragma once
// How far a run has come, on stderr.
#include <cstddef>
#include <functional>
#include <string>

namespace ehl::program {

/// On a terminal a bar that is drawn anew; otherwise a line every few seconds.
class Progress {
 public:
  /// Hears how far the work is and what goes on. out: false: stop.
  using Listener = std::function<bool(double fraction, const std::string& text)>;

  explicit Progress(bool quiet);
  /// Says nothing itself.
  explicit Progress(Listener listener);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// in: share of the work that is done; what goes on; whether it is shown soon after the last one too.
  /// out: false when the user asked to stop.
  bool show(double fraction, const std::string& text, bool at_once = false);

  /// One of many cases has ended: a line that stays, with the bar below it.
  void count(std::size_t done, std::size_t cases, const std::string& text);

  /// Takes the bar away.
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
