#include "steady/mixed.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "core/timer.hpp"
#include "multigrid/start.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/newton_fallback.hpp"
#include "steady/starts.hpp"
#include "steady/strategies.hpp"
#include "transfer/transfer.hpp"

namespace ehl::steady {
namespace {

// Share of the total time for the solution without contact.
constexpr double share_of_apart = 0.3;

// The solution without contact; nothing if there is none.
std::optional<Solution> solve_apart(const Scene& scene, const ProgressCallback& progress) {
  Scene apart = scene;
  apart.boundary_film.reset();
  try {
    Solution solution = solve_by_strategies(apart, progress);
    if (solution.converged) return solution;
  } catch (const core::SolverError&) {
    // Surfaces that touch may have no film without contact.
  }
  return std::nullopt;
}

bool stays_apart(const Scene& scene, const Solution& solution) {
  return core::minimum(solution.H).value >= scene.boundary_film->H_b;
}

Solution without_contact(Solution solution) {
  solution.P_f = solution.P;
  solution.P_c = core::Field(solution.grid);
  return solution;
}

// Height of the relief above its lowest point.
double height_of_relief(const Scene& scene) {
  if (!scene.surface) return 0.0;
  core::Field S(scene.grid);
  scene.surface(scene.grid, S);
  return core::maximum(S).value - core::minimum(S).value;
}

/// True if the film without contact probably exists and is thicker than the boundary film.
bool may_stay_apart(const Scene& scene) {
  const double film = scene.contact.film;
  return film > scene.boundary_film->H_b && height_of_relief(scene) < scene.tuning.relief_over_film * film;
}

// The whole domain's field on a coarser level, by injection.
core::Field on_level(const multigrid::Hierarchy& hierarchy, std::size_t l, const core::Field& on_domain) {
  core::Field field = core::on_patch(hierarchy.levels.back().grid, on_domain);
  for (std::size_t k = hierarchy.levels.size() - 1; k-- > l;) {
    core::Field coarse(hierarchy.levels[k].grid);
    transfer::restrict_injection(field, coarse);
    field = std::move(coarse);
  }
  return field;
}

// The smooth dry contact, whose surfaces carry nearly all of the load: Newton's method needs some wet nodes.
multigrid::State dry_state(const Scene& scene, const multigrid::Hierarchy& hierarchy, std::size_t l) {
  const core::Patch& grid = hierarchy.levels[l].grid;
  constexpr double share_of_oil = 1e-3;
  multigrid::State state{core::Field(grid), -dry_approach(scene) + multigrid::boundary_film(hierarchy),
                         core::Field(grid)};
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) {
      const double inside = 1.0 - hierarchy.problem.geometry.outline.at(grid.X(i), grid.Y(j));
      state.P_c(i, j) = std::sqrt(std::max(0.0, inside));
      state.P(i, j) = share_of_oil * state.P_c(i, j);
    }
  return state;
}

/// Most Newton steps for one boundary film. Where a plateau of the film comes to touch or to part, the contact changes
/// by some nodes in every step, and the residual does not fall before it has found its place. [bench:
/// boundary_film_step]
constexpr int most_steps = 150;

Scene patient(Scene scene) {
  scene.newton.patience = most_steps;
  return scene;
}

class MixedSolve {
 public:
  MixedSolve(const Scene& scene, const Solution* apart, const ProgressCallback& progress)
      : scene_(scene), patient_(patient(scene)), apart_(apart), run_(begin_multigrid(scene, usual_start(), progress)) {}

  Solution run() {
    const multigrid::LevelStep begin = [](multigrid::Run&, std::size_t) {};
    const multigrid::LevelStep solve = [this](multigrid::Run&, std::size_t l) { solve_level(l); };
    multigrid::for_levels(run_, run_.plan.first, run_.hierarchy.levels.size(), begin, solve);
    Solution solution = solution_of(scene_, std::move(run_));
    solution.newton = std::move(last_.steps);
    solution.method = "Newton-Krylov with contact";
    solution.path = "newton-mixed";
    return solution;
  }

 private:
  multigrid::Hierarchy& hierarchy() { return run_.hierarchy; }

  void solve_level(std::size_t l) {
    run_.record.levels.emplace_back();
    const bool finest = l == run_.finest();
    const bool solved = from_coarser(l) || from_apart(l) || from_dry(l, false) || from_dry(l, true);
    solved_ = solved;
    const std::string reason = multigrid::name_of_level(hierarchy(), l) + ": " + last_.reason;
    if (finest) {
      judge_newton(scene_, run_, solved, reason);
    } else {
      multigrid::enter(hierarchy(), l, 0, multigrid::measures_of(hierarchy(), l), run_.record);
      multigrid::observe(run_, l);
      if (!solved) run_.record.levels.clear();
    }
  }

