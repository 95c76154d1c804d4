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
#include "tables/children.hpp"
#include "tables/csv.hpp"
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
std::vector<TimeStudyPoint> run_variants(const Case& input, const std::vector<TimeVariant>& variants, bool look,
                                         int at_once, bool quiet) {
  return computed_rows<TimeStudyPoint, TimeVariant>(
      variants, at_once, quiet,
      [&](const TimeVariant& variant) { return measure_in_time(input, variant, look ? samples : 0); },
      [&](const TimeVariant& variant) { return name_of_variant(variant) + (look ? "" : ", timed"); });
}

TimeReference find_reference(Case input, double rtol, double longest_step, bool quiet) {
  input.scene.threads = usable_cores();
  input.transient->parameters.most_steps = most_steps;  // the limit of the deck is meant for its own tolerance
  const TimeVariant variant{tighter * rtol, shorter * longest_step};
  const TimeVariant coarser{coarser_rtol * variant.rtol, coarser_step * variant.longest_step};
  if (!quiet) std::fprintf(stderr, "ehl: the reference, and the run that estimates its error\n");
  std::vector<TimeStudyPoint> runs = run_variants(input, {coarser, variant}, true, 1, quiet);
  for (const TimeStudyPoint& run : runs)
    if (!is_complete(run))
      throw core::SolverError("the reference, " + name_of_variant(run.variant) + ": " + run.reason);
  TimeReference reference{std::move(runs[1]), std::move(runs[0]), {}, input.transient->parameters.probes};
  reference.errors = errors_in_time(reference.run, reference.coarser);
  return reference;
}

std::vector<TimeStudyPoint> measured(const Case& input, const std::vector<double>& rtols, double longest_step,
                                     const StudyHeader& header, bool quiet) {
  std::vector<TimeVariant> variants;
  for (const double rtol : rtols) variants.push_back({rtol, longest_step});
  if (!quiet)
    std::fprintf(stderr, "ehl: %zu tolerances, each once for its film and %d times for its time\n", rtols.size(),
                 header.repeats);
  std::vector<TimeStudyPoint> points = run_variants(input, variants, true, header.jobs, quiet);
  for (TimeStudyPoint& point : points)
    point.seconds = point.seconds_most = TimeStudyPoint::unknown;  // the time includes recording and does not count
  const std::vector<TimeStudyPoint> timed =
      run_variants(input, repeated(variants, header.repeats), false, header.jobs, quiet);
  for (std::size_t k = 0; k < timed.size(); ++k) add_repetition(timed[k], points[k % points.size()]);
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
  std::vector<TimeStudyPoint> points = measured(input, rtols, longest_step, header, quiet);
  for (TimeStudyPoint& point : points) point.errors = errors_in_time(reference.run, point);
  write_table(path, time_study_csv(header, reference, points), arguments.has("overwrite"));
  print(time_study_report(header, reference, points) + "table        " + path + "\n");
  return std::ranges::all_of(points, is_complete) ? solved : not_converged;
}

}  // namespace ehl::program
