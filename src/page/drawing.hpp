#pragma once
// A figure as SVG within a page: axes, curves, symbols and pictures.
#include <string>
#include <vector>

namespace ehl::program {

struct Axis {
  double from = 0.0;
  double to = 1.0;
  bool logarithmic = false;
  std::string words{};  ///< may contain indices (markup.hpp)
  bool whole = false;   ///< the values are counts: ticks only at whole numbers
};

/// An axis from the lowest to the highest finite value with some margin; a logarithmic axis uses only values above
/// zero.
Axis axis_of(const std::vector<double>& values, const std::string& words, bool logarithmic = false);
/// An axis from zero to the highest value.
Axis axis_from_zero(double highest, const std::string& words);
/// True if all values are positive and the highest is at least `factor` times the lowest.
bool spans(const std::vector<double>& values, double factor);

struct Stroke {
  std::string colour = "#2166ac";
  double width = 1.6;
  std::string dashes{};  ///< "5 3"; empty: a solid line
};

/// The k-th of twelve well-distinguished colours, which are those of the pictures of postprocess/.
std::string curve_colour(std::size_t k);

/// The position of a tick and its label.
struct Tick {
  double at = 0.0;
  std::string name{};  ///< empty: a small tick without a label
};
/// The ticks of an axis, from its lower to its upper end.
std::vector<Tick> ticks_of(const Axis& axis);

class Drawing {
 public:
  /// in: width and height of the plotted part [px].
  Drawing(Axis x, Axis y, double width = 400.0, double height = 250.0);

  /// Points that are not finite, or not positive on a logarithmic axis, interrupt the line. mark: the name that a
  /// script finds it by.
  void curve(const std::vector<double>& x, const std::vector<double>& y, const Stroke& stroke,
             const std::string& mark = "");
  /// The curve as the "d" attribute of an SVG path.
  std::string path(const std::vector<double>& x, const std::vector<double>& y) const;
  void points(const std::vector<double>& x, const std::vector<double>& y, const std::string& colour,
              double radius = 3.0);
  /// Error bars from y - error to y + error; none if the error is unknown or 0.
  void bars(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& errors,
            const std::string& colour);
  /// A cross, for a case that failed.
  void cross(double x, double y);
  /// A PNG as a data URI; it fills the plotted part.
  void picture(const std::string& uri, const std::string& mark = "");
  /// A vertical line at x over the full height, drawn over the rest.
  void upright(double x, const Stroke& stroke, const std::string& mark = "");
  /// in: position of the left end of the text; the text, with indices.
  void words(double x, double y, const std::string& words);
  /// A colour bar at the right edge. in: its picture, its axis.
  void colour_bar(const std::string& uri, const Axis& axis);

  /// in: label: a description of the figure for readers who cannot see it.
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
  std::string words{};  ///< may contain indices
  Stroke stroke{};
  bool point = false;
};

/// A figure with its legend and caption. in: the SVG; caption: markup.
std::string figure(const std::string& svg, const std::vector<LegendEntry>& legend, const std::string& caption);

}  // namespace ehl::program
