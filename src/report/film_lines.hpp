#pragma once
// The printed lines about the computed film and pressure; in SI first if the contact is in SI.
#include <string>

#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

/// Central film, minimum film and maximum pressure, each with its error bar.
std::string film_lines(const Case& input, const Computed& computed);

/// The values extrapolated to mesh size zero, and the parts of the error bars.
std::string error_lines(const Case& input, const steady::Solution& solution);

/// The checks of the final state; empty if there was none.
std::string verified_lines(const Case& input, const steady::Verification& checked);

}  // namespace ehl::program
