#pragma once
// An effect whose factors on the coefficients follow the state of a run in time, as heat does.
#include <functional>
#include <optional>

#include "core/field.hpp"
#include "film/model.hpp"

namespace ehl::transient {

/// What an effect does to the coefficients at one time.
struct FilmFactors {
  film::FactorFields coefficients;
  core::Field stored;    ///< factor on rho_bar H, the oil that the gap holds
  core::Field stress{};  ///< factor on the mean shear stress of sliding; empty: 1
};

/// The effect. Within an implicit step its factors are constant while the cycles run; between them it responds to the
/// state that they have found, until the response changes the state by less than the tolerance of the step.
struct Coupling {
  /// The factors of the steady effect at the P and H of T = 0.
  std::function<FilmFactors(const core::Patch& grid, const core::Field& P, const core::Field& H)> settle{};
  /// The factors at T, extrapolated from the last two accepted steps, or interpolated between them.
  std::function<FilmFactors(double T)> predict{};
  /// The factors of a step from the last accepted state to P and H at T.
  std::function<FilmFactors(double T, const core::Field& P, const core::Field& H)> respond{};
  /// The step of the last response is accepted.
  std::function<void()> accept{};
  /// The next step follows a jump, across which nothing is extrapolated.
  std::function<void()> restart{};
  /// The effect responds before every cycle instead: its factors converge together with the state.
  bool in_cycles = false;
  /// A limiting stress that belongs to the film model; the factors then lack it.
  std::optional<film::StressLimit> limit{};
};

}  // namespace ehl::transient
