#pragma once
// Times of reference workloads that every machine can run, measured together with a benchmark.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

#include "core/aligned_array.hpp"
#include "core/timer.hpp"
#include "mlmi/fourier_convolution.hpp"
#include "mlmi/fourier_transform.hpp"

namespace ehl::tests {

struct Yardsticks {
  double fft_seconds = 0.0;    ///< forward and inverse real transform of a 513 x 513 grid, padded to twice its size
  double copy_GB_per_s = 0.0;  ///< bytes copied per second, large arrays
};

/// Measures with one thread; the least of some runs.
inline Yardsticks measure_yardsticks(int runs) {
  Yardsticks result{.fft_seconds = 1e9};
  constexpr int nodes = 513;
  const int length = mlmi::padded_length(2 * nodes - 1);
  constexpr int together = mlmi::ColumnTransform::columns;
  const int blocks = (length / 2 + 1 + together - 1) / together;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(blocks) * 2 * together;
  const mlmi::RealTransform rows(length);
  const mlmi::ColumnTransform columns(length);
  const auto real = core::zeroed_array(static_cast<std::size_t>(length));
  const auto half = core::zeroed_array(static_cast<std::size_t>(length * stride));
  const auto block = core::zeroed_array(static_cast<std::size_t>(length) * 2 * together);
  const auto transformed = core::zeroed_array(static_cast<std::size_t>(length) * 2 * together);
  const auto columns_of_block = [&](int b, bool forward) {
    double* const column = half.get() + b * 2 * together;
    for (int i = 0; i < length; ++i) std::copy_n(column + i * stride, 2 * together, block.get() + i * 2 * together);
    if (forward)
      columns.forward(block.get(), transformed.get());
    else
      columns.inverse(block.get(), transformed.get());
    for (int i = 0; i < length; ++i)
      std::copy_n(transformed.get() + i * 2 * together, 2 * together, column + i * stride);
  };
  for (int run = 0; run < runs + 2; ++run) {
    const double began = core::now();
    for (int i = 0; i < length; ++i) {
      for (int j = 0; j < length; ++j) real[static_cast<std::size_t>(j)] = i < nodes && j < nodes ? 1.0 : 0.0;
      rows.forward(real.get(), half.get() + i * stride);
    }
    for (const bool forward : {true, false})
      for (int b = 0; b < blocks; ++b) columns_of_block(b, forward);
    for (int i = 0; i < length; ++i) rows.inverse(half.get() + i * stride, real.get());
    result.fft_seconds = std::min(result.fft_seconds, core::now() - began);
  }
  constexpr std::size_t doubles = std::size_t{1} << 23;  // 64 MB
  std::vector<double> from(doubles, 1.0), to(doubles, 0.0);
  for (int run = 0; run < runs + 2; ++run) {
    const double began = core::now();
    std::memcpy(to.data(), from.data(), doubles * sizeof(double));
    const double seconds = core::now() - began;
    from[static_cast<std::size_t>(run)] =
        to[static_cast<std::size_t>(run + 1)];  // so that the copy is not optimised away
    result.copy_GB_per_s = std::max(result.copy_GB_per_s, 1e-9 * doubles * sizeof(double) / seconds);
  }
  return result;
}

}  // namespace ehl::tests
