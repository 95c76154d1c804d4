#include "thermal/source_convolution.hpp"

#include <omp.h>

#include <algorithm>

#include "core/store_lines.hpp"
#include "mlmi/fourier_convolution.hpp"

namespace ehl::thermal {
namespace {

constexpr int block_doubles = mlmi::ColumnTransform::doubles;

std::size_t size(std::ptrdiff_t n) { return static_cast<std::size_t>(n); }

// Complex product, written to the second factor.
void multiply(const double* by, double* number) {
  const double re = number[0], im = number[1];
  number[0] = by[0] * re - by[1] * im;
  number[1] = by[0] * im + by[1] * re;
}

}  // namespace

SourceConvolution::SourceConvolution(const core::Patch& patch, const SourceTable& table, int threads)
    : patch_(patch),
      length_rows_(mlmi::padded_length(2 * patch.nodes_x() - 1)),
      length_columns_(mlmi::padded_length(2 * patch.domain.nodes_y() - 1)),
      blocks_((length_columns_ + 2 + block_doubles - 1) / block_doubles),
      stride_(static_cast<std::ptrdiff_t>(blocks_) * block_doubles),
      half_(size(std::max(patch.nodes_x(), length_rows_) * stride_)),
      spectrum_(size(static_cast<std::ptrdiff_t>(blocks_) * length_rows_ * block_doubles)) {
  for (int t = 0; t < threads; ++t)
    workers_.push_back({mlmi::RealTransform(length_columns_), mlmi::ColumnTransform(length_rows_),
                        mlmi::Buffer(size(length_columns_) + 2), mlmi::Buffer(size(length_rows_) * block_doubles),
                        mlmi::Buffer(size(length_rows_) * block_doubles)});
  prepare_spectrum(table);
}

void SourceConvolution::prepare_spectrum(const SourceTable& table) {
  const int reach = patch_.nx, count = static_cast<int>(workers_.size());
  const double factor = 1.0 / (static_cast<double>(length_rows_) * length_columns_);
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int d = -reach; d <= reach; ++d) {
    Worker& worker = workers_[size(omp_get_thread_num())];
    double* row = worker.real.data();
    std::fill_n(row, worker.real.size(), 0.0);
    for (int k = 0; k <= patch_.domain.ny; ++k) row[k] = row[k == 0 ? 0 : length_columns_ - k] = factor * table(d, k);
    worker.row.forward(row, half_.data() + (d < 0 ? d + length_rows_ : d) * stride_);
  }
#pragma omp parallel for schedule(static) num_threads(count) if (count > 1)
  for (int b = 0; b < blocks_; ++b) {
    Worker& worker = workers_[size(omp_get_thread_num())];
    double* block = worker.block.data();
    for (int i = 0; i < length_rows_; ++i)
      std::copy_n(half_.data() + i * stride_ + b * block_doubles, block_doubles, block + i * block_doubles);
    worker.column.forward(block, worker.transformed.data());
    std::copy_n(worker.transformed.data(), length_rows_ * block_doubles,
                spectrum_.data() + static_cast<std::ptrdiff_t>(b) * length_rows_ * block_doubles);
  }
  // Columns beyond the last frequency are zero and must stay zero.
  std::fill_n(half_.data(), half_.size(), 0.0);
}

// For one block of columns: transform along X, multiply by the kernel, transform back.
void SourceConvolution::convolve_block(int b, Worker& worker) {
  double* block = worker.block.data();
  double* transformed = worker.transformed.data();
  double* column = half_.data() + b * block_doubles;
  const int rows = patch_.nodes_x();
  for (int i = 0; i < rows; ++i) std::copy_n(column + i * stride_, block_doubles, block + i * block_doubles);
  std::fill(block + rows * block_doubles, block + length_rows_ * block_doubles, 0.0);
  worker.column.forward(block, transformed);
  const double* kernel = spectrum_.data() + static_cast<std::ptrdiff_t>(b) * length_rows_ * block_doubles;
  for (int n = 0; n < length_rows_ * block_doubles; n += 2) multiply(kernel + n, transformed + n);
  worker.column.inverse(transformed, block);
  for (int i = 0; i < rows; ++i) std::copy_n(block + i * block_doubles, block_doubles, column + i * stride_);
}

void SourceConvolution::apply(const core::Field& q, core::Field& theta) {
  const int rows = patch_.nodes_x(), columns = patch_.domain.nodes_y(), count = static_cast<int>(workers_.size());
#pragma omp parallel num_threads(count) if (count > 1)
  {
    Worker& worker = workers_[size(omp_get_thread_num())];
    double* row = worker.real.data();
#pragma omp for schedule(static)
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns; ++j) row[j] = q(i, patch_.holder(j));
      std::fill(row + columns, row + worker.real.size(), 0.0);
      worker.row.forward(row, half_.data() + i * stride_);
    }
#pragma omp for schedule(static)
    for (int b = 0; b < blocks_; ++b) convolve_block(b, worker);
#pragma omp for schedule(static)
    for (int i = 0; i < rows; ++i) {
      worker.row.inverse(half_.data() + i * stride_, row);
      std::copy_n(row, patch_.nodes_y(), theta.at_x(i));
    }
  }
}

std::size_t SourceConvolution::bytes() const {
  std::size_t total = half_.bytes() + spectrum_.bytes();
  for (const Worker& worker : workers_) total += worker.real.bytes() + 2 * worker.block.bytes();
  return total;
}

LineConvolution::LineConvolution(const core::Patch& patch, const SourceTable& table)
    : patch_(patch), first_(-patch.nx), q_(size(patch.nodes_x())), theta_(q_.size()) {
  int last = patch.nx;
  while (last >= first_ && table(last, 0) == 0.0) --last;
  while (first_ <= last && table(first_, 0) == 0.0) ++first_;
  for (int d = first_; d <= last; ++d) G_.push_back(table(d, 0));
}

void LineConvolution::apply(const core::Field& q, core::Field& theta) {
  const int nodes = patch_.nodes_x();
  core::load_line(q, q_);
  std::ranges::fill(theta_, 0.0);
  for (std::size_t k = 0; k < G_.size(); ++k) {
    const int d = first_ + static_cast<int>(k), begin = std::max(0, d), end = std::min(nodes, nodes + d);
    const double G = G_[k];
    const double* from = q_.data() + begin - d;
    double* to = theta_.data() + begin;
    for (int i = 0; i < end - begin; ++i) to[i] += G * from[i];
  }
  core::store_line(theta_, theta);
}

Source make_source(const core::Patch& patch, const SourceTable& table, int threads) {
  if (patch.domain.line) return LineConvolution(patch, table);
  return SourceConvolution(patch, table, threads);
}

}  // namespace ehl::thermal
