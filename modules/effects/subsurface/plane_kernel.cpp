#include "effects/subsurface/plane_kernel.hpp"

#include <algorithm>

#include "core/constants.hpp"
#include "mlmi/fourier_convolution.hpp"

namespace ehl::subsurface {
namespace {

std::size_t size(std::ptrdiff_t n) { return static_cast<std::size_t>(n); }

}  // namespace

Padding::Padding(const core::Grid& grid)
    : length_x(mlmi::padded_length(2 * grid.nodes_x() - 1)),
      length_y(mlmi::padded_length(2 * grid.nodes_y() - 1)),
      blocks((length_y + 2 + block_doubles - 1) / block_doubles),
      stride(static_cast<std::ptrdiff_t>(blocks) * block_doubles) {}

PlaneKernel::Work::Work(const core::Grid& grid)
    : row_(Padding(grid).length_y),
      column_(Padding(grid).length_x),
      half_(size(Padding(grid).length_x * Padding(grid).stride)),
      real_(size(Padding(grid).length_y)),
      block_(size(Padding(grid).length_x) * block_doubles),
      transformed_(block_.size()) {
  for (auto& station : corners_) station.resize(size(grid.nodes_y() + 1));
  for (auto& component : table_) component.resize(size(grid.nodes_x()) * size(grid.nodes_y()));
}

PlaneKernel::PlaneKernel(const core::Grid& grid, double nu, double z, bool with_shear, Work& work)
    : row_length_(static_cast<std::ptrdiff_t>(Padding(grid).blocks) * columns_of_block) {
  const Padding padding(grid);
  for (const Load load : {pressed, sheared}) {
    if (load == sheared && !with_shear) continue;
    fill_table(grid, load, nu, z, work);
    for (std::size_t k = 0; k < components; ++k) {
      spectra_[load][k] = mlmi::Buffer(size((padding.length_x / 2 + 1) * row_length_));
      transform(grid, padding, load, k, work);
    }
  }
}

// Stress below a cell at the offsets 0..nx, 0..ny; neighbouring cells share their corners.
void PlaneKernel::fill_table(const core::Grid& grid, Load load, double nu, double z, Work& work) const {
  const auto corner = load == pressed ? normal_corner : shear_corner;
  const int columns = grid.nodes_y();
  const auto fill_corners = [&](int d_x, std::vector<Stress>& station) {
    const double u = (d_x - 0.5) * grid.hx();
    for (int d_y = 0; d_y <= columns; ++d_y) station[size(d_y)] = corner(u, (d_y - 0.5) * grid.hy(), z, nu);
  };
  fill_corners(0, work.corners_[0]);
  for (int d_x = 0; d_x < grid.nodes_x(); ++d_x) {
    const std::vector<Stress>& low = work.corners_[d_x % 2];
    std::vector<Stress>& high = work.corners_[1 - d_x % 2];
    fill_corners(d_x + 1, high);
    for (std::size_t k = 0; k < components; ++k) {
      double* to = work.table_[k].data() + static_cast<std::ptrdiff_t>(d_x) * columns;
      for (std::size_t j = 0; j < size(columns); ++j)
        to[j] = (low[j][k] + high[j + 1][k] - high[j][k] - low[j + 1][k]) / (2.0 * core::pi);
    }
  }
}

void PlaneKernel::transform(const core::Grid& grid, const Padding& padding, Load load, std::size_t component,
                            Work& work) {
  const int columns = grid.nodes_y();
  const double sign_x = is_odd_in_x(load, component) ? -1.0 : 1.0;
  const double sign_y = is_odd_in_y(static_cast<int>(component)) ? -1.0 : 1.0;
  double* half = work.half_.data();
  double* row = work.real_.data();
  std::fill(half + grid.nodes_x() * padding.stride, half + (padding.length_x - grid.nx) * padding.stride, 0.0);
  for (int d = 0; d < grid.nodes_x(); ++d) {
    const double* table = work.table_[component].data() + static_cast<std::ptrdiff_t>(d) * columns;
    std::fill_n(row, work.real_.size(), 0.0);
    row[0] = sign_y > 0.0 ? table[0] : 0.0;
    for (int j = 1; j < columns; ++j) {
      row[j] = table[j];
      row[padding.length_y - j] = sign_y * table[j];
    }
    double* right = half + d * padding.stride;
    work.row_.forward(row, right);
    if (d == 0) continue;
    double* left = half + (padding.length_x - d) * padding.stride;
    for (std::ptrdiff_t k = 0; k < padding.length_y + 2; ++k) left[k] = sign_x * right[k];
  }
  const int part = is_imaginary(load, component) ? 1 : 0;
  double* spectrum = spectra_[load][component].data();
  for (int b = 0; b < padding.blocks; ++b) {
    for (int i = 0; i < padding.length_x; ++i)
      std::copy_n(half + i * padding.stride + b * block_doubles, block_doubles, work.block_.data() + i * block_doubles);
    work.column_.forward(work.block_.data(), work.transformed_.data());
    for (int i = 0; i <= padding.length_x / 2; ++i)
      for (int c = 0; c < columns_of_block; ++c)
        spectrum[i * row_length_ + b * columns_of_block + c] =
            work.transformed_[size(i * block_doubles + 2 * c + part)];
  }
}

}  // namespace ehl::subsurface
