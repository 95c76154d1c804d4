#pragma once
// A result file as a page shows it; the numbers are in SI if the contact is given in SI.
#include <optional>
#include <string>
#include <vector>

#include "page/markup.hpp"
#include "report/result_source.hpp"

namespace ehl::program {

struct ResultView {
  ResultSource source;
  bool converged = false;
  bool in_time = false;
  bool dry = false;

  /// errors: core::FileError.
  explicit ResultView(const std::string& path);

  bool has(const std::string& name) const;
  /// A single number with its unit; NaN if the file does not contain it.
  results::Array number(const std::string& name) const;
  double value(const std::string& name) const { return number(name).values[0]; }
  /// A text; empty if the file does not contain it.
  std::string text(const std::string& name) const;
};

/// The tables of the numbers of a steady result, each number with its error bar.
std::string numbers_of_run(const ResultView& view);
/// The tables of the numbers of a run in time.
std::string numbers_in_time(const ResultView& view);
/// The warnings, and the reason if the result did not converge.
std::string warnings_of(const ResultView& view);
/// The tables of the file, all its numbers, its deck and its provenance; most of them are collapsed.
std::string details_of(const ResultView& view);
}  // namespace ehl::program
