#pragma once
// What is printed about a case and its solution.
#include <string>

#include "report/outcome.hpp"

namespace ehl::program {

/// One row per level: what accuracy cost in time.
std::string level_table(const Case& input, const steady::Solution& solution);

/// One row per load that a load continuation solved for; empty where there was none.
std::string continuation_table(const Case& input, const steady::Solution& solution);

/// The tables, then what a person wants to know; says it first when the solution did not converge.
std::string summary(const Case& input, const Computed& computed);

/// Where the time went: seconds and share of every part of the cycles.
std::string profile_table(const core::PartTimes& times, double seconds);

/// Everything that follows from the deck before anything is solved.
std::string derived(const Case& input);

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

/// One JSON object with the same content, that of the effects included.
std::string json_report(const Case& input, const Computed& computed);

/// The JSON object for a case that ended without a solution.
std::string json_failure(const Case& input, const std::string& reason);

}  // namespace ehl::program
