#include "effects/subsurface/plane_sum.hpp"

#include <algorithm>

namespace ehl::subsurface {
namespace {

std::size_t size(std::ptrdiff_t n) { return static_cast<std::size_t>(n); }

// product = spectrum (factor_real real + i factor_imaginary imaginary) over a row of a block.
void multiply_row(const double* __restrict spectrum, const double* __restrict real, double factor_real,
                  const double* __restrict imaginary, double factor_imaginary, double* __restrict product) {
  for (int c = 0; c < columns_of_block; ++c) {
    const double re = factor_real * real[c], im = factor_imaginary * imaginary[c];
    product[2 * c] = spectrum[2 * c] * re - spectrum[2 * c + 1] * im;
    product[2 * c + 1] = spectrum[2 * c] * im + spectrum[2 * c + 1] * re;
  }
}

}  // namespace

PlaneSum::Work::Work(const PlaneSum& sum)
    : row_(sum.padding_.length_y),
      column_(sum.padding_.length_x),
      half_(size(sum.grid_.nodes_x() * sum.padding_.stride)),
      real_(size(sum.padding_.length_y)),
      block_(size(sum.padding_.length_x) * block_doubles),
      transformed_(block_.size()) {}

PlaneSum::PlaneSum(const core::Grid& grid, const core::Field& P)
    : grid_(grid), padding_(grid), spectrum_(size(padding_.length_x * padding_.stride)) {
  mlmi::RealTransform row(padding_.length_y);
  mlmi::ColumnTransform column(padding_.length_x);
  mlmi::Buffer real(size(padding_.length_y)), block(size(padding_.length_x) * block_doubles), transformed(block.size());
  for (int i = 0; i < grid.nodes_x(); ++i) {
    std::ranges::copy(P.station(i), real.data());
    row.forward(real.data(), spectrum_.data() + i * padding_.stride);
  }
  const double per_point = 1.0 / (static_cast<double>(padding_.length_x) * padding_.length_y);
  for (int b = 0; b < padding_.blocks; ++b) {
    double* of_block = spectrum_.data() + b * block_doubles;
    for (int i = 0; i < padding_.length_x; ++i)
      std::copy_n(of_block + i * padding_.stride, block_doubles, block.data() + i * block_doubles);
    column.forward(block.data(), transformed.data());
    for (int i = 0; i < padding_.length_x; ++i)
      for (int c = 0; c < block_doubles; ++c)
        of_block[i * padding_.stride + c] = per_point * transformed[size(i * block_doubles + c)];
  }
}

// The pressure and the shear have opposite parities in x: where one of the two spectra is real, the other is imaginary.
void PlaneSum::multiply(const PlaneKernel& kernel, double friction, std::size_t component, int block,
                        double* product) const {
  static constexpr double none[columns_of_block] = {};
  for (int i = 0; i < padding_.length_x; ++i) {
    const bool mirrored = i > padding_.length_x / 2;
    const int row = mirrored ? padding_.length_x - i : i;
    const auto part = [&](Load load) {
      return kernel.has(load) ? kernel.row(load, component, row) + block * columns_of_block : none;
    };
    const auto sign = [&](Load load) { return mirrored && is_odd_in_x(load, component) ? -1.0 : 1.0; };
    const bool swapped = is_imaginary(pressed, component);
    const Load real = swapped ? sheared : pressed, imaginary = swapped ? pressed : sheared;
    const double factor_real = sign(real) * (real == sheared ? friction : 1.0);
    const double factor_imaginary = sign(imaginary) * (imaginary == sheared ? friction : 1.0);
    multiply_row(spectrum_.data() + i * padding_.stride + block * block_doubles, part(real), factor_real,
                 part(imaginary), factor_imaginary, product + i * block_doubles);
  }
}

void PlaneSum::evaluate(const PlaneKernel& kernel, double friction, Work& work, StressFields& stress) const {
  for (std::size_t component = 0; component < components; ++component) {
    for (int b = 0; b < padding_.blocks; ++b) {
      multiply(kernel, friction, component, b, work.block_.data());
      work.column_.inverse(work.block_.data(), work.transformed_.data());
      for (int i = 0; i < grid_.nodes_x(); ++i)
        std::copy_n(work.transformed_.data() + i * block_doubles, block_doubles,
                    work.half_.data() + i * padding_.stride + b * block_doubles);
    }
    for (int i = 0; i < grid_.nodes_x(); ++i) {
      work.row_.inverse(work.half_.data() + i * padding_.stride, work.real_.data());
      std::copy_n(work.real_.data(), grid_.nodes_y(), stress[component].at_x(i));
    }
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
