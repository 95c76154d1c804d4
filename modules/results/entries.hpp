#pragma once
// A result as a list of groups, texts and numbers with their paths in the file. The writer makes a file of it, and the
// C interface presents it in memory.
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "results/content.hpp"
#include "results/read.hpp"

namespace ehl::results {

/// One group, text or array of numbers of a result.
struct Entry {
  enum class Kind { group, text, numbers };

  std::string path{};  ///< "/fields/P"
  Kind kind = Kind::group;
  std::string text{};                        ///< for Kind::text
  std::vector<std::size_t> dims{};           ///< for Kind::numbers; empty: a single one
  std::vector<double> values{};              ///< last dimension fastest; empty if the values are in `fields`
  std::vector<const core::Field*> fields{};  ///< row = y, column = x; for three dimensions one field per first index
  int first_line = 0;                        ///< of these fields that belongs to the entry
  bool whole = false;                        ///< integers (counts)
  bool single = false;                       ///< stored in single precision
  std::vector<std::pair<std::string, std::string>> attributes{};  ///< unit, meaning, error; without empty ones
};

/// An attribute; nullptr if the entry has none.
const std::string* attribute(const Entry& entry, const std::string& name);

/// Lines of a grid in a file, where a line contact has one.
inline int lines_of(const core::Grid& grid) { return grid.line ? 1 : grid.nodes_y(); }

/// Values of a field of an entry, row = y, column = x, column fastest.
std::vector<double> row_by_row(const Entry& entry, std::size_t field);
/// A field that was read from a file, as computed: a single line of the file becomes three equal ones.
core::Field field_of(const Array& array);

/// All entries of a result except views, groups before their contents. Unknown numbers have no entry. The entries point
/// to the fields to which the content points.
std::vector<Entry> entries(const Content& content);

}  // namespace ehl::results
