#include "steady/multigrid_solve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/constants.hpp"
#include "multigrid/chattering.hpp"
#include "multigrid/mass_balance.hpp"
#include "steady/newton_fallback.hpp"
#include "steady/resolution.hpp"

namespace ehl::steady {
namespace {

/// The lower half of the domain if the scene is symmetric in Y and halving keeps all the levels, else all of the
/// domain.
core::Patch patch_to_compute_on(const Scene& scene, const multigrid::Parameters& parameters) {
  const core::Grid& grid = scene.grid;
  if (!scene.use_symmetry || !multigrid::symmetric(geometry_of(scene)) || grid.Y_a != -grid.Y_b || grid.ny % 2 != 0)
    return grid;
  const auto all = multigrid::grids_below(grid, parameters);
  const auto halves = multigrid::grids_below(core::lower_half(grid), parameters);
  constexpr int fewest_cells = 4;
  return halves.size() == all.size() && halves.back().ny >= fewest_cells ? halves.front() : grid;
}

/// Cells along x of a first grid for which `cells` are enough on the usual domain of a circular contact. On the longer
/// domains of lightly loaded contacts the cells must still resolve the contact.
int first_cells(int cells, const Scene& scene) {
  const double stretch = core::stretch(scene.grid);
  const double length = (scene.grid.X_b - scene.grid.X_a) / scene.contact.size;
  const double slender = scene.contact.slenderness;
  // For an oblique contact the shorter axis needs cells in both directions. [bench: first_cells_of_oblique_contacts]
  if (contact::gap(scene.contact.shape).oblique()) cells /= 4;
  return std::max(static_cast<int>(cells * slender / stretch),
                  static_cast<int>(length / scene.tuning.largest_first_step * slender / stretch));
}

std::optional<reynolds::FarField> far_field_of(const Scene& scene) {
  if (!scene.far_field) return std::nullopt;
  return far_field(scene, contact::load(scene.contact.shape), scene.grid);
}

reynolds::Transport transport_of(const Scene& scene) {
  reynolds::Transport transport = scene.wedge;
  // The coupling by the film, as for the crossover.
  transport.third_order_from *= scene.contact.shape.p_h / scene.contact.shape.a;
  return transport;
}

/// Deformation at X = 0 by the load of a line contact upstream of its inlet: -(1/pi) integral of P ln|X| dX. Inside the
/// domain it is nearly constant, so that H00 absorbs it; without this correction H00 would depend on the length of the
/// inlet.
double deformation_by_outside(const multigrid::Hierarchy& hierarchy) {
  const multigrid::Problem& problem = hierarchy.problem;
  const core::Grid& grid = hierarchy.levels.back().grid.domain;
  if (!problem.geometry.kernel.plane || !problem.far_field) return 0.0;
  const reynolds::FarState state{
      .H00 = hierarchy.H00, .speed = 1.0 / hierarchy.far_motion.mobility, .flow = hierarchy.far_motion.flow};
  const kernel::Kernel& kernel = problem.geometry.kernel;
  const double deformation = kernel.factor * problem.load.value_or(0.0);
  constexpr int parts = 200;  // of X_a/X, by the midpoint rule
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) {
    const double u = (k + 0.5) / parts;
    const double X = grid.X_a / u;
    const double K = kernel::at_distance(kernel, -X);
    const double H = hierarchy.H00 + problem.geometry.gap.XX * X * X + deformation * K;
    sum += problem.far_field->P(problem.far_field->at(X, 0.0), H, state) * K * -X / (u * parts);
  }
  return kernel.factor * sum;
}

multigrid::LevelObserver observer_of(const Scene& scene) {
  if (!scene.observer) return {};
  return
      [scene](const multigrid::Hierarchy& hierarchy, std::size_t l) { return observed(scene, hierarchy, l, {}, {}); };
}

}  // namespace

