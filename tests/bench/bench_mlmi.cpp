// Cost and accuracy of the elastic deformation: deformation_defaults.csv and deformation_order.csv.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "core/norms.hpp"
#include "core/timer.hpp"
#include "mlmi/deformation.hpp"
#include "support/mirrored.hpp"
#include "unit/mlmi/pressures.hpp"

namespace mlmi = ehl::mlmi;
using ehl::core::Field;
using ehl::core::Grid;
using ehl::core::Patch;

namespace {
// The best of several evaluations, in seconds.
double cost(mlmi::Deformation& evaluator, const Field& P, Field& w) {
  double best = 1e9;
  for (double spent = 0.0; spent < 0.3;) {
    const double start = ehl::core::now();
    evaluator.evaluate(P, w);
    const double seconds = ehl::core::now() - start;
    spent += seconds;
    best = std::min(best, seconds);
  }
  return best;
}

// The cost on the lower half of the domain, for a pressure that is symmetric in Y.
double cost_of_half(const Patch& grid, const mlmi::Parameters& parameters, int threads, const Field& P) {
  mlmi::Deformation evaluator(ehl::core::lower_half(grid), parameters, threads);
  const Field half = ehl::tests::half_of(grid, P);
  Field w(ehl::core::lower_half(grid));
  return cost(evaluator, half, w);
}

void report(const Patch& grid, const mlmi::Parameters& parameters, int threads, const Field& P, const Field& truth) {
  const double start = ehl::core::now();
  mlmi::Deformation evaluator(grid, parameters, threads);
  const double setup = ehl::core::now() - start;
  Field w(grid);
  const double per_node = 1e9 / (static_cast<double>(grid.nodes_x()) * grid.nodes_y());
  const double ns = per_node * cost(evaluator, P, w);
  const double ns_half = per_node * cost_of_half(grid, parameters, threads, P);
  const double scale = ehl::core::max_abs(truth);
  std::printf("%5d  %-60s %9.1e %9.1e %8.1f %8.1f %9.2f %8.1f\n", grid.nx, evaluator.description().c_str(),
              ehl::core::max_abs_difference(w, truth) / scale, ehl::tests::slope_difference(grid, w, truth) / scale, ns,
              ns_half, 1e3 * setup, static_cast<double>(evaluator.bytes()) / 1e6);
  std::fflush(stdout);
}

void scan(const Patch& grid, int threads, const Field& P, const Field& truth) {
  for (const int coarsenings : {2, 4})
    for (const int order : {4, 6, 8})
      for (const auto& patch : {std::pair{5, 2}, {7, 2}, {7, 3}, {7, 4}, {9, 3}, {9, 4}, {11, 5}})
        report(grid,
               {.order = order, .patch_along = patch.first, .patch_across = patch.second, .coarsenings = coarsenings},
               threads, P, truth);
}
}  // namespace

// bench_mlmi [n [threads [scan | order along across coarsenings]]]
int main(int count, char** argument) {
  const auto number = [&](int k, int otherwise) { return k < count ? std::atoi(argument[k]) : otherwise; };
  const int only = number(1, 0), threads = number(2, 1);
  std::printf("#   n  %-60s %9s %9s %8s %8s %9s %8s\n", "evaluator", "error", "of dw/dX", "ns/node", "by half",
              "setup ms", "MB");
  for (int n = only ? only : 32; n <= (only ? only : 1024); n *= 2) {
    const Grid grid{n, n, -4.5, 1.5, -3.0, 3.0};
    const Field P = ehl::tests::sampled(grid, ehl::tests::contact_pressure);
    const Field truth = ehl::tests::deformation(grid, P, {.method = mlmi::Method::fft});
    if (count > 3 && std::string_view(argument[3]) == "scan") {
      scan(grid, threads, P, truth);
    } else if (count > 3) {
      report(grid,
             {.order = number(3, 0),
              .patch_along = number(4, 0),
              .patch_across = number(5, 0),
              .coarsenings = number(6, -1)},
             threads, P, truth);
    } else {
      if (n <= 128) report(grid, {.method = mlmi::Method::direct}, threads, P, truth);
      report(grid, {.method = mlmi::Method::fft}, threads, P, truth);
      report(grid, {}, threads, P, truth);
    }
  }
}
