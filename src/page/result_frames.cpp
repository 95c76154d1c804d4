// The frames of a run in time, with a slider: a small script of the page shows one frame at a time.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/json.hpp"
#include "case/numbers/number.hpp"
#include "page/result_view.hpp"

namespace ehl::program {
namespace {

constexpr std::size_t most_frames = 60;
constexpr std::size_t points_of_profile = 161;

struct Frames {
  std::vector<double> times{};
  std::vector<FieldOnGrid> P{}, H{};
  Window window{};
};

// The frames shown: all, or at most `most_frames` at even intervals, with the first and the last among them.
std::vector<std::size_t> chosen(std::size_t count) {
  std::vector<std::size_t> list;
  const std::size_t shown = std::min(count, most_frames);
  for (std::size_t k = 0; k < shown; ++k) list.push_back(shown < 2 ? 0 : k * (count - 1) / (shown - 1));
  return list;
}

Frames read_frames(const ResultView& view) {
  const std::vector<double> times = view.source.numbers("/transient/frames/time").values;
  Frames frames;
  const std::vector<std::size_t> list = chosen(times.size());
  // The pictures become smaller as the number of frames grows, so that the page stays small.
  const std::size_t width = list.size() > 30 ? 200 : 260;
  for (const std::size_t k : list) {
    frames.times.push_back(times[k]);
    for (const auto& [name, to] : {std::pair("P", &frames.P), std::pair("H", &frames.H)}) {
      const std::string whole = std::string("/transient/frames/") + name;
      if (!view.has(whole)) continue;
      const FieldOnGrid field = read_field(view.source, whole, k);
      frames.window = contact_window(view, field);
      to->push_back(view.line ? field : drawn_part(field, frames.window, width));
    }
  }
  return frames;
}

Axis pressure_scale(const ResultView& view, const std::vector<FieldOnGrid>& fields) {
  double most = 0.0;
  for (const FieldOnGrid& field : fields)
    for (const double value : field.field.values)
      if (std::isfinite(value)) most = std::max(most, value);
  return axis_from_zero(most, view.pressure_words());
}

struct Strip {
  std::string figures{};
  Json data{};
};

// The map and the profile along y = 0 of one quantity.
void add_quantity(const ResultView& view, const Frames& frames, const std::vector<FieldOnGrid>& fields,
                  const Axis& scale, bool film, Strip& strip) {
  if (fields.empty()) return;
  const std::string mark = film ? "film" : "pressure";
  const Colours colours = film ? Colours::film : Colours::pressure;
  if (!view.line) {
    strip.figures +=
        figure(map_svg(view, fields.front(), frames.window, scale, colours, mark + " over the contact", mark), {},
               film ? "Film thickness." : "Pressure.");
    for (const FieldOnGrid& field : fields)
      strip.data["pictures"][mark].push_back(png_uri(coloured(field, scale, colours, {})));
  }
  const std::vector<double> xs = spaced(frames.window.left, frames.window.right, points_of_profile);
  Drawing drawing({frames.window.left, frames.window.right, false, view.places("x")}, scale);
  const Stroke stroke{film ? curve_colour(1) : curve_colour(0), 1.6, ""};
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const std::vector<double> values = on_lines(fields[k], xs, {0.0}).field.values;
    if (k == 0) {
      drawing.curve(xs, values, {"#bbbbbb", 1.2, "5 3"});
      drawing.curve(xs, values, stroke, mark + "-line");
    }
    strip.data["paths"][mark + "-line"].push_back(drawing.path(xs, values));
  }
  strip.figures +=
      figure(drawing.svg(mark + " along y = 0"), {{"now", stroke}, {"first frame", {"#bbbbbb", 1.2, "5 3"}}},
             film ? "Film along y = 0." : "Pressure along y = 0.");
}

// The quantities against time, with a vertical line that follows the slider.
void add_history(const ResultView& view, const Frames& frames, Strip& strip) {
  const auto column = [&](const std::string& name) { return view.source.numbers("/transient/" + name).values; };
  const std::vector<double> times = column(id::time);
  const auto add = [&](const std::vector<const char*>& list, const std::string& words, const std::string& caption) {
    std::vector<std::vector<double>> curves;
    std::vector<double> all;
    std::vector<LegendEntry> legend;
    for (const std::string name : list) {
      if (!view.has("/transient/" + name)) continue;
      curves.push_back(view.source.numbers("/transient/" + name).values);
      all.insert(all.end(), curves.back().begin(), curves.back().end());
      legend.push_back({numbers::label_in_time(name), {curve_colour(curves.size() - 1), 1.6, ""}});
    }
    if (curves.empty()) return;
    Drawing drawing(axis_of(times, view.time_words()), axis_of(all, words));
    for (std::size_t k = 0; k < curves.size(); ++k) drawing.curve(times, curves[k], legend[k].stroke);
    drawing.upright(frames.times.front(), {"#444444", 1.0, "2 2"}, "now");
    strip.figures += figure(drawing.svg(caption), legend, caption);
    if (strip.data["now"].empty())
      for (const double time : frames.times) strip.data["now"].push_back(std::round(10.0 * drawing.at_x(time)) / 10.0);
  };
  add({id::Hc, id::Hm}, view.film_words(), "Films, step by step.");
  add({id::P_max}, view.pressure_words(), "Largest pressure, step by step.");
  const std::vector<double> load = column(id::load);
  const std::vector<double> speed = column(id::speed);
  const auto changes = [](const std::vector<double>& v) {
    return std::ranges::any_of(v, [&](double value) { return value != v.front(); });
  };
  if (changes(load) || changes(speed)) add({id::load, id::speed}, "ratio", "Load and speed against time.");
}

}  // namespace

std::string frames_of(const ResultView& view) {
  const Frames frames = read_frames(view);
  Strip strip;
  if (!frames.H.empty()) add_quantity(view, frames, frames.H, film_scale(view, frames.H), true, strip);
  if (!frames.P.empty()) add_quantity(view, frames, frames.P, pressure_scale(view, frames.P), false, strip);
  add_history(view, frames, strip);
  const std::string unit = view.source.si ? " ms" : " a/u_m";
  for (const double time : frames.times) strip.data["times"].push_back(fmt::format("{:.4g}", time) + unit);
  const std::size_t all = view.source.file.dims("/transient/frames/time").at(0);
  std::string text = "<div class=\"frames\">\n<p class=\"slider\"><button type=\"button\">Play</button> ";
  text += fmt::format("<input type=\"range\" min=\"0\" max=\"{}\" value=\"0\" aria-label=\"time\"> t = <output>",
                      frames.times.size() - 1) +
          escaped(strip.data["times"][0].get<std::string>()) + "</output></p>\n";
  if (all > frames.times.size())
    text += fmt::format("<p class=\"small\">{} of {} frames of the file.</p>\n", frames.times.size(), all);
  // The data contain only numbers and pictures that this program made, so they need no escaping.
  return text + "<div class=\"figures\">\n" + strip.figures + "</div>\n<script type=\"application/json\">" +
         strip.data.dump() + "</script>\n</div>\n";
}

}  // namespace ehl::program
