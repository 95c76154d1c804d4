#pragma once
// The memory under fields and work space: aligned for the vector units, on huge pages where there is enough of it.
#include <cstddef>
#include <memory>

namespace ehl::core {

/// Gives back what zeroed_array() took.
struct ReleaseAligned {
  std::size_t alignment;
  void operator()(double* p) const;
};
using AlignedArray = std::unique_ptr<double[], ReleaseAligned>;

/// `count` zeros on a 64-byte boundary. Large arrays lie on huge pages (2 MiB) where the system grants them: walking
/// across the stations of a large field touches another page at every step, and the processor remembers only a few
/// thousand. errors: std::bad_alloc.
AlignedArray zeroed_array(std::size_t count);

}  // namespace ehl::core
