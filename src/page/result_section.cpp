// The section of a page about one result file.
#include <fmt/core.h>

#include <cmath>

#include "case/numbers/number.hpp"
#include "page/frames.hpp"
#include "page/result_view.hpp"
#include "page/section.hpp"

namespace ehl::program {
namespace {

using numbers::path_of;

// A number with its error bar.
std::string compared(const ResultView& view, const char* name) {
  const results::Array found = view.number(path_of(name));
  if (!std::isfinite(found.values[0])) return "–";
  return view.converged ? with_bar(found.values[0], view.value(numbers::error_path_of(name)), found.unit)
                        : not_converged_cell("");
}

std::string plain(double value, const std::string& unit) {
  return std::isfinite(value) ? fmt::format("{:.4g} ", value) + unit : "–";
}

std::vector<std::string> compared_cells(const ResultView& view) {
  const bool grows = view.value(path_of(id::P_max_converging)) == 0.0;
  const bool best = view.has(path_of(id::Hc_best));
  const results::Array load = view.number(path_of(id::load)), P_max = view.number(path_of(id::P_max));
  return {plain(view.value(path_of(id::M)), ""),
          plain(view.value(path_of(id::L)), ""),
          plain(load.values[0], load.unit),
          plain(0.5 * view.value(path_of(id::u_s)), "m/s"),
          compared(view, best ? id::Hc_best : id::Hc),
          compared(view, best ? id::Hm_best : id::Hm),
          grows && view.converged
              ? digits(P_max.values[0], std::nan("")) + " " + with_indices(unit_words(P_max.unit)) + " on this mesh"
              : compared(view, id::P_max),
          compared(view, id::mu)};
}

std::string contact_words(const ResultView& view) {
  const auto number = [&](const char* name) { return view.value(path_of(name)); };
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : " · ") + words; };
  if (std::isfinite(number(id::load)))
    add(fmt::format("load {:.4g} {}", number(id::load), view.number(path_of(id::load)).unit));
  if (std::isfinite(number(id::R))) add(fmt::format("R = {:.4g} mm", 1e3 * number(id::R)));
  if (std::isfinite(number(id::u_s))) add("u_m = " + fmt::format("{:.4g} m/s", 0.5 * number(id::u_s)));
  if (view.source.si && std::isfinite(number(id::p_h)))
    add(fmt::format("Hertz a = {:.4g} µm, p_h = {:.4g} GPa", 1e6 * view.source.si->a, 1e-9 * view.source.si->p_h));
  if (std::isfinite(number(id::M))) add(fmt::format("Moes M = {:.4g}, L = {:.4g}", number(id::M), number(id::L)));
  if (std::isfinite(number(id::radius_ratio))) add(fmt::format("R_x/R_y = {:.4g}", number(id::radius_ratio)));
  return "<p class=\"facts\">" + with_indices(text) + "</p>\n";
}

}  // namespace

PageSection result_section(const std::string& path, const DrawnFigures& figures) {
  const ResultView view(path);
  PageSection section{view.source.file.attribute("/", "title"), path, "", {}};
  section.compared = {view.in_time ? "run in time" : view.dry ? "dry contact" : "run", compared_cells(view)};
  section.markup = contact_words(view) + warnings_of(view);
  if (view.in_time) section.markup += numbers_in_time(view) + frames_of(view, figures);
  section.markup += numbers_of_run(view) + figures_markup(figures) + details_of(view);
  return section;
}

}  // namespace ehl::program
