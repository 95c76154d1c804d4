#pragma once
// Part of a body's source that is not marched with the film; it is computed from the fluxes of the previous sweep.
#include <cstddef>

#include "core/field.hpp"
#include "thermal/source_convolution.hpp"

namespace ehl::thermal {

/// Under-relaxed fixed-point iteration theta <- theta + w (S q - theta), S the source. A warmer body takes up less
/// heat. For an almost stationary body below a wide contact, S responds more strongly than the film resists, and with w
/// = 1 the sweeps diverge. w is 1 until a sweep overshoots by more than half; from then on it is chosen to remove one
/// mode exactly, with the amplification seen in the last sweep.
class LaggedSource {
 public:
  LaggedSource(Source&& source, const core::Patch& patch);

  /// in: q on the patch; theta of the previous call, zero at first. out: theta.
  void apply(const core::Field& q, core::Field& theta);

  std::size_t bytes() const;

 private:
  Source source_;
  core::Field left_, left_before_;  // S q - theta
  double weight_ = 1.0;
};

}  // namespace ehl::thermal
