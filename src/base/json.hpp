#pragma once
// Records as JSON.
#include <nlohmann/json.hpp>
#include <optional>

#include "base/column.hpp"
#include "base/si_units.hpp"
#include "core/warning.hpp"

namespace ehl::program {

using Json = nlohmann::ordered_json;

/// JSON has no infinity and no NaN: a number that is not finite becomes null.
inline Json json_of(const Value& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

/// One JSON object per row.
template <class Row>
Json rows_json(const std::vector<Column<Row>>& columns, const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) {
    Json& made = list.emplace_back();
    for (const Column<Row>& column : columns) made[column.name] = json_of(column.get(row));
  }
  return list;
}

/// Adds one member to the object for each quantity that has a value.
void add(const std::vector<results::Quantity>& quantities, Json& object);

/// Adds the quantities in SI, "P_max_Pa" in addition to "P_max", if their unit has a scale; adds nothing without
/// scales.
void add_in_SI(const std::vector<results::Quantity>& quantities, const std::optional<SiScales>& scales, Json& object);

/// Appends the warnings to the lists `warnings`, "text [name]", and `warning_names` of the object.
void add_warnings(const core::Warnings& warnings, Json& object);

/// The JSON on one line; bytes that are not UTF-8 become U+FFFD.
std::string line_of(const Json& json);

}  // namespace ehl::program
