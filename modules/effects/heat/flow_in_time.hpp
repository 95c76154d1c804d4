#pragma once
// Shear thinning by the pressure flow in a run in time, without heat: factors on the coefficients that follow the flow.
#include <limits>

#include "rheology/flow_thinning.hpp"
#include "rheology/laws.hpp"
#include "rheology/shear.hpp"
#include "transient/conditions.hpp"
#include "transient/coupling.hpp"

namespace ehl::heat {

/// Speeds in u_m, stresses in p_h.
struct FlowSetup {
  rheology::ViscosityLaw viscosity{};
  rheology::FlowThinning thinning{};
  double lambda = 1.0;       ///< 12 eta0 u_m R^2/(a^3 p_h)
  double stress_of_u = 0.0;  ///< eta0 u_m R/(a^2 p_h): stress of sliding by u_m at H = 1 and eta_bar = 1
  double limit = std::numeric_limits<double>::infinity();  ///< |tau_m| <= limit P
  int threads = 1;
};

/// The steady model of [shear] flow = on (effects/heat/README.md) at every cycle of an implicit step: the factors are
/// the secants flow/gradient at the flow of the present pressure, film and factors, a fixed-point iteration that
/// converges together with the cycles. limits: a contact that carries its load at T = 0.
class FlowInTime {
 public:
  /// The conditions must outlive this object.
  FlowInTime(const FlowSetup& setup, const transient::Conditions& conditions);
  /// The functions of the coupling, which refer to this object.
  transient::Coupling coupling();

 private:
  transient::FilmFactors respond(double T, const core::Patch& grid, const core::Field& P, const core::Field& H);

  FlowSetup setup_;
  const transient::Conditions& conditions_;
  core::Patch grid_{};
  transient::FilmFactors now_{};
  core::Field along_{}, across_{};  ///< its mobilities without the limiting stress
};

}  // namespace ehl::heat
