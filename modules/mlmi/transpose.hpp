#pragma once
// Transposition of a square block of numbers in registers, as many rows and columns as there are lanes.
#include "core/simd.hpp"

namespace ehl::mlmi {

/// Exchanges the off-diagonal blocks of `width` x `width` numbers in each block of twice that size.
template <int width>
inline void transpose_blocks(core::Lanes (&rows)[core::lanes]) {
  using core::Lanes, core::lanes;
  for (int k = 0; k < lanes; ++k) {
    if ((k & width) != 0) continue;
    const Lanes upper = rows[k], lower = rows[k + width];
    rows[k] = core::shuffled(upper, lower, [](int m) { return (m & width) == 0 ? m : lanes + m - width; });
    rows[k + width] = core::shuffled(upper, lower, [](int m) { return (m & width) == 0 ? m + width : lanes + m; });
  }
}

/// out[c][r] = in[r][c].
inline void transpose(const core::Lanes (&in)[core::lanes], core::Lanes (&out)[core::lanes]) {
  for (int k = 0; k < core::lanes; ++k) out[k] = in[k];
  transpose_blocks<1>(out);
  if constexpr (core::lanes > 2) transpose_blocks<2>(out);
  if constexpr (core::lanes > 4) transpose_blocks<4>(out);
}

}  // namespace ehl::mlmi
