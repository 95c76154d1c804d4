#pragma once
// The lubricated contact in time as a differential-algebraic system, each implicit step solved by multigrid cycles.
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "fmg/hierarchy.hpp"
#include "newton/steps.hpp"
#include "transient/body.hpp"
#include "transient/ida.hpp"

namespace ehl::transient {

/// What acts on the contact at one time.
struct Drive {
  double load = 1.0;       ///< over the one that the groups are made with
  double speed = 1.0;      ///< U >= 0: entrainment speed over the one that lambda is made with
  double load_rate = 0.0;  ///< d load/dT before T, for the far field
  double supply = 1.0;     ///< of oil at the inlet, over the problem's
};

/// Where the contact is taken in time beside its drive, with T = t u_m/a.
struct Course {
  /// Writes S(X, Y, T), the shape of the moving surfaces: what they add to the gap, in units of a^2/R; Ghost
  /// lines are not needed. Empty: smooth surfaces.
  std::function<void(const core::Patch& grid, double T, core::Field& S)> surface;
  /// Moves by its own equation; absent: the load is carried at all times.
  std::optional<Body> body{};
};

struct ErrorControl {
  double rtol = 1e-4;
  double P_scale = 0.1;  ///< pressures below this count absolutely
  double Q_scale = 0.1;  ///< films below this too: about the central film
  int most_cycles = 30;  ///< in one stage, before the step is cut
};

struct LoadBalance {
  double carried = 0.0;  ///< by the film, over W, the load that the groups are made with
  double error = 0.0;    ///< of what is carried, over the load that acts; with a body, over W
};

/// The oil of the domain, where mass is conserved.
struct OilInTime {
  double stored = 0.0;                      ///< in rho0 a^4/R
  double in = 0.0, out = 0.0, aside = 0.0;  ///< through inlet, outlet and sides, in rho0 u_m a^3/R
  double from_nowhere = 0.0;                ///< in the last step, over what flows into the steady film in a/u_m
  double lost = 0.0;                        ///< since the start, over what that brings in a/u_m
};

/// The unknowns y = (P, Q, H00), P and Q = rho_bar H on all nodes of the finest grid, Y fastest:
///   (eps P_X)_X + (eps P_Y)_Y - U(T) Q_X - Q' = 0 or P = 0,   Q = rho_bar(P) H(P, H00, S),   integral P = load(T).
/// With y' = y'_p + cj (y - y_p) of the implicit step this is the steady problem with the additional terms
///   L(P) = (eps P_X)_X + (eps P_Y)_Y - U Q_X - cj Q = Q'_p - cj Q_p,
/// which the cycles of `fmg` solve from the predicted state on. With a body that moves, y = (P, Q, H00, V):
///   H00' = V,   mass V' + damping V = integral P/W - load(T)
/// in place of the last equation. With a far field in closed form P on the boundary is what it says of H00 and H00',
/// and the integral has its load outside. In the implicit step V and V' follow from H00: a load that grows with H00.
/// Where mass is conserved Q of a dry point is what flows into it, and the last unknown is the oil of all interior
/// nodes by what flows in and out, A' = in - out - aside: it must stay what the nodes have.
class ContactDae {
 public:
  /// in: a hierarchy whose finest level holds the state at the start, with the right-hand sides of a coarse level:
  /// prepare() it. It must outlive this object.
  ContactDae(fmg::Hierarchy& hierarchy, const Course& course, const ErrorControl& control);

  std::size_t size() const { return 2 * nodes_ + (course_.body ? 2 : 1) + (conserves_mass() ? 1 : 0); }
  bool conserves_mass() const { return fmg::conserves_mass(hierarchy_.levels.back()); }
  std::size_t nodes() const { return nodes_; }

  /// y of the level's state.
  void state(std::span<double> y) const;
  /// The level's P, H00 and all that follows from them at T, from y. yp: for the load that a moving body wants; without
  /// it, the one that acts.
  void set_state(double T, const Drive& drive, std::span<const double> y, std::span<const double> yp = {});
  /// The body at its gap, without pressure, with its velocity; oil that is supplied lies under it. in: the drive at T =
  /// 0; a course with a body that has a gap.
  void release(const Drive& drive);

  /// in: the drive at the stage's time.
  StageResult solve(const Stage& stage, const Drive& drive, std::span<double> correction);
  void weights(std::span<const double> y, std::span<double> w) const;

  /// Smallest H of all nodes in y; where mass is conserved, of those that carry pressure.
  double least_film(std::span<const double> y);

  /// Where mass is conserved: makes the level's content that of the steady film, where there is one.
  void begin_oil();
  /// The oil that the flows are added to from now on: that of the state that was set, in y too.
  void count_from_here(std::span<double> y);
  OilInTime oil() const;
  /// theta = Q/(rho_bar H) of the whole domain, where mass is conserved; else empty.
  core::Field theta() const;

  /// One cycle of the problem that is posed. errors: core::SolverError.
  void cycle();
  /// The factor on all under-relaxation weights of its cycles, at rest and in time.
  double weight() const { return weight_; }
  void set_weight(double weight) { weight_ = weight; }

  /// Carries the load exactly: the pressure by a common factor, the film at the centre held by H00.
  void balance_load();

  /// Velocity of the body, 0 without one.
  double velocity() const { return V_; }
  LoadBalance load_balance() const;
  /// V' of a body, by its equation of motion from what the film carries.
  double acceleration(const Drive& drive) const;

  /// The terms of the problem at T with squeeze cj; the right-hand side is left alone.
  void pose(double T, const Drive& drive, double cj);

 private:
  /// How the equations of a stage are solved.
  enum class Way { cycles, newton };
  void begin(const Stage& stage, const Drive& drive);
  StageResult solved(const Stage& stage, const Drive& drive, std::span<double> correction);
  StageResult iterate(const Stage& stage, Way way, double& rate);
  bool newton_can() const;
  bool balanced_by_cycle(const Stage& stage) const;
  double change(const Stage& stage, double H00_before);
  double carried() const;
  void take_motion(const Drive& drive, double approach);
  void move_body(const Stage& stage);
  void take_velocity(const Stage& stage, const Drive& drive);
  double content(int i, int j) const;
  bool at_edge(std::span<const double> y, int i, int j) const;
  void set_content(std::span<const double> y);
  bool close_oil();
  void spread_oil();
  bool released() const { return course_.body && course_.body->gap; }
  void count_oil(const Stage& stage);

  fmg::Hierarchy& hierarchy_;
  const Course& course_;
  ErrorControl control_;
  std::size_t nodes_;
  double W_;           ///< integral P of the load that the groups are made with
  double V_ = 0.0;     ///< velocity of the body
  double zone_ = 0.0;  ///< nodes that make up the norm, of the whole domain
  double weight_ = 1.0;
  double rate_ = 0.3;  ///< of the cycles, as last measured
  std::unique_ptr<newton::Steps> newton_;
  int newton_stages_ = 0;      ///< to come that it solves, cycles having failed
  int newton_next_ = 1;        ///< as many when they fail again
  double inlet_ = 0.0;         ///< flow through it in the steady film
  double oil_by_flows_ = 0.0;  ///< as much as at the start, and what has flowed in and out since
  double from_nowhere_ = 0.0;
  core::Field P_before_, Q_before_;
  std::vector<double> rho_;
};

/// Gives the finest level the right-hand sides that a transient needs.
void prepare(fmg::Hierarchy& hierarchy);

}  // namespace ehl::transient
