#pragma once
// Memory for fields and work space: aligned for the vector units, on huge pages if the array is large enough.
#include <cstddef>
#include <memory>

namespace ehl::core {

/// Releases the memory of zeroed_array().
struct ReleaseAligned {
  std::size_t alignment;
  void operator()(double* p) const;
};
using AlignedArray = std::unique_ptr<double[], ReleaseAligned>;

/// `count` zeros on a 64-byte boundary. Large arrays lie on huge pages (2 MiB) if the system grants them: a loop over
/// the columns of a large field touches another page at every step, and the processor caches few page addresses.
/// errors: std::bad_alloc.
AlignedArray zeroed_array(std::size_t count);

}  // namespace ehl::core
