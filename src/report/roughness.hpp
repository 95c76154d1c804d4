#pragma once
// The lambda ratio: the minimum film of smooth surfaces divided by the combined roughness of both surfaces.
#include <optional>
#include <string>
#include <vector>

#include "case/computed.hpp"
#include "case/scene.hpp"
#include "core/warning.hpp"

namespace ehl::program {

/// The roughness of [contact] or of height maps, and the minimum film to compare it with. This film is taken from the
/// solution if its surfaces are smooth, else from a formula.
/// in: Hm of the solution; NaN before there is one. out: nothing if no surface is known to be rough.
/// source: Tallian (1967): lambda = h_m/sqrt(Sq1^2 + Sq2^2).
std::optional<Roughness> roughness_of(const Case& input, const std::vector<Formula>& formulas, double Hm);

/// The printed line: "roughness    S_q = 22.4 nm of both surfaces together; lambda ratio h_m/S_q = 6.42 with h_m =
/// 143.9 nm"; empty for smooth surfaces.
std::string roughness_line(const Case& input, const std::optional<Roughness>& roughness);

/// The warning if the lambda ratio is below 3.
std::optional<core::Warning> roughness_warning(const Case& input, const std::optional<Roughness>& roughness);

}  // namespace ehl::program
