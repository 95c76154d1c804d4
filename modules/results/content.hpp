#pragma once
// What a result file holds, as plain data: the writer knows no physics, it knows names, units and numbers.
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::results {

/// What the attribute `format` of a result file says.
constexpr char result_format[] = "ehl result";

/// What is known of a case: a number (NaN: not known in this case, and then not written), a count, yes or no, a word.
using Value = std::variant<double, int, bool, std::string>;

/// As a double; NaN for a word.
inline double number(const Value& value) {
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* count = std::get_if<int>(&value)) return *count;
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? 1.0 : 0.0;
  return std::numeric_limits<double>::quiet_NaN();
}

/// One value with its unit and meaning.
struct Quantity {
  std::string name{};  ///< in the file; empty: it is not kept there
  Value value{};
  std::string unit{};  ///< "-" for a pure number
  std::string meaning{};
  std::string json{};   ///< path in a report as JSON, where it is another one: "verification/least_P"
  std::string error{};  ///< name of the quantity beside it that is its estimated error
};
constexpr char not_in_json[] = "-";

struct Column {
  std::string name{};
  std::string unit{};
  std::string meaning{};
  bool whole = false;
  std::vector<double> values{};
};

struct Table {
  std::string name{};
  std::string meaning{};
  std::vector<Column> columns{};  ///< all of the same length
};

/// A field on the nodes of the grid; the pointer is only looked at while writing.
struct NamedField {
  std::string name{};
  std::string unit{};
  std::string meaning{};
  const core::Field* field = nullptr;
};

/// A field at several times or depths.
struct Series {
  std::string name{};
  std::string unit{};
  std::string meaning{};
  std::vector<const core::Field*> fields{};  ///< one for each time; looked at while writing
  bool single = false;                       ///< kept with single precision, seven digits: half the file
};
struct Frames {
  std::string group{};  ///< "/transient/frames", below a table's group; empty: none
  std::vector<double> times{};
  std::vector<Series> series{};
};

/// Fields on a section along x and across it.
struct Section {
  std::string group{};  ///< "/thermal_section"; empty: none
  std::string meaning{};
  Column across{};                   ///< z of the group
  std::vector<NamedField> fields{};  ///< stations of the grid x across
};

/// Fields in space: planes of a grid of their own at several depths, and a section across them.
struct Volume {
  std::string group{};  ///< "/subsurface"; empty: none
  std::string meaning{};
  std::string warnings{};        ///< one a line
  core::Grid grid{};             ///< of the planes: x and y of the group
  std::vector<double> depths{};  ///< z of the group
  std::vector<Series> series{};  ///< one field for each depth
  std::string section_meaning{};
  std::vector<NamedField> section{};  ///< along x and depth, in the group's "section"; as many depths
  std::vector<Quantity> numbers{};
};

/// Numbers and arrays of any lengths in one group.
struct Loose {
  std::string group{};  ///< "/checkpoint"; empty: none
  std::string meaning{};
  std::vector<Quantity> numbers{};
  std::vector<Column> arrays{};
};

/// An effect of the case: its seconds under its name in /effects, the rest as attributes.
struct EffectRow {
  std::string name{};
  double seconds = 0.0;  ///< NaN where it has no clock of its own
  std::string what{};
  std::string why{};  ///< the keys of the deck that called for it
};

struct Content {
  std::string title{};
  std::string deck{};  ///< the effective deck
  std::vector<Quantity> provenance{};
  std::vector<Quantity> scales{};
  core::Grid grid{};
  std::vector<NamedField> fields{};
  std::vector<Quantity> summary{};
  std::vector<Table> tables{};  ///< "levels", "history"
  Frames frames{};
  Loose checkpoint{};
  Volume volume{};
  Section section{};
  std::vector<EffectRow> effects{};  ///< none: no group
};

}  // namespace ehl::results
