#pragma once
// A line contact is computed on three lines that are alike; a file holds one.
#include <deque>

#include "results/content.hpp"

namespace ehl::results {

/// The content with the one line y = 0 of its fields, which stand in `kept`.
struct OneLine {
  explicit OneLine(const Content& content);
  OneLine(const OneLine&) = delete;
  OneLine& operator=(const OneLine&) = delete;

  std::deque<core::Field> kept{};
  Content content;
};

}  // namespace ehl::results
