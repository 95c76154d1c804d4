#include "steady/climb.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "fmg/full_multigrid.hpp"
#include "steady/checks.hpp"
#include "steady/rescue.hpp"
#include "steady/resolution.hpp"

namespace ehl::steady {
namespace {

/// Mesh size of the first grid, in units of contact_size.
constexpr double largest_first_step = 0.4;
/// Above this L epsilon differs by more than a factor e from cell to cell in the whole outlet flank: full weights there
/// oscillate and are lowered sooner or later.
constexpr double very_piezoviscous_L = 22.0;
constexpr double caution_where_steep = 0.8;
/// A state with this relative residual solves the equations, whatever else is wrong with it.
constexpr double solved_residual = 1e-5;

/// The grid to compute on: the lower half where the scene's is symmetric in Y and halving keeps all the levels.
core::Grid grid_to_compute_on(const Scene& scene, const fmg::Parameters& parameters) {
  const core::Grid& grid = scene.grid;
  if (!scene.use_symmetry || !fmg::symmetric(geometry_of(scene.shape)) || grid.Y_a != -grid.Y_b || grid.ny % 2 != 0)
    return grid;
  const auto all = fmg::grids_below(grid, parameters);
  const auto halves = fmg::grids_below(core::lower_half(grid), parameters);
  constexpr int fewest_cells = 4;
  return halves.size() == all.size() && halves.back().ny >= fewest_cells ? halves.front() : grid;
}

/// F(2,0) cycles leave the least algebraic error of Hc and Hm for their work, W(2,1) the least residual.
void choose_cycle(const Scene& scene, fmg::Parameters& parameters) {
  const bool to_tolerance = std::isfinite(scene.multigrid.tolerance);
  if (!parameters.cycle) parameters.cycle = to_tolerance ? fmg::Cycle::W : fmg::Cycle::F;
  if (!parameters.post) parameters.post = to_tolerance || scene.L > very_piezoviscous_L ? 1 : 0;
}

/// The first grid has cycled enough when the last cycle changed Hc and Hm by less than this, a few hundredths of what
/// such a grid is wrong by, at least after this many cycles.
constexpr double settled_change = 1e-3;
constexpr int fewest_first_cycles = 3;

bool settled(int cycle, const StateOfLevel& before, const StateOfLevel& now) {
  const auto change = [](double was, double is) { return std::abs((is - was) / is); };
  return cycle >= fewest_first_cycles && now.Hm > 0.0 && change(before.Hc, now.Hc) < settled_change &&
         change(before.Hm, now.Hm) < settled_change;
}

/// Cells along x of the coarsest grid: few enough for its relaxations to solve it, and in a narrow domain, where the
/// contact is slender, twice as many for a grid that holds it better.
int coarsest_cells(const Scene& scene, const Start& start) {
  const double length = scene.grid.X_b - scene.grid.X_a;
  const double width = scene.grid.Y_b - scene.grid.Y_a;
  constexpr double narrow = 1.99;
  return contact::circular(scene.shape) || length < narrow * width ? start.coarsest : 2 * start.coarsest;
}

double steep_caution(const Scene& scene) { return scene.L > very_piezoviscous_L ? caution_where_steep : 1.0; }

/// Geometric mean of the factors by which the cycles on one level reduced the residual, all but the first.
double mean_factor(const std::vector<double>& residuals) {
  if (residuals.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  return std::pow(residuals.back() / residuals.front(), 1.0 / static_cast<double>(residuals.size() - 1));
}

fmg::Parameters parameters_of(const Scene& scene, const Start& start) {
  fmg::Parameters parameters = scene.multigrid;
  parameters.coarsest_sweeps = std::max(parameters.coarsest_sweeps, start.balances);
  parameters.least_coarsest_cells = std::max(parameters.least_coarsest_cells, coarsest_cells(scene, start));
  // The load that a change of H00 brings, 3/2 load/approach of the dry contact, over that of a circle.
  parameters.load_relaxation *= scene.shape.approach / scene.shape.kappa;
  // The coupling by the film, against which that by epsilon is held.
  parameters.relaxation.crossover *= scene.shape.p_h / scene.shape.a;
  choose_cycle(scene, parameters);
  return parameters;
}

}  // namespace

fmg::Geometry geometry_of(const contact::Ellipse& shape) {
  return {contact::gap(shape), contact::outline(shape), contact::elastic_factor(shape)};
}

double first_H00(const Scene& scene) {
  return -scene.shape.approach + expected_central_film(scene.M, scene.L, scene.shape);
}

bool on_one_half(const Scene& scene) { return grid_to_compute_on(scene, parameters_of(scene, {})).mirrored; }

Climb begin_climb(const Scene& scene, const Start& start, const ProgressCallback& progress) {
  // The numbers of cells of a start are for a domain a few radii long. On the long ones of light loads the first grid
  // must still see the contact.
  const double length = (scene.grid.X_b - scene.grid.X_a) / contact_size(scene.M, scene.L, scene.shape);
  const double slender = slenderness(scene.M, scene.L, scene.shape);
  const auto cells = [slender](double of_circle) { return static_cast<int>(of_circle * slender); };
  int first_cells = std::max(cells(start.cells), cells(length / largest_first_step));
  if (start.coarseness > 0.0) {
    const double step = start.coarseness * resolving_step(scene.M, scene.L, scene.wedge, scene.shape);
    first_cells = std::max(first_cells, static_cast<int>((scene.grid.X_b - scene.grid.X_a) / step));
  }
  const fmg::Parameters parameters = parameters_of(scene, start);
  const fmg::Problem problem{.lambda = scene.lambda,
                             .viscosity = scene.viscosity,
                             .density = scene.density,
                             .transport = scene.wedge,
                             .load = contact::load(scene.shape),
                             .given_epsilon = {},
                             .geometry = geometry_of(scene.shape),
                             .surface = scene.surface,
                             .thinning = scene.thinning};
  Climb climb{.scene = scene,
              .progress = progress,
              .start = start,
              .hierarchy = fmg::make_hierarchy(problem, parameters, scene.deformation,
                                               grid_to_compute_on(scene, parameters), scene.threads)};
  while (climb.first < climb.finest() && climb.hierarchy.levels[climb.first].grid.nx < first_cells) ++climb.first;
  return climb;
}

void solve_first_level(Climb& climb) {
  const double began = core::now();
  forget_work(climb.hierarchy);
  climb.caution = {.all = climb.start.caution_at_first, .steep = steep_caution(climb.scene)};
  fmg::Parameters& used = climb.hierarchy.parameters;
  use_caution(climb.caution, climb.scene.multigrid.relaxation, used.relaxation);
  const std::optional<int> post = used.post;
  used.post = std::max(1, post.value_or(1));  // far from the solution
  fmg::start_from_hertz(climb.hierarchy, climb.first, first_H00(climb.scene), climb.start.sweeps);
  solve_level(climb, climb.first, std::max(climb.start.cycles, climb.scene.multigrid.cycles));
  climb.caution = {.all = climb.start.caution, .steep = steep_caution(climb.scene)};
  used.post = post;
  climb.solution.levels.back().seconds = core::now() - began;
}

void solve_level(Climb& climb, std::size_t l, int planned) {
  const fmg::Parameters& multigrid = climb.scene.multigrid;
  const bool last_level = l == climb.finest();
  const int extra = l == climb.first ? 0 : multigrid.extra_cycles;
  const int most = last_level ? std::max(multigrid.max_cycles, planned) : planned + extra;
  const double asked = last_level ? multigrid.tolerance : std::numeric_limits<double>::quiet_NaN();
  std::vector<double> residuals;
  Solution& solution = climb.solution;
  solution.levels.emplace_back();
  const Judge judge = [&](int cycle, const StateOfLevel& before, const StateOfLevel& now) -> Verdict {
    record(climb, l, cycle, now);
    report(climb, l, cycle, planned, now);
    residuals.push_back(now.residual);
    if (l == climb.first && !last_level && settled(cycle, before, now)) return {};
    if (std::isnan(asked) && cycle < planned) return {"cycles that were planned are still to come"};
    const LevelRow& row = solution.levels.back();
    const LastCycle last{before, now, row.error_Hc, row.error_Hm, cycle == 1};
    solution.verification = verification_of(last);
    const bool only_a_start = !last_level && std::isfinite(row.error_Hc);
    return {only_a_start ? unmet_film(last) : unmet_check(last, asked),
            now.residual < solved_residual && !(now.Hm > 0.0)};
  };
  const CyclesResult result = run_cycles(climb.hierarchy, l, most, multigrid.relaxation, climb.caution, judge);
  if (result.end == CyclesEnd::diverged)
    throw core::SolverError(name_of_level(climb.hierarchy, l) + ": " + result.unmet);
  solution.failed_check = result.unmet.empty() ? result.unmet : name_of_level(climb.hierarchy, l) + ": " + result.unmet;
  if (!last_level) return;
  solution.end = result.end;
  solution.cycle_factor = mean_factor(residuals);
  solution.converged = solution.failed_check.empty();
}

void ascend(Climb& climb, std::size_t from) {
  const double order = reynolds::order(climb.scene.wedge);
  fmg::Kept two_below;  // without a pressure where there is none to foretell from
  for (std::size_t l = from + 1; l <= climb.finest(); ++l) {
    const double began = core::now();
    forget_work(climb.hierarchy);
    // A film that is negative on a coarse grid foretells nothing.
    const bool holds = climb.solution.levels.back().Hm > 0.0;
    fmg::Kept below{climb.hierarchy.levels[l - 1].P, climb.hierarchy.H00};
    if (two_below.P.nodes_x() > 0 && holds)
      fmg::start_from_two_coarser(climb.hierarchy, l, two_below, order);
    else
      fmg::start_from_coarser(climb.hierarchy, l);
    two_below = holds ? std::move(below) : fmg::Kept{};
    solve_level(climb, l, climb.scene.multigrid.cycles);
    climb.solution.levels.back().seconds = core::now() - began;
  }
  if (climb.scene.polish == Polish::always) polish(climb);
}

void forget_work(fmg::Hierarchy& hierarchy) {
  for (fmg::Level& level : hierarchy.levels) level.evaluations = 0;
}

core::Field part_on(const core::Grid& grid, core::Field field) {
  if (!grid.mirrored) return field;
  core::Field half(grid);
  core::copy_lower_half(field, half);
  return half;
}

core::Field on_whole(const core::Grid& grid, core::Field field) {
  if (!grid.mirrored) return field;
  core::Field both(core::whole(grid));
  core::copy_whole(grid, field, both);
  return both;
}

Solution result_of(Climb&& climb) {
  Solution& solution = climb.solution;
  fmg::Level& finest = climb.hierarchy.finest();
  solution.grid = core::whole(finest.grid);
  solution.P = on_whole(finest.grid, std::move(finest.P));
  solution.H = on_whole(finest.grid, std::move(finest.H));
  solution.H00 = climb.hierarchy.H00;
  solution.times = climb.hierarchy.times;
  solution.deformation = finest.deformation.description();
  return std::move(solution);
}

Solution climb(const Scene& scene, const Start& start, const ProgressCallback& progress) {
  Climb climb = begin_climb(scene, start, progress);
  solve_first_level(climb);
  ascend(climb, climb.first);
  return result_of(std::move(climb));
}

}  // namespace ehl::steady
