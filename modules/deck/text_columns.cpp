// Columns of a table, found by the names and units of its heading.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "deck/text.hpp"
#include "deck/text_table.hpp"
#include "deck/units.hpp"

namespace ehl::deck {
namespace {

constexpr std::uintmax_t largest_table = 100'000'000;  // bytes; a million rows
constexpr std::size_t absent = std::numeric_limits<std::size_t>::max();

// Name without letter case, blanks, _, - and dots.
std::string core_of(const std::string& name) {
  std::string core;
  for (const char c : name)
    if (c != ' ' && c != '_' && c != '-' && c != '.')
      core += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return core;
}

std::size_t column_named(const std::string& name, const std::vector<Column>& wanted) {
  const std::string core = core_of(name);
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (std::ranges::any_of(wanted[k].names, [&](const std::string& known) { return core_of(known) == core; }))
      return k;
  return absent;
}

// "p [Pa], eta [Pa s]": the columns that are allowed, for messages.
std::string allowed(const std::vector<Column>& wanted) {
  std::string text;
  for (const Column& column : wanted) {
    text += (text.empty() ? "" : ", ") + column.names[0];
    if (column.unit != "-") text += " [" + column.unit + "]";
    if (!column.meaning.empty()) text += " " + column.meaning;
    if (!column.required) text += " (optional)";
  }
  return text;
}

// Meaning of one cell of the heading: its column, and the conversion of its unit.
struct Place {
  std::size_t column = absent;
  Conversion conversion{};
  std::string wrong{};
};

Place place_of(const std::string& cell, const std::string& unit_below, const std::vector<Column>& wanted) {
  HeadingCell read = heading_cell(cell);
  Place place{.column = column_named(read.name, wanted)};
  if (place.column == absent && read.unit.empty()) {
    // "p_MPa": a unit behind the last underscore.
    const std::size_t at = read.name.rfind('_');
    if (at != std::string::npos && find_unit(read.name.substr(at + 1)) != nullptr) {
      read = {read.name.substr(0, at), read.name.substr(at + 1)};
      place.column = column_named(read.name, wanted);
    }
  }
  if (place.column == absent) {
    place.wrong = fmt::format("the column {} is none of {}: rename it to one of these, or remove it", quoted(cell),
                              allowed(wanted));
    return place;
  }
  if (read.unit.empty()) read.unit = heading_cell("x " + unit_below).unit;
  place.conversion = conversion(read.unit, wanted[place.column].unit);
  if (!place.conversion.wrong.empty()) {
    const std::string& meaning = wanted[place.column].meaning;
    place.wrong =
        "the column " + quoted(cell) + ": " + place.conversion.wrong + (meaning.empty() ? "" : ", " + meaning);
  }
  return place;
}

// Columns by the heading. returns what is wrong, or empty. out: places, the column of each cell.
std::string by_heading(const Row& heading, const Row& units, const std::vector<Column>& wanted,
                       std::vector<Place>& places) {
  std::vector<bool> named(wanted.size());
  for (std::size_t k = 0; k < heading.cells.size(); ++k) {
    const std::string below = k < units.cells.size() ? units.cells[k] : "";
    places.push_back(place_of(heading.cells[k], below, wanted));
    const Place& place = places.back();
    if (!place.wrong.empty()) return heading.place + ": " + place.wrong;
    if (named[place.column]) return heading.place + ": " + quoted(wanted[place.column].names[0]) + " is named twice";
    named[place.column] = true;
  }
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (wanted[k].required && !named[k])
      return fmt::format("{}: the column {} is missing; the columns are {}", heading.place, quoted(wanted[k].names[0]),
                         allowed(wanted));
  return "";
}

// Columns in the order in which they were requested.
std::string by_position(const TextTable& table, const std::vector<Column>& wanted, std::vector<Place>& places) {
  std::size_t least = 0, most = 0;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    ++most;
    if (wanted[k].required) least = most;
  }
  const Row& first = table.rows.front();
  if (first.cells.size() < least || first.cells.size() > most)
    return fmt::format("{}: {} columns; without a heading they must be {}", first.place, first.cells.size(),
                       allowed(wanted));
  for (std::size_t k = 0; k < first.cells.size(); ++k) places.push_back({.column = k});
  return "";
}

std::string read_row(const Row& row, const std::vector<Place>& places, const std::vector<Column>& wanted,
                     ColumnRow& out) {
  if (row.cells.size() != places.size())
    return fmt::format("{}: {} columns instead of {}", row.place, row.cells.size(), places.size());
  out.place = row.place;
  out.values.assign(wanted.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::string& name = wanted[places[k].column].names[0];
    if (row.cells[k].empty()) return fmt::format("{}: {} is missing", row.place, name);
    const ReadNumber read = read_number(row.cells[k]);
    if (read.status != ReadNumber::Status::number)
      return fmt::format("{}: {} = {} is not a number", row.place, name, quoted(row.cells[k]));
    out.values[places[k].column] = places[k].conversion.factor * read.value + places[k].conversion.offset;
  }
  return "";
}

}  // namespace

