#include "results/entries.hpp"

#include <cmath>

namespace ehl::results {
namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

struct List {
  std::vector<Entry> made{};

  void add(Entry entry, const Attributes& attributes) {
    for (const auto& one : attributes)
      if (!one.second.empty()) entry.attributes.push_back(one);
    made.push_back(std::move(entry));
  }
  void group(const std::string& path, const std::string& meaning = {}, const Attributes& more = {}) {
    Attributes attributes{{"meaning", meaning}};
    attributes.insert(attributes.end(), more.begin(), more.end());
    add({.path = path}, attributes);
  }
  void text(const std::string& path, const std::string& value, const std::string& meaning) {
    add({.path = path, .kind = Entry::Kind::text, .text = value}, {{"meaning", meaning}});
  }
};

void quantity(List& list, const std::string& group, const Quantity& one) {
  if (one.name.empty()) return;
  const std::string path = group + "/" + one.name;
  if (const auto* words = std::get_if<std::string>(&one.value)) return list.text(path, *words, one.meaning);
  const double value = number(one.value);
  if (!std::isfinite(value)) return;
  list.add({.path = path,
            .kind = Entry::Kind::numbers,
            .values = {value},
            .whole = !std::holds_alternative<double>(one.value)},
           {{"unit", one.unit}, {"meaning", one.meaning}, {"error", one.error}});
}

void quantities(List& list, const std::string& group, const std::vector<Quantity>& of) {
  for (const Quantity& one : of) quantity(list, group, one);
}

void column(List& list, const std::string& group, const Column& one) {
  list.add({.path = group + "/" + one.name,
            .kind = Entry::Kind::numbers,
            .dims = {one.values.size()},
            .values = one.values,
            .whole = one.whole},
           {{"unit", one.unit}, {"meaning", one.meaning}});
}

void axis(List& list, const std::string& path, const std::vector<double>& at, const std::string& meaning) {
  list.add({.path = path, .kind = Entry::Kind::numbers, .dims = {at.size()}, .values = at},
           {{"unit", "a"}, {"meaning", meaning + ", in Hertz radii"}});
}

std::vector<double> stations(const core::Grid& nodes) {
  std::vector<double> x;
  for (int i = 0; i < nodes.nodes_x(); ++i) x.push_back(nodes.X(i));
  return x;
}

void grid(List& list, const std::string& of, const core::Grid& nodes) {
  std::vector<double> y;
  for (int j = 0; j < lines_of(nodes); ++j) y.push_back(nodes.Y(j));
  axis(list, of + "/x", stations(nodes), "X of the nodes, in the rolling direction");
  axis(list, of + "/y", y, "Y of the nodes, across the rolling direction");
}

std::vector<std::size_t> dims_of(const core::Field& field, int lines) {
  return {static_cast<std::size_t>(lines), static_cast<std::size_t>(field.nodes_x())};
}

// A line contact is computed on three equal lines, of which a file has the middle one.
int first_line(const core::Field& field, int lines) { return field.nodes_y() > lines ? 1 : 0; }

void field(List& list, const std::string& of, const NamedField& one, int lines) {
  list.add({.path = of + "/" + one.name,
            .kind = Entry::Kind::numbers,
            .dims = dims_of(*one.field, lines),
            .fields = {one.field},
            .first_line = first_line(*one.field, lines)},
           {{"unit", one.unit}, {"meaning", one.meaning}});
}

void series(List& list, const std::string& of, const Series& one, int lines) {
  if (one.fields.empty()) return;
  std::vector<std::size_t> dims = dims_of(*one.fields[0], lines);
  dims.insert(dims.begin(), one.fields.size());
  list.add({.path = of + "/" + one.name,
            .kind = Entry::Kind::numbers,
            .dims = dims,
            .fields = one.fields,
            .first_line = first_line(*one.fields[0], lines),
            .single = one.single},
           {{"unit", one.unit}, {"meaning", one.meaning}});
}

void frames(List& list, const Frames& of, int lines) {
  if (of.group.empty()) return;
  list.group(of.group);
  column(list, of.group, {"time", "a/u_m", "times of the fields", false, of.times});
  for (const Series& one : of.series) series(list, of.group, one, lines);
}

std::string names_of(const std::vector<Column>& columns) {
  std::string order;
  for (const Column& one : columns) order += (order.empty() ? "" : " ") + one.name;
  return order;
}

void table(List& list, const Table& of) {
  list.group("/" + of.name, of.meaning, {{"columns", names_of(of.columns)}});
  for (const Column& one : of.columns) column(list, "/" + of.name, one);
}

void loose(List& list, const Loose& of) {
  if (of.group.empty()) return;
  list.group(of.group, of.meaning);
  quantities(list, of.group, of.numbers);
  for (const Column& one : of.arrays) column(list, of.group, one);
}

void section(List& list, const core::Grid& along, const Section& of) {
  if (of.group.empty()) return;
  list.group(of.group, of.meaning, {{"columns", names_of(of.columns)}});
  axis(list, of.group + "/x", of.x.empty() ? stations(along) : of.x, "X of the nodes");
  column(list, of.group, of.across);
  for (const Column& one : of.columns) column(list, of.group, one);
  for (const NamedField& one : of.fields) field(list, of.group, one, one.field->nodes_y());
  for (const Series& one : of.series)
    if (!one.fields.empty()) series(list, of.group, one, one.fields[0]->nodes_y());
  quantities(list, of.group, of.numbers);
}

void volume(List& list, const Volume& of) {
  if (of.group.empty()) return;
  list.group(of.group, of.meaning);
  grid(list, of.group, of.grid);
  axis(list, of.group + "/z", of.depths, "depth below the surface");
  for (const Series& one : of.series) series(list, of.group, one, lines_of(of.grid));
  quantities(list, of.group, of.numbers);
  const Column z{"z", "a", "depth below the surface, in Hertz radii", false, of.depths};
  section(list, of.grid, {of.group + "/section", of.section_meaning, z, of.section});
}

void effects(List& list, const std::vector<EffectRow>& rows) {
  if (rows.empty()) return;
  list.group("/effects", "effects that the deck enabled, and the time that each took");
  for (const EffectRow& row : rows)
    list.add({.path = "/effects/" + row.name, .kind = Entry::Kind::numbers, .values = {row.seconds}},
             {{"unit", "s"}, {"meaning", row.what}, {"why", row.why}});
}

}  // namespace

