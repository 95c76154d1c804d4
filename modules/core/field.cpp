#include "core/field.hpp"

#include <algorithm>

namespace ehl::core {
namespace {
constexpr int doubles_per_line = 8;

std::size_t count(int nodes_x, std::ptrdiff_t stride) {
  return static_cast<std::size_t>(nodes_x) * static_cast<std::size_t>(stride);
}
}  // namespace

Field::Field(int nodes_x, int nodes_y)
    : nodes_x_(nodes_x),
      nodes_y_(nodes_y),
      // Two vectors of padding at least: the last batch of lines may read past ny.
      stride_((nodes_y + doubles_per_line - 1) / doubles_per_line * doubles_per_line + 2 * doubles_per_line),
      data_(zeroed_array(count(nodes_x_, stride_))) {}

Field::Field(const Field& other) : Field(other.nodes_x_, other.nodes_y_) { copy(other, *this); }

Field& Field::operator=(const Field& other) {
  if (this == &other) return *this;
  if (nodes_x_ != other.nodes_x_ || nodes_y_ != other.nodes_y_) *this = Field(other.nodes_x_, other.nodes_y_);
  copy(other, *this);
  return *this;
}

void Field::fill(double value) { std::fill_n(data_.get(), count(nodes_x_, stride_), value); }

void copy(const Field& from, Field& to) {
  if (from.nodes_x() == 0) return;
  std::copy_n(from.at_x(0), count(from.nodes_x(), from.stride()), to.at_x(0));
}

void make_images(const Grid& grid, Field& f) {
  if (!grid.mirrored) return;
  for (int i = 0; i < f.nodes_x(); ++i) make_images(grid, f.at_x(i));
}

void copy_lower_half(const Field& whole, Field& half) {
  for (int i = 0; i < half.nodes_x(); ++i) std::copy_n(whole.at_x(i), half.nodes_y(), half.at_x(i));
}

void copy_whole(const Grid& mirrored, const Field& half, Field& whole) {
  for (int i = 0; i < half.nodes_x(); ++i) {
    const double* from = half.at_x(i);
    std::copy_n(from, mirrored.nodes_y(), whole.at_x(i));
    std::reverse_copy(from, from + mirrored.ny, whole.at_x(i) + mirrored.ny + 1);
  }
}

}  // namespace ehl::core
