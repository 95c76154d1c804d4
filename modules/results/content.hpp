#pragma once
// Contents of a result file as plain data: the writer knows no physics, only names, units and numbers.
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::results {

/// Attribute `format` of a result file.
constexpr char result_format[] = "ehl result";

/// Value of a quantity: a number (NaN: not known, and not written), a count, yes or no, or a word.
using Value = std::variant<double, int, bool, std::string>;

/// The value as a double; NaN for a word.
inline double number(const Value& value) {
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* count = std::get_if<int>(&value)) return *count;
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? 1.0 : 0.0;
  return std::numeric_limits<double>::quiet_NaN();
}

/// A value with unit and meaning.
struct Quantity {
  std::string name{};  ///< in the file; empty: not stored there
  Value value{};
  std::string unit{};  ///< "-" for a pure number
  std::string meaning{};
  std::string json{};   ///< path in the JSON report if it differs: "verification/least_P"
  std::string error{};  ///< name of another quantity, which is its estimated error
};
constexpr char not_in_json[] = "-";

/// One column of a table, or an array, with unit and meaning.
struct Column {
  std::string name{};
  std::string unit{};
  std::string meaning{};
  bool whole = false;
  std::vector<double> values{};
};

/// A table, one group of the file.
struct Table {
  std::string name{};
  std::string meaning{};
  std::vector<Column> columns{};  ///< all of equal length
};

/// A field at the nodes of the grid; the pointer is used only while writing.
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
  std::vector<const core::Field*> fields{};  ///< one per time; used only while writing
  bool single = false;                       ///< stored in single precision, half the size
};
/// Fields at several times.
struct Frames {
  std::string group{};  ///< "/transient/frames", inside the group of a table; empty: none
  std::vector<double> times{};
  std::vector<Series> series{};
};

/// Fields on a section along x and across the film or in depth.
struct Section {
  std::string group{};  ///< "/thermal_section"; empty: none
  std::string meaning{};
  Column across{};                   ///< z of the group
  std::vector<NamedField> fields{};  ///< nodes along x by nodes across
  std::vector<double> x{};           ///< of the nodes; empty: of the grid of the contact
  std::vector<Column> columns{};     ///< a table beside the fields, whose first column is the time of `series`
  std::vector<Series> series{};      ///< the section at several times
  std::vector<Quantity> numbers{};
};

/// Fields in space: planes at several depths on their own grid, and a section across them.
struct Volume {
  std::string group{};  ///< "/subsurface"; empty: none
  std::string meaning{};
  core::Grid grid{};             ///< of the planes: x and y of the group
  std::vector<double> depths{};  ///< z of the group
  std::vector<Series> series{};  ///< one field per depth
  std::string section_meaning{};
  std::vector<NamedField> section{};  ///< along x and depth, in the group "section"; same depths
  std::vector<Quantity> numbers{};
};

/// Numbers and arrays of any length in one group.
struct Loose {
  std::string group{};  ///< "/checkpoint"; empty: none
  std::string meaning{};
  std::vector<Quantity> numbers{};
  std::vector<Column> arrays{};
};

/// An effect of the case: its seconds under its name in /effects, the rest as attributes.
struct EffectRow {
  std::string name{};
  double seconds = 0.0;  ///< NaN if its time is not measured separately
  std::string what{};
  std::string why{};  ///< keys of the deck that enabled it
};

/// A unit of the contact, "a^2/R", and its SI unit, "m".
struct InSi {
  std::string unit{};
  std::string name{};
  double factor = 1.0;  ///< from the former to the latter
};

/// All contents of a result file.
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
  std::vector<Section> more_sections{};
  std::vector<EffectRow> effects{};  ///< empty: no group
  std::vector<InSi> si{};            ///< units in which the XDMF file is written; empty: those of the contact
};

}  // namespace ehl::results
