#pragma once
// Reads the JSON that `ehl run --json` prints.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace support {

/// True if the text is exactly one JSON value (RFC 8259).
inline bool is_json(const std::string& text) { return nlohmann::json::accept(text); }

/// The value of a JSON text; null if the text is not JSON.
inline nlohmann::json parsed(const std::string& text) { return nlohmann::json::parse(text, nullptr, false); }

/// The number at a path, "/Hc" or "/friction/mu"; NaN if there is none.
inline double number_at(const nlohmann::json& json, const std::string& path) {
  const nlohmann::json::json_pointer pointer(path);
  return json.contains(pointer) && json[pointer].is_number() ? json[pointer].get<double>() : std::nan("");
}

}  // namespace support
