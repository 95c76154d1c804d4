#pragma once
// The film formula that is fitted to solutions of this program (contact/film_map.hpp), for one case, and its accuracy.
#include <optional>
#include <string>

#include "case/computed.hpp"
#include "case/physical_input.hpp"

namespace ehl::program {

/// The code of the fit in the list of formulas.
constexpr char map_code[] = "map";

/// The fit at M and L* of the case. out: nothing if the case lies outside the fitted range.
std::optional<Formula> fitted_film(const Physics& physics);

/// One line below the formulas. It gives the deviation of the fit from solutions with other oils, or says that this
/// deviation is not known because the density of the oil differs, or that the case lies outside the fitted range. Empty
/// for contact shapes without a fit.
std::string fitted_film_line(const Physics& physics);

}  // namespace ehl::program
