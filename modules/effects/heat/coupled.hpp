#pragma once
// A contact whose film is solved together with heat, or with an oil that thins by the pressure flow: flooded, starved,
// in several passes, or to a required accuracy.
#include <optional>

#include "effects/heat/solve.hpp"

namespace ehl::heat {

/// The contact.
struct Contact {
  const steady::Scene& scene;
  const thermal::Setup& setup;  ///< complete except for the patch and the threads
  const Tuning& tuning;
};

/// The film, and what belongs to it.
struct Coupled {
  steady::Solution film{};         ///< with heat or flow thinning; isothermal if `heat` has no value
  std::optional<Solution> heat{};  ///< except for its film; nothing: there is no isothermal film to begin with
  /// The film from which the fixed-point iteration began. Nothing if it began from the previous pass.
  std::optional<steady::Solution> isothermal{};
};

/// The isothermal film first, then heat::solve(). With a supply also the flooded contact with heat, to which the
/// starvation factor refers. The contacts of several passes follow one another on a track; the bodies enter each
/// contact at their bulk temperature. With a required accuracy every grid is solved from its own start. errors: as of
/// steady::solve().
Coupled solve_coupled(const Contact& contact, const steady::ProgressCallback& progress);

}  // namespace ehl::heat
