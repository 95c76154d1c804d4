#pragma once
// The lambda ratio: the film of smooth surfaces over the roughness of both.
#include <optional>
#include <string>
#include <vector>

#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

/// Roughness that [contact] states or maps have, and the smallest film to hold against it: that of the solution where
/// it is one of smooth surfaces, else that of a formula. in: Hm of the solution, NaN before there is one. out: nothing
/// where no surface is known to be rough. source: Tallian (1967): lambda = h_m/sqrt(Sq1^2 + Sq2^2).
std::optional<Roughness> roughness_of(const Case& input, const std::vector<Formula>& formulas, double Hm);

/// "roughness    Sq = 22.4 nm of both surfaces; lambda ratio 6.42, h_m 143.9 nm over it"; empty where there is none.
std::string roughness_line(const Case& input, const std::optional<Roughness>& roughness);

/// A sentence where the lambda ratio is below 3.
std::optional<std::string> roughness_warning(const Case& input, const std::optional<Roughness>& roughness);

}  // namespace ehl::program
