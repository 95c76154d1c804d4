#pragma once
// The grids of the multigrid method and the fields on each of them.
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "core/quadratic_form.hpp"
#include "core/timer.hpp"
#include "film/half_points.hpp"
#include "film/model.hpp"
#include "kernel/kernel.hpp"
#include "line_solvers/film_terms.hpp"
#include "mlmi/deformation.hpp"
#include "multigrid/parameters.hpp"
#include "multigrid/work_space.hpp"
#include "reynolds/far_field.hpp"
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
};

/// The unknowns of one level.
struct State {
  core::Field P;
  double H00 = 0.0;
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

/// Shares of a distributed change that each neighbour along X and along Y gives up; the four of them sum to 1. A point
/// of a line contact has two neighbours. On stretched cells the shares are in proportion to 1/h^2: equal ones make
/// lines amplify smooth errors (tests/convergence/test_smoothing.cpp).
struct DistributedShares {
  double along, across;
};
inline DistributedShares distributed_shares(const core::Patch& grid) {
  if (grid.domain.line) return {0.5, 0.5};
  if (!core::stretched(grid)) return {0.25, 0.25};
  const double stretch2 = core::stretch(grid) * core::stretch(grid);
  return {0.5 / (1.0 + stretch2), 0.5 * stretch2 / (1.0 + stretch2)};
}

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
  core::Field eps_across;  ///< along Y if it may differ (thinning, half points); 0 for a line contact; else empty
  OilFields oil;
  core::Field third_order;  ///< theta of the face downstream of each node (flux.hpp); empty if unused
  core::Field rho_bar;
  core::Field drho_bar;         ///< d rho_bar/dP
  core::Field f;                ///< right-hand side of the Reynolds equation (FAS); empty on the finest level: zero
  core::Field F;                ///< right-hand side of the film equation: S on the level being solved, else of FAS;
                                ///< empty on the finest level of a smooth contact
  core::Field H_restricted;     ///< the finer level's film at these nodes; empty on the finest level
  core::Field P_restricted;     ///< the finer level's pressure, restricted; empty on the finest level
  core::Field r;                ///< residual
  core::Field content;          ///< oil content Q of the mass-conserving model, set by the last residual; else empty
  std::vector<double> supply;   ///< oil that the surfaces bring in, per line; empty as `content`
  core::Field chatters;         ///< > 0 at chattering nodes; empty as `content`
  core::Field changes_of_kind;  ///< changes between full and cavitated, per node
  core::Field correction;       ///< of P, by the coarser level
  LineChanges changes;          ///< empty if relax_along_line() relaxes the level
  WorkSpace thread_work;        ///< made for the line solver and reach of the parameters
  mlmi::Deformation deformation;
  line_solvers::FilmTerms film_terms;
  std::vector<reynolds::FarPoint> boundary;  ///< far field at the boundary nodes (boundary.hpp)
  double load_outside = 0.0;                 ///< load outside the domain and on its boundary; not part of `load`
  double H00_of_boundary = 0.0;              ///< H00 for which the boundary pressure was computed
  double load = 0.0;                         ///< right-hand side of the force balance (FAS), at load_line.origin
  double H_floor = 0.0;                      ///< least share of H_restricted in epsilon on a correcting level; else 0
  Corrector corrector;
  long evaluations = 0;  ///< film evaluations, each with a relaxation sweep or a residual
};

/// A load that grows with H00, by `slope` per unit from `origin` on. In an implicit time step this is the inertia of a
/// body that moves with H00. slope >= 0; 0: a constant load.
struct LoadLine {
  double slope = 0.0;
  double origin = 0.0;
};

/// Motion of the bodies for the far field: their approach velocity, linear in H00 as in an implicit time step, and the
/// load that deforms them, over the problem's, with its rate. Default: steady.
struct FarMotion {
  double approach = 0.0;  ///< -dH00/dT where H00 = origin
  double slope = 0.0;     ///< derivative of dH00/dT by H00
  double origin = 0.0;
  double load = 1.0;
  double load_rate = 0.0;
  double flow = 0.0;  ///< flow through a line contact, renewed with the boundary
  /// Factor of the effects on epsilon upstream of a line contact's domain (recirculating oil is warm); renewed with the
  /// boundary.
  double mobility = 1.0;
};

struct Hierarchy {
  const Problem problem;
  const Parameters parameters;
  reynolds::Transport transport;  ///< the problem's, or that of an implicit step in time
  LoadLine load_line;
  FarMotion far_motion;
  LoadLine outside_line;      ///< change with H00 of the load that the outside leaves to the domain
  std::vector<Level> levels;  ///< solved one after another by the full multigrid method, coarsest first
  /// Grids that only correct, for levels with stretched cells: coarsened along Y alone until the cells are square, then
  /// in both directions. Lines along X smooth what varies rapidly along Y. Where the coupling along Y is the stronger
  /// one, errors that are smooth along Y and rough along X remain, which a grid coarsened in both directions cannot
  /// represent (local Fourier analysis). Coarsest first. [bench: grids_between]
  std::vector<Level> between;
  double H00 = 0.0;
  double coarsest_weight = 1.0;  ///< factor on the weights of the coarsest grid, reduced by failed visits
  double least_supply = 0.0;     ///< lower limit of the supply while a solution starts
  double supply_factor = 1.0;    ///< present supply over the problem's
  int threads = 1;
  core::PartTimes times;

