#pragma once
// Eight doubles side by side: one lane per line of a batch. A vector type of the compiler, so plain arithmetic
// reads as for one line, and a processor with narrower registers runs the same code in two or four pieces.
#include <cstdint>
#include <cstring>

namespace ehl::core {

inline constexpr int lanes = 8;
using Lanes [[gnu::vector_size(lanes * sizeof(double))]] = double;
/// What comparing two Lanes gives: all bits set where true. `mask ? a : b` selects lane by lane.
using LaneMask [[gnu::vector_size(lanes * sizeof(double))]] = std::int64_t;

inline Lanes load(const double* p) {
  Lanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
inline void store(double* p, Lanes v) { std::memcpy(p, &v, sizeof v); }
inline Lanes broadcast(double s) { return Lanes{} + s; }

inline Lanes max(Lanes a, Lanes b) { return a > b ? a : b; }
inline Lanes min(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes abs(Lanes a) { return a < 0.0 ? -a : a; }
inline bool all(LaneMask mask) {
  std::int64_t together = -1;
  for (int lane = 0; lane < lanes; ++lane) together &= mask[lane];
  return together != 0;
}

/// Elements 0, 2, 4, .. and 1, 3, 5, .. of sixteen in a row: the lines of the two colours.
inline Lanes every_second(Lanes low, Lanes high, LaneMask pick) { return __builtin_shuffle(low, high, pick); }
inline Lanes evens(Lanes low, Lanes high) { return every_second(low, high, LaneMask{0, 2, 4, 6, 8, 10, 12, 14}); }
inline Lanes odds(Lanes low, Lanes high) { return every_second(low, high, LaneMask{1, 3, 5, 7, 9, 11, 13, 15}); }
/// The inverse: the first and the second half of a0 b0 a1 b1 ..
inline Lanes interleaved_low(Lanes a, Lanes b) { return __builtin_shuffle(a, b, LaneMask{0, 8, 1, 9, 2, 10, 3, 11}); }
inline Lanes interleaved_high(Lanes a, Lanes b) {
  return __builtin_shuffle(a, b, LaneMask{4, 12, 5, 13, 6, 14, 7, 15});
}

}  // namespace ehl::core
