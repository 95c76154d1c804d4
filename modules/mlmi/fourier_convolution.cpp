#include "mlmi/fourier_convolution.hpp"

#include <omp.h>

#include <algorithm>
#include <utility>

namespace ehl::mlmi {
namespace {

constexpr int block_columns = ColumnTransform::columns;
constexpr int block_doubles = 2 * block_columns;

std::size_t size(std::ptrdiff_t n) { return static_cast<std::size_t>(n); }

bool is_zero(const double* row, int n) {
  return std::all_of(row, row + n, [](double v) { return v == 0.0; });
}

// Half-open range of the rows that hold anything.
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

FourierConvolution::FourierConvolution(int rows, int columns, const kernel::InfluenceTable& kernel, double factor,
                                       int threads)
    : rows_(rows),
      columns_(columns),
      length_rows_(padded_length(2 * rows - 1)),
      length_columns_(padded_length(2 * columns - 1)),
      frequencies_(length_columns_ / 2 + 1),
      blocks_((frequencies_ + block_columns - 1) / block_columns),
      stride_(static_cast<std::ptrdiff_t>(blocks_) * block_doubles),
      half_(size(rows_ * stride_)),
      spectrum_(size(static_cast<std::ptrdiff_t>(blocks_) * (length_rows_ / 2 + 1) * block_columns)) {
  for (int t = 0; t < threads; ++t)
    workers_.push_back({RealTransform(length_columns_), ColumnTransform(length_rows_), Buffer(size(length_columns_)),
                        Buffer(size(stride_) + 2), Buffer(size(length_rows_) * block_doubles),
                        Buffer(size(length_rows_) * block_doubles)});
  prepare_spectrum(kernel, factor / (static_cast<double>(length_rows_) * length_columns_));
}

// K is even in both offsets, so its spectrum is real and even: rows 0..length/2 say everything, and the column
// transforms carry one real column in each real part.
void FourierConvolution::prepare_spectrum(const kernel::InfluenceTable& kernel, double factor) {
  const int half_rows = length_rows_ / 2 + 1;
  const int table_rows = std::min(kernel.n_x + 1, rows_), table_columns = std::min(kernel.n_y + 1, columns_);
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
    std::copy_n(worker.complex.data(), 2 * frequencies_, half_.data() + i * stride_);
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
    const double* transformed = worker.transformed.data();
    double* to = spectrum_.data() + static_cast<std::ptrdiff_t>(b) * half_rows * block_columns;
    for (int i = 0; i < half_rows; ++i)
      for (int c = 0; c < block_columns; ++c) to[i * block_columns + c] = transformed[i * block_doubles + 2 * c];
  }
  // The columns behind the last frequency hold nothing and must stay so.
  std::fill_n(half_.data(), half_.size(), 0.0);
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
  const double* kernel = spectrum_.data() + static_cast<std::ptrdiff_t>(b) * (length_rows_ / 2 + 1) * block_columns;
  for (int i = 0; i < length_rows_; ++i) {
    const double* factor = kernel + std::min(i, length_rows_ - i) * block_columns;
    double* value = transformed + i * block_doubles;
    for (int c = 0; c < block_columns; ++c) {
      value[2 * c] *= factor[c];
      value[2 * c + 1] *= factor[c];
    }
  }
  worker.column.inverse(transformed, block);
  for (int i = 0; i < rows_; ++i) std::copy_n(block + i * block_doubles, block_doubles, column + i * stride_);
}

void FourierConvolution::apply(const double* u, std::ptrdiff_t stride_u, double* w, std::ptrdiff_t stride_w) {
  const auto occupied = occupied_rows(u, stride_u, rows_, columns_);
  const int first = occupied.first, last = occupied.second;
  const int count = static_cast<int>(workers_.size());
#pragma omp parallel num_threads(count) if (count > 1)
  {
    Worker& worker = workers_[size(omp_get_thread_num())];
    std::fill(worker.real.data() + columns_, worker.real.data() + length_columns_, 0.0);
#pragma omp for schedule(static)
    for (int i = first; i < last; ++i) {
      std::copy_n(u + i * stride_u, columns_, worker.real.data());
      worker.row.forward(worker.real.data(), half_.data() + i * stride_);
    }
#pragma omp for schedule(static)
    for (int b = 0; b < blocks_; ++b) convolve_block(b, first, last, worker);
#pragma omp for schedule(static)
    for (int i = 0; i < rows_; ++i) {
      worker.row.inverse(half_.data() + i * stride_, worker.real.data());
      std::copy_n(worker.real.data(), columns_, w + i * stride_w);
    }
  }
}

std::size_t FourierConvolution::bytes() const {
  std::size_t total = half_.bytes() + spectrum_.bytes();
  for (const Worker& worker : workers_)
    total += worker.real.bytes() + worker.complex.bytes() + 2 * worker.block.bytes();
  return total;
}

}  // namespace ehl::mlmi
