#pragma once
// The temperature of a lubricated contact: the energy equation of the film with both bodies, at a given pressure and
// film thickness. It stands at the stage of the coefficients: in P and H, out the three numbers per node that carry the
// temperature to the Reynolds equation, I0, M2 and C, and beside them friction, temperatures and heat.
//
//   Pe rho c H^2 (u theta_X + v theta_Y + across) = (k_bar theta_zeta)_zeta + heat of shear + heat of compression,
//   theta_i = theta of the body + resistance_i G_i*q_i,  i = 1, 2: its surface (moving_source.hpp).
#include <limits>
#include <memory>
#include <optional>

#include "core/field.hpp"
#include "rheology/flow_thinning.hpp"
#include "rheology/shear.hpp"
#include "rheology/thermal_properties.hpp"
#include "rheology/thermal_viscosity.hpp"

namespace ehl::thermal {

struct Body {
  double Pe = 0.0;          ///< u a/kappa >= 0
  double resistance = 0.0;  ///< k0 R/(k a); 0: the surface stays at theta
  double theta = 0.0;       ///< far from the contact
};

/// Speeds in u_m, lengths in a; R is R_x.
struct Setup {
  core::Patch patch{};
  int intervals = 16;        ///< across the film
  double lambda = 1.0;       ///< 12 eta0 u_m R^2/(a^3 p_h)
  double srr = 0.0;          ///< (u1 - u2)/u_m; both speeds >= 0: -2 <= srr <= 2
  double stress_of_P = 0.0;  ///< p_h a^2/(eta0 u_m R)
  rheology::ViscosityLaw viscosity{};
  rheology::ThermalViscosity thermal_viscosity{};
  std::optional<rheology::ShearThinning> thinning{};
  /// The pressure's own flow thins too, and flows at limit/rate where the limit acts.
  std::optional<rheology::FlowThinning> flow_thinning{};
  rheology::ThermalDensity density{};
  rheology::HeatLaw heat{};
  double Br = 0.0;                                         ///< eta0 u_m^2/(k0 T0)
  double Pe = 0.0;                                         ///< rho0 c0 u_m a^3/(k0 R^2); 0: the film carries no heat
  double compression = 0.0;                                ///< p_h u_m a^3/(k0 T0 R^2); 0: none
  double limit = std::numeric_limits<double>::infinity();  ///< |tau_m| <= limit P, in p_h
  double theta_oil = 0.0;                                  ///< where oil enters
  Body body_1{}, body_2{};
  bool lines = false;                           ///< bodies by Carslaw and Jaeger's lines alone
  bool pressure_flow = true;                    ///< what pressure drives heats and carries too
  double theta_least = -0.4, theta_most = 2.5;  ///< an oil that expands behind a spike cools by tens of kelvin
  int threads = 1;
  /// Nothing makes or brings heat: the film stays at T0.
  bool cold() const { return Br == 0.0 && Pe == 0.0 && compression == 0.0; }
};

/// A film that stays cold: for what is not heat. in: viscosity and density at T0, and the rest of the setup to come.
Setup cold_setup(const rheology::ViscosityLaw& viscosity, const rheology::DensityLaw& density);

/// Largest values of the whole film, with their nodes.
struct Extreme {
  double theta = -std::numeric_limits<double>::infinity();
  int i = 0, j = 0;
};

/// Forces and heat, integrals over the domain by the sum over its nodes.
struct Balance {
  double friction = 0.0;  ///< integral of tau_m over that of P: mu, with the sign of srr
  double heat = 0.0;      ///< made in the film, in k0 T0 R; by shear and compression
  double into_1 = 0.0, into_2 = 0.0;
  double carried = 0.0;  ///< by the oil
  double defect = 0.0;   ///< heat - into_1 - into_2 - carried over heat
  Extreme film{}, surface_1{}, surface_2{};
  bool clipped = false;  ///< somewhere theta stood at a bound: no solution
};

class FilmColumns;

/// The columns themselves stand in FilmColumns (film_columns.hpp). How they lie side by side depends on the level of
/// the processor that a file is compiled for, and who uses this class may be compiled for every processor.
class FilmTemperature {
 public:
  /// errors: InputError for a number of intervals that is none, a surface that moves against the entrainment, or one
  /// that stands still in a line contact.
  explicit FilmTemperature(const Setup& setup);
  FilmTemperature(FilmTemperature&&) noexcept;
  FilmTemperature& operator=(FilmTemperature&&) noexcept;
  ~FilmTemperature();

  /// Begins with the temperatures of the grid of every second node, between its nodes by bilinear interpolation; and, a
  /// grid coarser still given, with a quarter of what changed from that one to the former: the errors are of order 2.
  void start_from(const FilmTemperature& coarse, const FilmTemperature* coarser = nullptr);

  /// A new pressure and film: properties, and the flows that convection and heating take from it, with the temperatures
  /// as they are. in: fields of the patch; H > 0 where P > 0; theta, the share of the gap that holds oil, or nullptr:
  /// the gap is full. Of the share conducts and flows what is there; behind a film it is sheared too, as streaks are;
  /// before it the oil lies on the surfaces in layers, which nothing shears.
  void take(const core::Field& P, const core::Field& H, const core::Field* theta = nullptr);

  /// All columns once: upstream where oil flows back and `back` says so, and downstream; then what the bodies make of
  /// the new fluxes. out: the largest change of theta. The same bits for any number of threads; nothing is allocated.
  double sweep(bool back = true);

  /// True where oil flows against the entrainment somewhere, as in an inlet that is wide.
  bool flows_back() const;
  const core::Field& I0() const;  ///< over the fluidity at T0
  const core::Field& M2() const;  ///< likewise, with the density over that at T0
  const core::Field& C() const;   ///< factor of rho_bar H in the wedge
  /// What the pressure's own flow makes of both mobilities and of tau_m beyond that (rheology/flow_thinning.hpp).
  const core::Field& more_x() const;
  const core::Field& more_y() const;
  const core::Field& less_tau() const;
  const core::Field& tau_m() const;
  const core::Field& q_1() const;
  const core::Field& q_2() const;
  /// theta of node k of the column (i, j), k = 0..intervals from surface 2.
  double theta(int i, int j, int k) const;
  /// Speed along X there, of the last take(), in u_m. limits: not with Pe = 0 and compression = 0.
  double velocity(int i, int j, int k) const;
  Balance balance() const;
  std::size_t bytes() const;

 private:
  std::unique_ptr<FilmColumns> columns_;
};

}  // namespace ehl::thermal