  Level& finest() { return levels.back(); }
  /// Threads to use on a level: small grids are slower with more than one. A line contact always takes one, since a
  /// vector covers several of its nodes.
  int threads_on(const core::Patch& grid) const {
    return grid.domain.line || grid.nx * grid.ny < 128 * 128 ? 1 : threads;
  }
};

/// The present state of levels[l].
inline State state_of(const Hierarchy& hierarchy, std::size_t l) { return {hierarchy.levels[l].P, hierarchy.H00}; }

/// The grids from `finest` down to the coarsest, the finest first.
std::vector<core::Patch> grids_below(const core::Patch& finest, const Parameters& parameters);

/// The grid that corrects `level` in a cycle; null for the coarsest.
inline Level* corrector_of(Hierarchy& hierarchy, const Level& level) {
  if (level.corrector.index < 0) return nullptr;
  return &(level.corrector.between ? hierarchy.between
                                   : hierarchy.levels)[static_cast<std::size_t>(level.corrector.index)];
}

/// Grids from `finest` down to the coarsest, all fields zero, H00 = 0. The coarsest has parameters.coarsest_cells cells
/// along X; by default the least number >= least_coarsest_cells that halving gives. errors: core::InputError if the
/// finest grid cannot be halved down to the coarsest, or if the evaluation of the deformation does not fit a grid.
Hierarchy make_hierarchy(const Problem& problem, const Parameters& parameters, const mlmi::Parameters& deformation,
                         const core::Patch& finest, int threads);

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

/// H = H00 + gap + F + K*P (eq. 6), then rho_bar and epsilon (eq. 5) from P and H.
void update_film(Hierarchy& hierarchy, Level& level);
/// The coefficients of the present P and H.
void update_coefficients(Hierarchy& hierarchy, Level& level);

/// Line contacts: sets RelaxationParameters::line_zero on all levels.
void take_line_zero(Hierarchy& hierarchy, double line_zero);

/// Factor on the supply on this grid.
double share_of_supply(const Hierarchy& hierarchy, const Level& level);
/// Fills level.supply.
void supply_oil(const Hierarchy& hierarchy, Level& level);

/// level.r = f - L(P); also level.content.
void update_residual(Hierarchy& hierarchy, Level& level);

/// Pressure that deforms the bodies and carries the load: that of the fluid. (In mixed lubrication it would be the sum
/// of the fluid's and the asperities' pressure; only the former appears in the Reynolds equation.)
inline const core::Field& pressure_on_bodies(const Level& level) { return level.P; }

/// hx hy sum P (left-hand side of eq. 7).
double carried_load(const Level& level);
/// Right-hand side of eq. (7) at the present H00.
inline double wanted_load(const Hierarchy& hierarchy, const Level& level) {
  const auto along = [&](const LoadLine& line) { return line.slope * (hierarchy.H00 - line.origin); };
  return level.load + along(hierarchy.load_line) + along(hierarchy.outside_line);
}

/// True if epsilon of this level is stored at half points.
inline bool at_half_points(const Level& level) { return level.scheme.face != reynolds::Face::mean; }
/// True if epsilon along Y is a separate field.
inline bool two_epsilons(const Hierarchy& hierarchy, const Level& level) {
  return at_half_points(level) || film::anisotropic(hierarchy.problem.film);
}
/// epsilon along Y, chosen here so that the stencils read two fields without a branch.
inline const core::Field& eps_across(const Level& level) {
  if (level.grid.domain.line) return level.eps_across;
  const bool held_apart = level.oil.fluidity.nodes_x() == 0 || level.oil.fluidity_across.nodes_x() > 0;
  return level.eps_across.nodes_x() > 0 && (held_apart || at_half_points(level)) ? level.eps_across : level.eps;
}

/// Parameters of epsilon at half points.
inline film::Between between(const Problem& problem) {
  return {problem.film.lambda, reynolds::least_share(problem.face)};
}
/// The operator of the problem itself, and that of a level that corrects a finer one.
Scheme scheme_of(const Problem& problem);
Scheme coarse_scheme_of(const Problem& problem);
/// The transport term with the wedge of this level.
inline reynolds::Transport transport_on(const Hierarchy& hierarchy, const Level& level) {
  reynolds::Transport transport = hierarchy.transport;
  transport.wedge = level.scheme.wedge;
  return transport;
}

/// True for a level that corrects a finer one, false for the level being solved.
inline bool corrects_finer(const Level& level) { return level.H_floor != 0.0; }
/// True if the level has the mass-conserving cavitation model.
inline bool conserves_mass(const Level& level) { return level.content.nodes_x() > 0; }

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
          conserves_mass(level) ? &level.content : nullptr,
          conserves_mass(level) ? &level.chatters : nullptr};
}

}  // namespace ehl::multigrid
