#include "page/markup.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace ehl::program {
namespace {

constexpr char replacement[] = "\xEF\xBF\xBD";

// Length of the valid UTF-8 sequence at a position; 0 if there is none.
std::size_t sequence_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U; };
  const unsigned first = byte(at);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(at + k) & 0xC0U) != 0x80U) return 0;
  const bool overlong = (first == 0xE0 && byte(at + 1) < 0xA0) || (first == 0xF0 && byte(at + 1) < 0x90);
  const bool outside = (first == 0xED && byte(at + 1) >= 0xA0) || (first == 0xF4 && byte(at + 1) >= 0x90);
  return overlong || outside ? 0 : length;
}

struct Places {
  std::string below, end_below, above, end_above;
};

std::string indices(const std::string& words, const Places& places) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const bool index = (words[k] == '_' || words[k] == '^') && k + 1 < words.size();
    if (words[k] == '\\' && k + 1 < words.size()) {
      text += escaped(words.substr(++k, 1));
    } else if (index) {
      const bool braced = words[k + 1] == '{';
      const std::size_t from = k + (braced ? 2 : 1);
      const std::size_t to = braced ? std::min(words.find('}', from), words.size())
                                    : from + std::max<std::size_t>(1, sequence_at(words, from));
      const bool is_subscript = words[k] == '_';
      text += (is_subscript ? places.below : places.above) + escaped(words.substr(from, to - from)) +
              (is_subscript ? places.end_below : places.end_above);
      k = braced ? to : to - 1;
    } else {
      const std::size_t length = std::max<std::size_t>(1, sequence_at(words, k));
      text += escaped(words.substr(k, length));
      k += length - 1;
    }
  }
  return text;
}

}  // namespace

std::string escaped(const std::string& text) {
  static const std::map<char, std::string> entities{
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string made;
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t length = sequence_at(text, k);
    const auto byte = static_cast<unsigned char>(text[k]);
    const bool control = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F;
    if (length == 0 || control) {
      made += replacement;
    } else if (const auto entity = entities.find(text[k]); entity != entities.end()) {
      made += entity->second;
    } else {
      made += text.substr(k, length);
    }
    k += std::max<std::size_t>(1, length);
  }
  return made;
}

std::string with_indices(const std::string& words) { return indices(words, {"<sub>", "</sub>", "<sup>", "</sup>"}); }

std::string unit_words(const std::string& unit) {
  static const std::map<std::string, std::string> known{
      {"-", ""}, {"um", "µm"}, {"a^2/R", "a²/R"}, {"C", "°C"}, {"p_h", "p_h"}};
  const auto found = known.find(unit);
  return found == known.end() ? unit : found->second;
}

std::string digits(double value, double error) {
  if (!std::isfinite(value)) return "–";
  if (!(std::abs(error) > 0.0) || !std::isfinite(error) || value == 0.0) return fmt::format("{:.4g}", value);
  // Two digits of the smaller of error and value, but at most twelve digits of the value.
  const double places = 1.0 - std::floor(std::log10(std::min(std::abs(error), std::abs(value))));
  const double most = 12.0 - std::ceil(std::log10(std::abs(value)));
  if (places > most || std::abs(value) >= 1e6 || std::abs(value) < 1e-4) return fmt::format("{:.6g}", value);
  return fmt::format("{:.{}f}", value, static_cast<int>(std::max(0.0, places)));
}

std::string bar_digits(double error) {
  if (!(error > 0.0)) return "0";
  const double places = std::clamp(1.0 - std::floor(std::log10(error)), 0.0, 12.0);
  return error >= 1e-6 && error < 1e6 ? fmt::format("{:.{}f}", error, static_cast<int>(places))
                                      : fmt::format("{:.2g}", error);
}

std::string with_bar(double value, double relative_error, const std::string& unit) {
  if (!std::isfinite(value)) return "–";
  const std::string in_unit = unit_words(unit).empty() ? "" : " " + with_indices(unit_words(unit));
  const double error = std::abs(value * relative_error);
  if (!std::isfinite(error))
    return digits(value, std::nan("")) + in_unit + R"( <span class="none">no error bar</span>)";
  return digits(value, error) + " ± " + bar_digits(error) + in_unit;
}

std::string not_converged_cell(const std::string& number) {
  return R"(<span class="bad">not converged)" + (number.empty() ? "" : ": " + number) + "</span>";
}

std::string HtmlTable::text() const {
  std::string made = R"(<div class="scroll"><table class=")" + style + "\">";
  if (!caption.empty()) made += "<caption>" + caption + "</caption>";
  if (!head.empty()) {
    made += "<thead><tr>";
    for (const std::string& cell : head) made += "<th>" + cell + "</th>";
    made += "</tr></thead>";
  }
  made += "<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    made += "<tr>";
    for (std::size_t k = 0; k < row.size(); ++k) {
      // The last cell of a short row spans the remaining columns.
      const std::size_t wide = k + 1 == row.size() && row.size() < head.size() ? head.size() - k : 1;
      made += (wide > 1 ? fmt::format("<td colspan=\"{}\" class=\"words\">", wide) : "<td>") + row[k] + "</td>";
    }
    made += "</tr>\n";
  }
  return made + "</tbody></table></div>\n";
}

std::string folded(const std::string& summary, const std::string& content) {
  return "<details><summary>" + summary + "</summary>\n" + content + "</details>\n";
}

}  // namespace ehl::program
