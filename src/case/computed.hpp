#pragma once
// What a run has computed.
#include <optional>
#include <string>
#include <vector>

#include "case/transient_run.hpp"
#include "core/constants.hpp"
#include "dry/solve.hpp"
#include "effects/friction/friction.hpp"
#include "effects/heat/solve.hpp"
#include "effects/roller/distribution.hpp"
#include "effects/subsurface/stress.hpp"
#include "steady/solution.hpp"

namespace ehl::program {

/// A value of a field and where it is, in Hertz radii.
struct Place {
  double value = 0.0;
  double X = 0.0;
  double Y = 0.0;
};

/// Central and minimum film by a published formula, as H = h R/a^2; NaN: the formula does not say.
struct Formula {
  std::string name{};
  std::string code{};  ///< in names of columns: nvm, hd, chittenden
  double Hc = 0.0;
  double Hm = 0.0;
};

/// Of a formula from the film computed, over that; NaN: one of them is unknown, or the film is below zero on too coarse
/// a mesh.
inline double deviation(double formula, double computed) {
  return computed > 0.0 ? formula / computed - 1.0 : core::unknown;
}

/// The film beside the roughness of the surfaces, in a^2/R.
struct Roughness {
  double Sq = 0.0;     ///< root mean square of the heights of both surfaces together, sqrt(Sq1^2 + Sq2^2)
  double Hm = 0.0;     ///< smallest film of smooth surfaces; NaN where nothing tells it
  std::string from{};  ///< that film: empty where this solution is one of smooth surfaces, else the formula
  double lambda_ratio() const { return Hm / Sq; }
};

/// NaN: not known in this case (nanometres of a dimensionless contact).
struct Outcome {
  double Hc = 0.0;
  Place Hm{};
  Place P_max{};
  double Hc_moes = 0.0;
  double Hm_moes = 0.0;
  double hc = 0.0;  ///< [m]
  double hm = 0.0;  ///< [m]
  std::vector<Formula> formulas{};
  std::optional<Roughness> roughness{};  ///< nothing: none is stated or measured
  std::string regime{};
  std::vector<std::string> warnings{};
};

/// Fields that are computed from the solution for the result only.
struct DerivedFields {
  core::Field rho_bar{};
  core::Field ln_eta_bar{};
  core::Field S{};  ///< of surfaces at rest
};

/// A contact with heat, or with an oil that the pressure's own flow thins, beside the one without.
struct HeatResult {
  heat::Solution found{};  ///< but for the film, which is the contact's
  double mu = 0.0;         ///< sliding friction over the load
  double mu_isothermal = 0.0;
  bool unlikely = false, unlikely_isothermal = false;  ///< a stress that no oil carries (friction::unlikely)
  std::vector<std::string> friction_warnings{};        ///< of mu
  double Hc_isothermal = 0.0, Hm_isothermal = 0.0;
};

/// Of the one that there is; nullptr: neither.
inline const heat::Fields* fields_of_film(const std::optional<HeatResult>& heat,
                                          const std::optional<HeatResult>& flow) {
  return heat ? &heat->found.fields : (flow ? &flow->found.fields : nullptr);
}

/// How a roller carries its load; with oil, on the grid of half as many cells, and without oil.
struct RollerResult {
  roller::Distribution found{};
  bool solved = true;  ///< the contact; else half as many cells are not tried
  std::optional<roller::Distribution> coarser{};
  roller::Distribution dry{};
  /// False where a spike may still grow, or hide between the nodes: what half as many cells say tells nothing of the
  /// highest pressures and of the stresses.
  bool pressures_settle = true;
  /// Largest von Mises stress below the middle and below the ends, where [subsurface] is on, and on the coarser grid.
  double mises_middle = 0.0, mises_end = 0.0;
  double mises_middle_coarser = 0.0, mises_end_coarser = 0.0;
  double seconds = 0.0;
};

/// The contact, and what each effect has added to it.
struct Computed {
  steady::Solution solution{};  ///< of a dry contact grid, P and whether it converged
  std::optional<dry::Solution> dry{};
  Outcome outcome{};
  DerivedFields derived{};
  std::optional<TransientResult> in_time{};
  std::optional<subsurface::StressField> stresses{};
  std::optional<friction::Friction> friction{};
  std::optional<HeatResult> heat{};
  std::optional<RollerResult> roller{};
  std::optional<HeatResult> flow{};  ///< isothermal, with [shear] flow = on
  double seconds = 0.0;              ///< of all of it
};

}  // namespace ehl::program