std::vector<double> observed(const Scene& scene, const multigrid::Hierarchy& hierarchy, std::size_t l,
                             const core::Field& I0, const core::Field& less_tau) {
  if (!scene.observer) return {};
  const multigrid::Level& level = hierarchy.levels[l];
  const core::Field P = core::on_domain(level.grid, level.P), H = core::on_domain(level.grid, level.H);
  const core::Field P_c = level.touching ? core::on_domain(level.grid, level.touching->P_c) : core::Field();
  const auto given = [](const core::Field& field) { return field.nodes_x() > 0 ? &field : nullptr; };
  return scene.observer(scene, {.grid = level.grid.domain,
                                .P = P,
                                .H = H,
                                .H00 = hierarchy.H00 - deformation_by_outside(hierarchy),
                                .I0 = given(I0),
                                .less_tau = given(less_tau),
                                .P_c = given(P_c)});
}

multigrid::Geometry geometry_of(const Scene& scene) {
  const contact::Ellipse& shape = scene.contact.shape;
  return {.gap = contact::gap(shape),
          .outline = contact::outline(shape),
          .kernel = {.plane = contact::line(shape) && !contact::roller(shape),
                     .factor = contact::elastic_factor(shape) * scene.coatings.stiffness,
                     .coatings = scene.coatings.parts}};
}

reynolds::FarField far_field(const Scene& scene, double load, const core::Grid& domain) {
  const multigrid::Geometry geometry = geometry_of(scene);
  const double deformation = geometry.kernel.factor * load;
  std::function<double(double)> by_coatings;
  if (!geometry.kernel.coatings.empty())
    by_coatings = [deformation, kernel = geometry.kernel](double r) {
      return deformation * kernel::by_coatings(kernel, r);
    };
  return reynolds::FarField({.gap = geometry.gap,
                             .lambda = scene.lambda,
                             .deformation = deformation,
                             .viscosity = scene.viscosity,
                             .domain = domain,
                             .by_coatings = std::move(by_coatings)});
}

double dry_approach(const Scene& scene) {
  const auto [gap, outline, kernel] = geometry_of(scene);
  if (kernel.coatings.empty()) return scene.contact.shape.approach;
  constexpr int directions = 32, steps = 32;  // midpoint rule: the approach only starts the iteration
  double sum = 0.0;
  for (int n = 0; n < directions; ++n) {
    const double phi = 2.0 * core::pi * (n + 0.5) / directions;
    const double edge = kernel.plane ? 1.0 : 1.0 / std::sqrt(outline.at(std::cos(phi), std::sin(phi)));
    for (int k = 0; k < steps; ++k) {
      const double u = (k + 0.5) / steps;
      const double area = kernel.plane ? 2.0 : 2.0 * core::pi * edge * edge * u;
      sum += area * std::sqrt(1.0 - u * u) * kernel::by_coatings(kernel, edge * u) / (directions * steps);
    }
  }
  return scene.coatings.stiffness * scene.contact.shape.approach + kernel.factor * sum;
}

bool held_by(int cells, const Scene& scene) {
  const double step = (scene.grid.X_b - scene.grid.X_a) / first_cells(cells, scene) / core::stretch(scene.grid);
  // A coarser grid does not see the zones in which the film forms.
  return step <= scene.tuning.widest_step * scene.contact.film_zone;
}

double first_H00(const Scene& scene) {
  // Beside a slender contact most of a thick initial film has to leave, and the outflow pulls the film below zero; a
  // thin film fills from the inlet. [bench: first_H00_of_slender_contacts]
  const double share = core::stretched(scene.grid) ? scene.tuning.first_film_of_slender : 1.0;
  return (scene.dry ? 0.0 : -dry_approach(scene)) + share * scene.contact.film;
}

bool on_one_half(const Scene& scene) {
  return patch_to_compute_on(scene, parameters_of(scene, {})).north == core::Edge::mirror;
}

