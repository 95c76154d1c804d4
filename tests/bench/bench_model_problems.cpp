// The sequence of model problems in the paper as tables: the prediction of the local Fourier analysis and the measured
// convergence. Prints smoothing_analysis.csv and model_problem_*.csv.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "contact/groups.hpp"
#include "steady/solve.hpp"
#include "support/local_fourier_analysis.hpp"
#include "support/model_problem.hpp"

using namespace ehl;
using namespace ehl::tests;
using multigrid::Cycle;
using reynolds::Wedge;

namespace {

constexpr double ladder[] = {0.0, 0.01, 0.03, 0.1, 0.3, 0.6, 1.0, 1.2, 1.6, 2.2, 3.0, 5.0, 10.0, 30.0, 100.0, 1e6};
constexpr Wedge wedges[] = {Wedge::upstream1, Wedge::upstream2};
int number(Wedge wedge) { return wedge == Wedge::upstream1 ? 1 : 2; }

void print_analysis(Wedge wedge) {
  const LocalFourierAnalysis analysis;
  const double weight = multigrid::RelaxationParameters{}.weight_distributed;
  const LineRelaxation relaxations[] = {papers_distributive,
                                        papers_gauss_seidel,
                                        {true, Ordering::two_colours, weight},
                                        {false, Ordering::two_colours, 1.0}};
  std::printf("\n# local Fourier analysis, upstream%d: smoothing rate, factor of smooth errors, two grids (2,1)\n",
              number(wedge));
  std::printf("# %-7s  %-23s  %-23s  %-23s  %-23s\n", "e", "paper's distributive", "paper's Gauss-Seidel",
              "distributive, 2 colours", "Gauss-Seidel, 2 colours");
  for (const double e : ladder) {
    std::printf("%9g", e);
    for (const LineRelaxation& relaxation : relaxations) {
      const Analysis a = analysis.analyse(relaxation, e, wedge);
      std::printf("  %6.3f %7.3f %8.3f", a.smoothing, a.low, a.two_grid);
    }
    std::printf("\n");
  }
}

double measured(double e, Wedge wedge, Cycle cycle, double crossover) {
  ModelProblem problem = constant_epsilon(e, 128, wedge, cycle);
  problem.relaxation.crossover = crossover;
  return late_factor(error_factors(problem, 14), 6);
}

void print_constant_epsilon(Wedge wedge) {
  const double crossovers[] = {0.6, 1.1, multigrid::RelaxationParameters{}.crossover, 2.0};
  std::printf("\n# constant epsilon, upstream%d, n = 128 .. 8: error left by a W(2,1) and a V(2,1) cycle\n",
              number(wedge));
  std::printf("# crossover");
  for (const double crossover : crossovers) std::printf("  %7g (W, V)", crossover);
  std::printf("\n");
  for (const double e : ladder) {
    std::printf("%11g", e);
    for (const double crossover : crossovers)
      std::printf("  %6.3f %7.3f", measured(e, wedge, Cycle::W, crossover), measured(e, wedge, Cycle::V, crossover));
    std::printf("\n");
    std::fflush(stdout);
  }
}

void print_varying_epsilon() {
  std::printf("\n# eq. (20): error left by a cycle, n .. 8: geometric mean of cycles 1-4, of 9-16, largest of 9-16\n");
  std::printf("# %4s %6s  %-21s  %-21s\n", "n", "wedge", "W(2,1)", "V(2,1)");
  for (const Wedge wedge : wedges)
    for (const int n : {64, 128, 256, 512}) {
      std::printf("%6d %6d", n, number(wedge));
      for (const Cycle cycle : {Cycle::W, Cycle::V}) {
        const std::vector<double> factors = error_factors(papers_epsilon(n, wedge, cycle), 16);
        std::printf("  %6.3f %6.3f %6.3f", late_factor({factors.begin(), factors.begin() + 4}, 4),
                    late_factor(factors, 8), *std::max_element(factors.begin() + 8, factors.end()));
      }
      std::printf("\n");
      std::fflush(stdout);
    }
}

void print_full_problem(Wedge wedge, Cycle cycle) {
  steady::Scene scene;
  scene.contact = steady::scales_of(50.0, 10.0);
  const contact::Groups groups = contact::from_moes(scene.contact.M, scene.contact.L);
  const double alpha = 1.7e-8;
  const double p_h = groups.alpha_bar / alpha;
  scene.lambda = groups.lambda;
  scene.viscosity = rheology::make_roelands(alpha, rheology::roelands_p0, 0.6, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  scene.grid = {256, 256, -4.5, 1.5, -3.0, 3.0};
  scene.wedge = wedge;
  scene.deformation.method = mlmi::Method::fft;
  scene.solver.cycle = cycle;
  scene.solver.tolerance = 1e-10;
  const steady::Solution solution = steady::solve(scene);
  std::printf("upstream%d %c(2,1):", number(wedge), cycle == Cycle::W ? 'W' : 'V');
  const int finest = solution.levels.back().level;
  double before = 0.0;
  for (const steady::CycleRow& row : solution.history) {
    if (row.level != finest) continue;
    if (before > 0.0) std::printf(" %.3f", row.residual / before);
    before = row.residual;
  }
  std::printf("  down to %.1e, %s\n", before, solution.converged ? "converged" : solution.failed_check.c_str());
}

}  // namespace

int main() {
  for (const Wedge wedge : wedges) print_analysis(wedge);
  for (const Wedge wedge : wedges) print_constant_epsilon(wedge);
  print_varying_epsilon();
  std::printf(
      "\n# the full problem, M = 50, L = 10, 256 x 256 cells: residual left by each cycle on the finest grid\n");
  for (const Wedge wedge : wedges)
    for (const Cycle cycle : {Cycle::W, Cycle::V}) print_full_problem(wedge, cycle);
}
