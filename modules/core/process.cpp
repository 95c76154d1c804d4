#include "core/process.hpp"

#include <unistd.h>

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ehl::core {

void prepare_process(char** words) {
  const bool decided = ::getenv("OMP_WAIT_POLICY") != nullptr || ::getenv("GOMP_SPINCOUNT") != nullptr;
  if (!decided && ::setenv("GOMP_SPINCOUNT", "3000", 1) == 0)
    ::execv("/proc/self/exe", words);  // comes back only where it is impossible; then it is merely slow
#ifdef __GLIBC__
  constexpr int megabyte = 1 << 20;
  ::mallopt(M_MMAP_THRESHOLD, 32 * megabyte);  // the largest that is heard
  ::mallopt(M_TRIM_THRESHOLD, 256 * megabyte);
  ::mallopt(M_TOP_PAD, 32 * megabyte);
#endif
}

}  // namespace ehl::core
