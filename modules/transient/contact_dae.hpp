#pragma once
// The lubricated contact in time as a differential-algebraic system; multigrid cycles solve each implicit step.
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "multigrid/hierarchy.hpp"
#include "newton/steps.hpp"
#include "transient/body.hpp"
#include "transient/coupling.hpp"
#include "transient/ida.hpp"
#include "transient/tuning.hpp"

namespace ehl::transient {

/// What acts on the contact at one time.
struct Drive {
  double load = 1.0;       ///< over the load from which the dimensionless groups are made
  double speed = 1.0;      ///< U: entrainment speed over u_m, the speed that enters lambda; < 0: along -X
  double load_rate = 0.0;  ///< d load/dT before T, for the far field
  double supply = 1.0;     ///< oil supplied at the inlet, over that of the problem
  double sliding = 0.0;    ///< |u1 - u2| over u_m
  double radius = 1.0;     ///< R_x over that from which the groups are made; R_y stays the same
};

/// Surfaces and body of the contact, as functions of T = t u_m/a.
struct Course {
  /// Writes S(X, Y, T), the height that the reliefs of moving surfaces add to the gap, in units of a^2/R. Ghost nodes
  /// need not be set. Empty: smooth surfaces.
  std::function<void(const core::Patch& grid, double T, core::Field& S)> surface;
  bool bends = false;  ///< the radius varies
  /// Moves by its own equation of motion; absent: the film carries the load at all times.
  std::optional<Body> body{};
};

/// Tolerances of the time integration, and the iteration limit of one implicit step.
struct ErrorControl {
  double rtol = 1e-4;
  double P_scale = 0.1;  ///< absolute tolerance below this pressure: rtol P_scale
  double Q_scale = 0.1;  ///< the same for the film; about the central film
  int most_cycles = 30;  ///< per implicit step, before the time step is cut
  Tuning tuning{};
  newton::Tuning newton{};
  const Coupling* coupling = nullptr;  ///< an effect on the coefficients; null: none
};

/// Balance of the forces on the film at one time.
struct LoadBalance {
  double carried = 0.0;  ///< load that the film carries, over W
  double error = 0.0;    ///< carried load less required load, over the required load; with a body, over W
};

/// Oil in the domain, where mass is conserved.
struct OilInTime {
  double stored = 0.0;                      ///< in rho0 a^4/R
  double in = 0.0, out = 0.0, aside = 0.0;  ///< through inlet, outlet and sides, in rho0 u_m a^3/R
  double from_nowhere = 0.0;                ///< created by the last step, over the inflow of the steady film in a/u_m
  double lost = 0.0;                        ///< lost since the start, over that inflow in a/u_m
};

/// Unknowns y = (P, Q, H00); P and Q = rho_bar H on all nodes of the finest grid, Y fastest:
///   (eps P_X)_X + (eps P_Y)_Y - U(T) Q_X - Q' = 0 or P = 0,   Q = rho_bar(P) H(P, H00, S),   integral P = load(T).
/// An implicit step has y' = y'_p + cj (y - y_p), p the predictor. This is the steady problem with two more terms,
///   L(P) = (eps P_X)_X + (eps P_Y)_Y - U Q_X - cj Q = Q'_p - cj Q_p,
/// which the multigrid cycles solve from the predicted state. With a moving body y = (P, Q, H00, V), and
///   H00' = V,   mass V' + damping V = integral P/W - load(T)
/// replace the last equation; in an implicit step V and V' follow from H00, so the required load is linear in H00. With
/// a closed far field P on the boundary follows from H00 and H00', and the integral includes the load outside.
///
/// With an effect on the coefficients, whose factors are C on what the surfaces carry and E on what the gap holds, the
/// unknown Q is E rho_bar H, and the transport term is U (C rho_bar H)_X; cj (E - C) rho_bar H stands on the right-hand
/// side, where every cycle renews it. Where mass is conserved Q of a cavitated node is an unknown, and the last unknown
/// is the oil A of all interior nodes by the flows, A' = in - out - aside; it must equal the oil that the nodes store.
///
/// The wedge schemes, the march of the oil and the relaxation are written for a flow along +X. While U < 0 the level
/// therefore holds all fields mirrored in X, with the speed -U; y stays in the fixed coordinates, so IDA's history does
/// not change. limits: where U may become negative, X_a = -X_b and the gap has no term X Y.
class ContactDae {
 public:
  /// in: a hierarchy whose finest level holds the initial state and has the right-hand sides of a coarse level (see
  /// prepare()). The hierarchy must outlive this object.
  ContactDae(multigrid::Hierarchy& hierarchy, const Course& course, const ErrorControl& control);

  std::size_t size() const { return 2 * nodes_ + (course_.body ? 2 : 1) + (conserves_mass() ? 1 : 0); }
  bool conserves_mass() const { return multigrid::conserves_mass(hierarchy_.levels.back()); }
  std::size_t nodes() const { return nodes_; }

