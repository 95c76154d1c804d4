#include "core/aligned_array.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <cstdint>
#include <new>

namespace ehl::core {
namespace {
// Values for x86-64 [bytes]; on other processors they only affect the alignment.
constexpr std::size_t cache_line = 64;
constexpr std::size_t huge_page = std::size_t{1} << 21;

#ifdef __linux__
/// Size from which huge pages are requested.
constexpr std::size_t large = std::size_t{1} << 16;

// Requests huge pages for all pages that the array touches, of which it shares the first and the last with its
// neighbours, and for a next array of the same size before the allocator writes there. A refusal costs only speed.
void wish_for_huge_pages(double* p, std::size_t bytes) {
  const auto address = reinterpret_cast<std::uintptr_t>(p);
  const std::uintptr_t begin = address / huge_page * huge_page;
  const std::uintptr_t end = (address + 2 * bytes + huge_page - 1) / huge_page * huge_page;
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}
#endif
}  // namespace

void ReleaseAligned::operator()(double* p) const { ::operator delete[](p, std::align_val_t{alignment}); }

AlignedArray zeroed_array(std::size_t count) {
  const std::size_t bytes = count * sizeof(double);
  const std::size_t alignment = bytes >= huge_page ? huge_page : cache_line;
  auto* p = static_cast<double*>(::operator new[](bytes, std::align_val_t{alignment}));
#ifdef __linux__
  if (bytes >= large) wish_for_huge_pages(p, bytes);
#endif
  std::fill_n(p, count, 0.0);
  return {p, ReleaseAligned{alignment}};
}

}  // namespace ehl::core
