#pragma once
// What `ehl run --json` prints.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace support {

/// Is this text one JSON value (RFC 8259), and nothing else?
inline bool is_json(const std::string& text) { return nlohmann::json::accept(text); }

/// The value of a text; null where it is no JSON.
inline nlohmann::json parsed(const std::string& text) { return nlohmann::json::parse(text, nullptr, false); }

/// A number of it by its path, "/Hc" or "/friction/mu"; NaN where there is none.
inline double number_at(const nlohmann::json& json, const std::string& path) {
  const nlohmann::json::json_pointer pointer(path);
  return json.contains(pointer) && json[pointer].is_number() ? json[pointer].get<double>() : std::nan("");
}

}  // namespace support
