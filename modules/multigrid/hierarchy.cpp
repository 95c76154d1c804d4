#include "multigrid/hierarchy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "multigrid/boundary.hpp"
#include "multigrid/line_relaxation.hpp"
#include "multigrid/thread_work.hpp"
#include "reynolds/content.hpp"

namespace ehl::multigrid {
namespace {

// Delta K with the shares of stretched cells. Only for small d: far away the differences lose their digits.
double stretched_influence(const kernel::Kernel& kernel, int d, const core::Patch& grid) {
  const auto K = [&](int d_x, int d_y) { return kernel::influence(kernel, d_x, d_y, grid.hx(), grid.hy()); };
  const DistributedShares share = distributed_shares(grid);
  return K(d, 0) - share.along * (K(d - 1, 0) + K(d + 1, 0)) - 2.0 * share.across * K(d, 1);
}

line_solvers::FilmTerms film_terms(const core::Patch& grid, const kernel::Kernel& kernel,
                                   const RelaxationParameters& how) {
  line_solvers::FilmTerms terms;
  const int reach = how.reach;
  terms.reach = reach;
  for (int d = 0; d <= reach; ++d) {
    const auto k = static_cast<std::size_t>(d);
    if (kernel.plane) {
      const double zero_at = std::max(how.line_zero, 2.0 * grid.hx());
      const double at_zero = kernel::at_distance(kernel, zero_at);
      terms.K[k] = kernel.factor * (kernel::line_influence(kernel, d, grid.hx()) - grid.hx() * at_zero);
      terms.delta_K[k] = kernel.factor * kernel::distributed_line_influence(kernel, d, grid.hx());
      continue;
    }
    terms.K[k] = kernel.factor * kernel::influence(kernel, d, 0, grid.hx(), grid.hy());
    terms.K_across[k] = kernel.factor * kernel::influence(kernel, d, 1, grid.hx(), grid.hy());
    terms.delta_K[k] =
        kernel.factor * (core::stretched(grid) ? stretched_influence(kernel, d, grid)
                                               : kernel::distributed_influence(kernel, d, 0, grid.hx(), grid.hy()));
  }
  return terms;
}

OilFields oil_fields(const core::Patch& grid, bool anisotropic) {
  const core::Field zero(grid);
  return anisotropic ? OilFields{zero, zero, zero, zero} : OilFields{zero, zero, {}, {}};
}

std::optional<Touching> touching_surfaces(const Problem& problem, const core::Patch& grid) {
  if (!problem.boundary_film) return std::nullopt;
  const core::Field zero(grid);
  return Touching{zero, zero, std::isfinite(problem.boundary_film->hardness) ? zero : core::Field()};
}

// A number of coarsenings in the deck is meant for the finest grid; coarser grids take as many of them as fit.
Level make_level(const core::Patch& grid, bool finest, const Problem& problem, const Parameters& parameters,
                 const mlmi::Parameters& deformation, int threads) {
  const auto zero = [&] { return core::Field(grid); };
  const auto only_below_the_finest = [&] { return finest ? core::Field() : core::Field(grid); };
  // A coarse film that falls to zero would cut the contact off from its surroundings.
  const auto from_finer = [&] { return FromFiner{zero(), zero(), parameters.tuning.coarse_film_floor}; };
  // A colour has every second line; one more batch holds the lines next to its last one.
  const int lines_of_a_colour = grid.ny / 2 + 2 * core::lanes;
  const bool along_line = relaxes_along_line(grid, parameters.relaxation, problem.cavitation);
  const auto zero_changes = [&] { return along_line ? core::Field() : core::Field(grid.nodes_x(), lines_of_a_colour); };
  const bool half_points = problem.face != reynolds::Face::mean;
  const auto nodes_y = static_cast<std::size_t>(grid.nodes_y());
  ThreadWork work = make_thread_work(grid, problem.film, parameters.relaxation, problem.cavitation);
  if (half_points) {
    work.answers.resize(work.west.size());
    work.answers_west.resize(work.west.size());
  }
  return {.grid = grid,
          .P = zero(),
          .H = zero(),
          .scheme = scheme_of(problem),
          .eps = zero(),
          .eps_across = film::anisotropic(problem.film) || half_points ? zero() : core::Field(),
          .oil = half_points ? oil_fields(grid, film::anisotropic(problem.film)) : OilFields{},
          .factors = problem.film.has_factors ? std::optional(film::unit_factors(grid)) : std::nullopt,
          .third_order = half_points || reynolds::third_order(problem.transport.wedge) ? zero() : core::Field(),
          .rho_bar = zero(),
          .drho_bar = zero(),
          .f = only_below_the_finest(),
          .F = problem.surface ? zero() : only_below_the_finest(),
          .finer = finest ? std::nullopt : std::optional(from_finer()),
          .r = zero(),
          .content = reynolds::conserves(problem.cavitation)
                         ? std::optional(OilContent{zero(), std::vector<double>(nodes_y), zero(), zero()})
                         : std::nullopt,
          .touching = touching_surfaces(problem, grid),
          .correction = zero(),
          .changes = {zero_changes(), zero_changes()},
          .thread_work = WorkSpace(threads, std::move(work)),
          .deformation = mlmi::Deformation(grid, finest ? deformation : mlmi::fitting(deformation, grid), threads,
                                           problem.geometry.kernel),
          .film_terms = film_terms(grid, problem.geometry.kernel, parameters.relaxation),
          .boundary = points_of_boundary(problem, grid),
          .corrector = {}};
}

/// True if grids_below() coarsens this grid once more.
bool goes_on(const core::Patch& grid, const Parameters& parameters) {
  const int wanted = parameters.coarsest_cells > 0 ? parameters.coarsest_cells : parameters.least_coarsest_cells;
  return grid.nx > wanted && grid.nx % 2 == 0 && grid.ny % 2 == 0 &&
         (parameters.coarsest_cells > 0 || grid.nx / 2 >= wanted);
}

/// The next coarser of the grids that correct a level with stretched cells: half the lines until the cells are square,
/// then half of both. Too few lines do not resolve an elongated contact.
std::optional<core::Patch> next_correcting(const core::Patch& grid, const Parameters& parameters) {
  if (grid.ny % 2 != 0 || grid.ny / 2 < parameters.tuning.fewest_lines) return std::nullopt;
  if (core::stretched(grid)) return core::coarsened_across(grid);
  if (goes_on(grid, parameters)) return core::coarsened(grid);
  return std::nullopt;
}

int index_of(const std::vector<Level>& levels, const core::Patch& grid) {
  const auto found = std::ranges::find_if(levels, [&](const Level& level) { return level.grid == grid; });
  return found == levels.end() ? -1 : static_cast<int>(found - levels.begin());
}

// Two levels whose cells differ by a factor of two share their correcting grids from the first square grid of the
// coarser level on.
template <class MakeLevel>
void make_grids_between(Hierarchy& hierarchy, MakeLevel make) {
  std::vector<Level>& between = hierarchy.between;
  for (Level& level : hierarchy.levels) {
    std::vector<core::Patch> grids;
    int below = -1;
    for (auto next = next_correcting(level.grid, hierarchy.parameters); next;
         next = next_correcting(*next, hierarchy.parameters)) {
      below = index_of(between, *next);
      if (below >= 0) break;
      grids.push_back(*next);
    }
    for (auto grid = grids.rbegin(); grid != grids.rend(); ++grid) {
      between.push_back(make(*grid));
      between.back().corrector = {true, below};
      below = static_cast<int>(between.size()) - 1;
    }
    level.corrector = {true, below};
  }
}

}  // namespace

Scheme scheme_of(const Problem& problem) { return {problem.transport.wedge, problem.face}; }

Scheme coarse_scheme_of(const Problem& problem) {
  const reynolds::Wedge wedge = problem.transport.wedge;
  return {reynolds::third_order(wedge) ? reynolds::Wedge::upstream2 : wedge, reynolds::Face::mean};
}

std::vector<core::Patch> grids_below(const core::Patch& finest, const Parameters& parameters) {
  std::vector<core::Patch> grids{finest};
  while (goes_on(grids.back(), parameters)) grids.push_back(core::coarsened(grids.back()));
  return grids;
}

Hierarchy make_hierarchy(const Problem& problem, const Parameters& parameters, const mlmi::Parameters& deformation,
                         const core::Patch& finest, int threads) {
  Hierarchy hierarchy{.problem = problem,
                      .parameters = parameters,
                      .transport = problem.transport,
                      .load_line = {},
                      .far_motion = {},
                      .outside_line = {},
                      .levels = {},
                      .between = {},
                      .threads = threads,
                      .times = {}};
  const core::ScopedTimer timer(hierarchy.times, core::Part::setup);
  const std::vector<core::Patch> grids = grids_below(finest, parameters);
  const int wanted = parameters.coarsest_cells;
  if (wanted > 0 && grids.back().nx != wanted)
    throw core::InputError("[grid] coarsest = " + std::to_string(wanted) + ": " + std::to_string(finest.nx) + " x " +
                           std::to_string(finest.domain.ny) + " cells cannot be halved down to it");
  const auto make = [&](const core::Patch& grid) {
    return make_level(grid, grid == finest, problem, parameters, deformation, hierarchy.threads_on(grid));
  };
  for (auto grid = grids.rbegin(); grid != grids.rend(); ++grid) {
    hierarchy.levels.push_back(make(*grid));
    hierarchy.levels.back().corrector = {false, static_cast<int>(hierarchy.levels.size()) - 2};
  }
  if (core::stretched(finest)) make_grids_between(hierarchy, make);
  return hierarchy;
}

void take_line_zero(Hierarchy& hierarchy, double line_zero) {
  RelaxationParameters how = hierarchy.parameters.relaxation;
  how.line_zero = line_zero;
  for (Level& level : hierarchy.levels)
    level.film_terms = film_terms(level.grid, hierarchy.problem.geometry.kernel, how);
}

double share_of_supply(const Hierarchy& hierarchy, const Level& level) {
  return hierarchy.problem.supply_share ? hierarchy.problem.supply_share(level.grid.nx) : 1.0;
}

void supply_oil(const Hierarchy& hierarchy, Level& level) {
  if (!level.content) return;
  const double factor = hierarchy.supply_factor * share_of_supply(hierarchy, level);
  for (std::size_t j = 0; j < level.content->supply.size(); ++j)
    level.content->supply[j] =
        std::max(hierarchy.least_supply, factor * hierarchy.problem.supply(level.grid.Y(static_cast<int>(j))));
}

void update_residual(Hierarchy& hierarchy, Level& level) {
  const core::ScopedTimer timer(hierarchy.times, core::Part::residual);
  const reynolds::Transport transport = transport_on(hierarchy, level);
  const int threads = hierarchy.threads_on(level.grid);
  if (conserves_mass(level))
    reynolds::residual(level.grid, fields(level), {level.content->Q, level.content->supply}, transport, threads,
                       level.r);
  else
    reynolds::residual(level.grid, fields(level), transport, threads, level.r);
}

double carried_load(const Level& level) {
  return level.grid.hx() * level.grid.hy() * core::interior_sum(level.grid, pressure_on_bodies(level));
}

}  // namespace ehl::multigrid
