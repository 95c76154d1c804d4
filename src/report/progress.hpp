#pragma once
#include "steady/solve.hpp"

namespace ehl::program {

/// Progress on stderr: a bar on a terminal, otherwise a line per level and every few seconds; and the moment at which
/// a stop takes effect.
class ProgressReport {
 public:
  explicit ProgressReport(bool quiet);
  ~ProgressReport();
  ProgressReport(const ProgressReport&) = delete;
  ProgressReport& operator=(const ProgressReport&) = delete;

  /// Returns false when the user asked to stop.
  bool show(const steady::Progress& progress);

 private:
  bool quiet_;
  bool terminal_;
  bool line_open_ = false;
  int last_level_ = -1;
  double last_time_ = 0.0;
};

}  // namespace ehl::program
