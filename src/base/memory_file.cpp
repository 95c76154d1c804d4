#include "base/memory_file.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/errors.hpp"

namespace ehl::program {
namespace {

[[noreturn]] void no_memory() {
  throw core::FileError(std::string("no memory for the text of a process: ") + std::strerror(errno));
}

}  // namespace

MemoryFile::MemoryFile() : descriptor_(::memfd_create("text", 0)) {
  if (descriptor_ < 0) no_memory();
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

void MemoryFile::hold(const std::string& text) const {
  const bool done = ::ftruncate(descriptor_, 0) == 0 &&
                    ::pwrite(descriptor_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
  if (!done) no_memory();
}

std::string MemoryFile::text() const {
  std::string text(static_cast<std::size_t>(::lseek(descriptor_, 0, SEEK_END)), '\0');
  if (::pread(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) no_memory();
  return text;
}

std::string MemoryFile::name() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

}  // namespace ehl::program
