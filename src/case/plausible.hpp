#pragma once
// Numbers that are possible, and hardly meant: a unit that was mistaken shows in them.
#include <string>
#include <vector>

#include "case/scene.hpp"

namespace ehl::program {

/// Of speeds, viscosity and the ends of a roller, a sentence each with the number that gives it away.
std::vector<std::string> hardly_meant(const Case& input);

/// Of a film, expected or solved. in: central and minimum film [m]; NaN: not known, and nothing is said.
std::vector<std::string> hardly_a_film(double h_c, double h_m);

}  // namespace ehl::program
