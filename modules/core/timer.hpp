#pragma once
// Wall-clock time per named part of the work.
#include <array>
#include <chrono>
#include <cstddef>

namespace ehl::core {

/// Seconds since some fixed moment.
inline double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The parts of the solver whose share of the time is reported.
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

/// Name of a part as the report prints it.
const char* name(Part part);

/// Seconds spent in each part. Plain data: whoever works adds to it.
struct PartTimes {
  std::array<double, static_cast<std::size_t>(Part::count)> seconds{};
  bool enclosed = false;  ///< in a part that takes all: what it calls need not look at the clock
  double& operator[](Part part) { return seconds[static_cast<std::size_t>(part)]; }
  double operator[](Part part) const { return seconds[static_cast<std::size_t>(part)]; }
};

/// what += more, part by part.
void add(const PartTimes& more, PartTimes& what);

/// Adds the seconds from its birth to its death to one part.
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

/// The same for all that happens meanwhile, whatever parts it calls itself.
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
