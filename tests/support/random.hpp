#pragma once
// Random numbers for tests: the same on every machine.
#include <cstdint>
#include <random>

#include "core/field.hpp"

namespace ehl::tests {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Uniform between low and high. The library's distributions differ between machines; 53 bits of the engine do not.
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) / 9007199254740992.0);
  }
  bool chance(double probability) { return between(0.0, 1.0) < probability; }

 private:
  std::mt19937_64 engine_;
};

/// Every node, the boundary included, uniform between low and high.
inline core::Field random_field(const core::Patch& grid, Random& random, double low, double high) {
  core::Field field(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) field(i, j) = random.between(low, high);
  return field;
}

}  // namespace ehl::tests
