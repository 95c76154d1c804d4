// The section of a page about one result file.
#include <fmt/core.h>

#include <cmath>

#include "page/result_view.hpp"
#include "page/section.hpp"

namespace ehl::program {
namespace {

std::string compared_film(const ResultView& view, const std::string& best, const std::string& error) {
  const results::Array film = view.number(best);
  if (!std::isfinite(film.values[0])) return "–";
  return view.converged ? with_bar(film.values[0], view.value(error), film.unit) : not_converged_cell("");
}

std::string plain(double value, const std::string& unit) {
  return std::isfinite(value) ? fmt::format("{:.4g} ", value) + unit : "–";
}

std::vector<std::string> compared_cells(const ResultView& view) {
  const bool grows = view.value("/summary/P_max_converging") == 0.0;
  const results::Array mu = view.number("/summary/mu");
  const bool best = view.has("/summary/Hc_best");
  return {plain(view.value("/scales/M"), ""),
          plain(view.value("/scales/L"), ""),
          plain(view.value("/scales/load"), view.number("/scales/load").unit),
          plain(0.5 * view.value("/scales/u_s"), "m/s"),
          best ? compared_film(view, "/summary/Hc_best", "/summary/error_Hc_best")
               : compared_film(view, "/summary/Hc", "/summary/error_Hc"),
          best ? compared_film(view, "/summary/Hm_best", "/summary/error_Hm_best")
               : compared_film(view, "/summary/Hm", "/summary/error_Hm"),
          grows && view.converged ? digits(view.value("/summary/P_max"), std::nan("")) + " " +
                                        with_indices(unit_words(view.number("/summary/P_max").unit)) + " on this mesh"
                                  : compared_film(view, "/summary/P_max", "/summary/error_P_max"),
          std::isfinite(mu.values[0])
              ? view.converged ? with_bar(mu.values[0], view.value("/summary/error_mu"), "-") : not_converged_cell("")
              : "–"};
}

std::string contact_words(const ResultView& view) {
  const auto number = [&](const char* name) { return view.value(std::string("/scales/") + name); };
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : " · ") + words; };
  if (std::isfinite(number("load")))
    add(fmt::format("load {:.4g} {}", number("load"), view.number("/scales/load").unit));
  if (std::isfinite(number("R"))) add(fmt::format("R = {:.4g} mm", 1e3 * number("R")));
  if (std::isfinite(number("u_s"))) add("u_m = " + fmt::format("{:.4g} m/s", 0.5 * number("u_s")));
  if (view.source.si && std::isfinite(number("p_h")))
    add(fmt::format("Hertz a = {:.4g} µm, p_h = {:.4g} GPa", 1e6 * view.source.si->a, 1e-9 * view.source.si->p_h));
  if (std::isfinite(number("M"))) add(fmt::format("Moes M = {:.4g}, L = {:.4g}", number("M"), number("L")));
  if (std::isfinite(number("radius_ratio"))) add(fmt::format("R_x/R_y = {:.4g}", number("radius_ratio")));
  return "<p class=\"facts\">" + with_indices(text) + "</p>\n";
}

}  // namespace

PageSection result_section(const std::string& path) {
  const ResultView view(path);
  PageSection section{view.source.file.attribute("/", "title"), path, "", {}};
  section.compared = {view.in_time ? "run in time" : view.dry ? "dry contact" : "run", compared_cells(view)};
  section.markup = contact_words(view) + warnings_of(view);
  if (view.in_time) section.markup += numbers_in_time(view) + frames_of(view);
  section.markup +=
      numbers_of_run(view) + "<div class=\"figures\">\n" + figures_of(view) + "</div>\n" + details_of(view);
  return section;
}

}  // namespace ehl::program
