#include "core/aligned_array.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <new>

namespace ehl::core {
namespace {
constexpr std::size_t cache_line = 64;
constexpr std::size_t huge_page = std::size_t{1} << 21;
}  // namespace

void ReleaseAligned::operator()(double* p) const { ::operator delete[](p, std::align_val_t{alignment}); }

AlignedArray zeroed_array(std::size_t count) {
  const std::size_t bytes = count * sizeof(double);
  const std::size_t alignment = bytes >= huge_page ? huge_page : cache_line;
  auto* p = static_cast<double*>(::operator new[](bytes, std::align_val_t{alignment}));
#ifdef __linux__
  if (alignment == huge_page) madvise(p, bytes, MADV_HUGEPAGE);  // a wish: refusal costs speed only
#endif
  std::fill_n(p, count, 0.0);
  return {p, ReleaseAligned{alignment}};
}

}  // namespace ehl::core
