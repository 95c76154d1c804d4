// Writes a run in time to a result file, and reads it back.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "case/effects.hpp"
#include "case/numbers/number.hpp"
#include "case/transient_input.hpp"
#include "case/transient_run.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "results/entries.hpp"

namespace ehl::program {
namespace {

using transient::StepRow;

/// The optional columns of the rows.
struct RowKind {
  bool body = false;    ///< a body moves
  bool oil = false;     ///< oil mass is conserved
  bool line = false;    ///< for a line contact the oil is counted per length
  bool newton = false;  ///< Newton steps are counted separately; files of earlier versions lack this
  bool radius = false;  ///< R_x varies
  bool quasi = false;   ///< quasi-steady films beside the run in time
  bool errors = false;  ///< error bars
};

using Error = std::pair<const char*, double StepRow::*>;
constexpr Error error_columns[] = {{id::error_Hc, &StepRow::error_Hc},
                                   {id::error_Hm, &StepRow::error_Hm},
                                   {id::error_P_max, &StepRow::error_P_max},
                                   {id::error_mu, &StepRow::error_mu}};
/// Unknown where there is no steady state.
constexpr const char* quasi_columns[] = {"Hc_quasi_steady", "Hm_quasi_steady", "P_max_quasi_steady"};

// The columns of /transient, in order. in: the probes; the numbers that effects add.
std::vector<Column<StepRow>> step_columns(const RowKind& kind, const std::vector<transient::Place>& probes,
                                          const std::vector<std::string>& added) {
  using numbers::column;
  std::vector<Column<StepRow>> columns{column<StepRow>(id::step_time, &StepRow::T),
                                       column<StepRow>(id::Hc, &StepRow::Hc),
                                       column<StepRow>(id::Hm, &StepRow::Hm),
                                       column<StepRow>(id::Hm_x, &StepRow::Hm_X),
                                       column<StepRow>(id::Hm_y, &StepRow::Hm_Y),
                                       column<StepRow>(id::P_max, &StepRow::P_max),
                                       column<StepRow>(id::H00, &StepRow::H00),
                                       column<StepRow>(id::step_load, &StepRow::load),
                                       column<StepRow>(id::step_speed, &StepRow::speed),
                                       column<StepRow>(id::load_error, &StepRow::load_error)};
  if (kind.radius) columns.push_back({"radius_x", "-", "R_x over that of the contact", &StepRow::radius});
  if (kind.quasi) {
    columns.push_back({quasi_columns[0], "a^2/R", "central film of the steady state at this time", &StepRow::Hc_quasi});
    columns.push_back({quasi_columns[1], "a^2/R", "minimum film of the steady state at this time", &StepRow::Hm_quasi});
    columns.push_back(
        {quasi_columns[2], "p_h", "highest pressure of the steady state at this time", &StepRow::P_max_quasi});
  }
  for (const auto& [name, error] : error_columns)
    if (kind.errors && (error != &StepRow::error_mu || std::ranges::count(added, id::mu) > 0))
      columns.push_back({name, "-", "estimated relative error of mesh and time steps", error});
  if (kind.body) {
    columns.push_back({"velocity", "a u_m/R", "velocity of the body", &StepRow::velocity});
    columns.push_back({"carried", "-", "load that the film carries, over that of the contact", &StepRow::carried});
  }
  if (kind.oil) {
    const auto of_oil = [](double transient::OilInTime::*what) { return part(&StepRow::oil, what); };
    const std::string amount = kind.line ? "rho0 a^3/R" : "rho0 a^4/R";
    const std::string flow = numbers::number_of(id::oil_in).unit.of(kind.line);
    columns.push_back({"oil", amount, "oil between the bodies", of_oil(&transient::OilInTime::stored)});
    columns.push_back({id::oil_in, flow, "oil through the inlet boundary", of_oil(&transient::OilInTime::in)});
    columns.push_back({"oil_out", flow, "oil through the outlet boundary", of_oil(&transient::OilInTime::out)});
    columns.push_back(
        {id::oil_aside, flow, "oil through the sides of the domain", of_oil(&transient::OilInTime::aside)});
    columns.push_back({"oil_from_nowhere", "-",
                       "oil mass error of the step over the inflow of the steady film in a/u_m",
                       of_oil(&transient::OilInTime::from_nowhere)});
    columns.push_back({"oil_lost", "-", "oil mass error since the start over the inflow of the steady film in a/u_m",
                       of_oil(&transient::OilInTime::lost)});
  }
  columns.push_back({"step", "a/u_m", "length of the step; 0 for the start", &StepRow::length});
  columns.push_back({"order", "-", "order of the time integration", &StepRow::order});
  columns.push_back({id::cycles, "-", "cycles of all attempts at the step", &StepRow::cycles});
  if (kind.newton) columns.push_back({"newton_steps", "-", "Newton steps of all attempts", &StepRow::newton_steps});
  columns.push_back({"rejected", "-", "attempts that failed the error test", &StepRow::rejected});
  columns.push_back({"not_solved", "-", "attempts that were not solved", &StepRow::not_solved});
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    const auto probed = [k](double transient::Probed::*what) {
      return [k, what](auto& row) -> decltype(auto) { return (row.probed[k].*what); };
    };
    columns.push_back({"P_" + number, "p_h", name_of_probe("pressure", probes[k]), probed(&transient::Probed::P)});
    columns.push_back({"H_" + number, "a^2/R", name_of_probe("film", probes[k]), probed(&transient::Probed::H)});
  }
  for (std::size_t k = 0; k < added.size(); ++k) {
    const numbers::Number& number = numbers::number_of(added[k]);
    columns.push_back({number.name, number.unit.of(kind.line), number.meaning,
                       [k](auto& row) -> decltype(auto) { return (row.measured[k]); }});
  }
  return columns;
}

/// Larger than any number of a run.
constexpr double largest_credible = 1e20;

[[noreturn]] void damaged(const std::string& path, const std::string& what) {
  throw core::FileError(path + ": the file is damaged: " + what);
}

// The numbers of a dataset. in: may_be_unknown: NaN stands for a value that was not known.
std::vector<double> credible(const results::ResultFile& file, const std::string& name, bool may_be_unknown = false) {
  const std::vector<double> values = file.numbers(name).values;
  for (const double value : values)
    if (std::abs(value) > largest_credible || (std::isnan(value) && !may_be_unknown))
      damaged(file.path(), name + " contains " + deck::shortest(value));
  return values;
}

std::string why_no_checkpoint(const results::ResultFile& file) {
  const std::string why = "command line: " + file.path() + " has no checkpoint: ";
  if (file.kind("/transient") != results::ResultFile::Kind::group) return why + "its case is steady";
  if (credible(file, numbers::path_of(id::completed)) == std::vector{1.0}) return why + "its run is complete";
  const std::string ended = numbers::path_of(id::ended);  // files of earlier versions lack it
  const bool is_stated = file.kind(ended) == results::ResultFile::Kind::text;
  const bool stepped = file.numbers("/transient/time").values.size() > 1;
  if (stepped && is_stated && file.text(ended) == how_it_ended({.end = transient::MarchEnd::interrupted}))
    return why + "runs in time with [thermal] and quasi-steady states keep none; run its deck again";
  return stepped ? why + "its run was not interrupted but ended because it could not continue" +
                       (is_stated ? ": " + file.text(ended) : std::string()) + "; change its deck and run it again"
                 : why + "its run was interrupted before the first step; run its deck again";
}

int whole(const std::string& path, const std::string& name, double value) {
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
    damaged(path, name + " contains " + deck::shortest(value) + ", which is not a valid number of items");
  return static_cast<int>(value);
}

// The rows of the file, with all its probes. in: the numbers that effects add, which may be unknown at some times.
std::vector<StepRow> read_rows(const results::ResultFile& file, const std::vector<std::string>& added) {
  const auto there = [&](const std::string& name) {
    return file.kind("/transient/" + name) == results::ResultFile::Kind::numbers;
  };
  std::vector<transient::Place> probes;
  while (there("P_" + std::to_string(probes.size() + 1))) probes.emplace_back();
  std::vector<StepRow> rows(file.numbers("/transient/time").values.size());
  for (StepRow& row : rows) {
    row.probed.resize(probes.size());
    row.measured.resize(added.size());
  }
  for (const Column<StepRow>& column : step_columns({.body = there("velocity"),
                                       .oil = there(id::oil_in),
                                       .newton = there("newton_steps"),
                                       .radius = there("radius_x"),
                                       .quasi = there(quasi_columns[0]),
                                       .errors = there(id::error_Hc)},
                                                    probes, added)) {
    const std::string name = "/transient/" + column.name;
    const bool may_be_unknown = std::ranges::find(added, column.name) != added.end() ||
                                std::ranges::find(quasi_columns, column.name) != std::end(quasi_columns) ||
                                column.name.starts_with("error_");
    const std::vector<double> values = credible(file, name, may_be_unknown);
    if (values.size() != rows.size() || values.empty()) damaged(file.path(), name);
    for (std::size_t k = 0; k < values.size(); ++k)
      column.set(rows[k], column.whole ? Value(whole(file.path(), name, values[k])) : Value(values[k]));
  }
  return rows;
}

results::Loose loose_of(const transient::Checkpoint& checkpoint) {
  const auto array = [](const char* name, const char* meaning, const std::vector<double>& values) {
    return results::Column{name, "-", meaning, false, values};
  };
  return {"/checkpoint",
          "state from which `ehl resume` continues",
          {{"time", checkpoint.T, "a/u_m", "time reached"},
           {"step", checkpoint.step, "a/u_m", "length of the last step"},
           {"frames", checkpoint.frames, "-", "fields stored so far"},
           {"jumps", checkpoint.restarts, "-", "jumps of load or speed so far"},
           {"weight", checkpoint.weight, "-", "factor on the under-relaxation weights of the cycles"}},
          {array("y",
                 "unknowns: P and the oil content on the computed grid, H00, the velocity of a moving body, and the "
                 "oil balance of inflow and outflow where mass is conserved",
                 checkpoint.y),
           array("yp", "their derivatives in time", checkpoint.yp)}};
}

}  // namespace

