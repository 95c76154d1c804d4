#include "mlmi/fourier_convolution.hpp"

#include <omp.h>

#include <algorithm>
#include <utility>

#include "core/simd.hpp"

namespace ehl::mlmi {
namespace {

constexpr int block_doubles = ColumnTransform::doubles;

std::size_t size(std::ptrdiff_t n) { return static_cast<std::size_t>(n); }

bool is_zero(const double* row, int n) {
  return std::all_of(row, row + n, [](double v) { return v == 0.0; });
}

// Half-open range of the rows that are not zero.
std::pair<int, int> occupied_rows(const double* u, std::ptrdiff_t stride, int rows, int columns) {
  int first = 0, last = rows;
  while (first < last && is_zero(u + first * stride, columns)) ++first;
  while (last > first && is_zero(u + (last - 1) * stride, columns)) --last;
  return {first, last};
}

}  // namespace

int padded_length(int n) {
  for (int candidate = std::max(2, n + n % 2);; candidate += 2) {
    int rest = candidate;
    for (const int prime : {2, 3, 5})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return candidate;
  }
}

FourierConvolution::FourierConvolution(const Shape& shape, const kernel::InfluenceTable& kernel, double factor,
                                       int threads)
    : shape_(shape),
      length_rows_(padded_length(2 * shape.rows - 1)),
      length_columns_(padded_length(2 * shape.all_columns() - 1)),
      numbers_((shape.even ? 1 : 2) * (length_columns_ / 2 + 1)),
      blocks_((numbers_ + block_doubles - 1) / block_doubles),
      stride_(static_cast<std::ptrdiff_t>(blocks_) * block_doubles),
      half_(size(shape.rows * stride_)),
      spectrum_(size(static_cast<std::ptrdiff_t>(blocks_) * (length_rows_ / 2 + 1) * block_doubles)) {
  for (int t = 0; t < threads; ++t)
    workers_.push_back({RealTransform(length_columns_), ColumnTransform(length_rows_), Buffer(size(length_columns_)),
                        Buffer(size(length_columns_) + 2), Buffer(size(length_rows_) * block_doubles),
                        Buffer(size(length_rows_) * block_doubles)});
  prepare_spectrum(kernel, factor / (static_cast<double>(length_rows_) * length_columns_));
}

// K is even in both offsets, so its spectrum is real and even, and rows 0..length/2 determine it. The numbers of a
// block are stored in the order in which multiply() reads them.
void FourierConvolution::prepare_spectrum(const kernel::InfluenceTable& kernel, double factor) {
  const int half_rows = length_rows_ / 2 + 1;
  const int table_rows = std::min(kernel.n_x + 1, shape_.rows);
  const int table_columns = std::min(kernel.n_y + 1, shape_.all_columns());
  const int count = static_cast<int>(workers_.size());
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int i = 0; i < table_rows; ++i) {
    Worker& worker = workers_[size(omp_get_thread_num())];
    std::fill_n(worker.real.data(), worker.real.size(), 0.0);
    for (int j = 0; j < table_columns; ++j) {
      worker.real[size(j)] = factor * kernel(i, j);
      if (j > 0) worker.real[size(length_columns_ - j)] = factor * kernel(i, j);
    }
    worker.row.forward(worker.real.data(), worker.complex.data());
    double* to = half_.data() + i * stride_;
    // Without symmetry the real and the imaginary part have one factor.
    for (int k = 0; k < numbers_; ++k) to[k] = worker.complex[size(shape_.even ? 2 * k : k - k % 2)];
  }
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int b = 0; b < blocks_; ++b) {
    Worker& worker = workers_[size(omp_get_thread_num())];
    double* block = worker.block.data();
    std::fill_n(block, worker.block.size(), 0.0);
    for (int i = 0; i < table_rows; ++i) {
      const double* from = half_.data() + i * stride_ + b * block_doubles;
      std::copy_n(from, block_doubles, block + i * block_doubles);
      if (i > 0) std::copy_n(from, block_doubles, block + (length_rows_ - i) * block_doubles);
    }
    worker.column.forward(block, worker.transformed.data());
    double* to = spectrum_.data() + static_cast<std::ptrdiff_t>(b) * half_rows * block_doubles;
    std::copy_n(worker.transformed.data(), half_rows * block_doubles, to);
  }
  // The columns after the last frequency must stay zero.
  std::fill_n(half_.data(), half_.size(), 0.0);
}

