#include "report/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/needs.hpp"
#include "contact/film_formulas.hpp"
#include "core/constants.hpp"
#include "report/roughness.hpp"

namespace ehl::program {
namespace {

std::string nodes(int nx, int ny) { return fmt::format("{} x {}", nx + 1, ny + 1); }

std::string formula_lines(const std::vector<Formula>& formulas, const contact::Groups& groups, double h_scale) {
  std::string text = "formulas                                 Hc        Hm  Hc (Moes)  Hm (Moes)\n";
  for (const Formula& formula : formulas) {
    text += fmt::format("  {:<33}{:>8}  {:>8}  {:>9}  {:>9}", formula.name, known("{:.4g}", formula.Hc),
                        known("{:.4g}", formula.Hm),
                        known("{:.3f}", contact::H_to_moes_units(formula.Hc, groups.M, groups.shape)),
                        known("{:.3f}", contact::H_to_moes_units(formula.Hm, groups.M, groups.shape)));
    if (std::isfinite(h_scale))
      text += "   h_c " + length(formula.Hc * h_scale) + ", h_m " + length(formula.Hm * h_scale);
    text += "\n";
  }
  if (const std::string why = formulas_left_out(groups); !why.empty()) text += "  " + why + "\n";
  return text;
}

std::string si_lines(const SiInput& si) {
  const contact::SiContact& c = si.contact;
  const bool circular = contact::circular(c.shape);
  const std::string radii = circular
                                ? "R = " + length(c.radius)
                                : "R_x = " + length(c.radius) + ", R_y = " + length(c.radius / c.shape.radius_ratio);
  std::string text = fmt::format("contact      F = {:.6g} N, {}, E' = {}\n", c.load, radii, pressure(c.E_prime));
  text += fmt::format("motion       u1 = {:.6g} m/s, u2 = {:.6g} m/s: u_m = {:.6g} m/s, slide-roll ratio {:.4g}\n",
                      si.u1, si.u2, 0.5 * c.u_s, 2.0 * (si.u1 - si.u2) / c.u_s);
  text += fmt::format("lubricant    eta0 = {:.6g} Pa s, alpha = {:.6g} 1/Pa\n", c.eta0, c.alpha);
  text += "Hertz        a = " + length(si.hertz.a) + (circular ? "" : ", b = " + length(si.hertz.b)) +
          ", p_h = " + pressure(si.hertz.p_h) + (circular ? ", a^2/R = " : ", a^2/R_x = ") + length(si.hertz.h_scale) +
          "\n";
  return text;
}

std::string group_lines(const Physics& physics) {
  const contact::Groups& g = physics.groups;
  std::string text = fmt::format("Moes         M = {:.6g}, L = {:.6g}\n", g.M, g.L);
  if (!contact::circular(g.shape))
    text += fmt::format("ellipse      R_x/R_y = {:.6g}, kappa = b/a = {:.6g}, entrainment at {:g} degrees to R_x\n",
                        g.shape.radius_ratio, g.shape.kappa, g.shape.angle);
  if (std::isfinite(g.U)) text += fmt::format("Hamrock-D.   W = {:.6g}, U = {:.6g}, G = {:.6g}\n", g.W, g.U, g.G);
  text += fmt::format("Venner       lambda = {:.6g}, alpha_bar = {:.6g}\n", g.lambda, g.alpha_bar);
  if (!physics.si && std::isfinite(physics.p_h)) text += "Hertz        p_h = " + pressure(physics.p_h) + "\n";
  text += "fluid        " + fluid_text(physics) + "\n" + film_coefficients_line(physics);
  text += "regime       " + contact::regime_text(g.M, g.L, g.shape) + "\n";
  return text;
}

// What would be printed as -0.0000.
double unsigned_zero(double x) { return std::abs(x) < 5e-5 ? 0.0 : x; }

}  // namespace

std::string level_table(const steady::Solution& solution) {
  std::string text =
      "level        nodes        Hc        Hm  error(Hc)  error(Hm)  residual  load err  work units   seconds\n";
  for (const steady::LevelRow& row : solution.levels)
    text += fmt::format("{:5}  {:>11}  {:8.5f}  {:8.5f}  {:>9}  {:>9}  {:8.0e}  {:8.0e}  {:10.1f}  {:8.3f}\n",
                        row.level, nodes(row.nx, row.ny), row.Hc, row.Hm, percent(row.error_Hc), percent(row.error_Hm),
                        row.residual, row.load_error, row.work_units, row.seconds);
  const bool has_order = !solution.levels.empty() && std::isfinite(solution.levels.back().order_Hc);
  if (has_order) text += fmt::format("observed order of Hc: {:.2f}\n", solution.levels.back().order_Hc);
  return text;
}

std::string continuation_table(const Case& input, const steady::Solution& solution) {
  if (solution.continuation.empty()) return {};
  const bool si = input.physics.si.has_value();
  std::string text = std::string("continuation        M  ") + (si ? "    load [N]" : "load ratio") +
                     "        Hc        Hm  residual  cycles\n";
  for (const steady::ContinuationStep& step : solution.continuation)
    text += fmt::format("{:21.6g}  {:10.4g}  {:>8}  {:>8}  {:>8}  {:6}{}\n", step.M,
                        si ? step.load_ratio * input.physics.si->contact.load : step.load_ratio,
                        known("{:.5f}", step.Hc), known("{:.5f}", step.Hm), known("{:.0e}", step.residual), step.cycles,
                        step.converged ? "" : "  rejected: a shorter step follows");
  return text;
}

namespace {

// The way to the solution, and what did not lead to it.
std::string path(const steady::Solution& solution) {
  std::string text = "path         " + solution.method;
  if (std::isfinite(solution.cycle_factor))
    text += fmt::format("; residual left per cycle {:.2f}", solution.cycle_factor);
  if (!solution.newton.empty())
    text += fmt::format("; {} Newton steps to {:.0e}", solution.newton.size(), solution.newton.back().residual);
  text += "\n";
  for (const steady::Attempt& attempt : solution.attempts)
    if (!attempt.reason.empty())
      text +=
          fmt::format("             tried before, {:.2f} s: {}: {}\n", attempt.seconds, attempt.method, attempt.reason);
  return text;
}

std::string verified(const steady::Verification& checked) {
  const auto number = [](double value) { return known("{:.1e}", value); };
  if (std::isnan(checked.residual)) return {};
  return fmt::format(
      "verified     residual {}, largest {} at ({:.3f}, {:.3f}) a; load error {}; mass flow error {}\n"
      "             least P {}, dry node that wants pressure {}; left to the cycles Hc {}, Hm {}\n",
      number(checked.residual), number(checked.largest_residual), checked.largest_residual_X,
      checked.largest_residual_Y, number(checked.load_error), number(std::abs(checked.flow_imbalance)),
      known("{:.1g}", checked.least_P), number(checked.dry_violation), number(checked.algebraic_error_Hc),
      number(checked.algebraic_error_Hm));
}

// "+- 0.4 %", or nothing where there is no estimate.
std::string bar(double error) { return std::isfinite(error) ? " +- " + percent(error) : ""; }

// The values without mesh, and what the errors are made of.
std::string error_lines(const steady::Solution& solution) {
  const steady::ErrorBars& bars = solution.error_bars;
  std::string text;
  if (std::isfinite(bars.Hc_extrapolated.value))
    text += fmt::format("extrapolated Hc = {:.6f}{}, Hm = {:.6f}{} (mesh size zero, this domain)\n",
                        bars.Hc_extrapolated.value, bar(bars.Hc_extrapolated.error), bars.Hm_extrapolated.value,
                        bar(bars.Hm_extrapolated.error));
  if (std::isfinite(bars.Hm_fitted_value))
    text += fmt::format("fitted       Hm = {:.6f}{} between the nodes, at ({:.4f}, {:.4f}) a\n", bars.Hm_fitted_value,
                        bar(bars.Hm_fitted.total()), unsigned_zero(bars.Hm_fitted_X), unsigned_zero(bars.Hm_fitted_Y));
  if (std::isfinite(bars.Hc.discretization))
    text += fmt::format("errors       Hc: mesh {}, cycles {}; Hm: mesh {}, cycles {}; domain about {} beside them\n",
                        percent(bars.Hc.discretization), percent(bars.Hc.algebraic), percent(bars.Hm.discretization),
                        percent(bars.Hm.algebraic), percent(bars.domain));
  const steady::AccuracyReport& accuracy = solution.accuracy;
  if (std::isfinite(accuracy.asked))
    text += "accuracy     " + percent(accuracy.asked) + " asked for Hc and Hm: " +
            (!accuracy.met               ? "not reached, stopped by " + accuracy.stopped_by
             : accuracy.by_extrapolation ? "reached by the extrapolated values, not by the plain ones"
                                         : "reached") +
            "\n";
  return text;
}

}  // namespace

std::string summary(const Case& input, const Computed& computed) {
  const steady::Solution& solution = computed.solution;
  const Outcome& outcome = computed.outcome;
  const Physics& physics = input.physics;
  const double h_scale = physics.si ? physics.si->hertz.h_scale : std::nan("");
  const std::string mark = solution.converged ? "" : "  (NOT CONVERGED)";
  std::string text = continuation_table(input, solution) + level_table(solution);
  if (!solution.converged) text += "NOT CONVERGED: " + solution.failed_check + "\n";
  // What the domain cuts off changes both alike.
  const double domain = std::abs(solution.error_bars.domain);
  const bool governs = domain > std::min(solution.error_bars.Hc.total(), solution.error_bars.Hm.total());
  const auto film = [&](const char* label, double H, double H_moes, const Place& at, double error) {
    const std::string errors = bar(error) + (governs ? " (domain " + percent(domain) + ")" : "");
    return fmt::format("{} H = {:.5f}{}, Moes {:.4f}{}, at ({:.3f}, {:.3f}) a{}\n", label, H, errors, H_moes,
                       std::isfinite(h_scale) ? (", h = " + length(H * h_scale)) : "", at.X, at.Y, mark);
  };
  text += film("centre      ", outcome.Hc, outcome.Hc_moes, {}, solution.error_bars.Hc.total());
  text += film("minimum     ", outcome.Hm.value, outcome.Hm_moes, outcome.Hm, solution.error_bars.Hm.total());
  const steady::ErrorBars& bars = solution.error_bars;
  const bool spike = solution.levels.size() > 2 && !bars.P_max_converging;
  text += fmt::format("p_max        P = {:.5f}{}{}, at ({:.3f}, {:.3f}) a{}\n", outcome.P_max.value, bar(bars.P_max),
                      std::isfinite(physics.p_h) ? (", " + pressure(outcome.P_max.value * physics.p_h)) : "",
                      outcome.P_max.X, outcome.P_max.Y, mark);
  if (spike) text += "             it still grows from grid to grid as at a spike, and belongs to this mesh\n";
  text += error_lines(solution);
  text += group_lines(physics);
  text += formula_lines(outcome.formulas, physics.groups, h_scale) + roughness_line(input, outcome.roughness);
  text += path(solution);
  text += verified(solution.verification);
  text += fmt::format("method       wedge {}; deformation {}; {}\ntime         {:.3f} s\n", name(input.scene.wedge),
                      solution.deformation, threads_text(input.scene.threads), solution.seconds);
  return text + warning_lines(outcome.warnings);
}

std::string profile_table(const core::PartTimes& times, double seconds) {
  std::string text = fmt::format("{:<29}  {:>8}  {:>5}\n", "profile", "seconds", "share");
  const auto row = [&](const char* part, double of_part) {
    text += fmt::format("  {:<27}  {:8.4f}  {:3.0f} %\n", part, of_part, 100.0 * of_part / seconds);
  };
  double rest = seconds;
  for (std::size_t k = 0; k < times.seconds.size(); ++k) {
    row(core::name(static_cast<core::Part>(k)), times.seconds[k]);
    rest -= times.seconds[k];
  }
  row("everything else", rest);
  return text;
}

std::string derived(const Case& input) {
  const Physics& physics = input.physics;
  const steady::Scene& scene = input.scene;
  std::string text = "case         " + input.title + "\n";
  if (physics.si) text += si_lines(*physics.si);
  text += group_lines(physics);
  const std::vector<Formula> formulas = film_formulas(physics.groups);
  text += formula_lines(formulas, physics.groups, physics.si ? physics.si->hertz.h_scale : std::nan("")) +
          roughness_line(input, roughness_of(input, formulas, std::nan("")));
  text += fmt::format("domain       [{:g}, {:g}] x [{:g}, {:g}] Hertz radii\n", scene.grid.X_a, scene.grid.X_b,
                      scene.grid.Y_a, scene.grid.Y_b);
  text += fmt::format("grid         {} nodes, hx = {:.4g}, hy = {:.4g}\nmethod       wedge {}; deformation {}\n",
                      nodes(scene.grid.nx, scene.grid.ny), scene.grid.hx(), scene.grid.hy(), name(scene.wedge),
                      name(scene.deformation.method));
  text += effect_lines(input) + surface_report(input.surfaces, physics, scene.grid);
  const Needs needs = expected_needs(input);
  return text + fmt::format("needs        about {} and {} with {}\n", memory(needs.bytes), about_seconds(needs.seconds),
                            threads_text(scene.threads));
}

}  // namespace ehl::program
