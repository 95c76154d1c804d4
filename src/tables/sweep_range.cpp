#include "tables/sweep_range.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "base/text_format.hpp"
#include "core/errors.hpp"
#include "deck/deck.hpp"
#include "deck/file.hpp"
#include "deck/text.hpp"
#include "deck/text_table.hpp"
#include "tables/csv.hpp"
#include "tables/range_values.hpp"

namespace ehl::program {
namespace {

const std::string command_line = "command line";

bool is_number(const deck::Key& key) { return key.type == deck::Type::number || key.type == deck::Type::integer; }

// The errors that the deck reports for this value of this key alone; empty if the value may be right.
std::vector<std::string> complaints(const deck::Assignment& given, const deck::Catalogue& catalogue) {
  // A number within the range of its key is right. Reading the deck for each of many values would take too long.
  if (const deck::Key* key = deck::find_key(catalogue, given.section, given.name);
      key && key->type == deck::Type::number) {
    const deck::ReadNumber read = deck::read_number(given.value);
    if (read.status == deck::ReadNumber::Status::number && key->range.contains(read.value)) return {};
  }
  const deck::Deck judged = deck::validate({}, {given}, catalogue);
  if (deck::find_key(catalogue, given.section, given.name) == nullptr) return judged.errors;
  // Whether a key is used depends on the rest of the case; each case checks this itself.
  if (deck::value(judged, given.section, given.name).valid) return {};
  return judged.errors;
}

void check_values(const Variation& variation, const deck::Catalogue& catalogue, const std::string& said,
                  const std::string& place) {
  std::vector<std::string> errors;
  std::set<std::vector<std::string>> seen;
  std::set<std::pair<std::string, std::string>> judged;
  for (const std::vector<std::string>& values : variation.values) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto& [section, name] = variation.keys[k];
      if (!judged.insert({name_of(variation.keys[k]), values[k]}).second) continue;
      for (const std::string& complaint : complaints({section, name, values[k], place}, catalogue))
        errors.push_back(complaint);
      if (values[k].find_first_of("\"#") != std::string::npos)
        errors.push_back(said + values[k] + ": a value of a sweep must contain neither \" nor #");
    }
    if (!seen.insert(values).second) errors.push_back(said + deck::joined(values, ":") + " is given twice");
  }
  if (!errors.empty()) throw core::InputError(errors);
}

// in: text: "section.key"; given: value and place for the message about an unknown key.
Variation::Key key_of(const std::string& text, const deck::Assignment& given, const std::string& said,
                      const deck::Catalogue& catalogue) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos)
    throw core::InputError(said + "write section.key=LIST, e.g. contact.M=20,50 or contact.M=2:2000:4:log");
  Variation::Key key{deck::trimmed(text.substr(0, point)), deck::trimmed(text.substr(point + 1))};
  if (key.section == "output")
    throw core::InputError(said + "a sweep writes one table and no result files: remove [output]");
  if (deck::find_key(catalogue, key.section, key.name) == nullptr)
    throw core::InputError(complaints({key.section, key.name, given.value, given.place}, catalogue));
  return key;
}

// The values of one case, for keys that vary together.
std::vector<std::string> values_together(const std::string& text, std::size_t keys, const std::string& said) {
  const std::vector<std::string> values = parts_between(text, ':');
  if (values.size() != keys)
    throw core::InputError(said +
                           fmt::format("'{}' has {} values for {} keys: write a,b=1:2,3:4", text, values.size(), keys));
  return values;
}

// The number of values of a --vary, without creating them; 1 if the text will be refused later.
double count_of_values(const std::string& text, const deck::Catalogue& catalogue) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return 1.0;
  const std::string name = deck::trimmed(text.substr(0, equals));
  const std::size_t point = std::min(name.find('.'), name.size());
  const deck::Key* key =
      deck::find_key(catalogue, name.substr(0, point), name.substr(std::min(point + 1, name.size())));
  double count = 0.0;
  for (const std::string& part : parts_between(text.substr(equals + 1), ',')) {
    const std::vector<std::string> range = parts_between(part, ':');
    const bool is_range = key != nullptr && is_number(*key) && range.size() > 2;
    const deck::ReadNumber n = deck::read_number(is_range ? range[2] : "1");
    count += n.status == deck::ReadNumber::Status::number && n.value > 1.0 ? n.value : 1.0;
  }
  return count;
}

