#pragma once
// What a body's own source adds to its surface beside what is marched with the film: taken from the sweep before.
#include <cstddef>

#include "core/field.hpp"
#include "thermal/source_convolution.hpp"

namespace ehl::thermal {

/// theta <- theta + w (S q - theta), S the source. Heat that flows into a body warms it, and then less flows: of a body
/// that hardly moves below a wide contact S answers by more than the film resists, and with w = 1 each sweep overshoots
/// by more than the last. w is 1 until a sweep overshoots by more than half; from then on it is the weight that would
/// have left nothing of one mode, as the last sweep tells.
class LaggedSource {
 public:
  LaggedSource(Source&& source, const core::Patch& patch);

  /// in: q on the patch; theta as left by the call before, zero before the first. out: theta.
  void apply(const core::Field& q, core::Field& theta);

  std::size_t bytes() const;

 private:
  Source source_;
  core::Field left_, left_before_;  // S q - theta
  double weight_ = 1.0;
};

}  // namespace ehl::thermal
