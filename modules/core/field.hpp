#pragma once
// Two-dimensional field: one value per node, aligned for the vector units.
#include <cstddef>
#include <span>

#include "core/aligned_array.hpp"
#include "core/grid.hpp"

namespace ehl::core {

/// One double per node of a grid, initially zero. j (Y) is the fastest index in storage: the line relaxation solves
/// many lines of constant Y at once, one in each lane of a vector register, so neighbouring lines must be adjacent in
/// memory. Every column (constant i) starts on a 64-byte boundary; of the padding behind j = ny only the ghost lines
/// have meaning.
class Field {
 public:
  Field() = default;
  /// in: numbers of nodes >= 1. errors: std::bad_alloc.
  Field(int nodes_x, int nodes_y);
  /// For a line contact without padding next to its three lines, so that a whole field stays in the nearest caches.
  explicit Field(const Patch& patch);
  Field(const Field& other);
  Field& operator=(const Field& other);
  Field(Field&&) noexcept = default;
  Field& operator=(Field&&) noexcept = default;
  ~Field() = default;

  int nodes_x() const { return nodes_x_; }
  int nodes_y() const { return nodes_y_; }
  /// Doubles from column i to column i+1.
  std::ptrdiff_t stride() const { return stride_; }

  double& operator()(int i, int j) { return data_[i * stride_ + j]; }
  double operator()(int i, int j) const { return data_[i * stride_ + j]; }

  /// Values at X_i for j = 0..ny.
  std::span<double> station(int i) { return {data_.get() + i * stride_, static_cast<std::size_t>(nodes_y_)}; }
  std::span<const double> station(int i) const {
    return {data_.get() + i * stride_, static_cast<std::size_t>(nodes_y_)};
  }
  /// Pointer to the first value at X_i, for inner loops.
  double* at_x(int i) { return data_.get() + i * stride_; }
  const double* at_x(int i) const { return data_.get() + i * stride_; }

  /// Sets all values; does nothing to an empty field.
  void fill(double value);

 private:
  Field(int nodes_x, int nodes_y, std::ptrdiff_t stride);

  int nodes_x_ = 0;
  int nodes_y_ = 0;
  std::ptrdiff_t stride_ = 0;
  AlignedArray data_;
};

/// to <- from. limits: same shape.
void copy(const Field& from, Field& to);

/// Sets the three lines of a line contact in one column, and the padding next to them that every field has: one store.
inline void fill_lines(double* station, double value) {
  constexpr int lines = 4;
  for (int j = 0; j < lines; ++j) station[j] = value;
}

/// f_ij = value(i, j) at all nodes of the patch; for a line contact value(i, 1) on all three lines.
template <class Value>
void set_nodes(const Patch& patch, Field& f, Value value) {
  for (int i = 0; i <= patch.nx; ++i) {
    double* station = f.at_x(i);
    if (patch.domain.line)
      fill_lines(station, value(i, 1));
    else
      for (int j = 0; j <= patch.ny; ++j) station[j] = value(i, j);
  }
}

/// Number of ghost lines behind a mirror.
inline constexpr int ghost_lines = 2;
/// Fills the ghost lines of one column: behind a mirror f_{ny+k} = f_{ny-k}, k = 1, 2; for a line contact the two
/// copies of the line of unknowns. limits: ny >= 2.
inline void fill_ghosts(const Patch& patch, double* station) {
  if (patch.domain.line) return fill_lines(station, station[1]);
  if (patch.north == Edge::zero) return;
  for (int k = 1; k <= ghost_lines; ++k) station[patch.ny + k] = station[patch.ny - k];
}
/// Fills the ghost lines of all columns.
void fill_ghosts(const Patch& patch, Field& f);

/// The part of a field on the domain that lies on the patch; ghost lines are not filled.
Field on_patch(const Patch& patch, const Field& on_domain);
void copy_to_patch(const Patch& patch, const Field& on_domain, Field& on_patch);
/// A field of a patch, extended to its whole domain.
Field on_domain(const Patch& patch, const Field& on_patch);
void copy_to_domain(const Patch& patch, const Field& on_patch, Field& on_domain);

}  // namespace ehl::core
