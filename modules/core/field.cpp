#include "core/field.hpp"

#include <algorithm>

namespace ehl::core {
namespace {
constexpr int doubles_per_line = 8;  // a cache line, and the widest vector
constexpr int nodes_of_line = 3;     // core::line_grid

std::size_t count(int nodes_x, std::ptrdiff_t stride) {
  return static_cast<std::size_t>(nodes_x) * static_cast<std::size_t>(stride);
}
}  // namespace

Field::Field(int nodes_x, int nodes_y)
    : nodes_x_(nodes_x),
      nodes_y_(nodes_y),
      // Two vectors of padding at least: the last batch of lines may read past ny. Of a line contact, which is one
      // batch, one.
      stride_((nodes_y + doubles_per_line - 1) / doubles_per_line * doubles_per_line +
              (nodes_y > nodes_of_line ? 2 : 1) * doubles_per_line),
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

void fill_ghosts(const Patch& patch, Field& f) {
  if (patch.north == Edge::zero) return;
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
