#pragma once
// The printed lines about the contact itself: its scales, its groups, and the published film formulas.
#include <string>
#include <vector>

#include "case/computed.hpp"
#include "case/scene.hpp"
#include "core/constants.hpp"

namespace ehl::program {

/// The bearing or the gears that contain the contact: each number with its formula.
std::string machine_lines(const machines::Contact& machine);
/// The contact in SI: load, radii, elastic modulus, motion, oil, Hertz pressure and size.
std::string si_lines(const SiInput& si);
/// The dimensionless groups, the fluid and the lubrication regime.
std::string group_lines(const Physics& physics);

/// One line per formula, in nm first if the contact is in SI, with its deviation from the computed film.
/// in: the computed film Hc and Hm; NaN before there is one.
std::string formula_lines(const std::vector<Formula>& formulas, const Physics& physics, double Hc = core::unknown,
                          double Hm = core::unknown);

/// The meaning of the film formulas if the bodies are coated.
constexpr char formulas_if_coated[] =
    "the formulas are for uncoated bodies, here with the E' of the scales; where a coating is soft the film may differ "
    "from them by a quarter";
bool coated(const Physics& physics);

/// The domain and the grid, in um first if there are scales.
std::string domain_lines(const core::Grid& grid, const std::optional<SiScales>& si);

}  // namespace ehl::program
