// ehl sweep: many cases of one deck, one table.
#include <fmt/core.h>

#include <cstdio>

#include "base/exit_status.hpp"
#include "base/progress.hpp"
#include "base/signals.hpp"
#include "case/catalogue.hpp"
#include "commands/commands.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"
#include "results/atomic_file.hpp"
#include "tables/children.hpp"
#include "tables/csv.hpp"
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

}  // namespace

int sweep(const Arguments& arguments) {
  const std::string& deck = arguments.operands[0];
  if (!arguments.has("vary"))
    throw core::InputError("command line: `ehl sweep` needs --vary section.key=LIST, e.g. --vary contact.M=20,50,100");
  SweepHeader header{this_program(), deck, deck::load_text(deck), arguments.overrides(),
                     parse_variations(arguments.values("vary"), arguments.overrides(), catalogue())};
  const auto overrides_of = [&](std::size_t index) {
    std::vector<std::string> overrides = header.set;
    for (const std::string& varied : overrides_of_case(header.variations, index)) overrides.push_back(varied);
    return overrides;
  };
  header.files = files_of_cases(deck, header.set, header.variations);
  header.kind = kind_of_sweep(deck, overrides_of(0));
  const int at_once = requested_threads(arguments);
  const std::string path = table_name(arguments);
  std::vector<std::string> inputs{deck};
  for (const deck::NamedFile& file : header.files) inputs.push_back(file.path);
  results::check_writable(path, true, 0, inputs);
  SweepTable table(path, header, arguments.has("overwrite"));

  const double began = core::now();
  const std::vector<std::size_t> missing = table.missing();
  const std::size_t cases = number_of_cases(header.variations);
  Progress progress(arguments.has("quiet"));
  std::size_t done = 0;
  ChildrenCalls calls;
  calls.stop = stop_requested;
  calls.task = [&](std::size_t index, const Say& say) { return csv_row(sweep_case(header, overrides_of(index), say)); };
  calls.waits = [&](const ChildAtWork& child) {
    progress.show(
        static_cast<double>(done) / static_cast<double>(missing.size()),
        fmt::format("{}/{}  {}, {:.0f} s so far: {}", done, missing.size(),
                    deck::joined(overrides_of_case(header.variations, child.task), " "), child.seconds, child.says));
  };
  calls.ended = [&](const ChildEnd& end) {
    const SweepRow failure = row_without_solution(sweep_row(header.kind), "failed", end.status, end.reason);
    const std::string row = end.complete ? end.text : csv_row(failure);
    table.append(end.task, row);
    progress.count(
        ++done, missing.size(),
        deck::joined(overrides_of_case(header.variations, end.task), " ") + "  " + row.substr(0, row.find(',')));
  };
  const bool finished = run_in_children(missing, at_once, calls);
  progress.clear();
  if (!finished) {
    std::fprintf(stderr, "ehl: interrupted: %zu of %zu cases are in %s; the same command goes on with them\n",
                 cases - table.missing().size(), cases, path.c_str());
    return interrupted;
  }
  table.finish();
  print(summary(table, cases, cases - missing.size(), core::now() - began) + "table        " + path + "\n");
  return table.count("converged") == cases ? solved : not_converged;
}

}  // namespace ehl::program