HeadingCell heading_cell(const std::string& cell) {
  const std::string text = trimmed(cell);
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    if (!text.ends_with(close)) continue;
    // Brackets nest, as in "k [W/(m K)]".
    int depth = 0;
    for (std::size_t k = text.size(); k-- > 0;) {
      depth += text[k] == close ? 1 : text[k] == open ? -1 : 0;
      if (depth == 0) return {trimmed(text.substr(0, k)), trimmed(text.substr(k + 1, text.size() - k - 2))};
    }
  }
  // "p / MPa", "x MPa": a slash or a blank before a known unit.
  for (const char sign : {'/', ' '})
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + 1)) {
      const std::string unit = trimmed(text.substr(at + 1));
      if (at > 0 && find_unit(unit) != nullptr && unit != "1") return {trimmed(text.substr(0, at)), unit};
    }
  return {text, ""};
}

Conversion conversion(const std::string& from, const std::string& to) {
  if (from.empty() || from == to) return {};
  const Unit* unit = find_unit(from);
  if (unit != nullptr && unit->si == to) return {unit->factor, unit->offset, ""};
  std::vector<std::string> names = units_of(to);
  if (names.empty()) names = {to};
  return {
      1.0, 0.0,
      fmt::format("the unit {} must be {}{}", quoted(from), names.size() > 1 ? "one of " : "", joined(names, ", "))};
}

ReadColumns read_columns(const std::string& path, const std::vector<Column>& wanted, const std::string& note) {
  const TextTable table = read_text_table(path, largest_table, note);
  if (table.rows.empty()) return path + ": the table has no row; the columns are " + allowed(wanted);
  std::vector<Place> places;
  std::string wrong;
  if (!table.heading.cells.empty()) {
    wrong = by_heading(table.heading, table.units, wanted, places);
  } else {
    // A comment that names all columns of the rows is their heading.
    const auto names_columns = [&](const Row& remark) {
      return remark.cells.size() == table.rows.front().cells.size() &&
             std::ranges::all_of(remark.cells,
                                 [&](const std::string& cell) { return place_of(cell, "", wanted).column != absent; });
    };
    const auto remark = std::ranges::find_if(table.remarks, names_columns);
    wrong =
        remark != table.remarks.end() ? by_heading(*remark, {}, wanted, places) : by_position(table, wanted, places);
  }
  if (!wrong.empty()) return wrong;
  ColumnTable read{.present = std::vector<bool>(wanted.size())};
  for (const Place& place : places) read.present[place.column] = true;
  for (const Row& row : table.rows) {
    read.rows.emplace_back();
    if (const std::string bad = read_row(row, places, wanted, read.rows.back()); !bad.empty()) return bad;
  }
  return read;
}

}  // namespace ehl::deck