multigrid::Run begin_multigrid(const Scene& scene, const Start& start, const ProgressCallback& progress) {
  int fewest_cells = first_cells(start.cells, scene);
  if (start.coarseness > 0.0) {
    const double step =
        start.coarseness * resolving_step(scene.tuning, scene.contact, scene.wedge) * core::stretch(scene.grid);
    fewest_cells = std::max(fewest_cells, static_cast<int>((scene.grid.X_b - scene.grid.X_a) / step));
  }
  const multigrid::Parameters parameters = parameters_of(scene, start);
  const multigrid::Problem problem{
      .film = {.lambda = scene.lambda,
               .viscosity = scene.viscosity,
               .density = scene.density,
               .thinning = scene.thinning,
               .has_factors = scene.has_factors,
               .limit = scene.limit},
      .transport = transport_of(scene),
      .face = scene.face,
      .load = contact::load(scene.contact.shape),
      .cavitation = scene.supply ? reynolds::Cavitation::mass_conserving : reynolds::Cavitation::nonnegative_pressure,
      .supply = scene.supply,
      .supply_share = scene.supply_share,
      .geometry = geometry_of(scene),
      .far_field = far_field_of(scene),
      .surface = scene.surface,
      .dry = scene.dry,
      .boundary_film = scene.boundary_film};
  const double steep = steep_damping(scene);
  multigrid::Run run{.hierarchy = multigrid::make_hierarchy(problem, parameters, scene.deformation,
                                                            patch_to_compute_on(scene, parameters), scene.threads),
                     .plan = {.H00 = first_H00(scene),
                              .sweeps = start.sweeps,
                              .cycles = start.cycles,
                              .at_first = {.all = start.damping_at_first, .steep = steep, .relax_after = true},
                              .above = {.all = start.damping, .steep = steep}},
                     .progress = progress,
                     .observer = observer_of(scene)};
  std::size_t& first = run.plan.first;
  while (first < run.finest() && run.hierarchy.levels[first].grid.nx < fewest_cells) ++first;
  return run;
}

Solution solution_of(const Scene& scene, multigrid::Run&& run) {
  const multigrid::Level& finest = run.hierarchy.finest();
  Solution solution;
  static_cast<multigrid::Record&>(solution) = std::move(run.record);
  solution.grid = finest.grid.domain;
  solution.P = core::on_domain(finest.grid, multigrid::pressure_on_bodies(finest));
  if (finest.touching) {
    solution.P_f = core::on_domain(finest.grid, finest.P);
    solution.P_c = core::on_domain(finest.grid, finest.touching->P_c);
  }
  solution.H = core::on_domain(finest.grid, finest.H);
  solution.H00 = run.hierarchy.H00 - deformation_by_outside(run.hierarchy);
  if (multigrid::conserves_mass(finest)) {
    solution.Q = core::on_domain(finest.grid, finest.content->Q);
    solution.theta = core::on_domain(finest.grid, multigrid::theta_of(finest));
    solution.oil = multigrid::oil_of(run.hierarchy, finest);
  }
  solution.chattering_nodes = multigrid::chattering_nodes(finest);
  solution.deformation = finest.deformation.description();
  solution.remedies = std::move(run.remedies);
  if (scene.adjoint_errors && solution.converged && reynolds::third_order(scene.wedge) && !scene.has_factors &&
      !scene.supply && !scene.boundary_film)
    solution.adjoint = adjoint::errors(run.hierarchy, scene.error_maps);
  solution.times = run.hierarchy.times;
  return solution;
}

Solution end_multigrid(const Scene& scene, multigrid::Run&& run) {
  if (scene.polish != Polish::always) return solution_of(scene, std::move(run));
  return polished(scene, std::move(run));
}

Solution solve_by_multigrid(const Scene& scene, const Start& start, const ProgressCallback& progress) {
  multigrid::Run run = begin_multigrid(scene, start, progress);
  multigrid::full_multigrid(run);
  return end_multigrid(scene, std::move(run));
}

}  // namespace ehl::steady
