#pragma once
// What is printed of the contact itself: its scales, its groups, the published films.
#include <limits>
#include <string>
#include <vector>

#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

/// The bearing or the gears that the contact is of: each number with its formula.
std::string machine_lines(const machines::Contact& machine);
/// The contact in SI: load, radii, modulus, motion, oil, Hertz.
std::string si_lines(const SiInput& si);
/// The dimensionless groups, the fluid, the regime.
std::string group_lines(const Physics& physics);

/// A line for each formula, in nm first where the contact is in SI; with its deviation from the film computed.
/// in: that film, H; NaN before there is one.
std::string formula_lines(const std::vector<Formula>& formulas, const Physics& physics,
                          double Hc = std::numeric_limits<double>::quiet_NaN(),
                          double Hm = std::numeric_limits<double>::quiet_NaN());

/// The domain and the grid, in um first where there are scales.
std::string domain_lines(const core::Grid& grid, const std::optional<SiScales>& si);

}  // namespace ehl::program