  bool newton(std::size_t l, bool patiently = false) {
    const double tolerance = l == run_.finest() ? final_tolerance(scene_) : scene_.solver.judgement.default_tolerance;
    last_ = patiently ? solve_level_by_newton(patient_, run_, l, tolerance, most_steps)
                      : solve_level_by_newton(scene_, run_, l, tolerance);
    return last_.converged;
  }

  bool from_coarser(std::size_t l) {
    if (!solved_) return false;
    multigrid::start_from_coarser(hierarchy(), l);
    return newton(l);
  }

  bool from_apart(std::size_t l) {
    if (apart_ == nullptr) return false;
    multigrid::start_from_state(hierarchy(), l, {on_level(hierarchy(), l, apart_->P), apart_->H00});
    return newton(l);
  }

  // Continuation in the boundary film, from one that is thicker than the oil film. If it fails it is repeated with the
  // second-order wedge and epsilon as the mean of the nodes, with which rough contacts are found.
  bool from_dry(std::size_t l, bool with_mean) {
    double& factor = hierarchy().boundary_film;
    double ratio = scene_.tuning.boundary_film_step;
    factor = std::max(1.0, scene_.tuning.boundary_film_start * scene_.contact.film / scene_.boundary_film->H_b);
    multigrid::State state = dry_state(scene_, hierarchy(), l);
    double from = factor;
    for (bool any = false;;) {
      if (with_mean)
        start_with_mean(l, state);
      else
        multigrid::start_from_state(hierarchy(), l, state);
      if (newton(l, with_mean)) {
        state = multigrid::state_of(hierarchy(), l);
        if (factor == 1.0) break;
        any = true;
        from = factor;
      } else {
        ratio = std::sqrt(ratio);
        if (!any || ratio < scene_.tuning.boundary_film_least_step) {
          last_.reason +=
              "; this is for " + std::to_string(factor) + " times the boundary film of the deck: use more cells";
          factor = 1.0;
          return false;
        }
      }
      factor = std::max(1.0, from / ratio);
    }
    if (!with_mean) return true;
    multigrid::start_from_state(hierarchy(), l, state);
    return newton(l, true);
  }

  void start_with_mean(std::size_t l, const multigrid::State& state) {
    multigrid::start_from_state(hierarchy(), l, state);
    multigrid::Level& level = hierarchy().levels[l];
    level.scheme = multigrid::coarse_scheme_of(hierarchy().problem);
    multigrid::update_coefficients(hierarchy(), level);
  }

  const Scene& scene_;
  const Scene patient_;  ///< the same, for Newton's method
  const Solution* apart_;
  multigrid::Run run_;
  newton::Result last_{};
  bool solved_ = false;  ///< the level below
};

}  // namespace

Solution solve_mixed(const Scene& scene, const ProgressCallback& progress) {
  const double began = core::now();
  std::optional<Solution> apart;
  const bool first_apart = may_stay_apart(scene);
  if (first_apart) apart = solve_apart(scene, multigrid::part_of(progress, 0.0, share_of_apart));
  if (apart && stays_apart(scene, *apart)) return without_contact(std::move(*apart));
  const double seconds_apart = core::now() - began;
  const ProgressCallback rest = multigrid::part_of(progress, first_apart ? share_of_apart : 0.0, 1.0);
  Solution solution = MixedSolve(scene, apart ? &*apart : nullptr, rest).run();
  if (!first_apart && solution.converged && core::max_abs(solution.P_c) == 0.0)
    if (apart = solve_apart(scene, rest); apart && stays_apart(scene, *apart))
      return without_contact(std::move(*apart));
  const Attempt attempt{.method = solution.method,
                        .reason = solution.failed_check,
                        .seconds = core::now() - began - seconds_apart,
                        .path = solution.path};
  if (apart) solution.attempts = apart->attempts;
  solution.attempts.push_back(attempt);
  return solution;
}

Solution solve_with_half_film(const Scene& scene) {
  Scene half = scene;
  half.grid = core::coarsened(scene.grid);
  half.deformation = mlmi::fitting(half.deformation, half.grid);
  half.boundary_film->H_b *= 0.5;
  half.solver.coarsest_cells = 0;
  half.observer = {};
  return solve_mixed(half, {});
}

}  // namespace ehl::steady
