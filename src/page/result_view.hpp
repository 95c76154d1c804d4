#pragma once
// A result file as a page shows it; the numbers are in SI if the contact is given in SI.
#include <optional>
#include <string>
#include <vector>

#include "page/colours.hpp"
#include "page/markup.hpp"
#include "report/result_source.hpp"

namespace ehl::program {

struct ResultView {
  ResultSource source;
  bool converged = false;
  bool in_time = false;
  bool dry = false;
  bool line = false;  ///< a line contact: one line of nodes

  /// errors: core::FileError.
  explicit ResultView(const std::string& path);

  bool has(const std::string& name) const;
  /// A single number with its unit; NaN if the file does not contain it.
  results::Array number(const std::string& name) const;
  double value(const std::string& name) const { return number(name).values[0]; }
  /// A text; empty if the file does not contain it.
  std::string text(const std::string& name) const;
  /// The label of an axis of places: "x [µm]" or "X = x/a".
  std::string places(const std::string& letter) const;
  /// The label of a film or a pressure: "film h [nm]", "pressure P/p_h".
  std::string film_words() const { return source.si ? "film h [nm]" : "film H = hR/a^2"; }
  std::string pressure_words() const { return source.si ? "pressure p [GPa]" : "pressure P = p/p_h"; }
  std::string time_words() const { return source.si ? "time t [ms]" : "time T = t u_m/a"; }
  /// One Hertz radius in the unit of places.
  double radius() const { return source.si ? 1e6 * source.si->a : 1.0; }
  /// Half width of the contact along y, in Hertz radii.
  double reach_y() const;
};

/// The window of the maps of a contact. in: a field on the whole domain.
Window contact_window(const ResultView& view, const FieldOnGrid& field);

/// The colour scale of films: from zero to 2.5 times the central film, so that the contact is visible; higher if the
/// films differ strongly.
Axis film_scale(const ResultView& view, const std::vector<FieldOnGrid>& films);

/// A map of a field with its colour bar. in: label of the scale; mark: the name that a script finds it by.
std::string map_svg(const ResultView& view, const FieldOnGrid& drawn, const Window& window, const Axis& scale,
                    Colours colours, const std::string& label, const std::string& mark = "");

/// The tables of the numbers of a steady result, each number with its error bar.
std::string numbers_of_run(const ResultView& view);
/// The tables of the numbers of a run in time.
std::string numbers_in_time(const ResultView& view);
/// The warnings, and the reason if the result did not converge.
std::string warnings_of(const ResultView& view);
/// The tables of the file, all its numbers, its deck and its provenance; most of them are collapsed.
std::string details_of(const ResultView& view);
/// Figures of a steady field: maps, profiles, convergence of the cycles, stresses, temperatures.
std::string figures_of(const ResultView& view);
/// The frames of a run in time, with a slider.
std::string frames_of(const ResultView& view);

}  // namespace ehl::program
