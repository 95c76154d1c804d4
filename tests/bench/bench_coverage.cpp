// Are the error bars right? Default runs of the program's solver against the truth of tests/support/coverage.hpp:
// solutions with upstream3 on 1024 and 2048 cells; what is judged ends at 512. Prints Markdown.
//   bench_coverage [quick | coarse | POINT...]
//   quick: four contacts up to 256 cells, truth from 512 and 1024; coarse: the same with all of them
//   POINT: numbers of contacts from the list, from 1
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "support/coverage.hpp"

using namespace ehl;

namespace {

/// Those held back are in no test and in no table of reference values.
constexpr test::Point points[] = {
    {10, 20, 2.2e-8, 0.68, false},   {20, 10, 2.2e-8, 0.68, false},   {50, 10, 1.7e-8, 0.60, false},
    {100, 5, 2.2e-8, 0.68, false},   {200, 2, 2.2e-8, 0.68, false},   {200, 10, 2.2e-8, 0.68, false},
    {500, 20, 2.2e-8, 0.68, false},  {1000, 10, 2.2e-8, 0.68, false}, {1000, 15, 2.2e-8, 0.68, false},
    {2000, 10, 2.2e-8, 0.68, false}, {11, 4, 2.0e-8, 0.64, true},     {16, 17, 1.5e-8, 0.55, true},
    {26, 7, 2.0e-8, 0.64, true},     {42, 12, 1.5e-8, 0.55, true},    {85, 19, 2.0e-8, 0.64, true},
    {130, 3, 1.5e-8, 0.55, true},    {240, 9, 2.0e-8, 0.64, true},    {350, 14, 1.5e-8, 0.55, true},
    {450, 6, 2.0e-8, 0.64, true},    {620, 17, 1.5e-8, 0.55, true},   {850, 4, 2.0e-8, 0.64, true},
    {1200, 11, 1.5e-8, 0.55, true},  {1600, 18, 2.0e-8, 0.64, true},  {1900, 7, 1.5e-8, 0.55, true},
};
constexpr reynolds::Wedge wedges[] = {reynolds::Wedge::upstream1, reynolds::Wedge::upstream2,
                                      reynolds::Wedge::upstream3};
constexpr const char* names[] = {"upstream1", "upstream2", "upstream3, logmean_bounded"};
/// Of the solutions that tell what further cycles would have changed.
constexpr double residual_of_converged = 1e-8;
constexpr double algebraic_share = 0.1;

struct Task {
  std::vector<std::size_t> points;
  std::vector<int> cells;
  int coarse_truth;
  int fine_truth;
};

struct Row {
  const test::Point* point;
  reynolds::Wedge wedge;
  int n;
  test::Judged judged;
  double doubt;  ///< relative change of the truth between two pairs of grids; NaN where not known
};

/// What the default run left of the error that cycles can remove.
struct Algebraic {
  std::string name;
  const char* film;
  double algebraic;
  double discretization;
};

struct Result {
  std::vector<Row> rows;
  std::vector<Algebraic> algebraic;
  std::vector<std::string> without;  ///< runs that tell no error, or that did not converge
  std::size_t runs = 0;
};

struct Truth {
  test::Film film;
  test::Film doubt;
};

/// The doubt: how far the pair of grids before would have been off. It takes no part in the truth.
Truth truth_of(const test::Point& point, const Task& task) {
  const auto row = [&](int n) {
    return test::solved(test::scene_of(point, reynolds::Wedge::upstream3, n), test::residual_of_truth);
  };
  const steady::LevelRow coarse = row(task.coarse_truth);
  const test::Film film = test::extrapolated(coarse, row(task.fine_truth));
  const test::Film before = test::extrapolated(row(task.coarse_truth / 2), coarse);
  return {film, {std::abs(before.Hc / film.Hc - 1.0), std::abs(before.Hm / film.Hm - 1.0)}};
}

void judge_cycles(const test::Point& point, reynolds::Wedge wedge, int n, const steady::LevelRow& left,
                  const test::Film& truth, Result& result) {
  const steady::LevelRow exact = test::solved(test::scene_of(point, wedge, n), residual_of_converged);
  const auto judge = [&](const char* film, double value, double converged, double right) {
    const double algebraic = std::abs(value / converged - 1.0);
    const double discretization = std::abs(right / converged - 1.0);
    if (algebraic > algebraic_share * discretization)
      result.algebraic.push_back({test::name_of(point, wedge, n), film, algebraic, discretization});
  };
  judge("Hc", left.Hc, exact.Hc, truth.Hc);
  judge("Hm", left.Hm, exact.Hm, truth.Hm);
}

void judge_run(const test::Point& point, reynolds::Wedge wedge, int n, const Truth& truth, Result& result) {
  const std::string name = test::name_of(point, wedge, n);
  ++result.runs;
  try {
    const steady::Solution solution = steady::solve(test::scene_of(point, wedge, n));
    if (!solution.converged) {
      result.without.push_back(name + ": not converged, " + solution.failed_check);
      return;
    }
    if (std::isnan(solution.error_bars.Hc.total())) {
      result.without.push_back(name + ": no error told");
      return;
    }
    for (const test::Judged& judged : test::judged(solution, truth.film)) {
      const double doubt = judged.name.starts_with("Hc") ? truth.doubt.Hc : truth.doubt.Hm;
      if (!std::isnan(judged.estimate)) result.rows.push_back({&point, wedge, n, judged, doubt});
    }
    judge_cycles(point, wedge, n, solution.levels.back(), truth.film, result);
  } catch (const std::exception& error) {
    result.without.push_back(name + ": " + error.what());
  }
}

struct Share {
  std::size_t cases = 0;
  std::size_t within = 0;
  double median = 0.0;  ///< of estimate over error
};

Share share_of(const Result& result, const std::function<bool(const Row&)>& counts) {
  Share share;
  std::vector<double> ratios;
  for (const Row& row : result.rows) {
    if (!counts(row)) continue;
    ++share.cases;
    if (row.judged.within()) ++share.within;
    ratios.push_back(row.judged.ratio());
  }
  std::sort(ratios.begin(), ratios.end());
  if (!ratios.empty()) share.median = 0.5 * (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]);
  return share;
}

