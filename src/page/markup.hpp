#pragma once
// Texts of any origin as HTML, and tables.
#include <string>
#include <vector>

namespace ehl::program {

/// The text with nothing that a browser takes for markup. Bytes that are no UTF-8 and control characters become U+FFFD.
std::string escaped(const std::string& text);

/// Words with indices, "film h_c [a^2/R]", escaped: _c below and ^2 above the line, as elements of HTML or of SVG.
std::string with_indices(const std::string& words);
std::string with_indices_svg(const std::string& words);

/// A unit of a result as a person reads it: "µm", "a²/R"; empty for a pure number.
std::string unit_words(const std::string& unit);

/// A number with as many digits as its error bar leaves; four where the error is not known; a dash where it is NaN.
std::string digits(double value, double error);

/// An error bar with two digits.
std::string bar_digits(double error);

/// "261.22 ± 0.09 nm" escaped; without a known error the number and "no error bar".
std::string with_bar(double value, double relative_error, const std::string& unit);

/// A number that did not converge, marked.
std::string not_converged_cell(const std::string& number);

struct HtmlTable {
  std::string caption{};                         ///< markup
  std::vector<std::string> head{};               ///< markup
  std::vector<std::vector<std::string>> rows{};  ///< markup
  std::string style{};                           ///< class; "numbers": all cells but the first to the right

  std::string text() const;
};

/// A part of a page that is folded away; open on paper. in: escaped summary, markup.
std::string folded(const std::string& summary, const std::string& content);

}  // namespace ehl::program
