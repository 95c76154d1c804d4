#pragma once
// Eight by eight numbers, rows to columns, in registers.
#include "core/simd.hpp"

namespace ehl::mlmi {

/// out[c][r] = in[r][c].
inline void transpose(const core::Lanes (&in)[core::lanes], core::Lanes (&out)[core::lanes]) {
  using core::Lanes, core::lanes;
  Lanes a[lanes], b[lanes];
  for (int k = 0; k < lanes; k += 2) {
    a[k] = __builtin_shufflevector(in[k], in[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    a[k + 1] = __builtin_shufflevector(in[k], in[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int k = 0; k < lanes; k += 4)
    for (int m = 0; m < 2; ++m) {
      b[k + m] = __builtin_shufflevector(a[k + m], a[k + m + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      b[k + m + 2] = __builtin_shufflevector(a[k + m], a[k + m + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int k = 0; k < 4; ++k) {
    out[k] = __builtin_shufflevector(b[k], b[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    out[k + 4] = __builtin_shufflevector(b[k], b[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

}  // namespace ehl::mlmi
