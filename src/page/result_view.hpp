#pragma once
// A result file as a page shows it: its numbers in SI where the contact is given so.
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
  /// A single number with its unit; NaN where the file has none.
  results::Array number(const std::string& name) const;
  double value(const std::string& name) const { return number(name).values[0]; }
  /// A text; empty where the file has none.
  std::string text(const std::string& name) const;
  /// "x [µm]" or "X = x/a", for an axis of places.
  std::string places(const std::string& letter) const;
  /// "film h [nm]", "pressure P/p_h".
  std::string film_words() const { return source.si ? "film h [nm]" : "film H = hR/a^2"; }
  std::string pressure_words() const { return source.si ? "pressure p [GPa]" : "pressure P = p/p_h"; }
  std::string time_words() const { return source.si ? "time t [ms]" : "time T = t u_m/a"; }
  /// One Hertz radius in the unit of places.
  double radius() const { return source.si ? 1e6 * source.si->a : 1.0; }
  /// How far the contact reaches along y, in Hertz radii.
  double reach_y() const;
};

/// The window of the maps of a contact. in: a field on the whole domain.
Window contact_window(const ResultView& view, const FieldOnGrid& field);

/// The scale of colours of films: from zero to what shows the contact, 2.5 times the central film; more where films
/// differ.
Axis film_scale(const ResultView& view, const std::vector<FieldOnGrid>& films);

/// A map of a field with its colours. in: words of the scale, marks for a script.
std::string map_svg(const ResultView& view, const FieldOnGrid& drawn, const Window& window, const Axis& scale,
                    Colours colours, const std::string& label, const std::string& mark = "");

/// The tables of numbers of a result: what was computed, each with its error bar.
std::string numbers_of_run(const ResultView& view);
/// The same of what happened in time.
std::string numbers_in_time(const ResultView& view);
/// Warnings, and what says that the result did not converge.
std::string warnings_of(const ResultView& view);
/// Tables of the file, all its numbers, deck and provenance, mostly folded away.
std::string details_of(const ResultView& view);
/// Figures of a steady field: maps, lines, cycles, stresses, temperatures.
std::string figures_of(const ResultView& view);
/// Frames of a run in time under a slider.
std::string frames_of(const ResultView& view);

}  // namespace ehl::program
