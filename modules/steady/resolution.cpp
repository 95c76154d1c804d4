#include "steady/resolution.hpp"

#include <algorithm>
#include <cmath>

#include "contact/film_formulas.hpp"
#include "contact/groups.hpp"

namespace ehl::steady {
double expected_central_film(double M, double L) {
  return contact::H_from_moes_units(contact::nijenbanning_venner_moes(M, L), M);
}

double expected_least_film(double M, double L) {
  const contact::Asymptotes film = contact::asymptotes(M, L);
  const double isoviscous = std::pow(film.elastic_isoviscous, 8.0);
  const double piezoviscous = std::pow(film.elastic_piezoviscous, 8.0);
  const double at_50 = 0.6 + 0.3 * isoviscous / (isoviscous + piezoviscous);
  return expected_central_film(M, L) * std::min(0.9, at_50 * std::pow(M / 50.0, -0.2));
}

double contact_size(double M, double L) { return std::max(1.0, std::sqrt(2.0 * expected_central_film(M, L))); }

double resolving_step(double M, double L, reynolds::Wedge wedge) {
  const bool second_order = wedge == reynolds::Wedge::upstream2;
  const double share = second_order ? 0.3 : 0.2;
  const double coarsest = second_order ? 0.4 : 0.2;
  return std::min(coarsest, share * std::pow(expected_least_film(M, L), 2.0 / 3.0));
}

int resolving_cells(double step, double length, int fewest, int most) {
  int cells = fewest;
  while (2 * cells <= most && length / cells > step) cells *= 2;
  return cells;
}

}  // namespace ehl::steady
