#pragma once
// Vector of doubles: one lane per line of a batch. It is a vector type of the compiler, so arithmetic reads as for a
// single line. Its width, and with it size and alignment of every type made of it, depends on the processor level: only
// files compiled for each level may include this header.
#ifdef EHL_COMPILED_ONCE
#error \
    "core/simd.hpp is included by a file that is compiled once for every processor: keep types made of lanes in .cpp files and in headers that only files compiled for each level include"
#endif
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace ehl::core {

// As wide as the processor's registers. For a wider type the compiler goes through memory in every operation, which is
// much slower. Lines are independent, so the width does not change a result. [bench: simd_lanes]
#if defined(__AVX512F__)
inline constexpr int lanes = 8;
#elif defined(__AVX__)
inline constexpr int lanes = 4;
#else
inline constexpr int lanes = 2;
#endif
using Lanes [[gnu::vector_size(lanes * sizeof(double))]] = double;
/// Result of comparing two Lanes: all bits set where true. `mask ? a : b` selects per lane.
using LaneMask [[gnu::vector_size(lanes * sizeof(double))]] = std::int64_t;

/// Loads, stores and constants, of lanes or of a single number. `p` needs no alignment.
template <class Number = Lanes>
Number load(const double* p) {
  Number v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
template <class Number>
void store(double* p, Number v) {
  std::memcpy(p, &v, sizeof v);
}
inline Lanes broadcast(double s) { return Lanes{} + s; }

/// Functions per lane; all() is true if all lanes are.
inline Lanes max(Lanes a, Lanes b) { return a > b ? a : b; }
inline Lanes min(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes abs(Lanes a) { return a < 0.0 ? -a : a; }
inline bool all(LaneMask mask) {
  std::int64_t together = -1;
  for (int lane = 0; lane < lanes; ++lane) together &= mask[lane];
  return together != 0;
}

// The functions above for a single number.
inline double max(double a, double b) { return a > b ? a : b; }
inline double min(double a, double b) { return a < b ? a : b; }
inline double abs(double a) { return __builtin_fabs(a); }
inline bool all(bool mask) { return mask; }

/// rule(0), rule(1), ..: a number for each lane.
template <class Rule>
inline LaneMask lanes_by(Rule rule) {
  return [rule]<std::size_t... lane>(std::index_sequence<lane...>) {
    return LaneMask{std::int64_t{rule(static_cast<int>(lane))}...};
  }
  (std::make_index_sequence<lanes>{});
}

/// Elements of a and b in a new order. in: rule, a lambda without captures; lane k gets element rule(k) of the 2 x
/// lanes elements of a followed by those of b.
template <class Rule>
inline Lanes shuffled(Lanes a, Lanes b, Rule) {
  return [ a, b ]<std::size_t... lane>(std::index_sequence<lane...>) {
    return __builtin_shufflevector(a, b, Rule{}(static_cast<int>(lane))...);
  }
  (std::make_index_sequence<lanes>{});
}

/// Every second of 2 x lanes elements, beginning with the first or with the second: the lines of the two colours.
inline Lanes evens(Lanes low, Lanes high) {
  return shuffled(low, high, [](int k) { return 2 * k; });
}
inline Lanes odds(Lanes low, Lanes high) {
  return shuffled(low, high, [](int k) { return 2 * k + 1; });
}
/// Inverse of evens() and odds(): the first and the second half of a0 b0 a1 b1 ..
inline Lanes interleaved_low(Lanes a, Lanes b) {
  return shuffled(a, b, [](int k) { return k / 2 + k % 2 * lanes; });
}
inline Lanes interleaved_high(Lanes a, Lanes b) {
  return shuffled(a, b, [](int k) { return lanes / 2 + k / 2 + k % 2 * lanes; });
}
/// before[0], v[0], v[1], ..: all lanes shifted by one.
inline Lanes moved_up(Lanes before, Lanes v) {
  return shuffled(before, v, [](int k) { return k == 0 ? 0 : lanes + k - 1; });
}
/// v[1], v[0], v[3], v[2], ..
inline Lanes swapped_pairs(Lanes v) {
  return shuffled(v, v, [](int k) { return k ^ 1; });
}

}  // namespace ehl::core