void add_transient(const Case& input, const TransientResult& result, results::Content& content) {
  const transient::Input& march = *input.transient;
  const InSteps added = in_steps_of(input);
  const bool line = numbers::per_length(input);  // and small enough for Newton's method
  content.tables.push_back(table_of("transient", "every accepted time step; ended " + how_it_ended(result.report),
                                    step_columns({.body = march.conditions.body.has_value(),
                                                  .oil = march.conditions.conserves_mass,
                                                  .line = line,
                                                  .newton = line,
                                                  .radius = !march.conditions.radius.points.empty(),
                                                  .quasi = march.mode == transient::Mode::both,
                                                  .errors = result.errors && result.errors->missing.empty()},
                                                 march.parameters.probes, added.numbers),
                                    result.rows));
  content.frames.group = "/transient/frames";
  for (const transient::Frame& frame : result.frames) content.frames.times.push_back(frame.T);
  const auto series = [&](const char* name, const char* unit, const char* meaning,
                          core::Field transient::Frame::*member) {
    results::Series made{name, unit, meaning, {}};
    for (const transient::Frame& frame : result.frames) made.fields.push_back(&(frame.*member));
    content.frames.series.push_back(std::move(made));
  };
  const auto kept = [&](const char* name) { return std::ranges::find(input.fields, name) != input.fields.end(); };
  if (kept("P")) series("P", "p_h", "pressure p/p_h", &transient::Frame::P);
  if (kept("H")) series("H", "a^2/R", "film thickness h R/a^2", &transient::Frame::H);
  if (march.conditions.conserves_mass)
    series("theta", "-", "oil content: share of the gap that the oil fills, Q/(rho H)", &transient::Frame::theta);
  for (std::size_t k = 0; k < added.fields.size(); ++k) {
    const results::NamedField& field = added.fields[k];
    results::Series made{field.name, field.unit, field.meaning, {}};
    for (const transient::Frame& frame : result.frames) made.fields.push_back(&frame.measured.at(k));
    content.frames.series.push_back(std::move(made));
  }
  // Up to here the summary is that of the steady start; "converged" in a file means the whole run in time.
  if (const std::string why = why_incomplete(result); !why.empty())
    for (results::Quantity& one : content.summary) {
      if (one.name == id::converged) one.value = false;
      if (one.name == id::failed_check) one.value = why;
    }
  content.summary.push_back(numbers::given(id::completed, completed(result)));
  content.summary.push_back(numbers::given(id::ended, how_it_ended(result.report)));
  if (result.checkpoint) content.checkpoint = loose_of(*result.checkpoint);
}

