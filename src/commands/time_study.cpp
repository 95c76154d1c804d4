#include "commands/time_study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "results/outputs.hpp"
#include "tables/csv.hpp"
#include "tables/study_measure.hpp"
#include "tables/time_study_report.hpp"

namespace ehl::program {
namespace {

constexpr int samples = 400;
/// The tolerance and the longest step of the reference run, relative to the smallest tolerance studied and to the
/// longest step of the deck.
constexpr double tighter = 0.1;
constexpr double shorter = 1.0 / 16.0;
/// A second, coarser run, relative to the reference; the difference between the two shows how
/// accurate the reference is.
constexpr double coarser_rtol = 3.0;
constexpr double coarser_step = 2.0;
constexpr int most_steps = 100000000;
constexpr double least_rtol = 1e-7;
constexpr double most_rtol = 1e-1;

std::vector<double> tolerances(const Arguments& arguments) {
  const std::string text = arguments.value("rtol", "1e-2,1e-3,1e-4,1e-5,1e-6");
  const auto allowed = [](const std::string& word) {
    const deck::ReadNumber read = deck::read_number(word);
    return read.status == deck::ReadNumber::Status::number && read.value >= least_rtol && read.value <= most_rtol;
  };
  std::vector<double> list;
  for (const std::string& word :
       words_of_list("rtol", text, allowed, fmt::format("a number from {:g} to {:g}", least_rtol, most_rtol)))
    list.push_back(deck::read_number(word).value);
  std::ranges::sort(list, std::greater<>());
  if (const auto twice = std::ranges::adjacent_find(list); twice != list.end())
    throw core::InputError(fmt::format("command line: --rtol {}: {:g} is given twice", text, *twice));
  return list;
}

// in: look: record the film at the times of comparison; the run is then not timed.
std::vector<StudyPoint> run_variants(const Case& input, const std::vector<StudyCase>& variants, bool look, int times,
                                     int at_once, bool quiet) {
  return measured(
      variants, times, at_once, quiet,
      [&](const StudyCase& variant) { return measure_in_time(input, variant, look ? samples : 0); },
      look ? "" : ", timed");
}

TimeReference find_reference(Case input, double rtol, double longest_step, bool quiet) {
  input.scene.threads = usable_cores();
  input.transient->parameters.most_steps = most_steps;  // the limit of the deck is meant for its own tolerance
  const StudyCase variant{.rtol = tighter * rtol, .longest_step = shorter * longest_step};
  const StudyCase coarser{.rtol = coarser_rtol * variant.rtol, .longest_step = coarser_step * variant.longest_step};
  if (!quiet) std::fprintf(stderr, "ehl: the reference, and the run that estimates its error\n");
  std::vector<StudyPoint> runs = run_variants(input, {coarser, variant}, true, 1, 1, quiet);
  for (const StudyPoint& run : runs)
    if (!is_complete(run))
      throw core::SolverError("the reference, " + name_of_variant(run.variant) + ": " + run.reason);
  TimeReference reference{std::move(runs[1]), std::move(runs[0]), {}, input.transient->parameters.probes};
  reference.errors = errors_in_time(reference.run, reference.coarser);
  return reference;
}

// Each run once for its film and several times for its seconds.
std::vector<StudyPoint> measured_runs(const Case& input, const std::vector<StudyCase>& variants,
                                      const StudyHeader& header, bool quiet) {
  if (!quiet)
    std::fprintf(stderr, "ehl: %zu tolerances, each once for its film and %d times for its time\n", variants.size(),
                 header.repeats);
  std::vector<StudyPoint> points = run_variants(input, variants, true, 1, header.jobs, quiet);
  const std::vector<StudyPoint> timed = run_variants(input, variants, false, header.repeats, header.jobs, quiet);
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k].seconds = timed[k].seconds;  // the time with the recording does not count
    points[k].seconds_most = timed[k].seconds_most;
    points[k].peak_memory = std::fmax(points[k].peak_memory, timed[k].peak_memory);
  }
  return points;
}

}  // namespace

int study_in_time(const Arguments& arguments, const StudyHeader& header, const std::string& path, const Case& input) {
  for (const char* option : {"levels", "wedges", "evaluators", "cycles", "reference"})
    if (arguments.has(option))
      throw core::InputError(std::string("command line: --") + option +
                             " is for steady decks, but this one has [transient] end_time: use --rtol");
  const std::vector<double> rtols = tolerances(arguments);
  const bool quiet = arguments.has("quiet");
  results::check_files(header.inputs(), {{path, results::FileKind::table, arguments.has("overwrite")}});
  const transient::MarchParameters& march = input.transient->parameters;
  const double longest_step = std::isnan(march.longest_step)
                                  ? transient::longest_step(input.transient->conditions, march.end)
                                  : march.longest_step;
  const TimeReference reference = find_reference(input, rtols.back(), longest_step, quiet);
  std::vector<StudyCase> variants;
  for (const double rtol : rtols) variants.push_back({.rtol = rtol, .longest_step = longest_step});
  std::vector<StudyPoint> points = measured_runs(input, variants, header, quiet);
  judge(reference, points);
  write_table(path, time_study_csv(header, reference, points), arguments.has("overwrite"));
  print(time_study_report(header, reference, points) + "table        " + path + "\n");
  return std::ranges::all_of(points, is_complete) ? solved : not_converged;
}

}  // namespace ehl::program
