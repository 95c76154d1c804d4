#pragma once
// Records as JSON.
#include <nlohmann/json.hpp>
#include <optional>

#include "base/column.hpp"
#include "base/si_units.hpp"

namespace ehl::program {

using Json = nlohmann::ordered_json;

/// A number that is not finite becomes null, which is how JSON says it.
inline Json json_of(const Value& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

/// An object for each row.
template <class Row>
Json rows_json(const std::vector<Column<Row>>& columns, const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) {
    Json& made = list.emplace_back();
    for (const Column<Row>& column : columns) made[column.name] = json_of(column.get(row));
  }
  return list;
}

/// Sets a member for each quantity that has one.
void add(const std::vector<results::Quantity>& quantities, Json& object);

/// The same in SI, "P_max_Pa" beside "P_max", of those that have a scale; nothing where there are no scales.
void add_in_SI(const std::vector<results::Quantity>& quantities, const std::optional<SiScales>& scales, Json& object);

/// One line; bytes that are no UTF-8 become U+FFFD.
std::string line_of(const Json& json);

}  // namespace ehl::program
