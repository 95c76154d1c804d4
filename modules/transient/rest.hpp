#pragma once
// Detects from the rows of the time steps that the contact has become steady.
#include <cmath>
#include <vector>

#include "transient/march.hpp"

namespace ehl::transient {

/// True once Hc, Hm and P_max have changed by less than a relative tolerance for a time of 1. in: the tolerance; NaN:
/// disabled, no row is stored.
class Rest {
 public:
  explicit Rest(double tolerance) : tolerance_(tolerance) {}

  /// Adds a row later than all before it. returns true if the contact is steady.
  bool reached(const StepRow& row) {
    constexpr double window = 1.0;  // a surface moves by one Hertz radius in this time
    if (std::isnan(tolerance_)) return false;
    recent_.push_back(row);
    while (recent_.size() > 1 && recent_[1].T <= row.T - window) recent_.erase(recent_.begin());
    const StepRow& then = recent_.front();
    const auto rests = [&](double was, double is) { return std::abs(is / was - 1.0) < tolerance_; };
    return row.T - then.T >= window && rests(then.Hc, row.Hc) && rests(then.Hm, row.Hm) && rests(then.P_max, row.P_max);
  }

 private:
  double tolerance_;
  std::vector<StepRow> recent_{};  ///< rows of the last window
};

}  // namespace ehl::transient