void require_checkpoint(const results::ResultFile& file) {
  if (file.kind("/checkpoint") != results::ResultFile::Kind::group) throw core::InputError(why_no_checkpoint(file));
}

TransientResult read_transient(const results::ResultFile& file, const Case& input) {
  using Kind = results::ResultFile::Kind;
  const InSteps added = in_steps_of(input);
  TransientResult result{.measured = added.numbers};
  result.rows = read_rows(file, result.measured);
  const auto number = [&](const char* name) {
    const std::vector<double> values = credible(file, std::string("/checkpoint/") + name);
    if (values.size() != 1) damaged(file.path(), name);
    return values[0];
  };
  const std::vector<double> times = credible(file, "/transient/frames/time");
  const auto count = [&](const char* name) { return whole(file.path(), name, number(name)); };
  const bool has_weight = file.kind("/checkpoint/weight") == Kind::numbers;  // files of earlier versions lack it
  result.checkpoint = transient::Checkpoint{number("time"),
                                            number("step"),
                                            count("frames"),
                                            count("jumps"),
                                            has_weight ? number("weight") : 1.0,
                                            credible(file, "/checkpoint/y"),
                                            credible(file, "/checkpoint/yp")};
  const auto field = [&](const std::string& name, std::size_t k) {
    const std::string path = "/transient/frames/" + name;
    if (file.kind(path) != Kind::numbers) return core::Field();
    const results::Array array = file.frame(path, k);
    if (std::ranges::any_of(array.values, [](double value) { return !(std::abs(value) <= largest_credible); }))
      damaged(file.path(), path + " contains something else than a field");
    return results::field_of(array);
  };
  for (std::size_t k = 0; k < times.size(); ++k) {
    result.frames.push_back({times[k], field("P", k), field("H", k), field("theta", k)});
    for (const results::NamedField& one : added.fields) result.frames.back().measured.push_back(field(one.name, k));
  }
  return result;
}

