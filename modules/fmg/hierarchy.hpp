#pragma once
// The grids of the multigrid and what lives on each of them.
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
#include "fmg/parameters.hpp"
#include "fmg/work_space.hpp"
#include "line_solvers/film_terms.hpp"
#include "mlmi/deformation.hpp"
#include "reynolds/far_field.hpp"
#include "reynolds/residual.hpp"

namespace ehl::fmg {

/// The bodies, in the units of eq. (6); without anything said a ball on a plane.
struct Geometry {
  core::QuadraticForm gap{0.5, 0.0, 0.5};      ///< of the undeformed bodies
  core::QuadraticForm outline{1.0, 0.0, 1.0};  ///< 1 along the edge of the dry contact
  double elastic = mlmi::circular_factor;      ///< factor of K*P
};
/// True where X, Y and X, -Y are the same.
inline bool symmetric(const Geometry& geometry) { return !geometry.gap.aslant(); }

/// The equations to solve: eqs. (4)-(7), or one of the linear model problems that lead to them.
struct Problem {
  film::Model film;
  reynolds::Transport transport = reynolds::Wedge::upstream2;
  reynolds::Face face = reynolds::Face::mean;
  /// eq. (7), h^2 sum P = load; absent: H00 is given and stays (the model problems).
  std::optional<double> load = 2.0 * std::numbers::pi / 3.0;
  reynolds::Cavitation cavitation = reynolds::Cavitation::nonnegative_pressure;
  /// Of the mass conserving model: what the surfaces bring, rho_bar H at most; per Y.
  std::function<double(double Y)> supply{};
  /// Of it on a grid with so many cells along X; empty: 1.
  std::function<double(int nx)> supply_share{};
  Geometry geometry{};
  /// The pressure on the boundary of the domain and the load outside of it; absent: none.
  std::optional<reynolds::FarField> far_field{};
  /// Writes S(X, Y), what the surfaces add to the gap, in units of a^2/R: on every grid what that grid can hold of it.
  /// Ghost lines are not needed. Empty: smooth surfaces.
  std::function<void(const core::Patch& grid, core::Field& S)> surface{};
  /// Writes the pressure of the dry contact, and gives its H00: what to begin with. Empty: that of Hertz.
  std::function<double(const core::Patch& grid, core::Field& P)> dry{};
};

/// The unknowns on one level: what a solution is, and all that is kept of one.
struct State {
  core::Field P;
  double H00 = 0.0;
};

/// Lines of one colour side by side, as many to a vector as it has lanes, one entry per station and batch: the changes
/// of a half sweep.
struct LineChanges {
  core::Field delta;        ///< what the line systems gave, under-relaxed
  core::Field distributed;  ///< the same where the point distributes its change, else 0
};

/// What epsilon at half points is made of (film/half_points.hpp), with ghost lines: empty with Face::mean.
struct OilFields {
  core::Field fluidity, log_viscosity;                ///< along X; and along Y where those are the same
  core::Field fluidity_across, log_viscosity_across;  ///< along Y, where the oil is thinned by shear; else empty
};

/// The discrete operator of a level: the problem's where the level is solved. While it corrects a finer level its
/// epsilon is the mean of the nodes and its wedge upstream2 at most. What little pressure passes from the top of a
/// spike through the logarithmic mean a coarse grid cannot tell: with it cycles left 0.6 to 0.9 of the residual at
/// L = 20, with the mean 0.2 to 0.3.
struct Scheme {
  reynolds::Wedge wedge = reynolds::Wedge::upstream2;
  reynolds::Face face = reynolds::Face::mean;
};

/// What of a distributed change each neighbour along X and across gives up; all four together 1. Along a line contact
/// there are two of them. In proportion to 1/h^2 of stretched cells: a change that took a quarter from points far away
/// along X would leave the film near it as it is, for points near it across are changed alike; such lines amplify
/// smooth errors twofold at hx/hy = 8 (tests/convergence/test_smoothing.cpp).
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
  bool between = false;  ///< one of Hierarchy::between, else of Hierarchy::levels
  int index = -1;        ///< -1: there is none, the grid is the coarsest
};

