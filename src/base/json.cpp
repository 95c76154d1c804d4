#include "base/json.hpp"

#include <algorithm>
#include <utility>

namespace ehl::program {

namespace {

std::string path_of(const results::Quantity& one) { return "/" + (one.json.empty() ? one.name : one.json); }

}  // namespace

void add(const std::vector<results::Quantity>& quantities, Json& object) {
  for (const results::Quantity& one : quantities)
    if (one.json != results::not_in_json) object[Json::json_pointer(path_of(one))] = json_of(one.value);
}

void add_in_SI(const std::vector<results::Quantity>& quantities, const std::optional<SiScales>& scales, Json& object) {
  if (!scales) return;
  const std::vector<results::InSi> units = plain_units(*scales);
  for (const results::Quantity& one : quantities)
    if (const auto to = std::ranges::find(units, one.unit, &results::InSi::unit);
        to != units.end() && one.json != results::not_in_json)
      object[Json::json_pointer(path_of(one) + "_" + to->name)] = results::number(one.value) * to->factor;
}

void add_warnings(const core::Warnings& warnings, Json& object) {
  for (const char* list : {"warnings", "warning_names"})
    if (!object.contains(list)) object[list] = Json::array();
  for (const core::Warning& warning : warnings) {
    object["warnings"].push_back(with_name(warning));
    object["warning_names"].push_back(warning.name);
  }
}

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace ehl::program
