// Cost of a line system by elimination and by decimation, and its share of a relaxation sweep: the tables
// line_solvers.csv and line_solvers_in_sweep.csv.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "core/timer.hpp"
#include "line_solvers/decimation.hpp"
#include "line_solvers/elimination.hpp"
#include "multigrid/cycle.hpp"
#include "multigrid/relaxation.hpp"
#include "support/random.hpp"
#include "unit/multigrid/circular_contact.hpp"

namespace multigrid = ehl::multigrid;
using ehl::core::Field;
using ehl::core::Lanes;
using ehl::core::lanes;
using ehl::line_solvers::BandRow;
using ehl::line_solvers::Decimation;
using ehl::line_solvers::Elimination;

namespace {

// The rows come from a ring that stays in the first-level cache, as do rows that are assembled on the fly.
constexpr std::size_t ring = 32;

template <int reach>
std::vector<BandRow<reach>> rows() {
  ehl::tests::Random random(1);
  std::vector<BandRow<reach>> all(ring);
  for (BandRow<reach>& row : all)
    for (int lane = 0; lane < lanes; ++lane) {
      for (Lanes& a : row.a) a[lane] = random.between(-1.0, 1.0);
      row.a[BandRow<reach>::lower][lane] = 10.0;
      row.rhs[lane] = random.between(-1.0, 1.0);
    }
  return all;
}

/// The best time of one call, in ns per point of one line; a call solves a batch of lines.
template <class Solve>
double ns_per_point(int points, Solve solve) {
  double best = 1e9;
  for (double spent = 0.0; spent < 0.1;) {
    const double start = ehl::core::now();
    constexpr int calls = 10;
    for (int k = 0; k < calls; ++k) solve();
    const double seconds = ehl::core::now() - start;
    spent += seconds;
    best = std::min(best, seconds / calls);
  }
  return 1e9 * best / (static_cast<double>(points) * lanes);
}

struct Costs {
  double elimination, decimation;
};

template <int reach>
Costs costs(int points) {
  const auto system = rows<reach>();
  const auto row = [&](int i) -> const BandRow<reach>& { return system[static_cast<std::size_t>(i) % ring]; };
  std::vector<Lanes> x(static_cast<std::size_t>(points) + 1);
  std::vector<typename Elimination<reach>::Factors> work(x.size());
  Decimation<reach> decimation(points);
  return {
      ns_per_point(points,
                   [&] {
                     Elimination<reach> elimination(work.data());
                     for (int i = 1; i <= points; ++i) elimination.push(row(i));
                     elimination.back_substitute([&](int i, Lanes delta) { x[static_cast<std::size_t>(i)] = delta; });
                   }),
      ns_per_point(points, [&] {
        for (int i = 1; i <= points; ++i) decimation.set(i, row(i));
        decimation.solve();
        for (int i = 1; i <= points; ++i) x[static_cast<std::size_t>(i)] = decimation.delta(i);
      })};
}

/// The best time of a sweep [ns per node], and of its line relaxation alone: coefficients,
/// assembly, solution, application.
struct SweepCost {
  double sweep = 1e9, lines = 1e9;
};

/// Repeats sweeps from the same pressure.
SweepCost sweep_cost(multigrid::Hierarchy& hierarchy, const multigrid::RelaxationParameters& how, const Field& P) {
  multigrid::Level& level = hierarchy.finest();
  SweepCost best;
  const double nodes = static_cast<double>(level.grid.nodes_x()) * level.grid.nodes_y();
  for (double spent = 0.0; spent < 0.5;) {
    level.P = P;
    multigrid::update_film(hierarchy, level);
    hierarchy.times = {};
    const double start = ehl::core::now();
    multigrid::relax(hierarchy, level, how);
    const double seconds = ehl::core::now() - start;
    spent += seconds;
    best.sweep = std::min(best.sweep, 1e9 * seconds / nodes);
    best.lines = std::min(best.lines, 1e9 * hierarchy.times[ehl::core::Part::line_solve] / nodes);
  }
  return best;
}

multigrid::Hierarchy contact(int n, const multigrid::Parameters& parameters) {
  return multigrid::make_hierarchy(ehl::tests::circular_contact(50, 10, ehl::reynolds::Wedge::upstream2), parameters,
                                   {}, {n, n, -4.5, 1.5, -3, 3}, 1);
}

/// A full multigrid solution with two cycles per level.
multigrid::Hierarchy solved(int n) {
  multigrid::Hierarchy hierarchy = contact(n, {});
  std::size_t start = 0;
  while (hierarchy.levels[start].grid.nx < 64) ++start;
  multigrid::start_from_hertz(hierarchy, start, -0.69, 20);
  for (std::size_t l = start; l < hierarchy.levels.size(); ++l) {
    if (l > start) multigrid::start_from_coarser(hierarchy, l);
    for (int cycle = 0; cycle < 2; ++cycle) multigrid::fas_cycle(hierarchy, l);
  }
  return hierarchy;
}

void print_sweeps() {
  std::printf("\n# a relaxation sweep at M = 50, L = 10, mlmi, one thread [ns per node]\n");
  std::printf("#   n  reach  line solver    sweep  line relaxation  line systems alone  share of the sweep\n");
  for (const int n : {128, 256, 512, 1024}) {
    const multigrid::Hierarchy solution = solved(n);
    multigrid::Parameters parameters;
    for (const int reach : {1, 2, 3}) {
      const Costs alone = reach == 1 ? costs<1>(n - 1) : reach == 2 ? costs<2>(n - 1) : costs<3>(n - 1);
      parameters.relaxation.reach = reach;
      multigrid::Hierarchy hierarchy = contact(n, parameters);
      hierarchy.H00 = solution.H00;
      for (const multigrid::LineSolver solver :
           {multigrid::LineSolver::elimination, multigrid::LineSolver::decimation}) {
        parameters.relaxation.line_solver = solver;
        for (multigrid::Level& level : hierarchy.levels)
          level.thread_work.assign(
              1, multigrid::make_thread_work(level.grid, hierarchy.problem.film, parameters.relaxation));
        const bool eliminates = solver == multigrid::LineSolver::elimination;
        const SweepCost cost = sweep_cost(hierarchy, parameters.relaxation, solution.levels.back().P);
        const double band = eliminates ? alone.elimination : alone.decimation;
        std::printf("%5d  %5d  %-12s %7.1f  %15.1f  %18.2f  %17.0f%%\n", n, reach,
                    eliminates ? "elimination" : "decimation", cost.sweep, cost.lines, band, 100.0 * band / cost.sweep);
        std::fflush(stdout);
      }
    }
  }
}

}  // namespace

int main() {
  std::printf("# ns per point of one line; a batch of lines at once, one thread\n");
  std::printf("# points     elimination, reach 1     2     3    decimation, reach 1     2     3\n");
  for (int points = 64; points <= 2048; points *= 2) {
    const Costs one = costs<1>(points), two = costs<2>(points), three = costs<3>(points);
    std::printf("%8d  %23.2f %5.2f %5.2f  %21.2f %5.2f %5.2f\n", points, one.elimination, two.elimination,
                three.elimination, one.decimation, two.decimation, three.decimation);
  }
  print_sweeps();
}
