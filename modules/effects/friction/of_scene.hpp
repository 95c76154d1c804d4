#pragma once
// Friction of a scene of the steady solver, with the oil outside its domain.
#include <optional>

#include "effects/friction/beyond.hpp"
#include "effects/friction/friction.hpp"
#include "reynolds/far_field.hpp"
#include "steady/scene.hpp"

namespace ehl::friction {

/// True if the far field continues outside the domain, and the gap is full of oil there.
bool oil_outside(const steady::Scene& scene);

/// Friction of a solution of the scene on one grid. Where no oil lies outside of a flooded domain, the rolling friction
/// of the outer half of the inlet is reported separately.
Friction friction_of(const steady::Scene& scene, const steady::SolvedFilm& film, Parameters parameters);

/// What does not change in time: the oil outside the domain.
class Surroundings {
 public:
  Surroundings() = default;
  /// in: far_field: null: no oil outside the domain is known; it must outlive this object. The domain; the meniscus.
  Surroundings(const steady::Scene& scene, const reynolds::FarField* far_field, const core::Grid& domain,
               double meniscus);
  const reynolds::FarField* far_field() const { return far_field_; }
  const PointQuadrature* quadrature() const { return quadrature_ ? &*quadrature_ : nullptr; }
  double deformation() const { return deformation_; }  ///< Outside::deformation at the load of the scene

 private:
  const reynolds::FarField* far_field_ = nullptr;
  std::optional<PointQuadrature> quadrature_{};
  double deformation_ = 0.0;
};

/// The friction at one time of a run in time: forces over the load of the scene, by the formulas of friction_of(). in:
/// the stress of sliding at this time (Parameters::stress); the state of the far field. limits: point contacts; outside
/// the domain the pressure follows the conditions at once.
Friction friction_at(const steady::Scene& scene, const steady::SolvedFilm& film, const Surroundings& around,
                     const reynolds::FarState& state, Parameters parameters);

}  // namespace ehl::friction
