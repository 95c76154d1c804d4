#include "page/drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "page/markup.hpp"

namespace ehl::program {
namespace {

constexpr double left = 58.0, top = 8.0, below = 44.0;  // px around the plotted part

double share(const Axis& axis, double value) {
  return axis.logarithmic ? std::log(value / axis.from) / std::log(axis.to / axis.from)
                          : (value - axis.from) / (axis.to - axis.from);
}

// The next number of the form 1, 2 or 5 times a power of ten.
double round_step(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double lead = rough / power;
  return power * (lead <= 1.0001 ? 1.0 : lead <= 2.0001 ? 2.0 : lead <= 5.0001 ? 5.0 : 10.0);
}

std::string tick_name(double value) {
  const double size = std::abs(value);
  if (size != 0.0 && (size < 1e-3 || size >= 1e5)) {
    const int power = static_cast<int>(std::floor(std::log10(size) + 1e-9));
    const double lead = value / std::pow(10.0, power);
    const std::string tens = fmt::format("10^{{{}}}", power);
    return std::abs(lead - 1.0) < 1e-6 ? tens : fmt::format("{:.3g}·", lead) + tens;
  }
  return fmt::format("{:.6g}", value);
}

std::vector<Tick> decades(const Axis& axis) {
  std::vector<Tick> ticks;
  const double count = std::log10(axis.to / axis.from);
  const int every = std::max(1, static_cast<int>(std::ceil(count / 7.0)));
  for (int power = static_cast<int>(std::floor(std::log10(axis.from))); power <= std::log10(axis.to) + 1e-9; ++power)
    for (const int lead : {1, 2, 3, 4, 5, 6, 7, 8, 9}) {
      const double at = lead * std::pow(10.0, power);
      const bool named = lead == 1 ? power % every == 0 : (count < 2.2 && (lead == 2 || lead == 5));
      if (at >= axis.from * (1.0 - 1e-9) && at <= axis.to * (1.0 + 1e-9) && (named || count < 7.0))
        ticks.push_back({at, named ? tick_name(at) : ""});
    }
  return ticks;
}

std::string coordinate(double value) { return fmt::format("{:.1f}", value); }

std::string stroke_of(const Stroke& stroke) {
  return fmt::format(R"( fill="none" stroke="{}" stroke-width="{:g}")", stroke.colour, stroke.width) +
         (stroke.dashes.empty() ? "" : " stroke-dasharray=\"" + stroke.dashes + "\"");
}

std::string marked(const std::string& mark) { return mark.empty() ? "" : " data-mark=\"" + mark + "\""; }

}  // namespace

Axis axis_of(const std::vector<double>& values, const std::string& words, bool logarithmic) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double value : values)
    if (std::isfinite(value) && (!logarithmic || value > 0.0)) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  if (!(least <= most)) return {logarithmic ? 1.0 : 0.0, logarithmic ? 10.0 : 1.0, logarithmic, words};
  if (logarithmic) {
    const double room = std::max(1.15, std::pow(most / least, 0.04));
    return {least / room, most * room, true, words};
  }
  const double room = most > least ? 0.04 * (most - least) : std::max(0.05 * std::abs(most), 1e-12);
  return {least - room, most + room, false, words};
}

Axis axis_from_zero(double highest, const std::string& words) {
  return {0.0, std::isfinite(highest) && highest > 0.0 ? 1.04 * highest : 1.0, false, words};
}

bool spans(const std::vector<double>& values, double factor) {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  return least > 0.0 && most >= factor * least;
}

std::string curve_colour(std::size_t k) {
  constexpr std::array colours{"#2166ac", "#b2182b", "#1b7837", "#762a83", "#e08214", "#35978f",
                               "#8c510a", "#c51b7d", "#444444", "#80b1d3", "#fb8072", "#b3de69"};
  return colours[k % colours.size()];
}

