#pragma once
// Detects from the rows of the time steps that a contact repeats itself from period to period.
#include <vector>

#include "core/constants.hpp"

namespace ehl::transient {

struct StepRow;

/// Compares Hc and Hm of a period with those of the period before, at the same phase.
class Periodic {
 public:
  /// in: the period; NaN: nothing is compared and no row is stored.
  explicit Periodic(double period) : period_(period), next_(period) {}

  /// Adds a row later than all before it. returns true at the end of a period that was compared with the one before.
  bool add(const StepRow& row);
  /// Largest relative change of Hc and Hm between the last two whole periods. Between the steps of the earlier period
  /// the film is a cubic through four of them. NaN before the end of the second period.
  double change() const { return change_; }
  int periods() const { return periods_; }

 private:
  struct Film {
    double T, Hc, Hm;
  };
  Film at(double T) const;

  double period_, next_;
  int periods_ = 0;
  double change_ = core::unknown;
  std::vector<Film> films_{};  ///< of the last two periods
};

}  // namespace ehl::transient
