#pragma once
// A line contact is computed on three equal lines; a file has one.
#include <deque>

#include "results/content.hpp"
#include "results/read.hpp"

namespace ehl::results {

/// Content whose fields have only the line y = 0; `kept` owns these fields.
struct OneLine {
  explicit OneLine(const Content& content);
  OneLine(const OneLine&) = delete;
  OneLine& operator=(const OneLine&) = delete;

  std::deque<core::Field> kept{};
  Content content;
};

/// True if the fields are those of a computation, with copies of their one line.
inline bool has_copies(const Content& content) { return content.grid.line && content.grid.ny > 0; }

/// A field that was read from a file, as computed: a single line of the file becomes three equal ones.
core::Field field_of(const Array& array);

}  // namespace ehl::results
