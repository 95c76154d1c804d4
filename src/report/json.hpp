#pragma once
// Just enough JSON to print a result.
#include <string>
#include <utility>
#include <vector>

namespace ehl::program::json {

/// A text in quotes, with quotes, backslashes and control characters escaped; bytes that are no UTF-8 become U+FFFD.
std::string text(const std::string& value);
/// The shortest decimal that reads back as the same number; null when it is not finite, which JSON cannot say.
std::string number(double value);
std::string boolean(bool value);
/// in: members with values that are JSON already.
std::string object(const std::vector<std::pair<std::string, std::string>>& members);
std::string array(const std::vector<std::string>& values);

}  // namespace ehl::program::json
