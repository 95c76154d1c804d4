#pragma once
// The grids of the multigrid method.
#include <optional>
#include <vector>

#include "core/timer.hpp"
#include "multigrid/level.hpp"
#include "multigrid/parameters.hpp"
#include "reynolds/row.hpp"

namespace ehl::multigrid {

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
  double boundary_film = 1.0;    ///< present boundary film over the problem's
  double sliding = 1.0;          ///< present speed of sliding over that in the problem's shear thinning
  int threads = 1;
  core::PartTimes times;

  Level& finest() { return levels.back(); }
  /// Threads to use on a level: small grids are slower with more than one. So is a single line, since a vector covers
  /// several of its nodes.
  int threads_on(const core::Patch& grid) const {
    return grid.last_line() == 1 || grid.nx * grid.ny < 128 * 128 ? 1 : threads;
  }
};

/// The present state of levels[l].
inline State state_of(const Hierarchy& hierarchy, std::size_t l) {
  const Level& level = hierarchy.levels[l];
  return {level.P, hierarchy.H00, level.touching ? level.touching->P_c : core::Field()};
}
/// The present boundary film. in: a problem that has one.
inline double boundary_film(const Hierarchy& hierarchy) {
  return hierarchy.boundary_film * hierarchy.problem.boundary_film->H_b;
}

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

/// H = H00 + gap + F + K*P (eq. 6), then rho_bar and epsilon (eq. 5) from P and H.
void update_film(Hierarchy& hierarchy, Level& level);
/// The coefficients of the present P and H.
void update_coefficients(Hierarchy& hierarchy, Level& level);

/// Line contacts: sets RelaxationParameters::line_zero on all levels.
void take_line_zero(Hierarchy& hierarchy, double line_zero);

/// Factor on the supply on this grid.
double share_of_supply(const Hierarchy& hierarchy, const Level& level);
/// Fills the supply of the level if it conserves mass.
void supply_oil(const Hierarchy& hierarchy, Level& level);

/// level.r = f - L(P); also the oil content.
void update_residual(Hierarchy& hierarchy, Level& level);

/// Right-hand side of eq. (7) at the present H00.
inline double wanted_load(const Hierarchy& hierarchy, const Level& level) {
  const auto along = [&](const LoadLine& line) { return line.slope * (hierarchy.H00 - line.origin); };
  return level.load + along(hierarchy.load_line) + along(hierarchy.outside_line);
}

/// The nodes of column i as the film model takes them.
inline film::Station station_of(const Hierarchy& hierarchy, const Level& level, int i, std::span<const double> P,
                                std::span<const double> H, bool along = false) {
  return {level.grid, i, P, H, along, level.factors ? &*level.factors : nullptr, hierarchy.sliding};
}

/// True if epsilon along Y is a separate field.
inline bool two_epsilons(const Hierarchy& hierarchy, const Level& level) {
  return at_half_points(level) || film::anisotropic(hierarchy.problem.film);
}
/// The transport term with the wedge of this level.
inline reynolds::Transport transport_on(const Hierarchy& hierarchy, const Level& level) {
  reynolds::Transport transport = hierarchy.transport;
  transport.wedge = level.scheme.wedge;
  return transport;
}
/// The rows of the Reynolds equation on a level.
inline reynolds::NodeRows rows(const Hierarchy& hierarchy, const Level& level) {
  return {level.grid, fields(level), transport_on(hierarchy, level)};
}

}  // namespace ehl::multigrid
