#pragma once
// The film that is fitted to our own solutions (contact/film_map.hpp) for a case, and what is said of its accuracy.
#include <optional>
#include <string>

#include "case/computed.hpp"
#include "case/physical_input.hpp"

namespace ehl::program {

/// Code of the fit among the formulas.
constexpr char map_code[] = "map";

/// The fit at the case's M and L*. out: nothing outside its range.
std::optional<Formula> fitted_film(const Physics& physics);

/// One line below the formulas: how far the fit is from solutions with other oils; that this is not known for an oil of
/// another density; or that the case lies outside the fitted range. Empty for shapes that the fit is not made for.
std::string fitted_film_line(const Physics& physics);

}  // namespace ehl::program
