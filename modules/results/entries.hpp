#pragma once
// A result as a list of what stands in its file: groups, texts and numbers, each under its path. The writer makes a
// file of them, the C interface shows them in memory.
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "results/content.hpp"

namespace ehl::results {

struct Entry {
  enum class Kind { group, text, numbers };

  std::string path{};  ///< "/fields/P"
  Kind kind = Kind::group;
  std::string text{};                        ///< of a text
  std::vector<std::size_t> dims{};           ///< of numbers; none: a single one
  std::vector<double> values{};              ///< last dimension fastest; none where they lie in fields
  std::vector<const core::Field*> fields{};  ///< (row = y, column = x); of three dimensions one for each first index
  bool whole = false;                        ///< counts
  bool single = false;                       ///< kept with single precision
  std::vector<std::pair<std::string, std::string>> attributes{};  ///< unit, meaning, error; none is empty
};

/// An attribute; nullptr where the entry has none.
const std::string* attribute(const Entry& entry, const std::string& name);

/// The values of a field, row = y, column = x, the column fastest.
std::vector<double> row_by_row(const core::Field& from);

/// Everything of a result but its views, a group before what it holds. Numbers that are not known have no entry. The
/// entries point to the fields that the content points to.
std::vector<Entry> entries(const Content& content);

}  // namespace ehl::results
