#include "tables/sweep_range.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text_format.hpp"
#include "core/errors.hpp"
#include "deck/deck.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

constexpr std::size_t most_cases = 1000000;

bool is_number(const deck::Key& key) { return key.type == deck::Type::number || key.type == deck::Type::integer; }

std::vector<std::string> parts_between(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    if (at < text.size() && text[at] != separator) continue;
    parts.push_back(deck::trimmed(text.substr(begin, at - begin)));
    begin = at + 1;
  }
  return parts;
}

// in: "a:b:n" or "a:b:n:log".
std::vector<std::string> values_of_range(const std::string& text, const std::string& said) {
  const std::vector<std::string> parts = parts_between(text, ':');
  const auto refuse_if = [&](bool wrong, const std::string& why) {
    if (wrong) throw core::InputError(said + why);
  };
  refuse_if(parts.size() < 3 || parts.size() > 4, "'" + text + "': a range is a:b:n or a:b:n:log");
  const auto number = [&](const std::string& part) {
    const deck::ReadNumber read = deck::read_number(part);
    refuse_if(read.status != deck::ReadNumber::Status::number,
              "'" + part + "' is no number: a range is a:b:n or a:b:n:log");
    return read.value;
  };
  const double a = number(parts[0]), b = number(parts[1]), n = number(parts[2]);
  const bool logarithmic = parts.size() == 4;
  refuse_if(logarithmic && parts[3] != "log", "'" + parts.back() + "' in '" + text + "': only log may follow a:b:n");
  refuse_if(n != std::floor(n) || n < 2.0 || n > static_cast<double>(most_cases),
            "n = " + parts[2] + " in '" + text + "': must be a whole number >= 2 and <= 1000000");
  refuse_if(logarithmic && (a <= 0.0 || b <= 0.0), "'" + text + "': both ends of a logarithmic range must be > 0");
  refuse_if(a == b, "'" + text + "': the ends of a range must differ");

  std::vector<std::string> values{parts[0]};
  for (double k = 1.0; k + 1.0 < n; ++k) {
    const double t = k / (n - 1.0);
    // Twelve digits: 20 and not 19.999999999999996.
    values.push_back(fmt::format("{:.12g}", logarithmic ? a * std::pow(b / a, t) : a + (b - a) * t));
  }
  values.push_back(parts[1]);
  return values;
}

// What the deck itself would say to this value of this key, alone; empty when it may be right.
std::vector<std::string> complaints(const deck::Assignment& given, const deck::Catalogue& catalogue) {
  const deck::Deck judged = deck::validate({}, {given}, catalogue);
  if (deck::find_key(catalogue, given.section, given.name) == nullptr) return judged.errors;
  // Whether the key has any influence depends on the rest of the case: each case says that for itself.
  if (deck::value(judged, given.section, given.name).valid) return {};
  return judged.errors;
}

void check_values(const Variation& variation, const deck::Catalogue& catalogue, const std::string& said) {
  std::vector<std::string> errors;
  std::set<std::string> seen;
  for (const std::string& value : variation.values) {
    const deck::Assignment given{variation.section, variation.name, value, "command line"};
    for (const std::string& complaint : complaints(given, catalogue)) errors.push_back(complaint);
    if (!seen.insert(value).second) errors.push_back(said + value + " is given twice");
    if (value.find_first_of("\"#") != std::string::npos)
      errors.push_back(said + value + ": a value of a sweep may hold neither \" nor #");
  }
  if (!errors.empty()) throw core::InputError(errors);
}

}  // namespace

Variation parse_variation(const std::string& text, const deck::Catalogue& catalogue) {
  const std::string said = "command line: --vary " + text + ": ";
  const std::size_t equals = text.find('=');
  const std::size_t point = text.find('.');
  if (equals == std::string::npos || point == std::string::npos || point > equals)
    throw core::InputError(said + "write section.key=LIST, e.g. contact.M=20,50 or contact.M=2:2000:4:log");
  Variation variation{
      deck::trimmed(text.substr(0, point)), deck::trimmed(text.substr(point + 1, equals - point - 1)), {}};
  if (variation.section == "output")
    throw core::InputError(said + "a sweep writes one table and no results: leave [output] alone");
  const deck::Key* key = deck::find_key(catalogue, variation.section, variation.name);
  if (key == nullptr)
    throw core::InputError(
        complaints({variation.section, variation.name, text.substr(equals + 1), "command line"}, catalogue));
  for (const std::string& part : parts_between(text.substr(equals + 1), ',')) {
    const bool range = is_number(*key) && part.find(':') != std::string::npos;
    const std::vector<std::string> values = range ? values_of_range(part, said) : std::vector<std::string>{part};
    variation.values.insert(variation.values.end(), values.begin(), values.end());
  }
  check_values(variation, catalogue, said);
  return variation;
}

std::vector<Variation> parse_variations(const std::vector<std::string>& texts, const std::vector<std::string>& set,
                                        const deck::Catalogue& catalogue) {
  std::vector<Variation> variations;
  std::vector<std::string> errors;
  std::set<std::string> keys;
  std::set<std::string> fixed;
  for (const std::string& text : set) {
    const deck::Assignment given = deck::parse_override(text);
    fixed.insert(given.section + "." + given.name);
  }
  double cases = 1.0;
  for (const std::string& text : texts) try {
      variations.push_back(parse_variation(text, catalogue));
      const std::string key = variations.back().section + "." + variations.back().name;
      if (!keys.insert(key).second) errors.push_back("command line: --vary " + key + " is given twice");
      if (fixed.contains(key)) errors.push_back("command line: " + key + " is both varied and set: remove one");
      cases *= static_cast<double>(variations.back().values.size());
    } catch (const core::InputError& error) {
      errors.insert(errors.end(), error.messages().begin(), error.messages().end());
    }
  if (cases > static_cast<double>(most_cases))
    errors.push_back(fmt::format("command line: the --vary make {:.3g} cases: a sweep has at most 1000000", cases));
  if (!errors.empty()) throw core::InputError(errors);
  return variations;
}

std::size_t number_of_cases(const std::vector<Variation>& variations) {
  std::size_t count = 1;
  for (const Variation& variation : variations) count *= variation.values.size();
  return count;
}

std::vector<std::string> values_of_case(const std::vector<Variation>& variations, std::size_t index) {
  std::vector<std::string> values(variations.size());
  for (std::size_t k = variations.size(); k-- > 0;) {
    const std::vector<std::string>& list = variations[k].values;
    values[k] = list[index % list.size()];
    index /= list.size();
  }
  return values;
}

std::vector<std::string> overrides_of_case(const std::vector<Variation>& variations, std::size_t index) {
  std::vector<std::string> overrides = values_of_case(variations, index);
  for (std::size_t k = 0; k < variations.size(); ++k)
    overrides[k] = variations[k].section + "." + variations[k].name + "=" + overrides[k];
  return overrides;
}

}  // namespace ehl::program
