#include "core/field.hpp"

#include <algorithm>

namespace ehl::core {
namespace {
constexpr int doubles_per_line = 8;    // a cache line, also the widest vector
constexpr int doubles_per_vector = 4;  // vector of most processors

int rounded_up(int n, int unit) { return (n + unit - 1) / unit * unit; }

// At least two vectors of padding, because the last batch of lines may read past ny.
std::ptrdiff_t padded(int nodes_y) { return rounded_up(nodes_y, doubles_per_line) + 2 * doubles_per_line; }

std::size_t count(int nodes_x, std::ptrdiff_t stride) {
  return static_cast<std::size_t>(nodes_x) * static_cast<std::size_t>(stride);
}

// Without padding a batch reads values of the next columns, and beyond the last column past the end of the field.
std::size_t behind_last_station(std::ptrdiff_t stride) { return stride < doubles_per_line ? 3 * doubles_per_line : 0; }
}  // namespace

Field::Field(int nodes_x, int nodes_y, std::ptrdiff_t stride)
    : nodes_x_(nodes_x),
      nodes_y_(nodes_y),
      stride_(stride),
      data_(zeroed_array(count(nodes_x, stride) + behind_last_station(stride))) {}

Field::Field(int nodes_x, int nodes_y) : Field(nodes_x, nodes_y, padded(nodes_y)) {}

Field::Field(const Patch& patch)
    : Field(patch.nodes_x(), patch.nodes_y(),
            patch.domain.line ? rounded_up(patch.nodes_y(), doubles_per_vector) : padded(patch.nodes_y())) {}

Field::Field(const Field& other) : Field(other.nodes_x_, other.nodes_y_, other.stride_) {
  if (nodes_x_ > 0) copy(other, *this);
}

Field& Field::operator=(const Field& other) {
  if (this == &other) return *this;
  const bool moved_from = !data_;
  if (moved_from || nodes_x_ != other.nodes_x_ || nodes_y_ != other.nodes_y_ || stride_ != other.stride_)
    *this = Field(other.nodes_x_, other.nodes_y_, other.stride_);
  copy(other, *this);
  return *this;
}

void Field::fill(double value) { std::fill_n(data_.get(), count(nodes_x_, stride_), value); }

void copy(const Field& from, Field& to) {
  if (from.nodes_x() == 0) return;
  if (from.stride() == to.stride()) {
    std::copy_n(from.at_x(0), count(from.nodes_x(), from.stride()), to.at_x(0));
    return;
  }
  for (int i = 0; i < from.nodes_x(); ++i) std::ranges::copy(from.station(i), to.at_x(i));
}

void fill_ghosts(const Patch& patch, Field& f) {
  for (int i = 0; i < f.nodes_x(); ++i) fill_ghosts(patch, f.at_x(i));
}

void copy_to_patch(const Patch& patch, const Field& on_domain, Field& on_patch) {
  for (int i = 0; i <= patch.nx; ++i)
    std::copy_n(on_domain.at_x(patch.i0 + i) + patch.j0, patch.nodes_y(), on_patch.at_x(i));
}

Field on_patch(const Patch& patch, const Field& on_domain) {
  Field f(patch);
  copy_to_patch(patch, on_domain, f);
  return f;
}

void copy_to_domain(const Patch& patch, const Field& on_patch, Field& on_domain) {
  for (int i = 0; i <= patch.nx; ++i) {
    const double* from = on_patch.at_x(i);
    double* to = on_domain.at_x(patch.i0 + i) + patch.j0;
    std::copy_n(from, patch.nodes_y(), to);
    if (patch.north == Edge::mirror) std::reverse_copy(from, from + patch.ny, to + patch.nodes_y());
  }
}

Field on_domain(const Patch& patch, const Field& on_patch) {
  Field f(patch.domain);
  copy_to_domain(patch, on_patch, f);
  return f;
}

}  // namespace ehl::core