// Checks the number of cases before they are created.
void refuse_too_many(const std::vector<std::string>& texts, const deck::Catalogue& catalogue) {
  double cases = 1.0;
  std::string factors;
  for (const std::string& text : texts) {
    const double count = count_of_values(text, catalogue);
    cases *= count;
    factors += fmt::format("{}{:.10g}", factors.empty() ? "" : " x ", count);
  }
  if (cases > most_cases_of_sweep)
    throw core::InputError(fmt::format("command line: --vary gives {}{:.10g} cases: a sweep has at most {}",
                                       texts.size() > 1 ? factors + " = " : std::string(), cases,
                                       static_cast<std::size_t>(most_cases_of_sweep)));
}

}  // namespace

std::string name_of(const Variation::Key& key) { return key.section + "." + key.name; }

Variation parse_variation(const std::string& text, const deck::Catalogue& catalogue) {
  const std::string said = "command line: --vary " + text + ": ";
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw core::InputError(said + "write section.key=LIST, e.g. contact.M=20,50 or contact.M=2:2000:4:log");
  Variation variation;
  for (const std::string& name : parts_between(text.substr(0, equals), ','))
    variation.keys.push_back(key_of(name, {"", "", text.substr(equals + 1), command_line}, said, catalogue));
  const Variation::Key& first = variation.keys[0];
  const bool number = is_number(*deck::find_key(catalogue, first.section, first.name));
  for (const std::string& part : parts_between(text.substr(equals + 1), ',')) {
    if (variation.keys.size() > 1) {
      variation.values.push_back(values_together(part, variation.keys.size(), said));
    } else if (number && part.find(':') != std::string::npos) {
      for (const std::string& value : values_of_range(part, said)) variation.values.push_back({value});
    } else {
      variation.values.push_back({part});
    }
  }
  check_values(variation, catalogue, said, command_line);
  return variation;
}

namespace {

// A value of a column with a unit in its heading, converted to the unit of the key.
std::string in_unit_of_key(const std::string& cell, const deck::Conversion& conversion) {
  const deck::ReadNumber read = deck::read_number(cell);
  const bool plain = conversion.factor == 1.0 && conversion.offset == 0.0;
  if (plain || read.status != deck::ReadNumber::Status::number) return cell;
  return fmt::format("{:.15g}", conversion.factor * read.value + conversion.offset);
}

// What is wrong with a heading that is no key.
std::string no_key(const std::string& name, const deck::Catalogue& catalogue) {
  std::vector<std::string> names;
  for (const deck::Key& key : catalogue.keys) names.push_back(key.section + "." + key.name);
  const std::string near = deck::nearest("." + name, names);
  return "a column is named by its key, section.key" +
         (near.empty() ? ", as contact.M" : ": did you mean " + near + "?");
}

// The keys in a heading, and the conversion of the values below them.
std::vector<deck::Conversion> read_heading(const deck::TextTable& table, const deck::Catalogue& catalogue,
                                           Variation& variation) {
  std::vector<deck::Conversion> conversions;
  std::vector<std::string> errors;
  for (std::size_t k = 0; k < table.heading.cells.size(); ++k) try {
      deck::HeadingCell cell = deck::heading_cell(table.heading.cells[k]);
      if (cell.name.empty()) cell = {table.heading.cells[k], ""};
      const std::string said = table.heading.place + ": " + cell.name + ": ";
      if (cell.name.find('.') == std::string::npos) throw core::InputError(said + no_key(cell.name, catalogue));
      const Variation::Key key = key_of(cell.name, {"", "", "...", table.heading.place}, said, catalogue);
      const deck::Key& record = *deck::find_key(catalogue, key.section, key.name);
      const std::string below = k < table.units.cells.size() ? table.units.cells[k] : "";
      const std::string unit = cell.unit.empty() ? deck::heading_cell("x " + below).unit : cell.unit;
      conversions.push_back(deck::conversion(unit, record.unit.empty() ? "-" : record.unit));
      if (!conversions.back().wrong.empty()) throw core::InputError(said + conversions.back().wrong);
      const auto same = [&](const Variation::Key& one) { return name_of(one) == name_of(key); };
      if (std::ranges::any_of(variation.keys, same)) throw core::InputError(said + "stands twice in the heading");
      variation.keys.push_back(key);
    } catch (const core::InputError& error) {
      errors.insert(errors.end(), error.messages().begin(), error.messages().end());
    }
  if (!errors.empty()) throw core::InputError(errors);
  return conversions;
}

}  // namespace

