#pragma once
// The stresses below one cell, in Fourier space, for all nodes of a plane of constant depth.
#include <array>
#include <cstddef>
#include <vector>

#include "core/grid.hpp"
#include "effects/subsurface/patch.hpp"
#include "mlmi/buffer.hpp"
#include "mlmi/fourier_transform.hpp"

namespace ehl::subsurface {

/// Columns that are transformed together, and their real and imaginary parts.
inline constexpr int columns_of_block = mlmi::ColumnTransform::columns, block_doubles = mlmi::ColumnTransform::doubles;

/// Lengths of zero-padded transforms over the nodes of a plane. A spectrum has length_x rows of `stride` doubles,
/// complex numbers of the wave numbers 0..length_y/2 along y.
struct Padding {
  explicit Padding(const core::Grid& grid);
  int length_x, length_y;
  int blocks;             ///< of ColumnTransform::columns complex columns
  std::ptrdiff_t stride;  ///< doubles
};

/// Two surface loads: a pressure p = 1 and a shear traction q = 1 along +x (patch.hpp).
enum Load { pressed, sheared };
inline constexpr int loads = 2;

/// Spectra of the six stresses at depth z below one cell of hx by hy. Each is even or odd in x and in y, so that it is
/// real or imaginary and is kept for wave numbers along x of 0..length_x/2 only.
class PlaneKernel {
 public:
  /// Buffers of one caller.
  class Work {
   public:
    explicit Work(const core::Grid& grid);

   private:
    friend class PlaneKernel;
    mlmi::RealTransform row_;
    mlmi::ColumnTransform column_;
    mlmi::Buffer half_, real_, block_, transformed_;
    std::vector<Stress> corners_[2];                     // of two neighbouring columns of cells
    std::array<std::vector<double>, components> table_;  // one offset per node: [d_x][d_y]
  };

  /// cost: a kernel of closed forms and a transform of four times the nodes for each load and component.
  /// in: with_shear: whether a shear traction acts too.
  PlaneKernel(const core::Grid& grid, double nu, double z, bool with_shear, Work& work);

  bool has(Load load) const { return spectra_[load][0].size() != 0; }
  /// The row of wave number `row` >= 0 along x. Its element k belongs to wave number k along y: the real or the
  /// imaginary part of the spectrum, whichever is not zero.
  const double* row(Load load, std::size_t component, int row) const {
    return spectra_[load][component].data() + row * row_length_;
  }

 private:
  void fill_table(const core::Grid& grid, Load load, double nu, double z, Work& work) const;
  void transform(const core::Grid& grid, const Padding& padding, Load load, std::size_t component, Work& work);

  std::ptrdiff_t row_length_;
  std::array<mlmi::Buffer, components> spectra_[loads];
};

/// True if the stress below a cell under this load is odd in x.
constexpr bool is_odd_in_x(Load load, std::size_t component) {
  return (load == pressed) == normal_is_odd_in_x(static_cast<int>(component));
}
/// True if its spectrum is imaginary.
constexpr bool is_imaginary(Load load, std::size_t component) {
  return is_odd_in_x(load, component) != is_odd_in_y(static_cast<int>(component));
}

}  // namespace ehl::subsurface
