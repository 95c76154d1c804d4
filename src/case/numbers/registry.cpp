#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "base/si_units.hpp"
#include "case/effects.hpp"
#include "case/machine_input.hpp"
#include "case/numbers/records.hpp"
#include "deck/document.hpp"

namespace ehl::program::numbers {
namespace {

bool gives(const deck::Deck& deck, const char* section, const char* key) { return deck::given(deck, section, key); }

bool asks_si(const deck::Deck& deck) {
  return gives(deck, "contact", "load") || gives(deck, "contact", "load_per_length");
}
bool asks_line(const deck::Deck& deck) {
  const std::string kind = deck::word(deck, "contact", "kind");
  return kind == "line" || kind == "roller";
}
bool asks_point(const deck::Deck& deck) { return !asks_line(deck); }
bool asks_ellipse(const deck::Deck& deck) {
  return asks_point(deck) && (gives(deck, "contact", "radius_y") || gives(deck, "contact", "radius_ratio"));
}
bool asks_roughness(const deck::Deck& deck) {
  const auto has_map = [&](const char* section) { return deck::word(deck, section, "shape") == "map"; };
  return gives(deck, "contact", "Sq1") || gives(deck, "contact", "Sq2") || has_map("surface1") || has_map("surface2");
}
bool never(const deck::Deck&) { return false; }

bool has_rough(Of s) { return s.computed.outcome.roughness.has_value(); }

const Group& group(const std::string& name) {
  const auto found = std::ranges::find(registry(), name, &Group::name);
  if (found == registry().end()) throw std::logic_error("the registry has no group " + name);
  return *found;
}

bool exists(bool (*on)(Of), const Number& one, Of s) {
  return one.value && (on == nullptr || on(s)) && (!one.only_if || one.only_if(s));
}

const std::string& unit_in(const Number& one, const Case& input) {
  return one.unit.of(one.unit.also_of_rollers ? contact::line(input.physics.groups.shape) : per_length(input));
}

Quantity made(const Group& in, const Number& one, Of s) {
  return {one.in_file ? in.prefix + one.name : "",
          one.value(s),
          unit_in(one, s.input),
          one.meaning_here ? one.meaning_here(s) : one.meaning,
          one.json.empty() ? one.name : one.json,
          one.error};
}

std::vector<Quantity> quantities(const Group& in, Of s) {
  std::vector<Quantity> list;
  for (const Number& one : in.numbers)
    if (exists(in.on, one, s)) list.push_back(made(in, one, s));
  return list;
}

std::string path_in(const Group& in, const std::string& name) { return in.home + "/" + in.prefix + name; }

// Columns of the table of steps.
std::vector<Number> step_numbers() {
  return {number(id::time, "a/u_m", "time reached"),
          number(id::load, "-", "prescribed load over that of the contact", label("load F/F_0")),
          number(id::speed, "-", "entrainment speed (u1 + u2)/2 over u_m", label("entrainment speed over u_m"))};
}

struct Record {
  const Group* group;
  const Number* number;
};

bool has_columns(const Group& in) {
  return std::ranges::any_of(in.numbers, [](const Number& one) { return one.column.place > 0; });
}

const Record& record_of(const std::string& name) {
  static const std::map<std::string, Record> all = [] {
    std::map<std::string, Record> made;
    for (const Group& in : registry())
      for (const Number& one : in.numbers) {
        made.try_emplace(one.name, Record{&in, &one});
        if (one.in_file) made.try_emplace(path_in(in, one.name), Record{&in, &one});
      }
    return made;
  }();
  const auto found = all.find(name);
  if (found == all.end()) throw std::logic_error("the registry has no number " + name);
  return found->second;
}

// "h_c_nm"; a load is in N or in N/m.
std::string name_in_si(const std::string& symbol, const std::string& unit) {
  return symbol + "_" + unit_in_names(unit);
}
const std::string& unit_in_si(const Number& one) { return one.in_si.unit.empty() ? one.unit.name : one.in_si.unit; }
std::string name_in_si(const Number& one) { return name_in_si(one.in_si.symbol, unit_in_si(one)); }

// The value in another unit; the blank where a case has no such number.
std::function<Value(Of)> cell_of(const Group& in, const Number& one, const Conversion& to) {
  return [on = in.on, one, to](Of s) -> Value {
    if (!exists(on, one, s)) return one.column.blank;
    return to.none() ? one.value(s) : Value(to.of(results::number(one.value(s))));
  };
}

void add_columns(const Group& in, bool si, bool line, std::vector<SweepColumn>& columns) {
  for (const Number& one : in.numbers) {
    const std::string& own = one.unit.of(line);
    if (one.column.place > 0 && (si || !one.column.only_si))
      columns.push_back(
          {one.name, own, one.meaning, one.column.place, one.column.blank, in.known, cell_of(in, one, {})});
    if (one.in_si.place == 0 || !si) continue;
    const std::string unit = one.in_si.unit.empty() ? own : one.in_si.unit;
    columns.push_back({name_in_si(one.in_si.symbol, unit), unit, one.meaning, one.in_si.place, core::unknown, in.known,
                       cell_of(in, one, conversion(own, unit))});
  }
}

}  // namespace

const std::vector<Group>& registry() {
  static const std::vector<Group> all = [] {
    std::vector<Group> groups{
        {.name = "film", .numbers = film_numbers()},
        {.name = "course", .numbers = course_numbers(), .known = Known::solved},
        {.name = "verification", .numbers = verification_numbers()},
        {.name = "roughness", .numbers = roughness_numbers(), .on = has_rough, .asked = asks_roughness},
        {.name = "similarity", .numbers = similarity_numbers(), .home = "/scales", .known = Known::before},
        {.name = "scales", .numbers = scale_numbers(), .home = "/scales", .known = Known::before},
        {.name = "grid", .numbers = grid_numbers(), .home = "", .known = Known::before},
        {.name = "formulas of lines", .numbers = line_formulas(), .known = Known::before, .asked = asks_line},
        {.name = "deviations of lines", .numbers = line_deviations(), .asked = asks_line},
        {.name = "formulas of points", .numbers = point_formulas(), .known = Known::before, .asked = asks_point},
        {.name = "deviations of points", .numbers = point_deviations(), .asked = asks_point},
        {.name = "formulas of ellipses", .numbers = ellipse_formulas(), .known = Known::before, .asked = asks_ellipse},
        {.name = "deviations of ellipses", .numbers = ellipse_deviations(), .asked = asks_ellipse},
        {.name = "row", .numbers = row_numbers(), .home = "", .known = Known::before},
        {.name = "timing", .numbers = timing_numbers(), .home = "", .asked = never},
        {.name = "steps", .numbers = step_numbers(), .home = "/transient"}};
    // A number of two effects, as mu of [friction] and [shear], is known by the record that tables show.
    for (const bool in_tables : {true, false})
      for (const Effect& effect : effects())
        if (effect.numbers)
          if (Group group = effect.numbers(); has_columns(group) == in_tables) groups.push_back(std::move(group));
    for (const Effect& effect : effects())
      if (effect.more_numbers)
        for (Group& group : effect.more_numbers()) groups.push_back(std::move(group));
    return groups;
  }();
  return all;
}

std::vector<Quantity> quantities(const std::string& name, Of solved) { return quantities(group(name), solved); }

std::vector<Quantity> scale_quantities(const Case& input) {
  const Computed nothing{};
  const Solved solved{input, nothing};
  std::vector<Quantity> list = quantities("similarity", solved);
  if (input.machine)
    for (Quantity& one : quantities({.name = "machine", .numbers = machine_numbers(*input.machine)}, solved))
      list.push_back(std::move(one));
  for (Quantity& one : quantities("scales", solved)) list.push_back(std::move(one));
  return list;
}

Quantity quantity(const std::string& name, Of solved) {
  const Record& found = record_of(name);
  return made(*found.group, *found.number, solved);
}

Quantity given(const std::string& name, const Value& value) {
  const auto& [in, one] = record_of(name);
  const Number& of = *one;
  return {in->prefix + of.name, value, of.unit.name, of.meaning, of.json, of.error};
}

void append(const std::string& name, Of solved, std::vector<Quantity>& list) {
  for (Quantity& one : quantities(name, solved))
    if (one.name.empty() || std::ranges::find(list, one.name, &Quantity::name) == list.end())
      list.push_back(std::move(one));
}

bool per_length(const Case& input) { return input.scene.grid.line; }

const std::string& unit_of(const std::string& name, const Case& input) { return unit_in(number_of(name), input); }

const Number& number_of(const std::string& name) { return *record_of(name).number; }

std::string path_of(const std::string& name) {
  const Record& found = record_of(name);
  return path_in(*found.group, found.number->name);
}

std::string error_path_of(const std::string& name) {
  const Record& found = record_of(name);
  return found.number->error.empty() ? "" : path_in(*found.group, found.number->error);
}

std::vector<Shown> shown_on_page() {
  std::vector<Shown> list;
  for (const Group& in : registry())
    for (const Number& one : in.numbers)
      if (one.page.place > 0)
        list.push_back({&one, path_in(in, one.name), one.error.empty() ? "" : path_in(in, one.error)});
  std::ranges::stable_sort(list, {}, [](const Shown& one) { return one.number->page.place; });
  return list;
}

std::string symbol_of(const std::string& name) {
  const std::string& label = number_of(name).label;
  std::string symbol = label.substr(label.rfind(' ') + 1);
  std::erase_if(symbol, [](char c) { return c == '{' || c == '}'; });
  return symbol;
}

std::string symbol_in_si(const std::string& name) {
  const char* in_SI = name == id::Hc ? id::hc : name == id::Hm ? id::hm : name == id::P_max ? id::p_max : nullptr;
  return in_SI == nullptr ? "" : symbol_of(in_SI);
}

std::string heading_in_si(const std::string& name) {
  const Number& of = number_of(name);
  return of.in_si.symbol + " [" + unit_in_si(of) + "]";
}

std::string label_in_time(const std::string& name) {
  if (name == id::Hc) return number_of(id::hc).label;
  if (name == id::Hm) return number_of(id::hm).label;
  return number_of(name == id::load ? id::step_load : name == id::speed ? id::step_speed : name).label;
}

std::vector<SweepColumn> columns_of_sweep(deck::Deck deck, bool timing) {
  const std::optional<machines::Contact> machine = machine_input(deck);
  const bool si = asks_si(deck), line = asks_line(deck);
  std::vector<SweepColumn> columns;
  for (const Group& in : registry())
    if (in.asked == nullptr || in.asked(deck) || (timing && in.name == "timing")) add_columns(in, si, line, columns);
  if (machine)
    add_columns({.name = "machine", .numbers = machine_numbers(*machine), .known = Known::before}, si, line, columns);
  std::ranges::stable_sort(columns, {}, &SweepColumn::place);
  std::vector<SweepColumn> list;
  for (SweepColumn& one : columns)  // friction with heat stands in two groups
    if (std::ranges::find(list, one.name, &SweepColumn::name) == list.end()) list.push_back(std::move(one));
  return list;
}

const Number* number_of_column(const std::string& column) {
  static const std::map<std::string, const Number*> all = [] {
    std::map<std::string, const Number*> made;
    for (const Group& in : registry())
      for (const Number& one : in.numbers) {
        if (one.column.place > 0) made.try_emplace(one.name, &one);
        if (one.in_si.place > 0) made.try_emplace(name_in_si(one), &one);
      }
    return made;
  }();
  const auto found = all.find(column);
  return found == all.end() ? nullptr : found->second;
}

BarColumns bar_columns(const std::string& column) {
  const Number* of = number_of_column(column);
  if (of == nullptr || of->error.empty()) return {};
  const bool si = of->in_si.place > 0 && name_in_si(*of) == column;
  return {si ? name_in_si(of->in_si.symbol + "_error", unit_in_si(*of)) : "", of->error};
}

std::string column_in_si(const std::string& name) { return name_in_si(number_of(name)); }

}  // namespace ehl::program::numbers
