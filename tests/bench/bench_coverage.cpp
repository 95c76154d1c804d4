// Counts how many error bars are right. Runs with the default settings of a deck (upstream3, closed far field, adjoint
// errors) on 128 to 512 cells are compared with solutions on 512 and 1024 cells of the same domain
// (tests/support/coverage.hpp), with the same cells converged to rounding, and with a domain of twice the size. Prints
// error_bars.csv, then error_bars_missed.csv.
//   bench_coverage [listed | random]
//   listed: 24 contacts, which were used to calibrate the bars (with 90 random ones of the seeds
//   20261122, 777001, 777002);
//   random: 30 contacts of a seed that was not used in the calibration
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "steady/resolution.hpp"
#include "support/coverage.hpp"
#include "support/random.hpp"

using namespace ehl;

namespace {

constexpr test::Point listed[] = {
    {10, 20, 2.2e-8, 0.68, false},   {20, 10, 2.2e-8, 0.68, false},   {50, 10, 1.7e-8, 0.60, false},
    {100, 5, 2.2e-8, 0.68, false},   {200, 2, 2.2e-8, 0.68, false},   {200, 10, 2.2e-8, 0.68, false},
    {500, 20, 2.2e-8, 0.68, false},  {1000, 10, 2.2e-8, 0.68, false}, {1000, 15, 2.2e-8, 0.68, false},
    {2000, 10, 2.2e-8, 0.68, false}, {11, 4, 2.0e-8, 0.64, false},    {16, 17, 1.5e-8, 0.55, false},
    {26, 7, 2.0e-8, 0.64, false},    {42, 12, 1.5e-8, 0.55, false},   {85, 19, 2.0e-8, 0.64, false},
    {130, 3, 1.5e-8, 0.55, false},   {240, 9, 2.0e-8, 0.64, false},   {350, 14, 1.5e-8, 0.55, false},
    {450, 6, 2.0e-8, 0.64, false},   {620, 17, 1.5e-8, 0.55, false},  {850, 4, 2.0e-8, 0.64, false},
    {1200, 11, 1.5e-8, 0.55, false}, {1600, 18, 2.0e-8, 0.64, false}, {1900, 7, 1.5e-8, 0.55, false},
};
constexpr std::uint64_t seed = 777003;
constexpr int count_of_random = 30;
constexpr int judged_cells[] = {128, 256, 512};
/// The grid of a deck, one that is coarser by a factor of two, and finer ones are judged.
constexpr double widest_step = 2.0;
constexpr int truth_cells = 1024;
/// The residual of the solutions that show the remaining change by further cycles, and the change by a larger domain.
constexpr double residual_of_converged = 1e-9;

/// M = 5 to 800, L = 1 to 18; half of the contacts are elliptic, a quarter of those at an angle. A quarter have Barus'
/// law, and a quarter are incompressible.
std::vector<test::Point> drawn() {
  tests::Random random(seed);
  std::vector<test::Point> points;
  for (int k = 0; k < count_of_random; ++k) {
    test::Point one{std::exp(random.between(std::log(5.0), std::log(800.0))), random.between(1.0, 18.0),
                    random.between(1.2e-8, 2.4e-8), random.between(0.45, 0.7), true};
    const double ratio = std::exp(random.between(std::log(0.2), std::log(5.0))), angle = random.between(10.0, 80.0);
    if (k % 2 == 1) one.radius_ratio = ratio;
    if (k % 4 == 3) one.angle = angle;
    if (k % 4 == 1) one.oil = test::Oil::barus;
    if (k % 4 == 2) one.oil = test::Oil::incompressible;
    if (one.oil == test::Oil::barus)
      one.L = 0.5 * (1.0 + one.L);  // at higher L, the viscosities of Barus' law
                                    // exceed those of real oils
    points.push_back(one);
  }
  return points;
}

struct Row {
  const test::Point* point;
  int n;
  test::Judged judged;
};
struct Result {
  std::vector<Row> rows;
  std::vector<std::string> without;  ///< the cases that did not converge
};

steady::Scene plain(const test::Point& point, int n) {
  steady::Scene scene = test::scene_of(point, reynolds::Wedge::upstream3, n, true);
  scene.adjoint_errors = false;
  return scene;
}

double apart(double a, double b) { return std::abs(a / b - 1.0); }

void judge_domain(const test::Point& point, const steady::LevelRow& here, double bar, int n, Result& result) {
  steady::Scene twice = plain(point, 2 * n);
  for (double* side : {&twice.grid.X_a, &twice.grid.X_b, &twice.grid.Y_a, &twice.grid.Y_b}) *side *= 2.0;
  const steady::LevelRow there = test::solved(twice, residual_of_converged);
  const double change = std::max(apart(here.Hc, there.Hc), apart(here.Hm_fitted, there.Hm_fitted));
  result.rows.push_back({&point, n, {"domain", bar, change}});
}

void judge_run(const test::Point& point, int n, const test::Film& truth, double P_max, Result& result) {
  const steady::Solution solution = steady::solve(test::scene_of(point, reynolds::Wedge::upstream3, n, true));
  if (!solution.converged) throw std::runtime_error(solution.failed_check);
  const steady::ErrorBars& bars = solution.error_bars;
  const steady::LevelRow& row = solution.levels.back();
  const auto judge = [&](const test::Judged& one) {
    if (!std::isfinite(one.estimate)) return;
    std::fprintf(stderr, "   %d %s: %.3g of %.3g\n", n, one.name.data(), one.error, one.estimate);
    result.rows.push_back({&point, n, one});
  };
  // Values extrapolated from half of the reference's cells are as accurate as the reference, and are not judged.
  for (const test::Judged& one : test::judged(solution, truth))
    if (4 * n <= truth_cells || !one.name.ends_with("extrapolated")) judge(one);
  judge({"P_max", bars.P_max, apart(row.P_max, P_max)});
  if (4 * n > truth_cells) return;
  const steady::LevelRow exact = test::solved(plain(point, n), residual_of_converged);
  judge({"Hc, cycles", bars.Hc.algebraic, apart(row.Hc, exact.Hc)});
  judge({"Hm, cycles", bars.Hm_fitted.algebraic, apart(row.Hm_fitted, exact.Hm_fitted)});
  if (4 * n == truth_cells) judge_domain(point, exact, bars.domain, n, result);
}

std::string name_of(const test::Point& point, int n) {
  char text[128];
  constexpr const char* oils[] = {"", ";Barus", ";incompressible"};
  std::snprintf(text, sizeof text, "%.4g,%.3g,%.3g;%.0f%s,%d", point.M, point.L, point.radius_ratio, point.angle,
                oils[static_cast<int>(point.oil)], n);
  return text;
}

void judge_contact(const test::Point& point, Result& result) {
  try {
    steady::Scene scene = plain(point, truth_cells);
    scene.solver.tolerance = test::residual_of_truth;
    const steady::Solution fine = steady::solve(scene);
    if (!fine.converged) throw std::runtime_error(fine.failed_check);
    const steady::LevelRow& last = fine.levels.back();
    const test::Film truth = test::extrapolated(fine.levels[fine.levels.size() - 2], last);
    for (const int n : judged_cells) try {
        const steady::Scene one = plain(point, n);
        if (one.grid.hx() > widest_step * steady::resolving_step({}, one.contact, one.wedge)) continue;
        judge_run(point, n, truth, last.P_max, result);
      } catch (const std::exception& error) {
        result.without.push_back(name_of(point, n) + ": " + error.what());
      }
  } catch (const std::exception& error) {
    result.without.push_back(name_of(point, truth_cells) + ": " + error.what());
  }
}

/// "within,of,median" of the bar divided by the error.
std::string share_of(const Result& result, const std::function<bool(const Row&)>& counts) {
  std::vector<double> ratios;
  for (const Row& row : result.rows)
    if (counts(row)) ratios.push_back(row.judged.ratio());
  if (ratios.empty()) return ",,";
  std::sort(ratios.begin(), ratios.end());
  const double median = 0.5 * (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]);
  const auto within = std::count_if(ratios.begin(), ratios.end(), [](double ratio) { return ratio >= 1.0; });
  char text[64];
  std::snprintf(text, sizeof text, "%td,%zu,%.2g", within, ratios.size(), median);
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  const auto asked = [&](const char* word) { return argc < 2 || !std::strcmp(argv[1], word); };
  const std::vector<test::Point> random = drawn();
  Result result;
  const auto all = [&](const auto& points) {
    for (const test::Point& point : points) {
      std::fprintf(stderr, "%s\n", name_of(point, truth_cells).c_str());
      judge_contact(point, result);
    }
  };
  if (asked("listed")) all(listed);
  if (asked("random")) all(random);
  std::puts(
      "value,listed: within,listed: of,listed: bar/error (median),drawn: within,drawn: of,drawn: bar/error (median)");
  for (const char* name : {"Hc", "Hm, fitted", "Hm, node", "Hc, extrapolated", "Hm, extrapolated", "P_max",
                           "Hc, cycles", "Hm, cycles", "domain"}) {
    const auto share = [&](bool held_back) {
      return share_of(result,
                      [&](const Row& row) { return row.judged.name == name && row.point->held_back == held_back; });
    };
    std::string head = name;
    std::replace(head.begin(), head.end(), ',', ';');
    std::printf("%s,%s,%s\n", head.c_str(), share(false).c_str(), share(true).c_str());
  }
  std::puts("\nM,L,R_x/R_y;angle;oil,cells,value,estimate [%],true error [%]");
  for (const Row& row : result.rows)
    if (!row.judged.within()) {
      std::string name(row.judged.name);
      std::replace(name.begin(), name.end(), ',', ';');
      std::printf("%s,%s,%.3g,%.3g\n", name_of(*row.point, row.n).c_str(), name.c_str(), 100.0 * row.judged.estimate,
                  100.0 * row.judged.error);
    }
  for (const std::string& text : result.without) std::printf("# without: %s\n", text.c_str());
  return 0;
}