std::vector<Tick> ticks_of(const Axis& axis) {
  if (axis.logarithmic) return decades(axis);
  std::vector<Tick> ticks;
  const double step = std::max(round_step((axis.to - axis.from) / 6.0), axis.whole ? 1.0 : 0.0);
  for (double k = std::ceil(axis.from / step - 1e-6); k * step <= axis.to + 1e-6 * step; k += 1.0)
    ticks.push_back({k * step, tick_name(k == 0.0 ? 0.0 : k * step)});
  return ticks;
}

Drawing::Drawing(Axis x, Axis y, double width, double height)
    : x_(std::move(x)), y_(std::move(y)), width_(width), height_(height) {}

double Drawing::at_x(double value) const { return left + width_ * share(x_, value); }
double Drawing::at_y(double value) const { return top + height_ * (1.0 - share(y_, value)); }

std::string Drawing::path(const std::vector<double>& x, const std::vector<double>& y) const {
  std::string text;
  bool pen_up = true;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double px = at_x(x[k]), py = at_y(y[k]);
    if (!std::isfinite(px) || !std::isfinite(py)) {
      pen_up = true;
      continue;
    }
    // Points far outside are clamped: some browsers lose precision for large coordinates.
    text += (pen_up ? "M" : "L") + coordinate(px) + " " + coordinate(std::clamp(py, -2000.0, 3000.0));
    pen_up = false;
  }
  return text;
}

void Drawing::curve(const std::vector<double>& x, const std::vector<double>& y, const Stroke& stroke,
                    const std::string& mark) {
  inside_ += "<path d=\"" + path(x, y) + "\"" + stroke_of(stroke) + marked(mark) + "/>\n";
}

void Drawing::points(const std::vector<double>& x, const std::vector<double>& y, const std::string& colour,
                     double radius) {
  for (std::size_t k = 0; k < x.size(); ++k)
    if (std::isfinite(at_x(x[k])) && std::isfinite(at_y(y[k])))
      inside_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" fill=\"{}\"/>\n", at_x(x[k]), at_y(y[k]),
                             radius, colour);
}

void Drawing::bars(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& errors,
                   const std::string& colour) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double lower = y_.logarithmic ? std::max(y[k] - errors[k], y_.from) : y[k] - errors[k];
    const double low = at_y(lower), high = at_y(y[k] + errors[k]), at = at_x(x[k]);
    if (!(errors[k] > 0.0) || !std::isfinite(low) || !std::isfinite(high) || !std::isfinite(at)) continue;
    inside_ += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {1:.1f}h6M{3:.1f} {2:.1f}h6\"", at, low, high,
                           at - 3.0) +
               stroke_of({colour, 1.0, ""}) + "/>\n";
  }
}

void Drawing::cross(double x, double y) {
  if (!std::isfinite(at_x(x)) || !std::isfinite(at_y(y))) return;
  inside_ += fmt::format("<path d=\"M{:.1f} {:.1f}l8 8m0 -8l-8 8\"", at_x(x) - 4.0, at_y(y) - 4.0) +
             stroke_of({"#b2182b", 2.0, ""}) + "/>\n";
}

void Drawing::picture(const std::string& uri, const std::string& mark) {
  inside_ += fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{:.1f}\" preserveAspectRatio=\"none\" href=\"",
                         left, top, width_, height_) +
             uri + "\"" + marked(mark) + "/>\n";
}

void Drawing::upright(double x, const Stroke& stroke, const std::string& mark) {
  inside_ +=
      fmt::format("<path d=\"M0 {:.1f}V{:.1f}\" transform=\"translate({:.1f} 0)\"", top, top + height_, at_x(x)) +
      stroke_of(stroke) + marked(mark) + "/>\n";
}

void Drawing::words(double x, double y, const std::string& words) {
  inside_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">", at_x(x), at_y(y)) + with_indices_svg(words) + "</text>\n";
}

