#pragma once
// A line contact is computed on three equal lines; a file has one.
#include <deque>

#include "results/content.hpp"

namespace ehl::results {

/// Content whose fields have only the line y = 0; `kept` owns these fields.
struct OneLine {
  explicit OneLine(const Content& content);
  OneLine(const OneLine&) = delete;
  OneLine& operator=(const OneLine&) = delete;

  std::deque<core::Field> kept{};
  Content content;
};

}  // namespace ehl::results
