// ehl fit: fits constants of an oil to a measured traction curve.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/exit_status.hpp"
#include "base/progress.hpp"
#include "base/signals.hpp"
#include "base/text_format.hpp"
#include "case/catalogue.hpp"
#include "commands/commands.hpp"
#include "core/constants.hpp"
#include "core/errors.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"
#include "tables/children.hpp"
#include "tables/csv.hpp"
#include "tables/least_squares.hpp"
#include "tables/measured.hpp"
#include "tables/sweep_row.hpp"
#include "tables/sweep_table.hpp"

namespace ehl::program {
namespace {

constexpr std::size_t most_free = 3;

// The task of the fit: the deck, the measured points, and the free keys "shear.tau_0".
struct Task {
  SweepHeader header{};
  std::vector<MeasuredPoint> points{};
  std::vector<std::string> free{};
  int at_once = 1;
  bool quiet = false;
};

std::vector<std::string> overrides_of(const Task& task, const std::vector<double>& parameters, double srr) {
  std::vector<std::string> overrides = task.header.set;
  // A free key may also be set; this value is then the start of the fit.
  if (!parameters.empty())
    for (const std::string& key : task.free)
      std::erase_if(overrides, [&](const std::string& one) { return one.starts_with(key + "="); });
  for (std::size_t a = 0; a < parameters.size(); ++a)
    overrides.push_back(fmt::format("{}={:.12g}", task.free[a], parameters[a]));
  overrides.push_back(fmt::format("motion.srr={:.12g}", srr));
  return overrides;
}

// The friction coefficient mu as text; if there is none, the reason.
std::string solved_mu(const Task& task, const std::vector<double>& parameters, double srr, const Say& say) {
  SweepRow row = sweep_case(task.header, overrides_of(task, parameters, srr), say);
  if (csv_cell(in_row(row, id::status)) != "converged") return csv_cell(in_row(row, id::reason));
  return csv_cell(in_row(row, id::mu));
}

// The friction of all points for all sets of parameters, computed in child processes.
std::vector<std::vector<double>> friction_of_all(const Task& task, const std::vector<std::vector<double>>& sets,
                                                 int round, std::string& reason) {
  const std::size_t points = task.points.size();
  std::vector<std::vector<double>> mu(sets.size(), std::vector<double>(points, core::unknown));
  std::vector<std::size_t> tasks(points * sets.size());
  std::iota(tasks.begin(), tasks.end(), std::size_t{0});
  Progress progress(task.quiet);
  std::size_t done = 0;
  std::size_t first_without = tasks.size();  // by number, so that the message is reproducible
  ChildrenCalls calls;
  calls.stop = stop_requested;
  calls.task = [&](std::size_t k, const Say& say) {
    return solved_mu(task, sets[k / points], task.points[k % points].srr, say);
  };
  calls.waits = [&](const ChildAtWork& child) {
    progress.show(static_cast<double>(done) / static_cast<double>(tasks.size()),
                  fmt::format("round {}, {}/{}: {}", round, done, tasks.size(), child.says));
  };
  calls.ended = [&](const ChildEnd& end) {
    ++done;
    const deck::ReadNumber read = deck::read_number(end.complete ? end.text : "");
    if (read.status == deck::ReadNumber::Status::number) {
      mu[end.task / points][end.task % points] = read.value;
    } else if (end.task < first_without) {
      first_without = end.task;
      reason =
          fmt::format("srr = {:.6g}: {}", task.points[end.task % points].srr, end.complete ? end.text : end.reason);
    }
  };
  const bool finished = run_in_children(tasks, task.at_once, calls);
  progress.clear();
  if (!finished) throw core::Interrupted();
  return mu;
}

Task task_of(const Arguments& arguments) {
  const std::string& deck = arguments.operands[0];
  if (!arguments.has("measured") || !arguments.has("free"))
    refuse("`ehl fit` needs --measured FILE.csv and --free section.key, e.g. --free shear.tau_0");
  Task task;
  task.points = read_measured(arguments.value("measured", ""));
  task.header.program = this_program();
  task.header.deck = deck;
  task.header.deck_text = deck::load_text(deck);
  task.header.set = arguments.overrides();
  task.free = arguments.values("free");
  task.at_once = task.header.at_once = requested_threads(arguments);
  task.quiet = arguments.has("quiet");
  for (const std::string& key : task.free) {
    const std::size_t dot = std::min(key.find('.'), key.size());
    const std::string section = key.substr(0, dot), name = key.substr(std::min(dot + 1, key.size()));
    const deck::Catalogue known = catalogue();
    if (deck::find_key(known, section, name) != nullptr) continue;
    std::vector<std::string> names;
    for (const deck::Key& one : known.keys)
      if (one.type == deck::Type::number) names.push_back(one.section + "." + one.name);
    const std::string near = deck::nearest(key, names);
    refuse("--free " + key + ": there is no such key" + (near.empty() ? "" : ": did you mean " + near + "?") +
           " Keys are written section.key, e.g. shear.tau_0");
  }
  if (task.free.size() > most_free) refuse(fmt::format("--free: {} keys at most", most_free));
  if (task.points.size() <= task.free.size())
    refuse(fmt::format("--measured: {} points are too few for {} constants and their standard errors",
                       task.points.size(), task.free.size()));
  task.header.files = files_of_cases(deck, task.header.set, {});
  const deck::Deck of_last = deck::read(deck, overrides_of(task, {}, task.points.back().srr), catalogue());
  if (deck::called_for(of_last, "transient")) refuse(deck + ": a fit needs a steady contact: remove [transient]");
  task.header.columns = numbers::columns_of_sweep(of_last, false);
  if (std::ranges::find(task.header.columns, id::mu, &numbers::SweepColumn::name) == task.header.columns.end())
    refuse(deck + ": the deck computes no friction to fit: add [friction] or [thermal]");
  return task;
}

// The values of the free keys in the deck, where the fit begins.
std::vector<double> start_of(const Task& task) {
  const deck::Deck deck = deck::read(task.header.deck, overrides_of(task, {}, task.points.back().srr), catalogue());
  std::vector<double> start;
  for (const std::string& key : task.free) {
    const std::size_t dot = key.find('.');
    const std::string section = key.substr(0, dot), name = dot == std::string::npos ? "" : key.substr(dot + 1);
    if (!deck::given(deck, section.c_str(), name.c_str()) || !(deck::number(deck, section.c_str(), name.c_str()) > 0.0))
      refuse("--free " + key + ": the deck must give this key a positive starting value");
    start.push_back(deck::number(deck, section.c_str(), name.c_str()));
  }
  return start;
}

std::string report(const Task& task, const Fit& fit) {
  std::string text = fmt::format("{:>10} {:>10} {:>10} {:>10}\n", "srr", "measured", "computed", "deviation");
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    const MeasuredPoint& point = task.points[i];
    text += fmt::format("{:>10.5g} {:>10.5g} {:>10.5g} {:>10.5f}\n", point.srr, point.mu, fit.model[i],
                        fit.model[i] - point.mu);
  }
  text += fmt::format("deviation    {:.2g} root mean square over {} points, {} rounds\n", fit.deviation,
                      task.points.size(), fit.rounds);
  for (std::size_t a = 0; a < task.free.size(); ++a)
    text += fmt::format("{:<12} = {:.5g} +- {} (one standard error)\n", task.free[a], fit.parameters[a],
                        percent(fit.errors[a]));
  for (std::size_t a = 0; a < task.free.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      text += fmt::format("correlation  {:.3f} between {} and {}\n", fit.correlation[a][b], task.free[b], task.free[a]);
  if (!fit.settled)
    text += "warning: the fit has not converged: its last steps still lowered the deviation, or none did\n";
  return text;
}

}  // namespace

int fit(const Arguments& arguments) {
  const Task task = task_of(arguments);
  std::string reason;
  int round = 0;
  const Model model = [&](const std::vector<std::vector<double>>& sets) {
    return friction_of_all(task, sets, ++round, reason);
  };
  std::vector<Measurement> measured;
  for (const MeasuredPoint& point : task.points) measured.push_back({point.mu, point.sigma});
  try {
    const Fit found = least_squares(model, measured, start_of(task));
    print(report(task, found));
    return found.settled ? solved : not_converged;
  } catch (const core::SolverError& error) {
    std::fprintf(stderr, "ehl: %s%s\n", error.what(), reason.empty() ? "" : ("; " + reason).c_str());
    return not_converged;
  }
}

}  // namespace ehl::program
