// The keys of a cycle, and the table that they name.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/record.hpp"
#include "deck/text_table.hpp"
#include "transient/keys.hpp"

namespace ehl::transient {

std::vector<deck::Key> cycle_keys() {
  using namespace deck::record;
  return {
      key("cycle", file, words({"machine"}), otherwise("none"), example("cam.csv"),
          "machine: the course of the cam, the pair of teeth or the stroke that [case] kind names; end_time is then "
          "one "
          "course, in seconds, unless it is given. Or a text file with the columns t, radius_x, load, u1 and u2, of "
          "which all but t may be missing: what is missing "
          "is constant, or has its own key. Linear between the rows. In SI the columns are in m, N (line contacts: "
          "N/m) and m/s, unless the heading names other units; else they are relative to [contact] and [motion]. The "
          "scales a, p_h and u_m of the results remain those of [contact] and [motion].",
          source("modules/transient/README.md")),
      key("cycle_repeats", words({"on", "off"}), by_default("on"), needs("cycle"),
          "on: the last row repeats the first one, and the cycle begins again there. off: the table is run through "
          "once, and its last row remains.",
          source("modules/transient/README.md")),
      key("mode", words({"in_time", "quasi_steady", "both"}), by_default("in_time"), needs("cycle"),
          "in_time: the run in time. quasi_steady: the steady state under the load, radius and speed of each row of "
          "the table by itself, as the rows of the same table of results. both: the run in time, with the "
          "quasi-steady films as columns. Where the speed is 0 there is no steady film, and no number.",
          source("modules/transient/README.md")),
  };
}

namespace {

constexpr double most_periods = 10000.0;  // the table is stored once for each
/// Largest ratio of a radius to that of [contact], whose Hertz radius sets the domain and the cells.
constexpr double widest_range = 1000.0;

/// A column of the table: names, the unit of the heading in SI, and its scale.
struct Quantity {
  const char* name;
  const char* in_SI;
  const char* relative_to;
  double scale;
  Schedule Cycle::*schedule;
};

std::vector<Quantity> quantities(const Scales& scales, bool line) {
  const double u_m = scales.a / scales.time;
  return {{"radius_x", "m", "relative to that of [contact]", scales.radius, &Cycle::radius},
          {"load", line ? "N/m" : "N", "relative to that of [contact]", scales.load, &Cycle::load},
          {"u1", "m/s", "relative to the entrainment speed of [motion]", u_m, &Cycle::u1},
          {"u2", "m/s", "relative to the entrainment speed of [motion]", u_m, &Cycle::u2}};
}

// What is wrong with the times of the rows, or empty.
std::string wrong_times(const std::vector<deck::ColumnRow>& rows) {
  if (rows.size() < 2) return "has fewer than two rows";
  if (rows.front().values[0] != 0.0) return "must begin at t = 0";
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (!(rows[k].values[0] >= rows[k - 1].values[0])) return rows[k].place + ": t falls";
    if (k > 1 && rows[k].values[0] == rows[k - 2].values[0])
      return rows[k].place + ": the same t three times; a jump has two rows";
  }
  return rows.back().values[0] > 0.0 ? "" : "must end at t > 0";
}

// The rows of one column, repeated until the end.
Schedule repeated(const std::vector<deck::ColumnRow>& rows, std::size_t column, double scale, double unit,
                  double periods) {
  const double duration = rows.back().values[0] / unit;
  Schedule schedule{.sampled_over = duration};
  for (double n = 0.0; n < periods; ++n)
    for (const deck::ColumnRow& row : rows) {
      const Schedule::Point point{n * duration + row.values[0] / unit, row.values[column] / scale};
      const bool repeats = n > 0.0 && &row == &rows.front();
      if (!repeats) schedule.points.push_back(point);
    }
  return schedule;
}

// The table of the machine or of the file; nullopt after an error.
std::optional<deck::ColumnTable> read_table(const deck::Part& part, const std::vector<Quantity>& wanted, bool SI,
                                            const deck::ColumnTable* of_machine) {
  const bool seconds = part.word("time_unit") == "seconds";
  if (part.word("cycle") == "machine") {
    if (!seconds) part.complain("time_unit", "must be seconds with cycle = machine");
    if (of_machine == nullptr) return std::nullopt;
    return *of_machine;
  }
  std::vector<deck::Column> columns{
      {{"t", "time", "T"}, seconds ? "s" : "a/u_m", true, seconds ? "" : "or in seconds with time_unit = seconds"}};
  for (const Quantity& one : wanted)
    columns.push_back({{one.name}, SI ? one.in_SI : "-", false, SI ? "" : one.relative_to});
  const deck::ReadColumns read =
      deck::read_columns(deck::found_beside(part.deck, part.section, "cycle"), columns, " ([transient] cycle)");
  if (const auto* wrong = std::get_if<std::string>(&read)) {
    part.complain("cycle", *wrong);
    return std::nullopt;
  }
  return std::get<deck::ColumnTable>(read);
}

}  // namespace

std::optional<Cycle> read_cycle(const deck::Part& part, double unit, const Scales& scales,
                                const deck::ColumnTable* of_machine) {
  if (!part.given("cycle")) return std::nullopt;
  const bool SI = scales.in_SI, known = std::isfinite(scales.a);
  const bool line = deck::word(part.deck, "contact", "kind") == "line";
  const std::vector<Quantity> wanted = quantities(scales, line);
  const std::optional<deck::ColumnTable> read = read_table(part, wanted, SI, of_machine);
  if (!read) return std::nullopt;
  const deck::ColumnTable& table = *read;
  std::string wrong = wrong_times(table.rows);
  if (std::ranges::count(table.present, true) < 2) wrong = "has none of the columns radius_x, load, u1, u2";
  if (!wrong.empty()) {
    part.complain("cycle", wrong);
    return std::nullopt;
  }
  Cycle cycle;
  const bool repeats = part.word("cycle_repeats") != "off";
  const double duration = table.rows.back().values[0] / unit;
  if (repeats) cycle.period = duration;
  const double end = part.number("end_time") / unit;
  const double periods = repeats && std::isfinite(end) ? std::fmax(1.0, std::ceil(end / duration)) : 1.0;
  if (periods > most_periods) {
    part.complain("cycle",
                  fmt::format("end_time is {:.6g} periods, and at most {:g} are possible", periods, most_periods));
    return std::nullopt;
  }
  for (const deck::ColumnRow& row : table.rows) cycle.times.push_back(row.values[0] / unit);
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (!table.present[k + 1]) continue;
    const double first = table.rows.front().values[k + 1], last = table.rows.back().values[k + 1];
    if (repeats && first != last)
      part.complain("cycle", fmt::format("the last row must repeat the first one, but {} is {:g} and {:g}: close the "
                                         "cycle, or set cycle_repeats = off",
                                         wanted[k].name, last, first));
    cycle.*wanted[k].schedule = repeated(table.rows, k + 1, known ? wanted[k].scale : 1.0, unit, periods);
  }
  for (const deck::ColumnRow& row : table.rows) {
    if (!table.present[1]) break;
    const double ratio = row.values[1] / (known ? scales.radius : 1.0);
    if (ratio >= 1.0 / widest_range && ratio <= widest_range) continue;
    part.complain("cycle", fmt::format("{}: radius_x is {:g} times that of [contact]; allowed is {:g} to {:g} times",
                                       row.place, ratio, 1.0 / widest_range, widest_range));
    break;
  }
  return cycle;
}

}  // namespace ehl::transient