void check_fits(const TransientResult& before, const Case& input, const std::string& path) {
  const transient::Checkpoint& checkpoint = *before.checkpoint;
  const auto rise = [](const auto& list, auto time) {
    return std::ranges::adjacent_find(list, std::ranges::greater_equal(), time) == list.end();
  };
  if (!rise(before.rows, &StepRow::T) || !rise(before.frames, &transient::Frame::T))
    damaged(path, "its times are not rising");
  const double end = before.rows.back().T;
  if (before.rows.front().T != 0.0 || checkpoint.T != end || end > input.transient->parameters.end ||
      !(checkpoint.step > 0.0) || !(checkpoint.weight > 0.0 && checkpoint.weight <= 1.0) ||
      (!before.frames.empty() && before.frames.back().T > end))
    damaged(path, "the times of its checkpoint, rows, fields and deck do not agree");
  if (static_cast<std::size_t>(checkpoint.frames) != before.frames.size() || checkpoint.restarts < 0)
    damaged(path, "the number of fields does not match its checkpoint");
  const auto fits = [&](const core::Field& field) {
    return field.nodes_x() == input.scene.grid.nodes_x() && field.nodes_y() == input.scene.grid.nodes_y();
  };
  for (const transient::Frame& frame : before.frames) {
    for (const core::Field* field : {&frame.P, &frame.H, &frame.theta})
      if (field->nodes_x() > 0 && !fits(*field))
        damaged(path, "its fields belong to another grid than that of its deck");
    if ((input.subsurface && !fits(frame.P)) || !std::ranges::all_of(frame.measured, fits))
      damaged(path, "it lacks fields that its deck asks for");
  }
}

}  // namespace ehl::program
