#pragma once
// Escapes text of any origin for HTML, and builds tables.
#include <string>
#include <vector>

namespace ehl::program {

/// The text with all markup characters escaped. Invalid UTF-8 and control characters become U+FFFD.
std::string escaped(const std::string& text);

/// Text with indices, "film h_c [a^2/R]", escaped: _c becomes a subscript and ^2 a superscript.
std::string with_indices(const std::string& words);

/// A unit of a result in print: "µm", "a²/R"; empty for a pure number.
std::string unit_words(const std::string& unit);

/// A number with the digits that its error bar justifies; four digits if the error is not known; a dash for NaN.
std::string digits(double value, double error);

/// An error bar with two digits.
std::string bar_digits(double error);

/// "261.22 ± 0.09 nm", escaped; if the error is not known, the number followed by "no error bar".
std::string with_bar(double value, double relative_error, const std::string& unit);

/// A table cell for a number that did not converge, with a mark.
std::string not_converged_cell(const std::string& number);

struct HtmlTable {
  std::string caption{};                         ///< markup
  std::vector<std::string> head{};               ///< markup
  std::vector<std::vector<std::string>> rows{};  ///< markup
  std::string style{};                           ///< CSS class; "numbers": aligns all but the first right

  std::string text() const;
};

/// A part of a page that is collapsed on screen and open in print. in: summary (escaped), content (markup).
std::string folded(const std::string& summary, const std::string& content);

}  // namespace ehl::program