const std::string* attribute(const Entry& entry, const std::string& name) {
  for (const auto& one : entry.attributes)
    if (one.first == name) return &one.second;
  return nullptr;
}

std::vector<double> row_by_row(const Entry& entry, std::size_t field) {
  const core::Field& from = *entry.fields[field];
  const std::size_t rows = entry.dims[entry.dims.size() - 2], columns = entry.dims.back();
  std::vector<double> values(rows * columns);
  for (std::size_t i = 0; i < columns; ++i) {
    const double* station = from.at_x(static_cast<int>(i)) + entry.first_line;
    for (std::size_t j = 0; j < rows; ++j) values[j * columns + i] = station[j];
  }
  return values;
}

core::Field field_of(const Array& array) {
  const std::size_t lines = array.dims[0], length = array.dims[1];
  const int nodes_y = lines == 1 ? 3 : static_cast<int>(lines);
  core::Field field(static_cast<int>(length), nodes_y);
  for (int i = 0; i < field.nodes_x(); ++i)
    for (int j = 0; j < nodes_y; ++j)
      field(i, j) = array.values[(lines == 1 ? 0 : static_cast<std::size_t>(j)) * length + static_cast<std::size_t>(i)];
  return field;
}

std::vector<Entry> entries(const Content& content) {
  List list;
  list.add({.path = "/"}, {{"format", result_format}, {"title", content.title}});
  list.text("/deck", content.deck, "the deck as it was understood; read again, it gives this case");
  list.group("/provenance");
  quantities(list, "/provenance", content.provenance);
  list.group("/scales");
  quantities(list, "/scales", content.scales);
  list.group("/grid");
  grid(list, "/grid", content.grid);
  list.group("/fields");
  for (const NamedField& one : content.fields) field(list, "/fields", one, lines_of(content.grid));
  list.group("/summary");
  quantities(list, "/summary", content.summary);
  for (const Table& one : content.tables) table(list, one);
  frames(list, content.frames, lines_of(content.grid));
  loose(list, content.checkpoint);
  volume(list, content.volume);
  section(list, content.grid, content.section);
  for (const Section& one : content.more_sections) section(list, content.grid, one);
  effects(list, content.effects);
  return std::move(list.made);
}

}  // namespace ehl::results
