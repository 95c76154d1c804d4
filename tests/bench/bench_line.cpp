// Cost of a steady line contact: milliseconds of one thread for the whole solution and for its parts, the least of many
// runs in one process, and the first run. Prints CSV.
//   bench_line [--runs N] [--cells N] [M L]...
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "steady/solve.hpp"
#include "support/roelands_scene.hpp"

using namespace ehl;

namespace {

double cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// The least of all runs for each number separately: on a busy machine no single run has the least of all.
struct Least {
  double value = std::numeric_limits<double>::infinity();
  void meet(double other) { value = std::min(value, other); }
};

struct Cost {
  Least whole, set_up, coarser, finest;  ///< the first in processor time, its parts in wall-clock time
  double first = 0.0;                    ///< the first run
  steady::Solution solution;
};

Cost cost_of(const steady::Scene& scene, int runs) {
  Cost cost;
  for (int run = 0; run < runs; ++run) {
    const double began = cpu_milliseconds();
    steady::Solution solution = steady::solve(scene);
    const double took = cpu_milliseconds() - began;
    if (run == 0) cost.first = took;
    cost.whole.meet(took);
    cost.set_up.meet(1e3 * solution.times[core::Part::setup]);
    double below = 0.0;
    for (std::size_t l = 0; l + 1 < solution.levels.size(); ++l) below += 1e3 * solution.levels[l].seconds;
    cost.coarser.meet(below);
    cost.finest.meet(1e3 * solution.levels.back().seconds);
    cost.solution = std::move(solution);
  }
  return cost;
}

void print(double M, double L, int cells, int runs) {
  const Cost cost = cost_of(tests::open_line(M, L, cells), runs);
  const steady::Solution& solution = cost.solution;
  const steady::LevelRow& last = solution.levels.back();
  std::printf("%g,%g,%d,%.2f,%.2f,%.2f,%.2f,%.2f,%.1f,%.10f,%.10f,%.2e,%.1e,%s\n", M, L, cells, cost.whole.value,
              cost.first, cost.set_up.value, cost.coarser.value, cost.finest.value, last.work_units, last.Hc, last.Hm,
              solution.error_bars.Hc.discretization, solution.error_bars.Hc.algebraic,
              solution.converged ? solution.method.c_str() : "not converged");
}

}  // namespace

int main(int argc, char** argv) {
  int runs = 50;
  int cells = 1024;
  std::vector<double> loads;
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    if (word == "--runs" && k + 1 < argc)
      runs = std::atoi(argv[++k]);
    else if (word == "--cells" && k + 1 < argc)
      cells = std::atoi(argv[++k]);
    else
      loads.push_back(std::atof(argv[k]));
  }
  if (loads.size() < 2) loads = {2, 0, 5, 5, 20, 5, 50, 10, 200, 10, 1000, 10};
  std::puts(
      "M,L,cells,whole [ms],first run [ms],set-up [ms],coarser grids [ms],finest [ms],work units,Hc,Hm,error,algebraic,"
      "method");
  for (std::size_t k = 0; k + 1 < loads.size(); k += 2) print(loads[k], loads[k + 1], cells, runs);
  return 0;
}
