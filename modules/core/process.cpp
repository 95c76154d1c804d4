#include "core/process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ehl::core {

namespace {

// A file opened while 0, 1 or 2 is free would get that number and receive the output. Reads and writes there still
// report errors, except for messages, which are lost.
void occupy_standard_descriptors() {
  constexpr int modes[] = {O_WRONLY, O_RDONLY, O_WRONLY};
  for (int number = 0; number < 3; ++number)
    if (::fcntl(number, F_GETFD) < 0 && ::open("/dev/null", modes[number]) < 0) ::_exit(1);
}

}  // namespace

void prepare_process(char** words) {
  occupy_standard_descriptors();
  const bool decided = ::getenv("OMP_WAIT_POLICY") != nullptr || ::getenv("GOMP_SPINCOUNT") != nullptr;
  if (!decided && ::setenv("GOMP_SPINCOUNT", "3000", 1) == 0)
    ::execv("/proc/self/exe", words);  // returns only if it fails; the program is then merely slower
  const char* const slash = ::strrchr(words[0], '/');
  ::prctl(PR_SET_NAME, slash == nullptr ? words[0] : slash + 1);  // it was started as /proc/self/exe
#ifdef __GLIBC__
  constexpr int megabyte = 1 << 20;
  ::mallopt(M_MMAP_THRESHOLD, 32 * megabyte);  // largest value that is accepted
  ::mallopt(M_TRIM_THRESHOLD, 256 * megabyte);
  ::mallopt(M_TOP_PAD, 32 * megabyte);
#endif
}

}  // namespace ehl::core
