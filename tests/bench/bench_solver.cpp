// Cost of a solution: seconds against mesh, threads and film evaluators, shares of the parts, and the paper's two
// tables. Prints Markdown; seconds are the least of several runs.
//   bench_solver [cost | film | paper]...
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>

#include "contact/groups.hpp"
#include "steady/solve.hpp"

using namespace ehl;

namespace {

constexpr double alpha_stated = 1.7e-8;
constexpr double alpha_table1 = 2.2e-8;
/// The L that belongs to Table 1: alpha = 2.2e-8 1/Pa at the stated p_h.
constexpr double L_table1 = 10.0 * alpha_table1 / alpha_stated;

steady::Scene scene(double L, double alpha, int n, reynolds::Wedge wedge, int threads) {
  const contact::Groups groups = contact::from_moes(50.0, L);
  const double p_h = groups.alpha_bar / alpha;
  steady::Scene result;
  result.contact = steady::scales_of(50.0, L);
  result.lambda = groups.lambda;
  result.viscosity = rheology::make_roelands(alpha, rheology::roelands_p0, 0.6, p_h);
  result.density = rheology::make_dowson_higginson(p_h);
  result.grid = {n, n, -4.5, 1.5, -3.0, 3.0};
  result.wedge = wedge;
  result.threads = threads;
  return result;
}

steady::Solution fastest(const steady::Scene& scene, int runs) {
  steady::Solution best = steady::solve(scene);
  for (int run = 1; run < runs; ++run) {
    steady::Solution next = steady::solve(scene);
    if (next.seconds < best.seconds) best = std::move(next);
  }
  return best;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void cost() {
  std::puts("M = 50, L = 10, upstream2, default cycles, film by MLMI\n");
  std::puts("| nodes | 1 thread [s] | ratio | 2 threads [s] | 1 thread / 2 threads | work units | peak memory [MB] |");
  std::puts("|---|---|---|---|---|---|---|");
  double before = 0.0;
  steady::Solution at_512;
  for (const int n : {128, 256, 512, 1024}) {
    const int runs = n > 512 ? 3 : 5;
    steady::Solution one = fastest(scene(10.0, alpha_stated, n, reynolds::Wedge::upstream2, 1), runs);
    const double memory = peak_megabytes();
    const steady::Solution two = fastest(scene(10.0, alpha_stated, n, reynolds::Wedge::upstream2, 2), runs);
    std::printf("| %d x %d | %.3f | %s | %.3f | %.2f | %.1f | %.0f |\n", n + 1, n + 1, one.seconds,
                before > 0.0 ? std::to_string(one.seconds / before).substr(0, 4).c_str() : "-", two.seconds,
                one.seconds / two.seconds, one.levels.back().work_units, memory);
    before = one.seconds;
    if (n == 512) at_512 = std::move(one);
  }
  std::puts("\nShares of the time at 513 x 513, one thread\n");
  for (std::size_t part = 0; part < static_cast<std::size_t>(core::Part::count); ++part)
    std::printf("- %s: %.0f %%\n", core::name(static_cast<core::Part>(part)),
                100.0 * at_512.times.seconds[part] / at_512.seconds);
}

void film() {
  std::puts("Whole solution, M = 50, L = 10, upstream2, one thread\n");
  std::puts("| nodes | film by | seconds | of MLMI | Hc - Hc(direct or FFT), relative |");
  std::puts("|---|---|---|---|---|");
  for (const int n : {64, 128, 256, 512}) {
    double exact = 0.0;
    double mlmi_seconds = 0.0;
    steady::Scene input = scene(10.0, alpha_stated, n, reynolds::Wedge::upstream2, 1);
    input.deformation.method = mlmi::Method::fft;
    exact = steady::solve(input).levels.back().Hc;
    for (const mlmi::Method method : {mlmi::Method::mlmi, mlmi::Method::fft, mlmi::Method::direct}) {
      if (method == mlmi::Method::direct && n > 256) continue;  // takes minutes
      input.deformation.method = method;
      const steady::Solution solution = fastest(input, method == mlmi::Method::direct ? 1 : 3);
      if (method == mlmi::Method::mlmi) mlmi_seconds = solution.seconds;
      const char* name = method == mlmi::Method::mlmi ? "MLMI" : method == mlmi::Method::fft ? "FFT" : "direct sum";
      std::printf("| %d x %d | %s | %.3f | %.2f | %.0e |\n", n + 1, n + 1, name, solution.seconds,
                  solution.seconds / mlmi_seconds, solution.levels.back().Hc / exact - 1.0);
    }
  }
}

void paper() {
  const double paper_Hm[] = {8.868e-2, 1.525e-1, 1.668e-1, 1.650e-1, 1.624e-1, 1.609e-1};
  const double paper_Hc[] = {6.875e-1, 1.967e-1, 2.667e-1, 2.686e-1, 2.649e-1, 2.620e-1};
  std::puts("Table 1: first-order wedge, M = 50, converged on every grid\n");
  std::puts("| nodes | Hm paper | Hc paper | Hm stated set | Hc stated set | Hm alpha 2.2e-8 | Hc alpha 2.2e-8 |");
  std::puts("|---|---|---|---|---|---|---|");
  for (int k = 0; k < 6; ++k) {
    const int n = 16 << k;
    steady::LevelRow rows[2];
    for (const int set : {0, 1}) {
      steady::Scene input =
          scene(set == 0 ? 10.0 : L_table1, set == 0 ? alpha_stated : alpha_table1, n, reynolds::Wedge::upstream1, 1);
      input.solver.tolerance = 1e-7;
      rows[set] = steady::solve(input).levels.back();
    }
    std::printf("| %d x %d | %.4f | %.4f | %.4f | %.4f | %.4f | %.4f |\n", n + 1, n + 1, paper_Hm[k], paper_Hc[k],
                rows[0].Hm, rows[0].Hc, rows[1].Hm, rows[1].Hc);
  }
  const char* paper_V[] = {"9.5", "22.1", "1:23", "4:51", "17:35", "1:07:53"};
  const char* paper_W[] = {"9.5", "40.3", "2:44", "10:40", "41:27", "2:41:25"};
  std::puts("\nTable 2: seconds of the whole full multigrid, first-order wedge, stated set, one thread\n");
  std::puts("| nodes | 2 V(2,1) paper | 2 W(2,1) paper | 2 V(2,1) [s] | ratio | 2 W(2,1) [s] | ratio |");
  std::puts("|---|---|---|---|---|---|---|");
  double before[2] = {0.0, 0.0};
  for (int k = 2; k < 6; ++k) {
    const int n = 16 << k;
    double seconds[2];
    for (const int w : {0, 1}) {
      steady::Scene input = scene(10.0, alpha_stated, n, reynolds::Wedge::upstream1, 1);
      input.solver.cycle = w == 0 ? multigrid::Cycle::V : multigrid::Cycle::W;
      input.solver.post = 1;
      seconds[w] = fastest(input, 5).seconds;
    }
    const auto ratio = [&](int w) {
      return before[w] > 0.0 ? std::to_string(seconds[w] / before[w]).substr(0, 4) : std::string("-");
    };
    std::printf("| %d x %d | %s | %s | %.4f | %s | %.4f | %s |\n", n + 1, n + 1, paper_V[k], paper_W[k], seconds[0],
                ratio(0).c_str(), seconds[1], ratio(1).c_str());
    before[0] = seconds[0];
    before[1] = seconds[1];
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto asked = [&](const char* name) {
    return argc == 1 || std::any_of(argv + 1, argv + argc, [&](const char* word) { return !std::strcmp(word, name); });
  };
  if (asked("cost")) cost();
  if (asked("film")) film();
  if (asked("paper")) paper();
  return 0;
}
