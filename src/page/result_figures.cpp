// Figures of a steady field: maps, profiles, convergence of the cycles, stresses, temperatures.
#include <algorithm>
#include <cmath>
#include <limits>

#include "case/numbers/number.hpp"
#include "page/result_view.hpp"

namespace ehl::program {
namespace {

constexpr std::size_t picture_width = 420;
constexpr std::size_t points_of_line = 401;

double highest(const std::vector<double>& values) {
  double most = -std::numeric_limits<double>::infinity();
  for (const double value : values)
    if (std::isfinite(value)) most = std::max(most, value);
  return most;
}

bool varies(const FieldOnGrid& field) {
  return !field.field.values.empty() && highest(field.field.values) > *std::ranges::min_element(field.field.values);
}

std::string unit_in_words(const FieldOnGrid& field) {
  return unit_words(field.field.unit).empty() || field.field.unit == "p_h" ? ""
                                                                           : " [" + unit_words(field.field.unit) + "]";
}

// A map of a field over the contact plane, with a scale that covers the values of this field alone.
std::string own_map(const ResultView& view, const std::string& name, const std::string& words, Colours colours,
                    const std::string& caption) {
  const FieldOnGrid field = read_field(view.source, name, 0);
  if (!varies(field)) return "";
  const Window window = contact_window(view, field);
  const FieldOnGrid drawn = drawn_part(field, window, picture_width);
  Axis scale = axis_of(drawn.field.values, words + unit_in_words(field));
  if (*std::ranges::min_element(drawn.field.values) >= 0.0) scale.from = 0.0;
  return figure(map_svg(view, drawn, window, scale, colours, caption), {}, caption);
}

std::string film_map(const ResultView& view) {
  const FieldOnGrid field = read_field(view.source, "/fields/H", 0);
  const Window window = contact_window(view, field);
  const FieldOnGrid drawn = drawn_part(field, window, picture_width);
  const Axis scale = film_scale(view, {drawn});
  const std::string caption =
      "Film thickness; lines at the ticks of the scale and between them. Lightest: thicker than the scale.";
  return figure(map_svg(view, drawn, window, scale, Colours::film, "Film thickness over the contact"), {}, caption);
}

// The values of a field along y = 0 within the window.
std::vector<double> along(const FieldOnGrid& field, const std::vector<double>& xs) {
  const double y = std::clamp(0.0, std::min(field.y.values.front(), field.y.values.back()),
                              std::max(field.y.values.front(), field.y.values.back()));
  return on_lines(field, xs, {y}).field.values;
}

struct CentreLine {
  std::vector<double> x{};
  Axis axis{};
};

CentreLine centre_line(const ResultView& view) {
  const FieldOnGrid P = read_field(view.source, "/fields/P", 0);
  const Window window = contact_window(view, P);
  return {spaced(window.left, window.right, points_of_line), {window.left, window.right, false, view.places("x")}};
}

std::string pressure_line(const ResultView& view) {
  const CentreLine line = centre_line(view);
  const std::vector<double> P = along(read_field(view.source, "/fields/P", 0), line.x);
  const double p_h = view.source.si ? 1e-9 * view.source.si->p_h : 1.0;
  std::vector<double> hertz;
  for (const double x : line.x) hertz.push_back(p_h * std::sqrt(std::max(0.0, 1.0 - std::pow(x / view.radius(), 2))));
  const bool known = !view.has("/roller") && !(std::abs(view.value(numbers::path_of(id::angle))) > 0.0);
  Drawing drawing(line.axis, axis_from_zero(std::max(highest(P), known ? p_h : 0.0), view.pressure_words()));
  std::vector<LegendEntry> legend{{view.dry ? "dry contact" : "with oil", {}}};
  if (known) {
    drawing.curve(line.x, hertz, {"#888888", 1.2, "5 3"});
    legend.push_back({"Hertz", {"#888888", 1.2, "5 3"}});
  }
  drawing.curve(line.x, P, {});
  return figure(drawing.svg("Pressure along y = 0"), legend, "Pressure along y = 0.");
}

std::string film_line(const ResultView& view) {
  const CentreLine line = centre_line(view);
  const std::string name = view.dry ? "/fields/gap" : "/fields/H";
  if (!view.has(name)) return "";
  const FieldOnGrid field = read_field(view.source, name, 0);
  const std::vector<double> H = along(field, line.x);
  Axis axis = view.dry ? axis_from_zero(highest(H), "gap" + unit_in_words(field)) : film_scale(view, {field});
  axis.words = view.dry ? axis.words : view.film_words();
  Drawing drawing(line.axis, axis);
  drawing.curve(line.x, H, {"#b2182b", 1.6, ""});
  return figure(drawing.svg("Film along y = 0"), {}, view.dry ? "Gap along y = 0." : "Film along y = 0.");
}

std::string cycles_figure(const ResultView& view) {
  const auto column = [&](const std::string& name) { return view.source.numbers("/history/" + name).values; };
  if (!view.has(std::string("/history/") + id::residual)) return "";
  const std::vector<double> residual = column(id::residual);
  const std::vector<double> load = column(id::load_error);
  const std::vector<double> level = column("level");
  if (residual.size() < 2 || load.size() != residual.size() || level.size() != residual.size()) return "";
  std::vector<double> cycle, both = residual;
  for (std::size_t k = 0; k < residual.size(); ++k) cycle.push_back(static_cast<double>(k + 1));
  both.insert(both.end(), load.begin(), load.end());
  const Axis y = axis_of(both, "residual, load error (relative)", true);
  Drawing drawing({0.5, static_cast<double>(cycle.size()) + 0.5, false, "cycle, coarse to fine grids", true}, y);
  for (std::size_t k = 0; k < level.size(); ++k) {
    const bool begins = k == 0 || level[k] != level[k - 1];
    if (begins && k > 0) drawing.upright(static_cast<double>(k) + 0.5, {"#bbbbbb", 1.0, "3 3"});
    if (begins) drawing.words(static_cast<double>(k) + 0.6, y.from * 1.5, "level " + digits(level[k], std::nan("")));
  }
  drawing.curve(cycle, residual, {});
  drawing.points(cycle, residual, curve_colour(0));
  drawing.curve(cycle, load, {curve_colour(1), 1.6, "5 3"});
  drawing.points(cycle, load, curve_colour(1));
  return figure(drawing.svg("Residual and load error, cycle by cycle"),
                {{"residual of the Reynolds equation", {}}, {"error of the load", {curve_colour(1), 1.6, "5 3"}}},
                "Convergence, cycle by cycle.");
}

// The section below the surface; depth increases downwards.
std::string stress_section(const ResultView& view) {
  const std::string name = "/subsurface/section/sigma_mises";
  if (!view.has(name)) return "";
  FieldOnGrid field = read_field(view.source, name, 0);
  std::ranges::reverse(field.y.values);
  for (double& z : field.y.values) z = -z;
  FieldOnGrid turned = field;
  const std::size_t rows = field.y.values.size(), columns = field.x.values.size();
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) turned.field.values[j * columns + i] = field.at(i, rows - 1 - j);
  const double a = view.radius();
  const Window window{std::max(-1.8 * a, turned.x.values.front()), std::min(1.8 * a, turned.x.values.back()),
                      turned.y.values.front(), turned.y.values.back()};
  const FieldOnGrid drawn = drawn_part(turned, window, picture_width);
  const Axis scale =
      axis_from_zero(highest(drawn.field.values),
                     std::string("von Mises stress") + (view.source.si ? "" : " over p_h") + unit_in_words(field));
  return figure(map_svg(view, drawn, window, scale, Colours::pressure, "Stress below the surface"), {},
                "Von Mises stress below y = 0, surface above.");
}

std::string temperature_lines(const ResultView& view) {
  if (!view.has("/fields/T_max")) return "";
  const CentreLine line = centre_line(view);
  const std::vector<std::pair<const char*, const char*>> names{{"/fields/T_max", "largest temperature across the film"},
                                                               {"/fields/T_mid", "middle of the film"},
                                                               {"/fields/T1", "surface 1"},
                                                               {"/fields/T2", "surface 2"}};
  std::vector<std::vector<double>> curves;
  std::vector<LegendEntry> legend;
  double most = 0.0;
  for (const auto& [name, words] : names) {
    if (!view.has(name)) continue;
    curves.push_back(along(read_field(view.source, name, 0), line.x));
    most = std::max(most, highest(curves.back()));
    legend.push_back({words, {curve_colour(curves.size()), 1.6, ""}});
  }
  Drawing drawing(line.axis, axis_from_zero(most, "T - T_{oil} [K]"));
  for (std::size_t k = 0; k < curves.size(); ++k) drawing.curve(line.x, curves[k], legend[k].stroke);
  return figure(drawing.svg("Temperatures along y = 0"), legend, "Temperature rise along y = 0.");
}

std::string temperature_section(const ResultView& view) {
  if (!view.has("/thermal_section/T")) return "";
  const FieldOnGrid field = read_field(view.source, "/thermal_section/T", 0);
  if (field.y.values.size() < 2) return "";
  const double a = view.radius();
  const Window window{std::max(-1.8 * a, field.x.values.front()), std::min(1.4 * a, field.x.values.back()),
                      field.y.values.front(), field.y.values.back()};
  FieldOnGrid drawn = on_lines(field, spaced(window.left, window.right, picture_width),
                               spaced(window.bottom, window.top, picture_width / 2));
  const Axis scale = axis_from_zero(highest(drawn.field.values), "T - T_{oil} [K]");
  return figure(map_svg(view, drawn, window, scale, Colours::temperature, "Temperature across the film"), {},
                "Temperature rise across the film at y = 0.");
}

// Pressure and film along the length of a roller.
std::string roller_figures(const ResultView& view) {
  if (!view.has("/roller/y")) return "";
  const results::Array y = view.source.numbers("/roller/y");
  std::string text;
  for (const auto& [name, words] : {std::pair(id::P_max, view.pressure_words() + ", maximum"),
                                    std::pair("H_min", view.film_words() + ", minimum")}) {
    const std::vector<double> values = view.source.numbers(std::string("/roller/") + name).values;
    // Where the pressure is zero, next to the ends, no film is drawn.
    std::vector<double> loaded;
    const std::vector<double> pressure = view.source.numbers(std::string("/roller/") + id::P_max).values;
    for (std::size_t k = 0; k < values.size() && k < pressure.size(); ++k)
      loaded.push_back(pressure[k] > 0.0 ? values[k] : std::nan(""));
    Drawing drawing(axis_of(y.values, view.places("y")), axis_from_zero(highest(loaded), words));
    drawing.curve(y.values, loaded, {curve_colour(name[0] == 'P' ? 0 : 1), 1.6, ""});
    text += figure(drawing.svg(words + " along the roller"), {}, with_indices(words) + ", along the roller.");
  }
  return text;
}

}  // namespace

std::string figures_of(const ResultView& view) {
  if (!view.has("/fields/P")) return "";
  // For a run in time the figures of the start are among the frames.
  if (view.in_time) return cycles_figure(view);
  std::string text;
  const bool maps = !view.line && !view.has("/roller");
  if (maps && view.has("/fields/H")) text += film_map(view);
  if (maps)
    text += own_map(view, "/fields/P", view.source.si ? "pressure p" : "pressure P = p/p_h", Colours::pressure,
                    "Pressure; lines at the ticks of the scale and between them.");
  text += film_line(view) + pressure_line(view) + roller_figures(view) + cycles_figure(view);
  text += temperature_lines(view) + temperature_section(view) + stress_section(view);
  if (!maps) return text;
  for (const auto& [name, words, colours, caption] :
       {std::tuple("/fields/T_mid", "T - T_{oil}", Colours::temperature, "Temperature rise in the middle of the film."),
        std::tuple("/fields/theta", "content θ", Colours::film, "Share of the gap that the oil fills."),
        std::tuple("/fields/S", "surface", Colours::film, "Height that the surfaces at rest add to the gap.")})
    if (view.has(name)) text += own_map(view, name, words, colours, caption);
  return text;
}

}  // namespace ehl::program
