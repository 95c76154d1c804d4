#include "report/case_progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace ehl::program {

CaseProgress::CaseProgress(bool quiet, std::size_t cases)
    : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0), cases_(cases) {}

void CaseProgress::show(const std::string& name, const std::string& status) {
  ++done_;
  if (quiet_) return;
  std::fprintf(stderr, "%sehl: %zu/%zu  %s  %s\n", terminal_ ? "\r\x1b[K" : "", done_, cases_, name.c_str(),
               status.c_str());
  if (!terminal_) return;
  constexpr std::size_t width = 30;
  const std::size_t filled = width * done_ / cases_;
  std::fprintf(stderr, "[%s%s] %zu/%zu", std::string(filled, '#').c_str(), std::string(width - filled, '.').c_str(),
               done_, cases_);
  std::fflush(stderr);
}

void CaseProgress::close() const {
  if (!quiet_ && terminal_ && done_ > 0) std::fputs("\r\x1b[K", stderr);
}

}  // namespace ehl::program
