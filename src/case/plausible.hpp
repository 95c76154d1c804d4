#pragma once
// Warns of values that are possible but improbable, as they result from a wrong unit.
#include "case/scene.hpp"
#include "core/warning.hpp"

namespace ehl::program {

/// Warnings about speeds, viscosity and the ends of a roller, each with the value in question.
core::Warnings hardly_meant(const Case& input);

/// Warnings about a film, predicted or solved. in: central and minimum film [m]; NaN: not known, no warning.
core::Warnings hardly_a_film(double h_c, double h_m);

}  // namespace ehl::program
