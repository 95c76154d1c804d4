#pragma once
// How a law goes over a span: a register full of values at a time.
#include <array>
#include <cstddef>
#include <span>

#include "rheology/elementary.hpp"

namespace ehl::rheology {

/// out = f(in) for a pack at a time; the rest goes through a padded copy, so that a value never depends on where
/// in the span it stands. in and out may be the same span. 0 is a legal argument of every f.
template <class Function>
void apply(std::span<const double> in, std::span<double> out, Function f) {
  constexpr std::size_t width = pack_width;
  const std::size_t whole = in.size() / width * width;
  for (std::size_t k = 0; k < whole; k += width) store_pack(&out[k], f(load_pack(&in[k])));
  if (whole == in.size()) return;
  std::array<double, width> padded{};
  for (std::size_t k = whole; k < in.size(); ++k) padded[k - whole] = in[k];
  store_pack(padded.data(), f(load_pack(padded.data())));
  for (std::size_t k = whole; k < in.size(); ++k) out[k] = padded[k - whole];
}

}  // namespace ehl::rheology
