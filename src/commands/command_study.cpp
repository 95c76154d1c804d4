// ehl study: accuracy against computing time.
#include <algorithm>
#include <cstdio>

#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "commands/commands.hpp"
#include "commands/time_study.hpp"
#include "core/errors.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"
#include "results/outputs.hpp"
#include "tables/csv.hpp"
#include "tables/study_measure.hpp"
#include "tables/study_report.hpp"

namespace ehl::program {
namespace {

constexpr double reference_tolerance = 1e-10;
constexpr int reference_cycles = 200;
/// The reference may be one level finer than the studied grids if it has at most this many nodes.
constexpr double most_nodes_of_reference = 5e6;
constexpr std::size_t grids_of_reference = 3;

// Provides the case on each grid, without solving it.
class Grids {
 public:
  Grids(const Arguments& arguments, int threads)
      : path_(arguments.operands[0]), set_(arguments.overrides()), threads_(threads) {}

  Case deck() const { return read_lubricated_case(path_, set_, threads_, "study"); }
  Case on(int cells) const { return case_on_grid(path_, set_, cells, threads_); }
  double nodes(int cells) const {
    const core::Grid grid = on(cells).scene.grid;
    return static_cast<double>(grid.nodes_x()) * grid.nodes_y();
  }
  bool legal(int cells) const try {
    on(cells);
    return true;
  } catch (const core::InputError&) {
    return false;
  }

 private:
  std::string path_;
  std::vector<std::string> set_;
  int threads_;
};

// With heat or flow thinning, the cycles are part of a fixed-point iteration, so their number is that of `ehl run`.
std::string cycles_of(const Arguments& arguments, const Case& input) {
  const bool passes = input.heat || input.flow_thinning;
  const std::string cycles = arguments.value("cycles", passes ? "run" : "1V,2V,1W,2W,run");
  if (passes && cycles != "run")
    throw core::InputError(
        "command line: --cycles " + cycles +
        ": a contact with heat, or with [shear] flow = on, is solved by a fixed-point iteration: use run");
  return cycles;
}

StudyPlan plan_of(const Arguments& arguments, const Grids& grids, const Case& input) {
  const int cells_of_deck = input.scene.grid.nx;
  const auto list = [&](const char* option, const char* otherwise, bool (*allowed)(const std::string&),
                        const char* told) {
    return words_of_list(option, arguments.value(option, otherwise), allowed, told);
  };
  return {arguments.has("levels") ? levels_between(arguments.value("levels", ""))
                                  : levels_of_deck(cells_of_deck, [&](int cells) { return grids.legal(cells); }),
          list("wedges", "upstream1,upstream2,upstream3", is_study_wedge, "upstream1, upstream2 or upstream3"),
          list("evaluators", "mlmi4,mlmi6,mlmi8,fft,direct", is_study_evaluator, "mlmi4, mlmi6, mlmi8, fft or direct"),
          words_of_list("cycles", cycles_of(arguments, input), is_study_cycles,
                        "a number and a shape, e.g. 2W (V, W or F), or run")};
}

// Coarse to fine: the grids below the reference grid, which is one level finer than the studied
// ones if that is affordable.
std::vector<int> reference_grids(const Arguments& arguments, const Grids& grids, int finest) {
  int cells = finest;
  if (arguments.has("reference")) {
    cells = whole_number(arguments, "reference", finest, 1 << 20);
    int grown = finest;
    while (grown < cells) grown *= 2;
    if (grown != cells)
      throw core::InputError("command line: --reference " + std::to_string(cells) + ": must be the " +
                             std::to_string(finest) + " cells of the finest grid studied, times 1 or a power of two");
    grids.on(cells);
  } else if (4.0 * grids.nodes(finest) <= most_nodes_of_reference && grids.legal(2 * finest)) {
    cells = 2 * finest;
  }
  std::vector<int> all{cells};
  while (all.size() < grids_of_reference && all.front() % 2 == 0 && grids.legal(all.front() / 2))
    all.insert(all.begin(), all.front() / 2);
  return all;
}

Case reference_case(const Grids& grids, int cells) {
  Case input = grids.on(cells);
  input.scene.solver.tolerance = reference_tolerance;
  input.scene.solver.max_cycles = std::max(input.scene.solver.max_cycles, reference_cycles);
  input.scene.threads = usable_cores();
  return input;
}

Reference find_reference(const Grids& grids, const std::vector<int>& cells, bool quiet) {
  std::vector<StudyCase> variants;
  for (const int one : cells)
    variants.push_back({.cells = one, .wedge = "upstream3", .evaluator = "fft", .cycles = "run"});
  if (!quiet) std::fprintf(stderr, "ehl: the reference, on %zu grids\n", cells.size());
  const std::vector<StudyPoint> solutions = measured(variants, 1, 1, quiet, [&](const StudyCase& variant) {
    return measure(reference_case(grids, variant.cells), variant);
  });
  const Reference reference = reference_of(solutions);
  if (reference.cells.size() < 2)
    throw core::SolverError("the reference needs second-order solutions with a residual of 1e-10 on two grids: " +
                            (solutions.back().reason.empty() ? "the deck has one grid only" : solutions.back().reason));
  return reference;
}

}  // namespace

int study(const Arguments& arguments) {
  const std::string& deck = arguments.operands[0];
  const bool quiet = arguments.has("quiet");
  const int threads = arguments.has("threads") ? requested_threads(arguments) : 1;
  const int jobs = whole_number(arguments, "jobs", 1, 1024);
  const int repeats = whole_number(arguments, "repeat", 3, 100);
  const std::string path = table_name(arguments);
  const Grids grids(arguments, threads);
  const Case input = grids.deck();
  const StudyHeader header{this_program(),
                           deck,
                           deck::load_text(deck),
                           input.title,
                           arguments.overrides(),
                           processor(),
                           utc_date(),
                           threads,
                           jobs,
                           repeats,
                           si_scales(input.physics),
                           input.files};
  if (input.transient) return study_in_time(arguments, header, path, input);
  if (arguments.has("rtol"))
    throw core::InputError("command line: --rtol is for runs in time, but the deck has no [transient] end_time");
  const StudyPlan plan = plan_of(arguments, grids, input);
  for (const int cells : plan.cells) grids.on(cells);  // finds errors of the deck before the computation begins
  const std::vector<StudyCase> variants = cases_of(plan, [&](int cells) { return grids.nodes(cells); });
  if (variants.empty())
    throw core::InputError("command line: --evaluators direct: no grid is small enough, the limit is 20000 nodes");
  const std::vector<int> finest = reference_grids(arguments, grids, plan.cells.back());
  results::check_files(header.inputs(), {{path, results::FileKind::table, arguments.has("overwrite")}});

  const Reference reference = find_reference(grids, finest, quiet);
  if (!quiet) std::fprintf(stderr, "ehl: %zu variants, %d times each\n", variants.size(), repeats);
  std::vector<StudyPoint> points = measured(variants, repeats, jobs, quiet, [&](const StudyCase& variant) {
    return measure(grids.on(variant.cells), variant);
  });
  judge(reference, points);
  write_table(path, study_csv(header, reference, points), arguments.has("overwrite"));
  print(study_report(header, reference, points) + "\ntable        " + path + "\n");
  const bool all = std::ranges::all_of(points, [](const StudyPoint& point) { return has_film(point); });
  return all ? solved : not_converged;
}

}  // namespace ehl::program
