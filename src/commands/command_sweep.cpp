// ehl sweep: computes many cases of one deck and writes one table.
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

#include "base/exit_status.hpp"
#include "base/text_format.hpp"
#include "case/catalogue.hpp"
#include "case/needs.hpp"
#include "commands/commands.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"
#include "results/outputs.hpp"
#include "tables/children.hpp"
#include "tables/csv.hpp"
#include "tables/kept_results.hpp"
#include "tables/shard.hpp"
#include "tables/sweep_merge.hpp"
#include "tables/sweep_row.hpp"
#include "tables/sweep_table.hpp"

namespace ehl::program {
namespace {

std::string summary(const SweepTable& table, std::size_t cases, std::size_t kept, double seconds) {
  std::string text =
      fmt::format("cases        {}: {} kept, {} computed in {:.1f} s\n", cases, kept, cases - kept, seconds);
  text += "status       ";
  for (const char* status : {"converged", "not-converged", "refused", "failed"})
    text += fmt::format("{} {}{}", table.count(status), status, status == std::string("failed") ? "\n" : ", ");
  return text;
}

// A remark on the error bars of the converged cases; empty if all are below 10 %.
std::string summary_of_bars(const SweepTable& table, const std::vector<std::size_t>& own,
                            const std::function<std::string(std::size_t)>& name_of) {
  constexpr double large = 0.1, hardly_an_error = 1.0;
  std::size_t converged = 0, none = 0, poor = 0, useless = 0, worst = 0;
  double largest = 0.0;
  for (const std::size_t index : own) {
    if (!table.has_status(index, "converged")) continue;
    ++converged;
    const deck::ReadNumber of_Hc = deck::read_number(table.cell(index, id::error_Hc));
    const deck::ReadNumber of_Hm = deck::read_number(table.cell(index, id::error_Hm));
    const auto known = deck::ReadNumber::Status::number;
    if (of_Hc.status != known || of_Hm.status != known) {
      ++none;
      continue;
    }
    const double error = std::max(of_Hc.value, of_Hm.value);
    poor += error >= large ? 1 : 0;
    useless += error >= hardly_an_error ? 1 : 0;
    if (error <= largest) continue;
    largest = error;
    worst = index;
  }
  std::string text;
  if (poor > 0)
    text = fmt::format(
        "error bars   10 % or more in Hc or Hm: {} of the {} converged cases; 100 % or more: {}; the largest is {:.0f} "
        "% "
        "({}): use more cells there\n",
        poor, converged, useless, 100.0 * largest, name_of(worst));
  if (none > 0) text += fmt::format("error bars   unknown for {} of the {} converged cases\n", none, converged);
  return text;
}

// The shard that the command line or the job array of a scheduler asks for.
Shard wanted_shard(const Arguments& arguments) {
  if (arguments.has("shard")) return parse_shard(arguments.value("shard", ""));
  return shard_of_array().value_or(Shard{});
}

// The predicted time of a case; 0 if the case will be refused.
double seconds_of_case(const std::string& deck, const std::vector<std::string>& overrides) try {
  return expected_needs(read_lubricated_case(deck, overrides, 1, "sweep")).seconds;
} catch (const core::InputError&) {
  return 0.0;
}

bool has_kept(const std::string& table) { return std::filesystem::exists(name_of_kept(table)); }

// Checks all files that a sweep reads, writes or continues.
void check_files(const Arguments& arguments, const SweepHeader& header, const std::string& table) {
  std::vector<std::string> inputs{header.deck};
  for (const deck::NamedFile& file : header.files) inputs.push_back(file.path);
  if (arguments.has("cases")) inputs.push_back(arguments.value("cases", ""));
  std::vector<results::Output> outputs{{table, results::FileKind::table, true}};
  if (arguments.has("keep")) outputs.push_back({name_of_kept(table), results::FileKind::kept_results, true});
  results::check_files(inputs, outputs);
  const std::string folder = folder_of_kept(table);
  if (arguments.has("keep") && std::filesystem::exists(folder) && !std::filesystem::is_directory(folder))
    throw core::FileError(folder +
                          ": already exists and is not the folder of the results of a sweep: move it away, or " +
                          "give another --output");
}

int merge(const Arguments& arguments) {
  for (const char* option : {"vary", "cases", "shard", "set", "unset", "timing", "keep"})
    if (arguments.has(option)) refuse(std::string("--merge takes only tables: --") + option + " is stored in them");
  if (!arguments.has("output")) refuse("--merge needs --output FILE.csv");
  const std::string path = table_name(arguments);
  const bool overwrite = arguments.has("overwrite");
  std::vector<std::string> inputs = arguments.operands;
  std::vector<results::Output> outputs{{path, results::FileKind::table, overwrite}};
  for (const std::string& table : arguments.operands) inputs.push_back(name_of_kept(table));
  if (std::ranges::any_of(arguments.operands, has_kept))
    outputs.push_back({name_of_kept(path), results::FileKind::kept_results, overwrite});
  results::check_files(inputs, outputs);
  const MergedSweep merged = merged_sweep(arguments.operands);
  write_table(path, merged.text, overwrite);
  const std::string kept = merge_kept(arguments.operands, path);
  print(fmt::format("cases        {}: {} converged, {} missing\ntable        {}\n{}", merged.cases, merged.converged,
                    merged.missing.size(), path, kept.empty() ? "" : "results      " + kept + "\n"));
  if (!merged.missing.empty())
    std::fprintf(stderr, "ehl: %zu cases have no row yet, the first is case %zu: the sweep on %s continues with them\n",
                 merged.missing.size(), merged.missing[0], path.c_str());
  return merged.converged == merged.cases ? solved : not_converged;
}

}  // namespace

int sweep(const Arguments& arguments) {
  if (arguments.has("merge")) return merge(arguments);
  if (arguments.operands.size() > 1)
    refuse("'" + arguments.operands[1] + "' is one argument too many: a sweep has one deck");
  const std::string& deck = arguments.operands[0];
  if (!arguments.has("vary") && !arguments.has("cases"))
    throw core::InputError(
        "command line: `ehl sweep` needs --vary section.key=LIST, e.g. --vary contact.M=20,50,100, or --cases "
        "FILE.csv");
  const Shard shard = wanted_shard(arguments);
  SweepHeader header{
      this_program(), deck, deck::load_text(deck), arguments.overrides(),
      parse_variations(arguments.values("vary"), arguments.overrides(), catalogue(), arguments.value("cases", ""))};
  const auto overrides_of = [&](std::size_t index) {
    std::vector<std::string> overrides = header.set;
    for (const std::string& varied : overrides_of_case(header.variations, index)) overrides.push_back(varied);
    return overrides;
  };
  header.files = files_of_cases(deck, header.set, header.variations);
  header.timing = arguments.has("timing");
  const deck::Deck of_first_case = deck::read(deck, overrides_of(0), catalogue());
  header.columns = numbers::columns_of_sweep(of_first_case, header.timing);
  header.left_out = left_out(of_first_case);
  header.shard = shard;
  const int at_once = header.at_once = requested_threads(arguments);
  const std::string path = name_of_shard(table_name(arguments), shard);
  check_files(arguments, header, path);
  std::vector<std::size_t> values;
  for (const Variation& variation : header.variations) values.push_back(variation.values.size());
  const std::vector<double> seconds =
      shard.whole() ? std::vector<double>(number_of_cases(header.variations), 1.0)
                    : foreseen_seconds(values, [&](std::size_t k) { return seconds_of_case(deck, overrides_of(k)); });
  const std::vector<std::size_t> own = cases_of_shard(seconds, shard);
  SweepTable table(path, header, own, arguments.has("overwrite"));
  std::optional<KeptResults> kept;
  if (arguments.has("keep")) kept.emplace(path, arguments.has("overwrite"));
  for (const std::string& line : header.left_out) std::fprintf(stderr, "ehl: warning: %s\n", line.c_str());
  const auto name_of = [&](std::size_t index) {
    return deck::joined(overrides_of_case(header.variations, index), " ");
  };

  const double began = core::now();
  std::vector<std::size_t> missing = table.missing();
  if (kept) {  // needed for rows that an earlier sweep computed without --keep
    for (const std::size_t index : own)
      if (table.has_status(index, "converged") && !kept->has(name_of(index))) missing.push_back(index);
    std::ranges::sort(missing);
  }
  const std::size_t cases = own.size();
  const SweepRow nothing_known = sweep_row(header.columns);
  // The text of a task is the row, which is one line, followed by the result to keep.
  const auto compute = [&](std::size_t index, const Say& say) {
    std::string result;
    const std::string row = csv_row(sweep_case(header, overrides_of(index), say, kept ? &result : nullptr));
    return result.empty() ? row : row + "\n" + result;
  };
  const auto ended = [&](const ChildEnd& end) {
    const SweepRow failure = row_without_solution(nothing_known, "failed", end.status, end.reason);
    const std::string text = end.complete ? end.text : csv_row(failure);
    const std::string row = text.substr(0, text.find('\n'));
    if (row.size() < text.size()) kept->add(name_of(end.task), text.substr(row.size() + 1));
    table.append(end.task, row);
    return row.substr(0, row.find(','));
  };
  const bool finished = run_watched({missing, at_once, arguments.has("quiet"), name_of, compute, ended});
  if (!finished) {
    std::fprintf(stderr, "ehl: interrupted: %zu of %zu cases are in %s; the same command continues the sweep\n",
                 cases - table.missing().size(), cases, path.c_str());
    return interrupted;
  }
  table.finish();
  if (kept) {
    std::vector<std::pair<std::size_t, std::string>> named;
    for (const std::size_t index : own) named.emplace_back(index, name_of(index));
    kept->finish(named);
  }
  print(summary(table, cases, cases - missing.size(), core::now() - began) + summary_of_bars(table, own, name_of) +
        "table        " + path + "\n" + (kept ? "results      " + kept->path() + "\n" : ""));
  // The refused case is chosen by number and not by time of completion, so that the message is reproducible.
  const auto refused = std::ranges::find_if(own, [&](std::size_t index) { return table.has_status(index, "refused"); });
  if (refused != own.end())
    std::fprintf(stderr, "ehl: first refused case: %s: %s\n", name_of(*refused).c_str(),
                 table.cell(*refused, id::reason).c_str());
  if (table.count("refused") == cases) return wrong_input;
  return table.count("converged") == cases ? solved : not_converged;
}

}  // namespace ehl::program
