#pragma once
// A figure as SVG within a page: axes, curves, marks, pictures.
#include <string>
#include <vector>

namespace ehl::program {

struct Axis {
  double from = 0.0;
  double to = 1.0;
  bool logarithmic = false;
  std::string words{};  ///< with indices (markup.hpp)
  bool whole = false;   ///< counts: no ticks between whole numbers
};

/// From the least to the highest of the finite values, with room beside them; of a logarithm those above zero.
Axis axis_of(const std::vector<double>& values, const std::string& words, bool logarithmic = false);
/// The same from zero on.
Axis axis_from_zero(double highest, const std::string& words);
/// True where the values are above zero and the highest is at least `factor` times the least.
bool spans(const std::vector<double>& values, double factor);

struct Stroke {
  std::string colour = "#2166ac";
  double width = 1.6;
  std::string dashes{};  ///< "5 3"; empty: a full line
};

/// The k-th of twelve colours that stay apart, those of the pictures of postprocess/.
std::string curve_colour(std::size_t k);

/// Where ticks stand, and what they are called.
struct Tick {
  double at = 0.0;
  std::string name{};  ///< empty: a small one
};
std::vector<Tick> ticks_of(const Axis& axis);

class Drawing {
 public:
  /// in: width and height of the plotted part [px].
  Drawing(Axis x, Axis y, double width = 400.0, double height = 250.0);

  /// Points that are not finite, or not above zero on a logarithm, break the line. mark: what a script calls it.
  void curve(const std::vector<double>& x, const std::vector<double>& y, const Stroke& stroke,
             const std::string& mark = "");
  /// The same as the "d" of a path.
  std::string path(const std::vector<double>& x, const std::vector<double>& y) const;
  void points(const std::vector<double>& x, const std::vector<double>& y, const std::string& colour,
              double radius = 3.0);
  /// y - error to y + error; none where the error is not known or 0.
  void bars(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& errors,
            const std::string& colour);
  /// A cross: what failed.
  void cross(double x, double y);
  /// A PNG as a data URI, over the whole plotted part.
  void picture(const std::string& uri, const std::string& mark = "");
  /// A line at x from bottom to top; over the middle of what is plotted.
  void upright(double x, const Stroke& stroke, const std::string& mark = "");
  /// in: words with indices; where they begin.
  void words(double x, double y, const std::string& words);
  /// A bar of colours at the right edge. in: its picture, its axis.
  void colour_bar(const std::string& uri, const Axis& axis);

  /// in: what the figure shows, for those who cannot see it.
  std::string svg(const std::string& label) const;

  double at_x(double value) const;
  double at_y(double value) const;

 private:
  Axis x_, y_;
  double width_, height_;
  double right_ = 14.0;
  std::string inside_{}, outside_{};
};

struct LegendEntry {
  std::string words{};  ///< with indices
  Stroke stroke{};
  bool point = false;
};

/// A figure with its legend and its caption. in: svg; caption: markup.
std::string figure(const std::string& svg, const std::vector<LegendEntry>& legend, const std::string& caption);

}  // namespace ehl::program
