#include "report/contact_lines.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/text_format.hpp"
#include "case/numbers/number.hpp"
#include "contact/film_formulas.hpp"
#include "report/film_fit.hpp"
#include "report/outcome.hpp"
#include "report/report.hpp"

namespace ehl::program {
namespace {

// A deviation, " +5.7 %"; empty if there is none.
std::string deviation_text(double formula, double computed) {
  const double off = deviation(formula, computed);
  return std::isfinite(off) ? fmt::format("{:+.1f} %", 100.0 * off) : "";
}

// Rows with a heading: the first column is aligned left, the others right. A column becomes wider than `widths` if one
// of its cells would touch its neighbour.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::vector<std::size_t> widths) {
  for (std::size_t row = 1; row < rows.size(); ++row)
    for (std::size_t k = 0; k < rows[row].size(); ++k)
      widths[k] = std::max(widths[k], rows[row][k].size() + (k > 0 ? 1 : 0));
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    text += fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t k = 1; k < row.size(); ++k) text += fmt::format("{:>{}}", row[k], widths[k]);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string machine_lines(const machines::Contact& machine) {
  std::string text = fmt::format("{:<12} {}\n", machine.section, machine.what);
  for (const machines::Number& one : machine.numbers)
    text += fmt::format("  {:<20} {:>12} {:<7}  {}\n", one.name, known("{:.6g}", one.value),
                        one.unit == "-" ? "" : one.unit, one.formula);
  return text;
}

std::string si_lines(const SiInput& si) {
  const contact::SiContact& c = si.contact;
  const bool circular = contact::circular(c.shape);
  const bool line = contact::line(c.shape);
  const std::string radii = circular || line
                                ? "R = " + length(c.radius)
                                : "R_x = " + length(c.radius) + ", R_y = " + length(c.radius / c.shape.radius_ratio);
  std::string text = fmt::format("contact      {} = {:.6g} {}, {}, E' = {}\n", line ? "F/length" : "F", c.load,
                                 line ? "N/m" : "N", radii, pressure_in_GPa(c.E_prime));
  if (contact::roller(c.shape))
    text += fmt::format("roller       F = {:.6g} N, length {}\n", whole_load(si), length(c.shape.length * si.hertz.a));
  text += fmt::format("motion       u1 = {:.6g} m/s, u2 = {:.6g} m/s: u_m = {:.6g} m/s, slide-roll ratio {:.4g}\n",
                      si.u1, si.u2, 0.5 * c.u_s, 2.0 * (si.u1 - si.u2) / c.u_s);
  text += fmt::format("lubricant    eta0 = {:.6g} Pa s, alpha = {:.6g} 1/Pa\n", c.eta0, c.alpha);
  const std::string b = circular || line ? "" : ", b = " + length(si.hertz.b);
  text += std::string("Hertz        ") + (line ? "half width a = " : "a = ") + length(si.hertz.a) + b +
          ", p_h = " + pressure_in_GPa(si.hertz.p_h) + (circular || line ? ", a^2/R = " : ", a^2/R_x = ") +
          length(si.hertz.h_scale) + "\n";
  return text;
}

std::string group_lines(const Physics& physics) {
  const contact::Groups& g = physics.groups;
  std::string text = fmt::format("Moes         M = {:.6g}, L = {:.6g}\n", g.M, g.L);
  if (contact::roller(g.shape))
    text += fmt::format("roller       {:.6g} a long, with a the half width of the line contact under its mean load\n",
                        g.shape.length);
  else if (contact::line(g.shape))
    text += "line         R_y infinite; a is the half width\n";
  else if (!contact::circular(g.shape))
    text += fmt::format("ellipse      R_x/R_y = {:.6g}, kappa = b/a = {:.6g}, rolling at {:g} degrees to R_x\n",
                        g.shape.radius_ratio, g.shape.kappa, g.shape.angle);
  if (std::isfinite(g.U)) text += fmt::format("Hamrock-D.   W = {:.6g}, U = {:.6g}, G = {:.6g}\n", g.W, g.U, g.G);
  text += fmt::format("Venner       lambda = {:.6g}, alpha_bar = {:.6g}\n", g.lambda, g.alpha_bar);
  if (!physics.si && std::isfinite(physics.p_h)) text += "Hertz        p_h = " + pressure(physics.p_h) + "\n";
  text += "fluid        " + fluid_text(physics) + "\n" + film_coefficients_line(physics);
  text += "regime       " + contact::regime_text(g.M, g.L, g.shape) + "\n";
  return text;
}

std::string formula_lines(const std::vector<Formula>& formulas, const Physics& physics, double Hc, double Hm) {
  const contact::Groups& groups = physics.groups;
  const std::optional<SiScales> si = si_scales(physics);
  std::vector<std::vector<std::string>> rows{{"formulas"}};
  std::vector<std::size_t> widths{35};
  if (si) {
    rows[0].insert(rows[0].end(), {numbers::heading_in_si(id::hc), "", numbers::heading_in_si(id::hm), ""});
    widths = {33, 8, 9, 9, 9};
  }
  rows[0].insert(rows[0].end(), {id::Hc, id::Hm, "Hc (Moes)", "Hm (Moes)"});
  widths.insert(widths.end(), {si ? 10U : 8U, 10U, 11U, 11U});
  const auto in_nm = [&](double H) { return known("{:.4g}", 1e9 * si->h * H); };
  const auto in_moes_units = [&](double H) {
    return known("{:.3f}", contact::H_to_moes_units(H, groups.M, groups.shape));
  };
  for (const Formula& formula : formulas) {
    const auto& [H_c, H_m] = std::pair(formula.Hc, formula.Hm);
    std::vector<std::string> row{"  " + formula.name};
    if (si) row.insert(row.end(), {in_nm(H_c), deviation_text(H_c, Hc), in_nm(H_m), deviation_text(H_m, Hm)});
    row.insert(row.end(), {known("{:.4g}", H_c), known("{:.4g}", H_m), in_moes_units(H_c), in_moes_units(H_m)});
    rows.push_back(std::move(row));
  }
  std::string text = aligned(rows, widths);
  if (coated(physics)) return text + "  " + formulas_if_coated + "\n";
  text += fitted_film_line(physics);
  if (const std::string why = formulas_left_out(groups); !why.empty()) text += "  " + why + "\n";
  return text;
}

bool coated(const Physics& physics) { return physics.si && !physics.si->coatings.empty(); }

std::string domain_lines(const core::Grid& grid, const std::optional<SiScales>& si) {
  const auto along = [&](double factor) {
    return fmt::format("[{:.4g}, {:.4g}] ", factor * grid.X_a, factor * grid.X_b);
  };
  if (grid.line)
    return "domain       " + (si ? along(1e6 * si->a) + "um: " : "") + along(1.0) + "half widths\n" +
           fmt::format("grid         {} nodes, hx = {:.4g}\n", grid.nodes_x(), grid.hx());
  const auto box = [&](const char* format, double factor) {
    return fmt::format(fmt::runtime(format), factor * grid.X_a, factor * grid.X_b, factor * grid.Y_a,
                       factor * grid.Y_b);
  };
  const double um = si ? 1e6 * si->a : 0.0;
  std::string text = "domain       " + (si ? box("[{:.4g}, {:.4g}] x [{:.4g}, {:.4g}] um: ", um) : "") +
                     box("[{:g}, {:g}] x [{:g}, {:g}] Hertz radii\n", 1.0);
  text += "grid         " + fmt::format("{} x {} nodes, ", grid.nodes_x(), grid.nodes_y());
  if (si) text += fmt::format("{:.4g} um by {:.4g} um apart: ", um * grid.hx(), um * grid.hy());
  return text + fmt::format("hx = {:.4g}, hy = {:.4g}\n", grid.hx(), grid.hy());
}

}  // namespace ehl::program
