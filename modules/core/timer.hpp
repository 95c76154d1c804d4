#pragma once
// Wall-clock time per part of the work.
#include <array>
#include <chrono>
#include <cstddef>

namespace ehl::core {

/// Seconds since some fixed time.
inline double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Parts of the solver whose time is reported.
enum class Part : std::size_t {
  deformation,
  coefficients,
  residual,
  line_solve,
  transfer,
  coarsest,
  heat,
  checks,
  errors,
  setup,
  count
};

/// Name of a part in the report.
const char* name(Part part);

/// Seconds spent in each part.
struct PartTimes {
  std::array<double, static_cast<std::size_t>(Part::count)> seconds{};
  bool enclosed = false;  ///< an enclosing part is running; the functions that it calls do not measure
  double& operator[](Part part) { return seconds[static_cast<std::size_t>(part)]; }
  double operator[](Part part) const { return seconds[static_cast<std::size_t>(part)]; }
};

/// what += more, for each part.
void add(const PartTimes& more, PartTimes& what);

/// Adds the seconds of its lifetime to one part.
class ScopedTimer {
 public:
  ScopedTimer(PartTimes& times, Part part) : times_(times), part_(part), start_(times.enclosed ? 0.0 : now()) {}
  ~ScopedTimer() {
    if (!times_.enclosed) times_[part_] += now() - start_;
  }
  ScopedTimer(const ScopedTimer&) = delete;
  ScopedTimer& operator=(const ScopedTimer&) = delete;

 private:
  PartTimes& times_;
  Part part_;
  double start_;
};

/// Adds all seconds of its lifetime to one part, including those of functions that have their own timers.
class EnclosingTimer {
 public:
  EnclosingTimer(PartTimes& times, Part part)
      : times_(times), enclosed_(times.enclosed), part_(part), start_(enclosed_ ? 0.0 : now()) {
    times_.enclosed = true;
  }
  ~EnclosingTimer() {
    times_.enclosed = enclosed_;
    if (!enclosed_) times_[part_] += now() - start_;
  }
  EnclosingTimer(const EnclosingTimer&) = delete;
  EnclosingTimer& operator=(const EnclosingTimer&) = delete;

 private:
  PartTimes& times_;
  bool enclosed_;
  Part part_;
  double start_;
};

}  // namespace ehl::core
