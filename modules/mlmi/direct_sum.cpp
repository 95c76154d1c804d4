#include "mlmi/direct_sum.hpp"

#include <algorithm>
#include <cstdlib>

namespace ehl::mlmi {

DirectSum::DirectSum(int rows, int columns, const kernel::InfluenceTable& kernel, double factor, int threads)
    : rows_(rows), columns_(columns), threads_(threads) {
  const int width = 2 * columns - 1;
  kernel_.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(width));
  double* entry = kernel_.data();
  for (int d = 0; d < rows; ++d)
    for (int e = -(columns - 1); e < columns; ++e) *entry++ = factor * kernel(d, e);
}

void DirectSum::apply(const double* u, std::ptrdiff_t stride_u, double* w, std::ptrdiff_t stride_w) const {
  const std::ptrdiff_t width = 2 * columns_ - 1;
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (int i = 0; i < rows_; ++i) {
    double* out = w + i * stride_w;
    std::fill_n(out, columns_, 0.0);
    for (int k = 0; k < rows_; ++k) {
      const double* source = u + k * stride_u;
      const double* centre = kernel_.data() + std::abs(i - k) * width + (columns_ - 1);
      for (int l = 0; l < columns_; ++l) {
        const double strength = source[l];
        if (strength == 0.0) continue;
        const double* kernel = centre - l;
#pragma omp simd
        for (int j = 0; j < columns_; ++j) out[j] += strength * kernel[j];
      }
    }
  }
}

}  // namespace ehl::mlmi
