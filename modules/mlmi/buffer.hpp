#pragma once
// Work space: an aligned array of doubles, zero at birth, allocated once.
#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

namespace ehl::mlmi {

/// Owns size doubles on a 64-byte boundary. errors: std::bad_alloc.
class Buffer {
 public:
  Buffer() = default;
  explicit Buffer(std::size_t size)
      : size_(size), data_(static_cast<double*>(::operator new[](size * sizeof(double), alignment))) {
    std::fill_n(data_.get(), size_, 0.0);
  }
  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(double); }
  double& operator[](std::size_t k) { return data_[k]; }
  double operator[](std::size_t k) const { return data_[k]; }

 private:
  static constexpr std::align_val_t alignment{64};
  struct Release {
    void operator()(double* p) const { ::operator delete[](p, alignment); }
  };
  std::size_t size_ = 0;
  std::unique_ptr<double[], Release> data_;
};

}  // namespace ehl::mlmi