  /// Writes the state of the level to y.
  void state(std::span<double> y) const;
  /// Sets P, H00 and everything that depends on them at T from y. in: yp gives the load that a moving body requires;
  /// without it the applied load is required.
  void set_state(double T, const Drive& drive, std::span<const double> y, std::span<const double> yp = {});
  /// Places the body at its initial gap and velocity, without pressure, above the layer of supplied oil. in: the drive
  /// at T = 0. limits: the body has a gap.
  void release(const Drive& drive);

  /// Solves one implicit step. in: the drive at its time.
  StageResult solve(const Stage& stage, const Drive& drive, std::span<double> correction);
  void weights(std::span<const double> y, std::span<double> w) const;

  /// Smallest H of all nodes of y; where mass is conserved, of the nodes that carry pressure.
  double least_film(std::span<const double> y);

  /// Where mass is conserved: sets Q of the level to that of the steady film, or to the supplied layer below a body at
  /// a gap.
  void begin_oil();
  /// Starts the oil count: the oil of the current state becomes the reference, in y too.
  void count_from_here(std::span<double> y);
  OilInTime oil() const;
  /// theta = Q/(rho_bar H) on the whole domain where mass is conserved, else empty.
  core::Field theta() const;

  /// One multigrid cycle of the problem set by pose(). errors: core::SolverError.
  void cycle();
  /// Factor on all under-relaxation factors of the cycles, at the start and in time.
  double weight() const { return weight_; }
  void set_weight(double weight) { weight_ = weight; }
  const Tuning& tuning() const { return control_.tuning; }

  /// Makes the carried load exact: scales P by a common factor and shifts H00 so that the central film stays the same.
  void balance_load();

  /// Velocity of the body; 0 without a body.
  double velocity() const { return V_; }
  /// True while U < 0: the level holds all fields mirrored in X.
  bool reversed() const { return reversed_; }
  LoadBalance load_balance() const;
  /// V' of the body, from its equation of motion with the carried load.
  double acceleration(const Drive& drive) const;

  /// Sets the coefficients of the problem at T with squeeze coefficient cj; the right-hand side stays as it is.
  void pose(double T, const Drive& drive, double cj);

  /// Sets the factors of the effect. returns the largest change of ln(epsilon).
  double take_factors(const FilmFactors& factors);
  /// Its factor on the shear stress of sliding; empty: 1.
  const core::Field& stress() const { return stress_; }

 private:
  /// Method that solves the equations of an implicit step.
  enum class Iteration { cycles, newton };
  void begin(const Stage& stage, const Drive& drive);
  StageResult attempt(const Stage& stage, const Drive& drive, std::span<double> correction);
  StageResult solved(const Stage& stage, const Drive& drive, std::span<double> correction);
  StageResult iterate(const Stage& stage, Iteration kind, double& rate);
  StageResult respond(const Stage& stage, Iteration kind, double& rate);
  void set_known(const Stage& stage);
  void renew_coupling(const Stage& stage, int cycle);
  double stored_share(int i, int j) const { return control_.coupling ? stored_share_(i, j) : 1.0; }
  void pose_gap(double T, const Drive& drive);
  bool newton_can() const;
  bool balanced_by_cycle(const Stage& stage) const;
  double change(const Stage& stage, double H00_before);
  double carried() const;
  void take_motion(const Drive& drive, double approach);
  void move_body(const Stage& stage);
  void take_velocity(const Stage& stage, const Drive& drive);
  double content(int i, int j) const;
  bool in_zone(int i, int j) const;
  bool at_edge(std::span<const double> y, int i, int j) const;
  void set_content(std::span<const double> y);
  bool correct_mass();
  void spread_oil();
  bool released() const { return course_.body && course_.body->gap; }
  void count_oil(const Stage& stage);

  multigrid::Hierarchy& hierarchy_;
  const Course& course_;
  ErrorControl control_;
  std::size_t nodes_;
  double W_;        ///< integral of P for the load from which the groups are made
  double V_ = 0.0;  ///< velocity of the body
  bool reversed_ = false;
  double zone_ = 0.0;  ///< weighted number of nodes in the error norm, on the whole domain
  double weight_ = 1.0;
  double rate_;  ///< convergence factor of the cycles, as last measured
  std::unique_ptr<newton::Steps> newton_;
  int newton_stages_ = 0;      ///< implicit steps that Newton's method still solves, the cycles having failed
  int newton_next_ = 1;        ///< number of such steps after the next failure
  double inlet_ = 0.0;         ///< flow through the inlet in the steady film
  double oil_by_flows_ = 0.0;  ///< oil at the start plus what has flowed in and out since
  double from_nowhere_ = 0.0;
  core::Field P_before_, Q_before_;
  core::Field stored_share_;  ///< E/C of the effect
  core::Field stress_{};      ///< factor of the effect on the shear stress of sliding
  std::vector<double> rho_;
  std::vector<double> before_, now_;  ///< states around the response of an effect
};

/// Allocates on the finest level the right-hand sides that a transient needs.
void prepare(multigrid::Hierarchy& hierarchy);

}  // namespace ehl::transient
