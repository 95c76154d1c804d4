#include "effects/subsurface/plane_sum.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/constants.hpp"
#include "mlmi/fourier_convolution.hpp"

namespace ehl::subsurface {
namespace {

constexpr int block_doubles = mlmi::ColumnTransform::doubles;

std::size_t size(std::ptrdiff_t n) { return static_cast<std::size_t>(n); }

}  // namespace

PlaneSum::Work::Work(const PlaneSum& sum)
    : row_(sum.length_y_),
      column_(sum.length_x_),
      half_(size(sum.length_x_ * sum.stride_)),
      real_(size(sum.length_y_)),
      block_(size(sum.length_x_) * block_doubles),
      transformed_(block_.size()) {
  const bool sheared = sum.body_.friction != 0.0;
  const std::size_t nodes = size(sum.grid_.nodes_x()) * size(sum.grid_.nodes_y());
  for (int load = 0; load <= (sheared ? 1 : 0); ++load)
    for (auto& station : corners_[load]) station.resize(size(sum.grid_.nodes_y() + 1));
  for (auto& component : normal_) component.resize(nodes);
  if (sheared)
    for (auto& component : shear_) component.resize(nodes);
}

PlaneSum::PlaneSum(const core::Grid& grid, const core::Field& P, const Body& body)
    : grid_(grid),
      body_(body),
      length_x_(mlmi::padded_length(2 * grid.nodes_x() - 1)),
      length_y_(mlmi::padded_length(2 * grid.nodes_y() - 1)),
      blocks_((length_y_ + 2 + block_doubles - 1) / block_doubles),
      stride_(static_cast<std::ptrdiff_t>(blocks_) * block_doubles),
      spectrum_(size(length_x_ * stride_)) {
  mlmi::RealTransform row(length_y_);
  mlmi::ColumnTransform column(length_x_);
  mlmi::Buffer real(size(length_y_)), block(size(length_x_) * block_doubles), transformed(block.size());
  for (int i = 0; i < grid.nodes_x(); ++i) {
    std::ranges::copy(P.station(i), real.data());
    row.forward(real.data(), spectrum_.data() + i * stride_);
  }
  const double per_point = 1.0 / (static_cast<double>(length_x_) * length_y_);
  for (int b = 0; b < blocks_; ++b) {
    double* of_block = spectrum_.data() + b * block_doubles;
    for (int i = 0; i < length_x_; ++i)
      std::copy_n(of_block + i * stride_, block_doubles, block.data() + i * block_doubles);
    column.forward(block.data(), transformed.data());
    for (int i = 0; i < length_x_; ++i)
      for (int c = 0; c < block_doubles; ++c)
        of_block[i * stride_ + c] = per_point * transformed[size(i * block_doubles + c)];
  }
}

// Stress below a cell at the offsets 0..nx, 0..ny; neighbouring cells share their corners.
void PlaneSum::fill_kernels(double z, Work& work) const {
  const bool sheared = body_.friction != 0.0;
  const int columns = grid_.nodes_y();
  const double hx = grid_.hx(), hy = grid_.hy();
  const auto fill_corners = [&](int d_x, std::size_t where) {
    const double u = (d_x - 0.5) * hx;
    for (int d_y = 0; d_y <= columns; ++d_y) {
      const double v = (d_y - 0.5) * hy;
      work.corners_[0][where][size(d_y)] = normal_corner(u, v, z, body_.nu);
      if (sheared) work.corners_[1][where][size(d_y)] = shear_corner(u, v, z, body_.nu);
    }
  };
  fill_corners(0, 0);
  for (int d_x = 0; d_x < grid_.nodes_x(); ++d_x) {
    const std::size_t here = size(d_x % 2);
    fill_corners(d_x + 1, 1 - here);
    for (int load = 0; load <= (sheared ? 1 : 0); ++load) {
      const std::vector<Stress>& low = work.corners_[load][here];
      const std::vector<Stress>& high = work.corners_[load][1 - here];
      const double factor = (load == 0 ? 1.0 : body_.friction) / (2.0 * core::pi);
      auto& table = load == 0 ? work.normal_ : work.shear_;
      for (std::size_t k = 0; k < components; ++k) {
        double* to = table[k].data() + static_cast<std::ptrdiff_t>(d_x) * columns;
        for (std::size_t j = 0; j < size(columns); ++j)
          to[j] = factor * (low[j][k] + high[j + 1][k] - high[j][k] - low[j + 1][k]);
      }
    }
  }
}

// Writes one row of the kernel, at offset d_x or -d_x, to the real buffer. Pressure and shear have opposite parities in
// x.
void PlaneSum::row_of_kernel(int component, int d_x, bool left, Work& work) const {
  const int columns = grid_.nodes_y();
  const double sign_x = left && normal_is_odd_in_x(component) ? -1.0 : 1.0;
  const double sign_shear = left ? -sign_x : sign_x;
  const double sign_y = is_odd_in_y(component) ? -1.0 : 1.0;
  const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(d_x) * columns;
  const double* normal = work.normal_[size(component)].data() + from;
  const double* shear = body_.friction != 0.0 ? work.shear_[size(component)].data() + from : nullptr;
  double* row = work.real_.data();
  std::fill_n(row, work.real_.size(), 0.0);
  for (int j = 0; j < columns; ++j) {
    const double value = sign_x * normal[j] + (shear != nullptr ? sign_shear * shear[j] : 0.0);
    row[j] = value;
    if (j > 0) row[length_y_ - j] = sign_y * value;
  }
  if (sign_y < 0.0) row[0] = 0.0;
}

void PlaneSum::transform_kernel(int component, Work& work) const {
  double* half = work.half_.data();
  const bool by_parity = body_.friction == 0.0;
  const double parity = normal_is_odd_in_x(component) ? -1.0 : 1.0;
  std::fill(half + grid_.nodes_x() * stride_, half + (length_x_ - grid_.nx) * stride_, 0.0);
  for (int d = 0; d < grid_.nodes_x(); ++d) {
    double* right = half + d * stride_;
    row_of_kernel(component, d, false, work);
    work.row_.forward(work.real_.data(), right);
    if (d == 0) continue;
    double* left = half + (length_x_ - d) * stride_;
    if (by_parity) {
      for (std::ptrdiff_t k = 0; k < length_y_ + 2; ++k) left[k] = parity * right[k];
    } else {
      row_of_kernel(component, d, true, work);
      work.row_.forward(work.real_.data(), left);
    }
  }
}

// Transforms the columns of the kernel, multiplies by the spectrum of P, and transforms columns and rows back.
void PlaneSum::sum(Work& work, core::Field& out) const {
  double* block = work.block_.data();
  double* transformed = work.transformed_.data();
  for (int b = 0; b < blocks_; ++b) {
    double* half = work.half_.data() + b * block_doubles;
    const double* pressure = spectrum_.data() + b * block_doubles;
    for (int i = 0; i < length_x_; ++i) std::copy_n(half + i * stride_, block_doubles, block + i * block_doubles);
    work.column_.forward(block, transformed);
    for (int i = 0; i < length_x_; ++i) {
      double* value = transformed + i * block_doubles;
      const double* factor = pressure + i * stride_;
      for (int c = 0; c < block_doubles; c += 2) {
        const double real = value[c] * factor[c] - value[c + 1] * factor[c + 1];
        value[c + 1] = value[c] * factor[c + 1] + value[c + 1] * factor[c];
        value[c] = real;
      }
    }
    work.column_.inverse(transformed, block);
    for (int i = 0; i < grid_.nodes_x(); ++i) std::copy_n(block + i * block_doubles, block_doubles, half + i * stride_);
  }
  for (int i = 0; i < grid_.nodes_x(); ++i) {
    work.row_.inverse(work.half_.data() + i * stride_, work.real_.data());
    std::copy_n(work.real_.data(), grid_.nodes_y(), out.at_x(i));
  }
}

void PlaneSum::evaluate(double z, Work& work, StressFields& stress) const {
  fill_kernels(z, work);
  for (int component = 0; component < static_cast<int>(components); ++component) {
    transform_kernel(component, work);
    sum(work, stress[size(component)]);
  }
}

Stress stress_at(const core::Grid& grid, const core::Field& P, const Body& body, double X, double Y, double z) {
  Stress total{};
  const double half_x = 0.5 * grid.hx(), half_y = 0.5 * grid.hy();
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) {
      if (P(i, j) == 0.0) continue;
      const double x = X - grid.X(i), y = Y - grid.Y(j);
      const Stress normal = normal_patch(x, y, z, half_x, half_y, body.nu);
      Stress shear{};
      if (body.friction != 0.0) shear = shear_patch(x, y, z, half_x, half_y, body.nu);
      for (std::size_t k = 0; k < components; ++k) total[k] += P(i, j) * (normal[k] + body.friction * shear[k]);
    }
  return total;
}

}  // namespace ehl::subsurface
