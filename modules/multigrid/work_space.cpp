#include "multigrid/work_space.hpp"

#include <utility>

#include "multigrid/thread_work.hpp"

namespace ehl::multigrid {

WorkSpace::WorkSpace() = default;

WorkSpace::WorkSpace(int threads, ThreadWork&& work)
    : parts_(std::make_unique<std::vector<ThreadWork>>(static_cast<std::size_t>(threads - 1), work)) {
  parts_->push_back(std::move(work));
}

WorkSpace::WorkSpace(WorkSpace&&) noexcept = default;
WorkSpace& WorkSpace::operator=(WorkSpace&&) noexcept = default;
WorkSpace::~WorkSpace() = default;

ThreadWork& WorkSpace::operator[](std::size_t thread) { return (*parts_)[thread]; }
const ThreadWork& WorkSpace::front() const { return parts_->front(); }

}  // namespace ehl::multigrid
