#pragma once
// What is said about the oil.
#include <string>

#include "case/physical_input.hpp"

namespace ehl::program {

/// "Roelands, z = 0.52; Dowson-Higginson".
std::string fluid_text(const Physics& physics);

/// alpha* and alpha_film of the viscosity law in SI and in units of the alpha that L is made with.
struct FilmCoefficients {
  double alpha_star = 0.0;  ///< [1/Pa]; NaN where the law knows no pressure in SI, or viscosity does not rise
  double alpha_film = 0.0;  ///< [1/Pa]; likewise
  double L_star = 0.0;      ///< Moes' L with alpha* for alpha
  double L_film = 0.0;      ///< with alpha_film
};
FilmCoefficients film_coefficients(const Physics& physics);

/// The line of the summary about them; empty where there are none.
std::string film_coefficients_line(const Physics& physics);

}  // namespace ehl::program
