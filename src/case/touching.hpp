#pragma once
// Surfaces that are measured, and rougher than the film is thick.
#include <string>

#include "case/scene.hpp"

namespace ehl::program {

/// Root mean square of the heights that maps and a traced profile have, both surfaces together, in a^2/R; of the trace
/// without its form. 0: nothing was measured.
double measured_roughness(const Case& input);

/// The smallest film of smooth surfaces in a^2/R by the formula that the lambda ratio goes by: the fit to our own
/// solutions, where it reaches; else Dowson and Higginson, Hamrock and Dowson, or Chittenden. NaN: none of them does.
double smallest_smooth_film(const contact::Groups& groups);

/// Why the surfaces touch; empty where they do not: where what the mesh holds of the measured heights exceeds the
/// smallest film of smooth surfaces. In time and without lubricant: empty.
std::string why_they_touch(const Case& input);

}  // namespace ehl::program
