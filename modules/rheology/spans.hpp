#pragma once
// Evaluation of a law on a span, one vector register of values at a time.
#include <array>
#include <cstddef>
#include <span>

#include "rheology/elementary.hpp"

namespace ehl::rheology {

/// out = f(in) for one register at a time; the remainder uses a padded copy, so that a value does not depend on its
/// position
/// in the span. in and out may be the same span. 0 must be a legal argument of f.
template <class Function>
void apply(std::span<const double> in, std::span<double> out, Function f) {
  constexpr std::size_t width = core::lanes;
  const std::size_t whole = in.size() / width * width;
  for (std::size_t k = 0; k < whole; k += width) core::store(&out[k], f(core::load(&in[k])));
  if (whole == in.size()) return;
  std::array<double, width> padded{};
  for (std::size_t k = whole; k < in.size(); ++k) padded[k - whole] = in[k];
  core::store(padded.data(), f(core::load(padded.data())));
  for (std::size_t k = whole; k < in.size(); ++k) out[k] = padded[k - whole];
}

}  // namespace ehl::rheology
