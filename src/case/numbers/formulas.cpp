// The films of published formulas, for the table of a sweep of contacts in SI.
#include <algorithm>

#include "case/numbers/records.hpp"
#include "case/published.hpp"

namespace ehl::program::numbers {
namespace {

// The film of a formula [m].
double by_formula(Of s, const std::string& code, double Formula::*film) {
  const std::vector<Formula>& all = s.computed.outcome.formulas;
  const auto found = std::ranges::find(all, code, &Formula::code);
  return found == all.end() || !in_SI(s) ? core::unknown : (*found).*film * s.input.physics.si->hertz.h_scale;
}

struct FilmOf {
  const char* symbol;
  double Formula::*by_formula;
  double Outcome::*computed;
};
constexpr FilmOf central{"h_c", &Formula::Hc, &Outcome::hc}, smallest{"h_m", &Formula::Hm, &Outcome::hm};

struct Place {
  const Publication& published;
  const FilmOf& film;
  int place;
  OfSweep of_sweep;
};

std::string name_of(const Place& at) { return std::string(at.published.code) + "_" + at.film.symbol; }

Number film_by(const Place& at) {
  return number(name_of(at), "m", std::string("film by ") + at.published.name, only_column,
                in_si(at.place, name_of(at), "nm"),
                [at](Of s) { return by_formula(s, at.published.code, at.film.by_formula); });
}

Number deviation_of(const Place& at) {
  return number(name_of(at) + "_deviation", "-", "formula over the film computed, less 1", only_column,
                column_only_si(at.place + 1), sweep_page(at.of_sweep),
                label(std::string(at.published.code) + " " + at.film.symbol), [at](Of s) {
                  return deviation(by_formula(s, at.published.code, at.film.by_formula),
                                   s.computed.outcome.*at.film.computed);
                });
}

std::vector<Number> all_of(const std::vector<Place>& places, Number (*make)(const Place&)) {
  std::vector<Number> list;
  for (const Place& at : places) list.push_back(make(at));
  return list;
}

const std::vector<Place>& of_lines() {
  static const std::vector<Place> places{{published::moes, central, 110, OfSweep::in_table},
                                         {published::dh, central, 112, OfSweep::hidden},
                                         {published::dh, smallest, 114, OfSweep::hidden}};
  return places;
}
const std::vector<Place>& of_points() {
  static const std::vector<Place> places{{published::nvm, central, 110, OfSweep::hidden},
                                         {published::hd, central, 112, OfSweep::in_table},
                                         {published::hd, smallest, 114, OfSweep::in_table}};
  return places;
}
const std::vector<Place>& of_ellipses() {
  static const std::vector<Place> places{{published::chittenden, central, 116, OfSweep::hidden},
                                         {published::chittenden, smallest, 118, OfSweep::hidden}};
  return places;
}

}  // namespace

std::vector<Number> line_formulas() { return all_of(of_lines(), film_by); }
std::vector<Number> line_deviations() { return all_of(of_lines(), deviation_of); }
std::vector<Number> point_formulas() { return all_of(of_points(), film_by); }
std::vector<Number> point_deviations() { return all_of(of_points(), deviation_of); }
std::vector<Number> ellipse_formulas() { return all_of(of_ellipses(), film_by); }
std::vector<Number> ellipse_deviations() { return all_of(of_ellipses(), deviation_of); }

}  // namespace ehl::program::numbers
