// What a steady line contact costs: milliseconds of one thread, whole and by its parts, the least of many runs in one
// process; the first run beside them. Prints CSV.
//   bench_line [--runs N] [--cells N] [M L]...
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "contact/groups.hpp"
#include "steady/domain_error.hpp"
#include "steady/solve.hpp"

using namespace ehl;

namespace {

/// As a deck with M, L and Roelands' oil of alpha = 2.2e-8 1/Pa, z = 0.68 has it where it leaves the rest open.
steady::Scene scene_of(double M, double L, int cells, bool errors) {
  constexpr double alpha = 2.2e-8;
  steady::Scene scene;
  scene.shape = contact::line_contact();
  const contact::Groups groups = contact::from_moes(M, L, scene.shape);
  scene.M = M;
  scene.L = L;
  scene.lambda = groups.lambda;
  const double p_h = groups.alpha_bar / alpha;
  if (L > 0.0) scene.viscosity = rheology::make_roelands(alpha, rheology::roelands_p0, 0.68, p_h);
  if (L > 0.0) scene.density = rheology::make_dowson_higginson(p_h);
  const double X_b = steady::chosen_outlet(M, L, scene.shape, steady::error_of_closed_domain);
  scene.grid =
      core::line_grid(cells, steady::chosen_inlet(M, L, X_b, scene.shape, steady::error_of_closed_domain), X_b);
  scene.far_field = true;
  scene.wedge = reynolds::Wedge::upstream3;
  scene.face = reynolds::Face::logmean_bounded;
  scene.adjoint_errors = errors;
  if (const char* c = std::getenv("CYC")) scene.multigrid.cycle = c[0]=='V'?fmg::Cycle::V:c[0]=='W'?fmg::Cycle::W:fmg::Cycle::F;
  if (const char* c = std::getenv("PRE")) scene.multigrid.pre = std::atoi(c);
  if (const char* c = std::getenv("POST")) scene.multigrid.post = std::atoi(c);
  if (const char* c = std::getenv("CYCLES")) scene.multigrid.cycles = std::atoi(c);
  if (const char* c = std::getenv("CW")) scene.multigrid.coarsest_sweeps = std::atoi(c);
  if (const char* c = std::getenv("CC")) scene.multigrid.coarsest_cells = std::atoi(c);

  return scene;
}

double cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Cost {
  double first = 0.0;  ///< run
  double least = std::numeric_limits<double>::infinity();
  steady::Solution solution;  ///< of the least
};

Cost cost_of(const steady::Scene& scene, int runs) {
  Cost cost;
  for (int run = 0; run < runs; ++run) {
    const double began = cpu_milliseconds();
    steady::Solution solution = steady::solve(scene);
    const double took = cpu_milliseconds() - began;
    if (run == 0) cost.first = took;
    if (took >= cost.least) continue;
    cost.least = took;
    cost.solution = std::move(solution);
  }
  return cost;
}

void print(double M, double L, int cells, int runs) {
  const Cost whole = cost_of(scene_of(M, L, cells, true), runs);
  const Cost plain = cost_of(scene_of(M, L, cells, false), runs);
  const steady::LevelRow& last = whole.solution.levels.back();
  double below = 0.0;
  for (const steady::LevelRow& row : whole.solution.levels) below += row.seconds;
  below -= last.seconds;
  if (std::getenv("LEV")) {
  for (const auto& row : plain.solution.levels) std::printf("   %d: cycles %d wu %.1f ms %.2f res %.1e Hc %.8f eH %.1e eHm %.1e\n", row.nx, row.cycles, row.work_units, 1e3*row.seconds, row.residual, row.Hc,row.error_Hc,row.error_Hm);
  for (std::size_t p = 0; p < static_cast<std::size_t>(core::Part::count); ++p) std::printf("  %s %.3f", core::name(static_cast<core::Part>(p)), 1e3*plain.solution.times.seconds[p]);
  std::puts(""); }
  std::printf("%g,%g,%d,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.1f,%.10f,%.10f,%.2e,%.1e,%s\n", M, L, cells, whole.least,
              plain.least, whole.first, 1e3 * whole.solution.times[core::Part::setup], 1e3 * below, 1e3 * last.seconds,
              1e3 * whole.solution.times[core::Part::errors], last.work_units, last.Hc, last.Hm,
              whole.solution.error_bars.Hc.discretization, whole.solution.error_bars.Hc.algebraic,
              whole.solution.converged ? whole.solution.method.c_str() : "not converged");
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
      "M,L,cells,whole [ms],without weights [ms],first run [ms],set-up [ms],coarser grids [ms],finest [ms],"
      "weights [ms],work units,Hc,Hm,error,algebraic,method");
  for (std::size_t k = 0; k + 1 < loads.size(); k += 2) print(loads[k], loads[k + 1], cells, runs);
  return 0;
}
