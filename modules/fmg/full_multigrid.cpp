#include "fmg/full_multigrid.hpp"

#include <algorithm>
#include <cmath>

#include "fmg/cycle.hpp"
#include "fmg/relaxation.hpp"
#include "transfer/transfer.hpp"

namespace ehl::fmg {
namespace {

/// Relaxations between two corrections of H00 on a grid that is relaxed alone: long enough for the pressure to answer.
constexpr int sweeps_per_balance = 4;

void pose_original_problem(const Problem& problem, Level& level) {
  level.f.fill(0.0);
  if (problem.surface)
    problem.surface(level.grid, level.F);
  else
    level.F.fill(0.0);
  level.H_restricted.fill(0.0);
  level.H_floor = 0.0;
  level.load = problem.load.value_or(0.0);
}

// Mean of S, weighted with the pressure.
double mean_surface(const Level& level) {
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) {
      const double weight = level.grid.lines(j) * level.P(i, j);
      sum += weight * level.F(i, j);
      weights += weight;
    }
  return weights > 0.0 ? sum / weights : 0.0;
}

}  // namespace

void start_from_hertz(Hierarchy& hierarchy, std::size_t l, double H00, int sweeps) {
  Level& level = hierarchy.levels[l];
  pose_original_problem(hierarchy.problem, level);
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) {
      const double X = level.grid.X(i);
      const double Y = level.grid.Y(j);
      const double inside = 1.0 - X * X - Y * Y;
      level.P(i, j) = inside > 0.0 ? std::sqrt(inside) : 0.0;
    }
  core::make_images(level.grid, level.P);
  hierarchy.H00 = hierarchy.problem.surface ? H00 - mean_surface(level) : H00;
  update_film(hierarchy, level);
  for (int sweep = 1; sweep <= sweeps; ++sweep) {
    if (sweep % sweeps_per_balance == 0)
      relax_with_force_balance(hierarchy, level, 1);
    else
      relax(hierarchy, level);
  }
}

void start_from_state(Hierarchy& hierarchy, std::size_t l, const core::Field& P, double H00) {
  Level& level = hierarchy.levels[l];
  pose_original_problem(hierarchy.problem, level);
  core::copy(P, level.P);
  core::make_images(level.grid, level.P);
  hierarchy.H00 = H00;
  update_film(hierarchy, level);
}

void start_from_coarser(Hierarchy& hierarchy, std::size_t l) {
  Level& level = hierarchy.levels[l];
  pose_original_problem(hierarchy.problem, level);
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::transfer);
    transfer::prolong_bicubic(hierarchy.levels[l - 1].grid, hierarchy.levels[l - 1].P, level.P);
    for (int i = 0; i <= level.grid.nx; ++i)
      for (int j = 0; j <= level.grid.ny; ++j) {
        const bool boundary = i == 0 || j == 0 || i == level.grid.nx || j > level.grid.last_line();
        if (boundary || (hierarchy.problem.cavitation && level.P(i, j) < 0.0)) level.P(i, j) = 0.0;
      }
    core::make_images(level.grid, level.P);
  }
  update_film(hierarchy, level);
}

void start_from_two_coarser(Hierarchy& hierarchy, std::size_t l, const Kept& two_below, double order) {
  const double weight = std::exp2(-order);
  Level& below = hierarchy.levels[l - 1];
  core::Field coarser(below.grid);
  transfer::prolong_bicubic(hierarchy.levels[l - 2].grid, two_below.P, coarser);
  // No pressure where the finer solution has none: the cavitated region is the finer one's.
  for (int i = 1; i < below.grid.nx; ++i)
    for (int j = 1; j <= below.grid.last_line(); ++j) {
      double& P = below.P(i, j);
      if (P > 0.0) P = std::max(0.0, P + weight * (P - coarser(i, j)));
    }
  hierarchy.H00 += weight * (hierarchy.H00 - two_below.H00);
  start_from_coarser(hierarchy, l);
}

}  // namespace ehl::fmg