void FourierConvolution::row_forward(const double* u, Worker& worker, double* spectrum) const {
  double* row = worker.real.data();
  if (!shape_.even) {
    std::copy_n(u, shape_.columns, row);
    worker.row.forward(row, spectrum);
    return;
  }
  const int axis = shape_.columns - 1;
  row[0] = u[axis];
  for (int k = 1; k <= axis; ++k) row[k] = row[length_columns_ - k] = u[axis - k];
  worker.row.forward(row, worker.complex.data());
  for (int k = 0; k < numbers_; ++k) spectrum[k] = worker.complex[size(2 * k)];
}

void FourierConvolution::row_inverse(double* spectrum, Worker& worker, double* w) const {
  double* row = worker.real.data();
  if (!shape_.even) {
    worker.row.inverse(spectrum, row);
    std::copy_n(row, shape_.columns, w);
    return;
  }
  for (int k = 0; k < numbers_; ++k) {
    worker.complex[size(2 * k)] = spectrum[k];
    worker.complex[size(2 * k + 1)] = 0.0;
  }
  worker.row.inverse(worker.complex.data(), row);
  std::reverse_copy(row, row + shape_.columns, w);
}

// A complex column Z is one column with the spectrum K of the kernel; with even rows it is two real ones, Z = A + iB,
// with K_A and K_B. Then K_A A + i K_B B = (K_A + K_B)/2 Z_k + (K_A - K_B)/2 conj(Z_-k).
void FourierConvolution::multiply(const double* kernel, double* transformed) const {
  using core::Lanes, core::lanes;
  if (!shape_.even) {
    for (int k = 0; k < length_rows_; ++k) {
      const double* factor = kernel + std::min(k, length_rows_ - k) * block_doubles;
      double* value = transformed + k * block_doubles;
      for (int c = 0; c < block_doubles; ++c) value[c] *= factor[c];
    }
    return;
  }
  for (int k = 0; k <= length_rows_ / 2; ++k)
    for (int c = 0; c < block_doubles; c += lanes) {
      const Lanes K = 0.5 * core::load(kernel + k * block_doubles + c);
      const Lanes other = core::swapped_pairs(K);
      double* one = transformed + k * block_doubles + c;
      double* opposite = transformed + (k == 0 ? 0 : length_rows_ - k) * block_doubles + c;
      const Lanes Z = core::load(one);
      const Lanes Z_opposite = core::load(opposite);
      core::store(one, (K + other) * Z + (K - other) * Z_opposite);
      core::store(opposite, (K + other) * Z_opposite + (K - other) * Z);
    }
}

// Transform along the rows, multiply by the kernel, transform back, for the columns of one block. Only the rows
// first..last-1 are occupied on entry.
void FourierConvolution::convolve_block(int b, int first, int last, Worker& worker) {
  double* block = worker.block.data();
  double* column = half_.data() + b * block_doubles;
  std::fill_n(block, first * block_doubles, 0.0);
  for (int i = first; i < last; ++i) std::copy_n(column + i * stride_, block_doubles, block + i * block_doubles);
  std::fill(block + last * block_doubles, block + static_cast<std::ptrdiff_t>(length_rows_) * block_doubles, 0.0);
  double* transformed = worker.transformed.data();
  worker.column.forward(block, transformed);
  multiply(spectrum_.data() + static_cast<std::ptrdiff_t>(b) * (length_rows_ / 2 + 1) * block_doubles, transformed);
  worker.column.inverse(transformed, block);
  for (int i = 0; i < shape_.rows; ++i) std::copy_n(block + i * block_doubles, block_doubles, column + i * stride_);
}

void FourierConvolution::apply(const double* u, std::ptrdiff_t stride_u, double* w, std::ptrdiff_t stride_w) {
  const auto occupied = occupied_rows(u, stride_u, shape_.rows, shape_.columns);
  const int first = occupied.first, last = occupied.second;
  const int count = static_cast<int>(workers_.size());
#pragma omp parallel num_threads(count) if (count > 1)
  {
    Worker& worker = workers_[size(omp_get_thread_num())];
    std::fill_n(worker.real.data(), worker.real.size(), 0.0);
#pragma omp for schedule(static)
    for (int i = first; i < last; ++i) row_forward(u + i * stride_u, worker, half_.data() + i * stride_);
#pragma omp for schedule(static)
    for (int b = 0; b < blocks_; ++b) convolve_block(b, first, last, worker);
#pragma omp for schedule(static)
    for (int i = 0; i < shape_.rows; ++i) row_inverse(half_.data() + i * stride_, worker, w + i * stride_w);
  }
}

std::size_t FourierConvolution::bytes() const {
  std::size_t total = half_.bytes() + spectrum_.bytes();
  for (const Worker& worker : workers_)
    total += worker.real.bytes() + worker.complex.bytes() + 2 * worker.block.bytes();
  return total;
}

}  // namespace ehl::mlmi
