#pragma once
// The problem to solve, and one grid with its fields.
#include <cstdlib>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "core/quadratic_form.hpp"
#include "film/half_points.hpp"
#include "film/model.hpp"
#include "kernel/kernel.hpp"
#include "line_solvers/film_terms.hpp"
#include "mlmi/deformation.hpp"
#include "multigrid/boundary_film.hpp"
#include "multigrid/work_space.hpp"
#include "reynolds/far_field.hpp"
#include "reynolds/flux.hpp"
#include "reynolds/residual.hpp"

namespace ehl::multigrid {

/// The bodies, in the units of eq. (6). Default: a ball on a plane.
struct Geometry {
  core::QuadraticForm gap{0.5, 0.0, 0.5};      ///< of the undeformed bodies
  core::QuadraticForm outline{1.0, 0.0, 1.0};  ///< 1 along the edge of the dry contact
  kernel::Kernel kernel{};                     ///< of the deformation, K*P
};
/// True if the problem is symmetric about Y = 0.
inline bool symmetric(const Geometry& geometry) { return !geometry.gap.oblique(); }

/// The equations to solve: eqs. (4)-(7), or one of the linear model problems that lead to them.
struct Problem {
  film::Model film;
  reynolds::Transport transport = reynolds::Wedge::upstream2;
  reynolds::Face face = reynolds::Face::mean;
  /// eq. (7), h^2 sum P = load; absent: H00 is prescribed (the model problems).
  std::optional<double> load = 2.0 * std::numbers::pi / 3.0;
  reynolds::Cavitation cavitation = reynolds::Cavitation::nonnegative_pressure;
  /// Mass-conserving cavitation model: largest rho_bar H that the surfaces bring in along the line Y.
  std::function<double(double Y)> supply{};
  /// Factor on the supply on a grid of nx cells along X; empty: 1.
  std::function<double(int nx)> supply_share{};
  Geometry geometry{};
  /// The pressure on the boundary of the domain and the load outside of it; absent: none.
  std::optional<reynolds::FarField> far_field{};
  /// Writes S(X, Y), what the surface relief adds to the gap, in units of a^2/R, as far as the given grid resolves it.
  /// Ghost lines are not needed. Empty: smooth surfaces.
  std::function<void(const core::Patch& grid, core::Field& S)> surface{};
  /// Writes the pressure of the dry contact, from which the solution starts, and returns its H00. Empty: the Hertz
  /// pressure.
  std::function<double(const core::Patch& grid, core::Field& P)> dry{};
  /// Absent: the surfaces do not touch. limits: with it only Newton's method solves the problem.
  std::optional<BoundaryFilm> boundary_film{};
};

/// The unknowns of one level.
struct State {
  core::Field P;
  double H00 = 0.0;
  core::Field P_c{};  ///< of touching surfaces; empty: zero
};

/// The fields of touching surfaces. With them Level::P is the pressure of the fluid alone.
struct Touching {
  core::Field P_c;      ///< pressure between the surfaces
  core::Field total;    ///< P + P_c, set with the film
  core::Field yielded;  ///< what yielding adds to H; empty without a hardness
};

/// Changes of a half sweep. Lines of one colour are stored next to each other, as many to a vector as it has lanes, one
/// entry per column (constant X) and batch.
struct LineChanges {
  core::Field delta;        ///< solution of the line systems, under-relaxed
  core::Field distributed;  ///< the same at points that distribute their change, else 0
};

/// The fields that epsilon at half points is computed from (film/half_points.hpp), with ghost lines. Empty with
/// Face::mean.
struct OilFields {
  core::Field fluidity, log_viscosity;                ///< along X; without shear thinning also along Y
  core::Field fluidity_across, log_viscosity_across;  ///< along Y with shear thinning; else empty
};

/// The discrete operator of a level. A level that is solved has the problem's own. A level that corrects a finer one
/// has epsilon as the mean of the nodes, and upstream2 instead of a third-order wedge: a coarse grid cannot represent
/// how little pressure the logarithmic mean lets through at the top of a spike. [bench: coarse_scheme]
struct Scheme {
  reynolds::Wedge wedge = reynolds::Wedge::upstream2;
  reynolds::Face face = reynolds::Face::mean;
};

/// Shares of a distributed change that each neighbour along X and along Y gives up; the four of them sum to 1. Where
/// nothing flows aside, a point has two neighbours. On stretched cells the shares are in proportion to 1/h^2: equal
/// ones make lines amplify smooth errors (tests/convergence/test_smoothing.cpp).
struct DistributedShares {
  double along, across;
};
inline DistributedShares distributed_shares(const core::Patch& grid) {
  if (!reynolds::flows_aside(grid)) return {0.5, 0.5};
  if (!core::stretched(grid)) return {0.25, 0.25};
  const double stretch2 = core::stretch(grid) * core::stretch(grid);
  return {0.5 / (1.0 + stretch2), 0.5 * stretch2 / (1.0 + stretch2)};
}

/// What a level does at present: it is solved itself, or it corrects a finer one (full approximation scheme).
enum class Role { solved, corrects };

/// What a correcting level keeps of the finer one, injected or restricted to its nodes.
struct FromFiner {
  core::Field H;
  core::Field P;
  double H_floor = 0.0;  ///< least share of H in epsilon
};

/// The fields of the mass-conserving cavitation model.
struct OilContent {
  core::Field Q;                ///< oil content, set by the last residual
  std::vector<double> supply;   ///< oil that the surfaces bring in, per line
  core::Field chatters;         ///< > 0 at chattering nodes
  core::Field changes_of_kind;  ///< changes between full and cavitated, per node
};

/// The grid that corrects another one in a cycle.
struct Corrector {
  bool between = false;  ///< index in Hierarchy::between, else in Hierarchy::levels
  int index = -1;        ///< -1: none, the grid is the coarsest
};

/// One grid with its fields. P, both eps and r have their ghost lines filled at all times, H after its coefficients are
/// evaluated.
struct Level {
  core::Patch grid;
  core::Field P;
  core::Field H;
  Scheme scheme;
  core::Field eps;         ///< along X, stored as scheme.face says; see eps_across() for Y
  core::Field eps_across;  ///< along Y if it may differ (thinning, half points); else empty
  OilFields oil;
  std::optional<film::FactorFields> factors;  ///< if the film model has factors
  core::Field third_order;                    ///< theta of the face downstream of each node (flux.hpp); empty if unused
  core::Field rho_bar;
  core::Field drho_bar;            ///< d rho_bar/dP
  core::Field f;                   ///< right-hand side of the Reynolds equation (FAS); empty on the finest level: zero
  core::Field F;                   ///< right-hand side of the film equation: S on the level being solved, else of FAS;
                                   ///< empty on the finest level of a smooth contact
  std::optional<FromFiner> finer;  ///< absent on the finest level
  core::Field r;                   ///< residual
  std::optional<OilContent> content;  ///< of the mass-conserving cavitation model
  std::optional<Touching> touching;   ///< if the problem has a boundary film
  core::Field correction;             ///< of P, by the coarser level
  LineChanges changes;                ///< empty if relax_along_line() relaxes the level
  WorkSpace thread_work;              ///< made for the line solver and reach of the parameters
  mlmi::Deformation deformation;
  line_solvers::FilmTerms film_terms;
  std::vector<reynolds::FarPoint> boundary;  ///< far field at the boundary nodes (boundary.hpp)
  double load_outside = 0.0;                 ///< load outside the domain and on its boundary; not part of `load`
  double H00_of_boundary = 0.0;              ///< H00 for which the boundary pressure was computed
  double load = 0.0;                         ///< right-hand side of the force balance (FAS), at load_line.origin
  Role role = Role::solved;
  Corrector corrector;
  long evaluations = 0;  ///< film evaluations, each with a relaxation sweep or a residual
};

/// True if epsilon of this level is stored at half points.
inline bool at_half_points(const Level& level) { return level.scheme.face != reynolds::Face::mean; }
/// epsilon along Y, chosen here so that the stencils read two fields without a branch.
inline const core::Field& eps_across(const Level& level) {
  const bool held_apart = level.oil.fluidity.nodes_x() == 0 || level.oil.fluidity_across.nodes_x() > 0;
  return level.eps_across.nodes_x() > 0 && (held_apart || at_half_points(level)) ? level.eps_across : level.eps;
}

/// True for a level that corrects a finer one, false for the level being solved.
inline bool corrects_finer(const Level& level) { return level.role == Role::corrects; }
/// True if the level has the mass-conserving cavitation model.
inline bool conserves_mass(const Level& level) { return level.content.has_value(); }

/// The fields of the Reynolds equation.
inline reynolds::Fields fields(const Level& level) {
  return {level.P,
          level.H,
          level.rho_bar,
          level.eps,
          level.f,
          eps_across(level),
          level.scheme.face,
          level.third_order,
          conserves_mass(level) ? &level.content->Q : nullptr,
          conserves_mass(level) ? &level.content->chatters : nullptr};
}

/// Pressure that deforms the bodies and carries the load: that of the fluid, and of touching surfaces. Only the former
/// appears in the Reynolds equation.
inline const core::Field& pressure_on_bodies(const Level& level) {
  return level.touching ? level.touching->total : level.P;
}

/// hx hy sum P (left-hand side of eq. 7).
double carried_load(const Level& level);

/// Parameters of epsilon at half points.
inline film::Between between(const Problem& problem) {
  return {problem.film.lambda, reynolds::least_share(problem.face)};
}
/// The operator of the problem itself, and that of a level that corrects a finer one.
Scheme scheme_of(const Problem& problem);
Scheme coarse_scheme_of(const Problem& problem);

/// Film without deformation at (X_i, Y_j): H00 + gap, for a circular contact H00 + X^2/2 + Y^2/2.
inline double rigid_gap(const Geometry& geometry, const core::Patch& grid, double H00, int i, int j) {
  const auto& [XX, XY, YY] = geometry.gap;
  const double X = grid.X(i);
  const double Y = grid.Y(j);
  return H00 + XX * X * X + (XY * X + YY * Y) * Y;
}

/// dH_ij/dP_kl at the distances |i - k|, |j - l| <= 1 that the relaxations contain; along a line up to their reach.
inline double film_response(const Level& level, int d_x, int d_y = 0) {
  const auto k = static_cast<std::size_t>(std::abs(d_x));
  return d_y == 0 ? level.film_terms.K[k] : level.film_terms.K_across[k];
}

}  // namespace ehl::multigrid
