#pragma once
// What a user must know about a solution that the checks let pass.
#include <string>
#include <vector>

#include "steady/solution.hpp"

namespace ehl::steady {

/// Warnings with numbers: film not resolved by the mesh (estimated error above 10 %, or no estimate possible from a
/// single level), outlet boundary inside the pressure region, pressure still carried at the sides. in: a solution whose
/// levels, P and grid are complete.
std::vector<std::string> warnings_of(const Solution& solution);

}  // namespace ehl::steady
