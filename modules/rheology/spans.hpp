#pragma once
// How a law goes over a span: a register full of values at a time.
#include <array>
#include <cstddef>
#include <span>

#include "rheology/elementary.hpp"

namespace ehl::rheology {

/// out = f(in) for a register full at a time; the rest goes through a padded copy, so that a value never depends on
/// where in the span it stands. in and out may be the same span. 0 is a legal argument of every f.
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
