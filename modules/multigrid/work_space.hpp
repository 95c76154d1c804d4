#pragma once
// The work space of a level, one part for each thread. Its types (thread_work.hpp) are as wide as the vector registers
// of a processor level. Files that are compiled once for all processors see only an incomplete type, since each
// processor level gives it another size and alignment.
#include <cstddef>
#include <memory>
#include <vector>

namespace ehl::multigrid {

struct ThreadWork;

class WorkSpace {
 public:
  WorkSpace();
  /// `threads` copies of `work`.
  WorkSpace(int threads, ThreadWork&& work);
  WorkSpace(WorkSpace&&) noexcept;
  WorkSpace& operator=(WorkSpace&&) noexcept;
  ~WorkSpace();

  ThreadWork& operator[](std::size_t thread);
  ThreadWork& front() { return (*this)[0]; }
  const ThreadWork& front() const;

 private:
  std::unique_ptr<std::vector<ThreadWork>> parts_;
};

}  // namespace ehl::multigrid
