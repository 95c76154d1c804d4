#pragma once
// Work space: an aligned array of doubles, zero at construction, allocated once.
#include <cstddef>

#include "core/aligned_array.hpp"

namespace ehl::mlmi {

/// Owns size doubles on a 64-byte boundary. errors: std::bad_alloc.
class Buffer {
 public:
  Buffer() = default;
  explicit Buffer(std::size_t size) : size_(size), data_(core::zeroed_array(size)) {}
  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(double); }
  double& operator[](std::size_t k) { return data_[k]; }
  double operator[](std::size_t k) const { return data_[k]; }

 private:
  std::size_t size_ = 0;
  core::AlignedArray data_;
};

}  // namespace ehl::mlmi
