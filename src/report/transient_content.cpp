// A transient in a result file, and back.
#include <algorithm>
#include <cmath>

#include "case/transient_input.hpp"
#include "commands/transient_run.hpp"
#include "core/errors.hpp"
#include "report/text_format.hpp"

namespace ehl::program {
namespace {

using transient::StepRow;

/// The columns of /transient, in order; one of both members is set.
struct ColumnRecord {
  const char* name;
  const char* unit;
  const char* meaning;
  double StepRow::*number;
  int StepRow::*count;
  bool of_body = false;  ///< only where a body moves
};
constexpr ColumnRecord columns[] = {
    {"time", "a/u_m", "time reached", &StepRow::T, nullptr},
    {"Hc", "a^2/R", "film at (0,0)", &StepRow::Hc, nullptr},
    {"Hm", "a^2/R", "smallest film of all nodes", &StepRow::Hm, nullptr},
    {"Hm_x", "a", "where it is", &StepRow::Hm_X, nullptr},
    {"Hm_y", "a", "where it is", &StepRow::Hm_Y, nullptr},
    {"P_max", "p_h", "highest pressure of all nodes", &StepRow::P_max, nullptr},
    {"H00", "a^2/R", "mutual approach", &StepRow::H00, nullptr},
    {"load", "-", "wanted, over that of the contact", &StepRow::load, nullptr},
    {"speed", "-", "entrainment speed (u1 + u2)/2 over u_m", &StepRow::speed, nullptr},
    {"load_error", "-", "relative error of the load", &StepRow::load_error, nullptr},
    {"velocity", "a u_m/R", "of the body", &StepRow::velocity, nullptr, true},
    {"carried", "-", "load that the film carries, over that of the contact", &StepRow::carried, nullptr, true},
    {"step", "a/u_m", "length of the step; 0 for the start", &StepRow::length, nullptr},
    {"order", "-", "of the time integration", nullptr, &StepRow::order},
    {"cycles", "-", "of all attempts at the step", nullptr, &StepRow::cycles},
    {"rejected", "-", "attempts that failed the error test", nullptr, &StepRow::rejected},
    {"not_solved", "-", "attempts that the cycles did not solve", nullptr, &StepRow::not_solved}};

// Columns P_1, H_1, P_2, ...
std::string probe_column(const char* quantity, std::size_t number) { return formatted("%s_%zu", quantity, number + 1); }

void add_probes(const std::vector<transient::Place>& places, const std::vector<StepRow>& rows, results::Table& table) {
  for (std::size_t k = 0; k < places.size(); ++k) {
    results::Column P{probe_column("P", k), "p_h", name_of_probe("pressure", places[k]), false, {}};
    results::Column H{probe_column("H", k), "a^2/R", name_of_probe("film", places[k]), false, {}};
    for (const StepRow& row : rows) {
      P.values.push_back(row.probed[k].P);
      H.values.push_back(row.probed[k].H);
    }
    table.columns.push_back(std::move(P));
    table.columns.push_back(std::move(H));
  }
}

void read_probes(const results::ResultFile& file, std::vector<StepRow>& rows) {
  const auto column = [&](const char* quantity, std::size_t k) { return "/transient/" + probe_column(quantity, k); };
  for (std::size_t k = 0; file.kind(column("P", k)) == results::ResultFile::Kind::numbers; ++k) {
    const std::vector<double> P = file.numbers(column("P", k)).values;
    const std::vector<double> H = file.numbers(column("H", k)).values;
    if (P.size() != rows.size() || H.size() != rows.size())
      throw core::FileError(file.path() + ": the file is damaged: " + column("P", k));
    for (std::size_t n = 0; n < rows.size(); ++n) rows[n].probed.push_back({P[n], H[n]});
  }
}

results::Loose loose_of(const transient::Checkpoint& checkpoint) {
  const auto array = [](const char* name, const char* meaning, const std::vector<double>& values) {
    return results::Column{name, "-", meaning, false, values};
  };
  return {"/checkpoint",
          "where `ehl resume` goes on",
          {{"time", checkpoint.T, "a/u_m", "time reached"},
           {"step", checkpoint.step, "a/u_m", "length of the last step"},
           {"frames", static_cast<double>(checkpoint.frames), "-", "fields kept so far", true},
           {"jumps", static_cast<double>(checkpoint.restarts), "-", "jumps of load or speed so far", true}},
          {array("y", "P and rho_bar H on the grid that is computed on, H00, and the velocity of a body that moves",
                 checkpoint.y),
           array("yp", "their derivatives in time", checkpoint.yp)}};
}

}  // namespace

void add_transient(const Case& input, const TransientResult& result, results::Content& content) {
  results::Table table{"transient", "every accepted step of time; ended " + how_it_ended(result.report), {}};
  for (const ColumnRecord& record : columns) {
    if (record.of_body && !input.transient->conditions.body) continue;
    results::Column made{record.name, record.unit, record.meaning, record.count != nullptr, {}};
    for (const StepRow& row : result.rows) made.values.push_back(record.count ? row.*record.count : row.*record.number);
    table.columns.push_back(std::move(made));
  }
  add_probes(input.transient->parameters.probes, result.rows, table);
  if (std::isfinite(input.transient->second))
    content.scales.push_back({"time", 1.0 / input.transient->second, "s", "a/u_m, the scale of time"});
  content.tables.push_back(std::move(table));
  content.frames.group = "/transient/frames";
  for (const transient::Frame& frame : result.frames) content.frames.times.push_back(frame.T);
  const auto series = [&](const char* name, const char* unit, const char* meaning,
                          core::Field transient::Frame::*member) {
    if (std::ranges::find(input.fields, name) == input.fields.end()) return;
    results::Series made{name, unit, meaning, {}};
    for (const transient::Frame& frame : result.frames) made.fields.push_back(&(frame.*member));
    content.frames.series.push_back(std::move(made));
  };
  series("P", "p_h", "pressure p/p_h", &transient::Frame::P);
  series("H", "a^2/R", "film thickness h R/a^2", &transient::Frame::H);
  content.summary.push_back({"transient_completed", completed(result) ? 1.0 : 0.0, "-", "1: to its end, 0: not", true});
  if (result.checkpoint) content.checkpoint = loose_of(*result.checkpoint);
}

TransientResult read_transient(const results::ResultFile& file) {
  using Kind = results::ResultFile::Kind;
  if (file.kind("/checkpoint") != Kind::group)
    throw core::InputError("command line: " + file.path() + " has no checkpoint: " +
                           (file.kind("/transient") == Kind::group ? "its run is complete" : "its case is steady"));
  TransientResult result;
  const std::string damaged = file.path() + ": the file is damaged: ";
  result.rows.resize(file.numbers("/transient/time").values.size());
  for (const ColumnRecord& record : columns) {
    if (record.of_body && file.kind(std::string("/transient/") + record.name) != Kind::numbers) continue;
    const std::vector<double> values = file.numbers(std::string("/transient/") + record.name).values;
    if (values.size() != result.rows.size() || values.empty()) throw core::FileError(damaged + record.name);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (record.count)
        result.rows[k].*record.count = static_cast<int>(values[k]);
      else
        result.rows[k].*record.number = values[k];
  }
  read_probes(file, result.rows);
  const auto number = [&](const char* name) {
    const std::vector<double> values = file.numbers(std::string("/checkpoint/") + name).values;
    if (values.size() != 1 || !std::isfinite(values[0])) throw core::FileError(damaged + name);
    return values[0];
  };
  const std::vector<double> times = file.numbers("/transient/frames/time").values;
  result.checkpoint = transient::Checkpoint{number("time"),
                                            number("step"),
                                            static_cast<int>(number("frames")),
                                            static_cast<int>(number("jumps")),
                                            file.numbers("/checkpoint/y").values,
                                            file.numbers("/checkpoint/yp").values};
  const auto field = [&](const char* name, std::size_t k) {
    const std::string path = std::string("/transient/frames/") + name;
    if (file.kind(path) != Kind::numbers) return core::Field();
    const results::Array array = file.frame(path, k);
    core::Grid grid{.nx = static_cast<int>(array.dims[1]) - 1, .ny = static_cast<int>(array.dims[0]) - 1};
    core::Field read(grid);
    for (int j = 0; j <= grid.ny; ++j)
      for (int i = 0; i <= grid.nx; ++i)
        read(i, j) = array.values[static_cast<std::size_t>(j) * array.dims[1] + static_cast<std::size_t>(i)];
    return read;
  };
  for (std::size_t k = 0; k < times.size(); ++k) result.frames.push_back({times[k], field("P", k), field("H", k)});
  return result;
}

}  // namespace ehl::program
