#pragma once
// Tells from the rows of the steps when the contact has come to rest.
#include <cmath>
#include <vector>

#include "transient/march.hpp"

namespace ehl::transient {

/// Hc, Hm and P_max have changed by less than a share for a time of 1. in: NaN: never asked, and nothing is kept.
class Rest {
 public:
  explicit Rest(double tolerance) : tolerance_(tolerance) {}

  /// With this row, later than all before it, at rest?
  bool reached(const StepRow& row) {
    constexpr double window = 1.0;  // the oil crosses half of the contact: what moves must show in it
    if (std::isnan(tolerance_)) return false;
    recent_.push_back(row);
    while (recent_.size() > 1 && recent_[1].T <= row.T - window) recent_.erase(recent_.begin());
    const StepRow& then = recent_.front();
    const auto rests = [&](double was, double is) { return std::abs(is / was - 1.0) < tolerance_; };
    return row.T - then.T >= window && rests(then.Hc, row.Hc) && rests(then.Hm, row.Hm) && rests(then.P_max, row.P_max);
  }

 private:
  double tolerance_;
  std::vector<StepRow> recent_{};  ///< of the last window
};

}  // namespace ehl::transient
