#pragma once
// Eight doubles side by side: one lane per line of a batch. A vector type of the compiler, so plain arithmetic
// reads as for one line, and a processor with narrower registers runs the same code in two or four pieces.
#include <cstring>

namespace ehl::core {

inline constexpr int lanes = 8;
using Lanes [[gnu::vector_size(lanes * sizeof(double))]] = double;

inline Lanes load(const double* p) {
  Lanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
inline void store(double* p, Lanes v) { std::memcpy(p, &v, sizeof v); }
inline Lanes broadcast(double s) { return Lanes{} + s; }

}  // namespace ehl::core