void print_shares(const Result& result) {
  std::puts("| | wedge | within | % | estimate/error, median | held back: within | % | median |");
  std::puts("|---|---|---|---|---|---|---|---|");
  const auto percent = [](const Share& share) {
    return share.cases == 0 ? 0.0 : 100.0 * static_cast<double>(share.within) / static_cast<double>(share.cases);
  };
  for (const char* name : {"Hc", "Hm, node", "Hm, fitted", "Hc, extrapolated", "Hm, extrapolated"})
    for (const reynolds::Wedge wedge : wedges) {
      const auto counts = [&](const Row& row) { return row.judged.name == name && row.wedge == wedge; };
      const Share all = share_of(result, counts);
      const Share held = share_of(result, [&](const Row& row) { return counts(row) && row.point->held_back; });
      std::printf("| %s | %s | %zu of %zu | %.0f | %.1f | %zu of %zu | %.0f | %.1f |\n", name,
                  names[static_cast<std::size_t>(wedge)], all.within, all.cases, percent(all), all.median, held.within,
                  held.cases, percent(held), held.median);
    }
}

void print_levels(const Result& result, const std::vector<int>& cells) {
  std::puts("\n| wedge | cells | Hc within | median | Hm, node within | median |\n|---|---|---|---|---|---|");
  for (const reynolds::Wedge wedge : wedges)
    for (const int n : cells) {
      const auto share = [&](const char* name) {
        return share_of(result,
                        [&](const Row& row) { return row.n == n && row.wedge == wedge && row.judged.name == name; });
      };
      const Share Hc = share("Hc");
      const Share Hm = share("Hm, node");
      if (Hc.cases > 0)
        std::printf("| %s | %d | %zu of %zu | %.1f | %zu of %zu | %.1f |\n", names[static_cast<std::size_t>(wedge)], n,
                    Hc.within, Hc.cases, Hc.median, Hm.within, Hm.cases, Hm.median);
    }
}

void print_misses(const Result& result) {
  std::puts("\nMisses; doubt: by how much the truth moves with the pair of grids that it is made of.\n");
  std::puts("| case | film | estimate [%] | true error [%] | ratio | doubt [%] |\n|---|---|---|---|---|---|");
  for (const Row& row : result.rows)
    if (!row.judged.within())
      std::printf("| %s%s | %.*s | %.3g | %.3g | %.2f | %.1g |\n", test::name_of(*row.point, row.wedge, row.n).c_str(),
                  row.point->held_back ? ", held back" : "", static_cast<int>(row.judged.name.size()),
                  row.judged.name.data(), 100.0 * row.judged.estimate, 100.0 * row.judged.error, row.judged.ratio(),
                  100.0 * row.doubt);
  std::puts("\nAlgebraic error of the default run above a tenth of the discretization error:\n");
  std::puts("| case | film | algebraic [%] | discretization [%] | share |\n|---|---|---|---|---|");
  for (const Algebraic& one : result.algebraic)
    std::printf("| %s | %s | %.2g | %.2g | %.2f |\n", one.name.c_str(), one.film, 100.0 * one.algebraic,
                100.0 * one.discretization, one.algebraic / one.discretization);
  std::puts("\nWithout an error bar:\n");
  for (const std::string& text : result.without) std::printf("- %s\n", text.c_str());
}

Task task_of(int argc, char** argv) {
  Task task{{}, {64, 128, 256, 512}, 1024, 2048};
  const auto asked = [&](const char* word) { return argc > 1 && !std::strcmp(argv[1], word); };
  if (asked("quick") || asked("coarse")) task = {{1, 4, 12, 17}, {64, 128, 256}, 512, 1024};
  if (asked("quick")) return task;
  task.points.clear();
  for (int k = 1; k < argc && !asked("coarse"); ++k)
    task.points.push_back(static_cast<std::size_t>(std::atoi(argv[k]) - 1));
  if (task.points.empty())
    for (std::size_t k = 0; k < std::size(points); ++k) task.points.push_back(k);
  return task;
}

}  // namespace

int main(int argc, char** argv) {
  const Task task = task_of(argc, argv);
  Result result;
  for (const std::size_t k : task.points) {
    if (k >= std::size(points)) continue;
    const test::Point& point = points[k];
    std::fprintf(stderr, "%zu: M = %g, L = %g\n", k + 1, point.M, point.L);
    try {
      const Truth truth = truth_of(point, task);
      std::fprintf(stderr, "   truth Hc = %.8g (moved by %.1e), Hm = %.8g (%.1e)\n", truth.film.Hc, truth.doubt.Hc,
                   truth.film.Hm, truth.doubt.Hm);
      for (const reynolds::Wedge wedge : wedges)
        for (const int n : task.cells) judge_run(point, wedge, n, truth, result);
    } catch (const std::exception& error) {
      result.without.push_back("M = " + std::to_string(point.M) + ": no truth, " + error.what());
    }
  }
  std::printf("%zu contacts, %zu runs, truth from %d and %d cells\n\n", task.points.size(), result.runs,
              task.coarse_truth, task.fine_truth);
  print_shares(result);
  print_levels(result, task.cells);
  print_misses(result);
  return 0;
}