void Drawing::colour_bar(const std::string& uri, const Axis& axis) {
  const double at = left + width_ + 14.0, wide = 12.0;
  right_ = 92.0;
  outside_ +=
      fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{:.1f}\" preserveAspectRatio=\"none\" href=\"", at,
                  top, wide, height_) +
      uri + "\"/>\n";
  outside_ +=
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{:.1f}\" class=\"frame\"/>\n", at, top, wide, height_);
  for (const Tick& tick : ticks_of(axis)) {
    const double y = top + height_ * (1.0 - share(axis, tick.at));
    outside_ += fmt::format("<path d=\"M{} {:.1f}h4\" class=\"frame\"/>\n", at + wide, y);
    if (!tick.name.empty())
      outside_ += fmt::format("<text x=\"{}\" y=\"{:.1f}\">", at + wide + 6.0, y + 4.0) + with_indices_svg(tick.name) +
                  "</text>\n";
  }
  outside_ += fmt::format("<text transform=\"translate({} {:.1f}) rotate(-90)\" text-anchor=\"middle\">",
                          at + wide + 58.0, top + 0.5 * height_) +
              with_indices_svg(axis.words) + "</text>\n";
}

std::string Drawing::svg(const std::string& label) const {
  static_assert(left > 0.0);
  const double whole_width = left + width_ + right_, whole_height = top + height_ + below;
  std::string text = fmt::format(
      "<svg viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\" aria-label=\"",
      whole_width, whole_height);
  text += escaped(label) + "\">\n";
  text += fmt::format(
              "<svg x=\"{0}\" y=\"{1}\" width=\"{2:.1f}\" height=\"{3:.1f}\" viewBox=\"{0} {1} {2:.1f} {3:.1f}\">\n",
              left, top, width_, height_) +
          inside_ + "</svg>\n";
  text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"frame\"/>\n", left, top,
                      width_, height_);
  const double foot = top + height_;
  for (const Tick& tick : ticks_of(x_)) {
    text +=
        fmt::format("<path d=\"M{:.1f} {:.1f}v{}\" class=\"frame\"/>", at_x(tick.at), foot, tick.name.empty() ? 3 : 5);
    if (!tick.name.empty())
      text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">", at_x(tick.at), foot + 17.0) +
              with_indices_svg(tick.name) + "</text>\n";
  }
  for (const Tick& tick : ticks_of(y_)) {
    text += fmt::format("<path d=\"M{} {:.1f}h-{}\" class=\"frame\"/>", left, at_y(tick.at), tick.name.empty() ? 3 : 5);
    if (!tick.name.empty())
      text += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">", left - 7.0, at_y(tick.at) + 4.0) +
              with_indices_svg(tick.name) + "</text>\n";
  }
  text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">", left + 0.5 * width_, foot + 36.0) +
          with_indices_svg(x_.words) + "</text>\n";
  text +=
      fmt::format("<text transform=\"translate(13 {:.1f}) rotate(-90)\" text-anchor=\"middle\">", top + 0.5 * height_) +
      with_indices_svg(y_.words) + "</text>\n";
  return text + outside_ + "</svg>\n";
}

std::string figure(const std::string& svg, const std::vector<LegendEntry>& legend, const std::string& caption) {
  std::string text = "<figure>\n" + svg;
  if (!legend.empty()) {
    text += "<ul class=\"legend\">";
    for (const LegendEntry& entry : legend)
      text += "<li><svg width=\"26\" height=\"10\">" +
              (entry.point ? "<circle cx=\"13\" cy=\"5\" r=\"3\" fill=\"" + entry.stroke.colour + "\"/>"
                           : "<path d=\"M1 5H25\"" + stroke_of(entry.stroke) + "/>") +
              "</svg> " + with_indices(entry.words) + "</li>";
    text += "</ul>\n";
  }
  return text + "<figcaption>" + caption + "</figcaption>\n</figure>\n";
}

}  // namespace ehl::program