/// P, both eps and r have their ghost lines filled at all times, H with its coefficients.
struct Level {
  core::Patch grid;
  core::Field P;
  core::Field H;
  Scheme scheme;
  core::Field eps;         ///< along X, kept as scheme.face says; and along Y, where that is the same field
  core::Field eps_across;  ///< along Y, where it may be another one (thinning, half points); 0 of a line; else empty
  OilFields oil;
  core::Field third_order;  ///< theta of the face behind each node (flux.hpp); empty where no wedge and no face asks
  core::Field rho_bar;
  core::Field drho_bar;         ///< d rho_bar/dP
  core::Field f;                ///< right-hand side of the Reynolds equation (FAS); empty on the finest level: zero
  core::Field F;                ///< right-hand side of the film equation: S on the level being solved, else of FAS;
                                ///< empty on the finest level of a smooth contact
  core::Field H_restricted;     ///< the finer level's film at these nodes; empty on the finest level
  core::Field P_restricted;     ///< the finer level's pressure as it came down; likewise
  core::Field r;                ///< residual
  core::Field content;          ///< Q of the mass conserving model, as the last residual left it; else empty
  std::vector<double> supply;   ///< and what comes in, per line
  core::Field swings;           ///< likewise: > 0 at nodes that find no state (swinging.hpp)
  core::Field changes_of_kind;  ///< swinging.cpp
  core::Field correction;       ///< of P, on its way up
  LineChanges changes;          ///< empty where the lines are one (line_relaxation.hpp)
  WorkSpace thread_work;        ///< made for the parameters' line solver and reach
  mlmi::Deformation deformation;
  line_solvers::FilmTerms film_terms;
  std::vector<reynolds::FarPoint> boundary;  ///< boundary.hpp
  double load_outside = 0.0;                 ///< of the domain, and on its boundary; no part of `load`
  double H00_of_boundary = 0.0;              ///< to which the pressure on the boundary belongs
  double load = 0.0;                         ///< right-hand side of the force balance (FAS), at the load line's origin
  double H_floor = 0.0;  ///< share of H_restricted below which epsilon does not follow a falling coarse film; else 0
  Corrector corrector;
  long evaluations = 0;  ///< of the film, each with a relaxation sweep or a residual
};

/// A load that grows with H00, by `slope` per unit from `origin` on: in an implicit step of time the inertia of a body
/// that moves as H00 does. slope >= 0; without it the load is what it is.
struct LoadLine {
  double slope = 0.0;
  double origin = 0.0;
};

/// How the bodies move as the far field sees it: the velocity with which they come near each other, a line in H00 like
/// that of an implicit step of time, and the load that deforms them, over the problem's, with its rate. Steady without
/// anything said.
struct FarMotion {
  double approach = 0.0;  ///< -dH00/dT where H00 = origin
  double slope = 0.0;     ///< of dH00/dT with H00
  double origin = 0.0;
  double load = 1.0;
  double load_rate = 0.0;
  double flow = 0.0;  ///< through a line contact, renewed with the boundary
  /// Likewise: what effects make of epsilon upstream of a line's domain. Oil that recirculates there is warm.
  double mobility = 1.0;
};

struct Hierarchy {
  const Problem problem;
  const Parameters parameters;
  reynolds::Transport transport;  ///< the problem's, or that of an implicit step in time
  LoadLine load_line;
  FarMotion far_motion;
  LoadLine outside_line;      ///< of the load outside, as it is left for the inside
  std::vector<Level> levels;  ///< that the full multigrid solves one after another, coarsest first
  /// Grids that only correct, of levels with stretched cells: coarsened across X alone until the cells are square, then
  /// both ways. Along lines of constant Y relaxation smooths what changes fast across them, and nothing else where the
  /// coupling across is stronger: from hx = 2 hy on it leaves 0.6 to 0.99 of what is smooth across and rough along, so
  /// that a grid coarsened both ways cannot follow (local Fourier analysis; across X alone two grids leave 0.21 of the
  /// error at hx/hy = 1 to 16). Coarsest first.
  std::vector<Level> between;
  double H00 = 0.0;
  double coarsest_weight = 1.0;  ///< share of the relaxation's weights that the coarsest grid takes, from its visits on
  double least_supply = 0.0;     ///< less is not supplied yet: how a solution begins
  double supply_factor = 1.0;    ///< what is supplied now, over the problem's
  int threads = 1;
  core::PartTimes times;

  Level& finest() { return levels.back(); }
  /// Threads worth using on a level: small grids are slower with more than one. Of a line contact never more: vectors
  /// of lines reach over several of its stations.
  int threads_on(const core::Patch& grid) const {
    return grid.domain.line || grid.nx * grid.ny < 128 * 128 ? 1 : threads;
  }
};

/// What levels[l] holds now.
inline State state_of(const Hierarchy& hierarchy, std::size_t l) { return {hierarchy.levels[l].P, hierarchy.H00}; }