Variation read_cases(const std::string& path, const deck::Catalogue& catalogue) {
  constexpr std::uintmax_t largest = 1'000'000'000;  // bytes
  const deck::TextTable table = deck::read_text_table(path, largest);
  if (table.heading.cells.empty() || table.rows.empty())
    throw core::InputError(
        path +
        ": has no cases: write one line of keys, section.key separated by commas, and one line of values per case");
  Variation variation;
  const std::vector<deck::Conversion> conversions = read_heading(table, catalogue, variation);
  for (const deck::Row& row : table.rows) {
    if (row.cells.size() != conversions.size())
      throw core::InputError(
          fmt::format("{}: {} values for {} columns", row.place, row.cells.size(), conversions.size()));
    variation.values.emplace_back();
    for (std::size_t k = 0; k < conversions.size(); ++k)
      variation.values.back().push_back(in_unit_of_key(row.cells[k], conversions[k]));
  }
  check_values(variation, catalogue, path + ": ", path);
  variation.file = path + ": " + size_and_hash(deck::content_of(path, largest));
  return variation;
}

std::vector<Variation> parse_variations(const std::vector<std::string>& texts, const std::vector<std::string>& set,
                                        const deck::Catalogue& catalogue, const std::string& cases) {
  refuse_too_many(texts, catalogue);
  std::vector<Variation> variations;
  std::vector<std::string> errors;
  std::set<std::string> keys;
  std::set<std::string> fixed;
  for (const std::string& text : set) {
    const deck::Assignment given = deck::parse_override(text);
    fixed.insert(given.section + "." + given.name);
  }
  double count = 1.0;
  const auto take = [&](const Variation& variation) {
    for (const Variation::Key& one : variation.keys) {
      const std::string key = name_of(one);
      if (!keys.insert(key).second) errors.push_back("command line: " + key + " is varied twice");
      if (fixed.contains(key)) errors.push_back("command line: " + key + " is both varied and set: remove one of them");
    }
    count *= static_cast<double>(variation.values.size());
    variations.push_back(variation);
  };
  const auto add = [&](const std::function<Variation()>& read) {
    try {
      take(read());
    } catch (const core::InputError& error) {
      errors.insert(errors.end(), error.messages().begin(), error.messages().end());
    }
  };
  if (!cases.empty()) add([&] { return read_cases(cases, catalogue); });
  for (const std::string& text : texts) add([&] { return parse_variation(text, catalogue); });
  if (count > most_cases_of_sweep)
    errors.push_back(fmt::format("command line: {:.3g} cases: a sweep has at most 1000000", count));
  if (!errors.empty()) throw core::InputError(errors);
  return variations;
}

std::size_t number_of_cases(const std::vector<Variation>& variations) {
  std::size_t count = 1;
  for (const Variation& variation : variations) count *= variation.values.size();
  return count;
}

std::vector<std::string> varied_keys(const std::vector<Variation>& variations) {
  std::vector<std::string> keys;
  for (const Variation& variation : variations)
    for (const Variation::Key& key : variation.keys) keys.push_back(name_of(key));
  return keys;
}

std::vector<std::string> values_of_case(const std::vector<Variation>& variations, std::size_t index) {
  std::vector<std::string> values;
  for (std::size_t k = variations.size(); k-- > 0;) {
    const auto& list = variations[k].values;
    const std::vector<std::string>& own = list[index % list.size()];
    values.insert(values.begin(), own.begin(), own.end());
    index /= list.size();
  }
  return values;
}

std::vector<std::string> overrides_of_case(const std::vector<Variation>& variations, std::size_t index) {
  std::vector<std::string> overrides = values_of_case(variations, index);
  const std::vector<std::string> keys = varied_keys(variations);
  for (std::size_t k = 0; k < keys.size(); ++k) overrides[k] = keys[k] + "=" + overrides[k];
  return overrides;
}

}  // namespace ehl::program
