#pragma once
// Functions of vector registers on spans of numbers.
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <tuple>

#include "core/simd.hpp"

namespace ehl::core {

/// Sets the outputs to f of the inputs, for one register of values after another. The last register repeats a value, so
/// that no result depends on its position. in: f, which takes a register of every input and returns one for every
/// output; spans of one length. An empty output is not written; inputs and outputs may be the same spans.
template <std::size_t inputs, std::size_t outputs, class Function>
void in_registers(const std::array<std::span<const double>, inputs>& in,
                  const std::array<std::span<double>, outputs>& out, Function f) {
  constexpr std::size_t width = lanes;
  const std::size_t whole = in[0].size() / width * width, rest = in[0].size() - whole;
  const auto evaluate = [&](auto loaded, auto store_in) {
    std::array<Lanes, inputs> values;
    for (std::size_t n = 0; n < inputs; ++n) values[n] = loaded(in[n]);
    const std::array<Lanes, outputs> results = std::apply(f, values);
    for (std::size_t n = 0; n < outputs; ++n)
      if (!out[n].empty()) store_in(out[n], results[n]);
  };
  for (std::size_t k = 0; k < whole; k += width)
    evaluate([k](std::span<const double> from) { return load(&from[k]); },
             [k](std::span<double> to, Lanes values) { store(&to[k], values); });
  if (rest == 0) return;
  std::array<double, width> last;
  evaluate(
      [&](std::span<const double> from) {
        last.fill(from[whole]);
        std::copy_n(&from[whole], rest, last.data());
        return load(last.data());
      },
      [&](std::span<double> to, Lanes values) {
        store(last.data(), values);
        std::copy_n(last.data(), rest, &to[whole]);
      });
}

/// Sets one output to f of one input.
template <class Function>
void in_registers(std::span<const double> in, std::span<double> out, Function f) {
  in_registers(std::array{in}, std::array{out}, [&](Lanes values) { return std::array{f(values)}; });
}

}  // namespace ehl::core
