#pragma once
// The owning two-dimensional field: one value per node, aligned for the vector units.
#include <cstddef>
#include <span>

#include "core/aligned_array.hpp"
#include "core/grid.hpp"

namespace ehl::core {

/// One double per node of a grid, zero at birth. Storage runs along y (j) fastest: the line relaxation solves
/// lines of constant Y, many lines j at once, one in each lane of a vector register, so neighbouring lines
/// must be neighbours in memory. Every station i starts on a 64-byte boundary; the padding behind j = ny holds no
/// information, but for the image lines of a mirrored grid.
class Field {
 public:
  Field() = default;
  /// in: nodes_x, nodes_y >= 1 numbers of nodes. errors: std::bad_alloc.
  Field(int nodes_x, int nodes_y);
  explicit Field(const Grid& grid) : Field(grid.nodes_x(), grid.nodes_y()) {}
  Field(const Field& other);
  Field& operator=(const Field& other);
  Field(Field&&) noexcept = default;
  Field& operator=(Field&&) noexcept = default;
  ~Field() = default;

  int nodes_x() const { return nodes_x_; }
  int nodes_y() const { return nodes_y_; }
  /// Doubles from station i to station i+1.
  std::ptrdiff_t stride() const { return stride_; }

  double& operator()(int i, int j) { return data_[i * stride_ + j]; }
  double operator()(int i, int j) const { return data_[i * stride_ + j]; }

  /// The values at X_i for j = 0..ny.
  std::span<double> station(int i) { return {data_.get() + i * stride_, static_cast<std::size_t>(nodes_y_)}; }
  std::span<const double> station(int i) const {
    return {data_.get() + i * stride_, static_cast<std::size_t>(nodes_y_)};
  }
  /// First value at X_i, for inner loops.
  double* at_x(int i) { return data_.get() + i * stride_; }
  const double* at_x(int i) const { return data_.get() + i * stride_; }

  /// Sets every value; does nothing to an empty field.
  void fill(double value);

 private:
  int nodes_x_ = 0;
  int nodes_y_ = 0;
  std::ptrdiff_t stride_ = 0;
  AlignedArray data_;
};

/// to <- from. limits: same shape.
void copy(const Field& from, Field& to);

/// How many lines behind the axis can have an image.
inline constexpr int most_images = 2;
/// The image lines of one station, f_{ny+k} = f_{ny-k}, k = 1, 2; nothing on a grid that is not mirrored.
/// limits: ny >= 2.
inline void make_images(const Grid& grid, double* station) {
  if (!grid.mirrored) return;
  for (int k = 1; k <= most_images; ++k) station[grid.ny + k] = station[grid.ny - k];
}
/// The same of all stations.
void make_images(const Grid& grid, Field& f);

/// half <- the lower half, axis included, of a field on the whole of a mirrored grid; no image lines.
void copy_lower_half(const Field& whole, Field& half);
/// whole <- both halves. in: a field on the mirrored grid.
void copy_whole(const Grid& mirrored, const Field& half, Field& whole);

}  // namespace ehl::core
