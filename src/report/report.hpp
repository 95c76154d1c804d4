#pragma once
// The printed report of a case and its solution.
#include <string>

#include "report/outcome.hpp"

namespace ehl::program {

/// One row per grid level: the film, its errors, and the time it took.
std::string level_table(const Case& input, const steady::Solution& solution);

/// One row per load of a load continuation; empty if there was none.
std::string continuation_table(const Case& input, const steady::Solution& solution);

/// The tables, then the main numbers. If the solution did not converge, the summary begins with that.
std::string summary(const Case& input, const Computed& computed);

/// The computing time of each part of the cycles: seconds and share.
std::string profile_table(const core::PartTimes& times, double seconds);

/// Warnings that follow from the deck, before a lubricated contact is solved.
core::Warnings foreseen_warnings(const Case& input);

/// Everything that follows from the deck before anything is solved.
std::string derived(const Case& input);

/// The fluid laws: "Roelands, z = 0.52; Dowson-Higginson".
std::string fluid_text(const Physics& physics);

/// alpha* and alpha_film of the viscosity law, in SI and as Moes' L.
struct FilmCoefficients {
  double alpha_star = 0.0;  ///< [1/Pa]; NaN if the law has no pressure in SI, or the viscosity does not rise with
                            ///< pressure
  double alpha_film = 0.0;  ///< [1/Pa]; NaN as for alpha_star
  double L_star = 0.0;      ///< Moes' L computed with alpha* instead of alpha
  double L_film = 0.0;      ///< Moes' L computed with alpha_film
};
/// L_star = L alpha*/alpha and L_film = L alpha_film/alpha. out: NaN for each coefficient that the law does not have.
FilmCoefficients film_coefficients(const Physics& physics);

/// The line of the summary about these coefficients; empty if there are none.
std::string film_coefficients_line(const Physics& physics);

/// The report as one JSON object, including the numbers of the effects.
std::string json_report(const Case& input, const Computed& computed);

/// The JSON object of a case that ended without a solution.
std::string json_failure(const Case& input, const std::string& reason);

}  // namespace ehl::program
