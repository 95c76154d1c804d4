#pragma once
// Warns of values that are possible but improbable, as they result from a wrong unit.
#include <string>
#include <vector>

#include "case/scene.hpp"

namespace ehl::program {

/// Warnings about speeds, viscosity and the ends of a roller, each with the value in question.
std::vector<std::string> hardly_meant(const Case& input);

/// Warnings about a film, predicted or solved. in: central and minimum film [m]; NaN: not known, no warning.
std::vector<std::string> hardly_a_film(double h_c, double h_m);

}  // namespace ehl::program
