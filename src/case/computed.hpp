#pragma once
// The results of a run.
#include <optional>
#include <string>
#include <vector>

#include "case/transient_run.hpp"
#include "core/constants.hpp"
#include "core/warning.hpp"
#include "dry/solve.hpp"
#include "effects/friction/friction.hpp"
#include "effects/heat/solve.hpp"
#include "effects/mixed/contact.hpp"
#include "effects/roller/analysis.hpp"
#include "effects/subsurface/history.hpp"
#include "effects/subsurface/stress.hpp"
#include "steady/solution.hpp"

namespace ehl::program {

/// A value of a field and its place, in Hertz radii.
struct Place {
  double value = 0.0;
  double X = 0.0;
  double Y = 0.0;
};

/// Central and minimum film of a published formula, as H = h R/a^2; NaN: the formula does not give it.
struct Formula {
  std::string name{};
  std::string code{};  ///< in the names of columns: nvm, hd, chittenden
  double Hc = 0.0;
  double Hm = 0.0;
};

/// The relative deviation (formula - computed)/computed. NaN if one of them is unknown, or if the computed film is not
/// positive because the mesh is too coarse.
inline double deviation(double formula, double computed) {
  return computed > 0.0 ? formula / computed - 1.0 : core::unknown;
}

/// The film and the roughness of the surfaces, in a^2/R.
struct Roughness {
  double Sq = 0.0;     ///< root mean square height of both surfaces combined, sqrt(Sq1^2 + Sq2^2)
  double Hm = 0.0;     ///< minimum film of smooth surfaces; NaN if it is not known
  std::string from{};  ///< source of Hm: a formula; empty if Hm is that of this solution, whose surfaces are smooth
  double lambda_ratio() const { return Hm / Sq; }
};

/// NaN: not known in this case, such as a film in nanometres if the contact is dimensionless.
struct Outcome {
  double Hc = 0.0;
  Place Hm{};
  Place P_max{};
  double Hc_moes = 0.0;
  double Hm_moes = 0.0;
  double hc = 0.0;  ///< [m]
  double hm = 0.0;  ///< [m]
  std::vector<Formula> formulas{};
  std::optional<Roughness> roughness{};  ///< nothing: the roughness is neither stated nor measured
  std::string regime{};
  core::Warnings warnings{};
};

/// Fields that are computed from the solution only for the result file.
struct DerivedFields {
  core::Field rho_bar{};
  core::Field ln_eta_bar{};
  core::Field S{};  ///< the gap that surfaces at rest add
};

/// The solution with heat, or with an oil that thins by the pressure flow, and numbers of the solution without it.
struct HeatResult {
  heat::Solution found{};                ///< the solution except its film, which is that of the contact
  double mu = 0.0;                       ///< sliding friction divided by the load
  double error_mu = core::unknown;       ///< estimated relative error of mu
  double mu_isothermal = core::unknown;  ///< NaN as the others if the film was found from that of the previous pass
  bool unlikely = false, unlikely_isothermal = false;  ///< stress too high for an oil (friction::unlikely)
  core::Warnings friction_warnings{};                  ///< warnings about mu
  double Hc_isothermal = core::unknown, Hm_isothermal = core::unknown;
};

/// The fields of whichever of the two exists; nullptr if neither does.
inline const heat::Fields* fields_of_film(const std::optional<HeatResult>& heat,
                                          const std::optional<HeatResult>& flow) {
  return heat ? &heat->found.fields : (flow ? &flow->found.fields : nullptr);
}

/// Stresses at the stored times of a run in time, and what the material of both bodies has met by then.
struct StressCourse {
  /// The largest stresses below surface 1 at one time.
  struct Row {
    double T = 0.0;
    subsurface::Maximum mises{}, shear{};
  };
  std::vector<Row> rows{};
  core::Grid grid{};                                 ///< of the stresses
  std::vector<double> depths{};                      ///< of the planes
  std::vector<std::vector<core::Field>> sections{};  ///< [quantity][time], over x and depth
  /// What the material of a body has met, in coordinates that move with it; the place of a maximum is in them too.
  struct Body {
    std::vector<double> x{};
    std::vector<subsurface::Maximum> largest{};  ///< [subsurface::Met]
    std::vector<core::Field> sections{};         ///< the same order, over x and depth
    double longest_move = 0.0;                   ///< between two stored times, in cells of the stresses
  };
  std::vector<Body> bodies{};
  core::Warnings warnings{};
  double seconds = 0.0;
};

/// The contact of touching surfaces. NaN: not known.
struct MixedResult {
  mixed::Contact contact{};
  double error_share = core::unknown;  ///< relative
  double error_area = core::unknown;   ///< relative
  double share_extrapolated = core::unknown;
  double share_coarse = core::unknown;        ///< on half as many cells
  double share_of_half_film = core::unknown;  ///< the same with half the boundary film
  double seconds = 0.0;                       ///< of these numbers, among them the solution with half the film
};

/// The contact, and the results of each effect.
struct Computed {
  std::string unsolved{};       ///< why there is nothing to show; empty if there is a solution, converged or not
  steady::Solution solution{};  ///< for a dry contact only what it has in common with a film
  std::optional<dry::Solution> dry{};
  Outcome outcome{};
  DerivedFields derived{};
  std::optional<TransientResult> in_time{};
  std::optional<subsurface::StressField> stresses{};
  std::optional<StressCourse> stress_course{};
  std::optional<friction::Friction> friction{};
  std::optional<HeatResult> heat{};
  std::optional<roller::Analysis> roller{};
  std::optional<MixedResult> mixed{};
  std::optional<HeatResult> flow{};  ///< isothermal, with [shear] flow = on
  double seconds = 0.0;              ///< computing time of the whole run
};

}  // namespace ehl::program