/// The grids from `finest` down to the coarsest, the finest first.
std::vector<core::Patch> grids_below(const core::Patch& finest, const Parameters& parameters);

/// The grid that corrects `level` in a cycle; null where it is the coarsest.
inline Level* corrector_of(Hierarchy& hierarchy, const Level& level) {
  if (level.corrector.index < 0) return nullptr;
  return &(level.corrector.between ? hierarchy.between
                                   : hierarchy.levels)[static_cast<std::size_t>(level.corrector.index)];
}

/// Grids from `finest` down to the coarsest, all fields zero, H00 = 0.
/// The coarsest has parameters.coarsest_cells cells along x, or by default the smallest number >= 32 that halving
/// gives. errors: core::InputError when the finest grid cannot be halved down to the coarsest, or the film evaluation
/// refuses.
Hierarchy make_hierarchy(const Problem& problem, const Parameters& parameters, const mlmi::Parameters& deformation,
                         const core::Patch& finest, int threads);

/// The film without deformation, H00 + the gap, for a circular contact X^2/2 + Y^2/2, at (X_i, Y_j).
inline double rigid_gap(const Geometry& geometry, const core::Patch& grid, double H00, int i, int j) {
  const auto& [XX, XY, YY] = geometry.gap;
  const double X = grid.X(i);
  const double Y = grid.Y(j);
  return H00 + XX * X * X + (XY * X + YY * Y) * Y;
}

/// H = H00 + gap + F + K*P (eq. 6), then rho_bar and epsilon (eq. 5) from P and H.
void update_film(Hierarchy& hierarchy, Level& level);
/// The coefficients alone.
void update_coefficients(Hierarchy& hierarchy, Level& level);

/// Of a line contact: another zero of the logarithm in what its relaxation foretells (RelaxationParameters::line_zero).
void take_line_zero(Hierarchy& hierarchy, double line_zero);

/// What this grid gets of the supply.
double share_of_supply(const Hierarchy& hierarchy, const Level& level);
/// Fills level.supply.
void supply_oil(const Hierarchy& hierarchy, Level& level);

/// level.r = f - L(P), and level.content.
void update_residual(Hierarchy& hierarchy, Level& level);

/// The pressure that deforms the bodies and carries the load: what the fluid has. (Where the surfaces touch, the sum of
/// the fluid's, which the Reynolds equation knows, and of theirs.)
inline const core::Field& pressure_on_bodies(const Level& level) { return level.P; }

/// hx hy sum P (left-hand side of eq. 7).
double carried_load(const Level& level);
/// Its right-hand side at the present H00.
inline double wanted_load(const Hierarchy& hierarchy, const Level& level) {
  const auto along = [&](const LoadLine& line) { return line.slope * (hierarchy.H00 - line.origin); };
  return level.load + along(hierarchy.load_line) + along(hierarchy.outside_line);
}

inline bool at_half_points(const Level& level) { return level.scheme.face != reynolds::Face::mean; }
/// True where epsilon along Y is a field of its own.
inline bool two_epsilons(const Hierarchy& hierarchy, const Level& level) {
  return at_half_points(level) || film::anisotropic(hierarchy.problem.film);
}
/// epsilon along Y: chosen here, so that the stencils read two fields and ask nothing.
inline const core::Field& eps_across(const Level& level) {
  if (level.grid.domain.line) return level.eps_across;
  const bool held_apart = level.oil.fluidity.nodes_x() == 0 || level.oil.fluidity_across.nodes_x() > 0;
  return level.eps_across.nodes_x() > 0 && (held_apart || at_half_points(level)) ? level.eps_across : level.eps;
}

/// How epsilon at half points is made.
inline film::Between between(const Problem& problem) {
  return {problem.film.lambda, reynolds::least_share(problem.face)};
}
/// The operator of the problem itself, and that of a level which corrects a finer one.
Scheme scheme_of(const Problem& problem);
Scheme coarse_scheme_of(const Problem& problem);
/// How the film is carried on a level.
inline reynolds::Transport transport_on(const Hierarchy& hierarchy, const Level& level) {
  reynolds::Transport transport = hierarchy.transport;
  transport.wedge = level.scheme.wedge;
  return transport;
}

/// Else it is the level being solved.
inline bool corrects_finer(const Level& level) { return level.H_floor != 0.0; }
inline bool conserves_mass(const Level& level) { return level.content.nodes_x() > 0; }

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
          conserves_mass(level) ? &level.swings : nullptr};
}

}  // namespace ehl::fmg
