#pragma once
// One record for each number of a table. Its name, unit and meaning are declared once; JSON, the result file and the
// CSV tables take them from here.
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "results/content.hpp"

namespace ehl::program {

using results::Value;

/// A column of a table of rows.
template <class Row>
struct Column {
  std::string name{};
  std::string unit{};  ///< "-" for a pure number
  std::string meaning{};
  bool whole = false;  ///< a count, or yes or no
  std::function<Value(const Row&)> get{};
  std::function<void(Row&, const Value&)> set{};  ///< for rows that are read back; empty if derived

  /// in: at: a member of the row, or a function of the row that returns the value or a reference to it
  /// (decltype(auto)).
  template <class At>
  Column(std::string name_, std::string unit_, std::string meaning_, At at)
      : name(std::move(name_)), unit(std::move(unit_)), meaning(std::move(meaning_)) {
    using Result = std::invoke_result_t<At, Row&>;
    using Plain = std::remove_cvref_t<Result>;
    whole = std::is_integral_v<Plain>;
    get = [at](const Row& row) { return Value(std::invoke(at, row)); };
    if constexpr (std::is_lvalue_reference_v<Result> && !std::is_const_v<std::remove_reference_t<Result>>)
      set = [at](Row& row, const Value& value) { std::invoke(at, row) = std::get<Plain>(value); };
  }
};

/// Access to a member of a member: part(&StudyPoint::way, &StudyCase::cells).
template <class Row, class Whole, class Part>
auto part(Whole Row::*whole, Part Whole::*member) {
  return [whole, member](auto& row) -> decltype(auto) { return ((row.*whole).*member); };
}

/// The values of one row.
template <class Row>
std::vector<results::Quantity> quantities_of(const std::vector<Column<Row>>& columns, const Row& row) {
  std::vector<results::Quantity> list;
  for (const Column<Row>& column : columns) list.push_back({column.name, column.get(row), column.unit, column.meaning});
  return list;
}

/// A table of the result file.
template <class Row>
results::Table table_of(const std::string& name, const std::string& meaning, const std::vector<Column<Row>>& columns,
                        const std::vector<Row>& rows) {
  results::Table table{name, meaning, {}};
  for (const Column<Row>& column : columns) {
    results::Column made{column.name, column.unit, column.meaning, column.whole, {}};
    for (const Row& row : rows) made.values.push_back(results::number(column.get(row)));
    table.columns.push_back(std::move(made));
  }
  return table;
}

}  // namespace ehl::program
