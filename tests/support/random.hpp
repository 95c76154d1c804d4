#pragma once
// Random numbers for tests, identical on every machine.
#include <cstdint>
#include <random>

#include "core/field.hpp"

namespace ehl::tests {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Uniform between low and high. The distributions of the library differ between machines, so 53 bits of the
  /// engine are used directly.
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) / 9007199254740992.0);
  }
  bool chance(double probability) { return between(0.0, 1.0) < probability; }

 private:
  std::mt19937_64 engine_;
};

/// A field with uniform random values between low and high at every node, including the boundary.
inline core::Field random_field(const core::Patch& grid, Random& random, double low, double high) {
  core::Field field(grid);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) field(i, j) = random.between(low, high);
  return field;
}

}  // namespace ehl::tests
