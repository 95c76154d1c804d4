#include "fmg/hierarchy.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "kernel/influence.hpp"

namespace ehl::fmg {
namespace {

line_solvers::FilmTerms film_terms(const core::Grid& grid, double elastic, int reach) {
  line_solvers::FilmTerms terms;
  terms.reach = reach;
  for (int d = 0; d <= reach; ++d) {
    const auto k = static_cast<std::size_t>(d);
    terms.K[k] = elastic * kernel::influence(d, 0, grid.hx(), grid.hy());
    terms.delta_K[k] = elastic * kernel::distributed_influence(d, 0, grid.hx(), grid.hy());
  }
  return terms;
}

// The number of coarsenings that a user gives is meant for the finest grid: the others take as many as they hold.
Level make_level(const core::Grid& grid, bool finest, const Problem& problem, const Parameters& parameters,
                 const mlmi::Parameters& deformation, int threads) {
  const auto zero = [&] { return core::Field(grid); };
  const auto only_below_the_finest = [&] { return finest ? core::Field() : core::Field(grid); };
  // A colour has every second line, and one batch more for the lines beside its last one.
  const int lines_of_a_colour = grid.ny / 2 + 2 * core::lanes;
  const auto zero_changes = [&] { return core::Field(grid.nodes_x(), lines_of_a_colour); };
  ThreadWork work = make_thread_work(grid, parameters.relaxation);
  if (problem.thinning) work.fluidity_along = work.fluidity_across = work.fluidity;
  return {.grid = grid,
          .P = zero(),
          .H = zero(),
          .eps = zero(),
          .eps_across = problem.thinning ? zero() : core::Field(),
          .rho_bar = zero(),
          .drho_bar = zero(),
          .f = only_below_the_finest(),
          .F = problem.surface ? zero() : only_below_the_finest(),
          .H_restricted = only_below_the_finest(),
          .P_restricted = only_below_the_finest(),
          .r = zero(),
          .changes = {zero_changes(), zero_changes()},
          .thread_work = std::vector<ThreadWork>(static_cast<std::size_t>(threads), work),
          .deformation = mlmi::Deformation(grid, finest ? deformation : mlmi::fitting(deformation, grid), threads,
                                           problem.geometry.elastic),
          .film_terms = film_terms(grid, problem.geometry.elastic, parameters.relaxation.reach)};
}

// epsilon of one station. in: the film that it follows.
void epsilon_of_station(const Problem& problem, std::span<const double> H, Level& level, int i, ThreadWork& work) {
  const auto rho_bar = std::as_const(level.rho_bar).station(i);
  if (!problem.thinning) {
    reynolds::epsilon(H, rho_bar, work.fluidity, problem.lambda, level.eps.station(i));
    return;
  }
  rheology::film_fluidity(*problem.thinning, H, work.fluidity, work.fluidity_along, work.fluidity_across);
  reynolds::epsilon(H, rho_bar, work.fluidity_along, problem.lambda, level.eps.station(i));
  reynolds::epsilon(H, rho_bar, work.fluidity_across, problem.lambda, level.eps_across.station(i));
  core::make_images(level.grid, level.eps_across.at_x(i));
}

// One station of the field: epsilon, rho_bar and its slope from P and H.
void coefficients_of_station(const Problem& problem, Level& level, int i, ThreadWork& work) {
  const auto P = std::as_const(level.P).station(i);
  const auto H = std::as_const(level.H).station(i);
  if (problem.given_epsilon) {
    for (int j = 0; j <= level.grid.ny; ++j) level.eps(i, j) = problem.given_epsilon(level.grid.X(i), level.grid.Y(j));
    core::make_images(level.grid, level.eps.at_x(i));
    std::ranges::fill(level.rho_bar.station(i), 1.0);
    return;
  }
  rheology::film_properties(problem.viscosity, problem.density, P, work.fluidity, level.rho_bar.station(i));
  rheology::density_slope(problem.density, P, level.drho_bar.station(i));
  auto followed = H;
  if (level.H_floor != 0.0) {
    const auto finer = std::as_const(level.H_restricted).station(i);
    const auto held = level.r.station(i);  // free here: the residual is made anew after every change of the film
    for (std::size_t j = 0; j < held.size(); ++j) held[j] = std::max(H[j], level.H_floor * finer[j]);
    followed = held;
  }
  epsilon_of_station(problem, followed, level, i, work);
  core::make_images(level.grid, level.eps.at_x(i));
}

template <class Station>
void for_stations(Hierarchy& hierarchy, Level& level, Station station) {
  const int threads = hierarchy.threads_on(level.grid);
  const int last = level.grid.nx;
#pragma omp parallel num_threads(threads) if (threads > 1)
  {
    ThreadWork& work = level.thread_work[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
    for (int i = 0; i <= last; ++i) station(i, work);
  }
}

}  // namespace

std::vector<core::Grid> grids_below(const core::Grid& finest, const Parameters& parameters) {
  std::vector<core::Grid> grids{finest};
  const int wanted = parameters.coarsest_cells > 0 ? parameters.coarsest_cells : parameters.least_coarsest_cells;
  while (grids.back().nx > wanted && grids.back().nx % 2 == 0 && grids.back().ny % 2 == 0 &&
         (parameters.coarsest_cells > 0 || grids.back().nx / 2 >= wanted))
    grids.push_back(core::coarsened(grids.back()));
  return grids;
}

Hierarchy make_hierarchy(const Problem& problem, const Parameters& parameters, const mlmi::Parameters& deformation,
                         const core::Grid& finest, int threads) {
  Hierarchy hierarchy{
      .problem = problem, .load_line = {}, .parameters = parameters, .levels = {}, .threads = threads, .times = {}};
  const core::ScopedTimer timer(hierarchy.times, core::Part::setup);
  const std::vector<core::Grid> grids = grids_below(finest, parameters);
  const int wanted = parameters.coarsest_cells;
  if (wanted > 0 && grids.back().nx != wanted)
    throw core::InputError("[grid] coarsest = " + std::to_string(wanted) + ": " + std::to_string(finest.nx) + " x " +
                           std::to_string(core::whole(finest).ny) + " cells cannot be halved down to it");
  for (auto grid = grids.rbegin(); grid != grids.rend(); ++grid)
    hierarchy.levels.push_back(
        make_level(*grid, *grid == finest, problem, parameters, deformation, hierarchy.threads_on(*grid)));
  return hierarchy;
}

void update_coefficients(Hierarchy& hierarchy, Level& level) {
  const core::ScopedTimer timer(hierarchy.times, core::Part::coefficients);
  for_stations(hierarchy, level,
               [&](int i, ThreadWork& work) { coefficients_of_station(hierarchy.problem, level, i, work); });
}

void update_film(Hierarchy& hierarchy, Level& level) {
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::deformation);
    level.deformation.evaluate(level.P, level.H);
  }
  ++level.evaluations;
  const core::ScopedTimer timer(hierarchy.times, core::Part::coefficients);
  const core::Grid& grid = level.grid;
  for_stations(hierarchy, level, [&](int i, ThreadWork& work) {
    double* H = level.H.at_x(i);
    for (int j = 0; j <= grid.ny; ++j) H[j] += rigid_gap(hierarchy.problem.geometry, grid, hierarchy.H00, i, j);
    if (level.F.nodes_x() > 0) {
      const double* F = level.F.at_x(i);
      for (int j = 0; j <= grid.ny; ++j) H[j] += F[j];
    }
    coefficients_of_station(hierarchy.problem, level, i, work);
  });
}

void update_residual(Hierarchy& hierarchy, Level& level) {
  const core::ScopedTimer timer(hierarchy.times, core::Part::residual);
  reynolds::residual(level.grid, state(level), hierarchy.problem.transport, hierarchy.threads_on(level.grid), level.r);
}

double carried_load(const Level& level) {
  return level.grid.hx() * level.grid.hy() * core::interior_sum(level.grid, level.P);
}

}  // namespace ehl::fmg
