#pragma once
// What is printed of the film and the pressure that were computed: in SI first where the contact is in SI.
#include <string>

#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

/// Film at the centre, smallest film, highest pressure, each with its error bar.
std::string film_lines(const Case& input, const Computed& computed);

/// The values without mesh, and what the errors are made of.
std::string error_lines(const Case& input, const steady::Solution& solution);

/// What was checked of the final state; empty where nothing was.
std::string verified_lines(const Case& input, const steady::Verification& checked);

}  // namespace ehl::program
