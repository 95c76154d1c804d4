#pragma once
// Detects surfaces whose measured roughness exceeds the film.
#include <string>

#include "case/scene.hpp"

namespace ehl::program {

/// Root mean square of the measured heights of both surfaces combined (maps, and a traced profile without its form), in
/// a^2/R. 0: nothing was measured.
double measured_roughness(const Case& input);

/// The minimum film of smooth surfaces in a^2/R, from the formula that the lambda ratio uses: the fit to
/// solutions of this program if the case is in its range; else Dowson and Higginson, Hamrock and Dowson, or
/// Chittenden. NaN: none of them applies.
double smallest_smooth_film(const contact::Groups& groups);

/// A height as text: in SI if the contact is, else in a^2/R.
std::string height_text(const Case& input, double H);

/// The reason why the surfaces touch: the measured roughness that the mesh resolves exceeds the minimum film of smooth
/// surfaces. Empty if they do not touch, and always in time or without lubricant.
std::string why_they_touch(const Case& input);

}  // namespace ehl::program
