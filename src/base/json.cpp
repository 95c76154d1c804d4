#include "base/json.hpp"

namespace ehl::program {

void add(const std::vector<results::Quantity>& quantities, Json& object) {
  for (const results::Quantity& one : quantities)
    if (one.json != results::not_in_json)
      object[Json::json_pointer("/" + (one.json.empty() ? one.name : one.json))] = json_of(one.value);
}

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace ehl::program
