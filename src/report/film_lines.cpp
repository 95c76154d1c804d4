#include "report/film_lines.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/text_format.hpp"
#include "case/numbers/number.hpp"

namespace ehl::program {
namespace {

using numbers::symbol_of;

// A number that would be printed as -0.0000 becomes zero.
double unsigned_zero(double x) { return std::abs(x) < 5e-5 ? 0.0 : x; }

// "+- 0.4 %"; empty if there is no estimate.
std::string bar(double error) { return std::isfinite(error) ? " +- " + percent(error) : ""; }

}  // namespace

std::string film_lines(const Case& input, const Computed& computed) {
  const steady::Solution& solution = computed.solution;
  const Outcome& outcome = computed.outcome;
  const steady::ErrorBars& bars = solution.error_bars;
  const std::optional<SiScales> si = si_scales(input.physics);
  const bool broke_off = !why_incomplete(computed.in_time).empty();
  const std::string mark = solution.converged && broke_off ? "  (steady start)" : convergence_mark(solution.converged);
  // The error of the domain applies to both films.
  const double domain = std::abs(bars.domain);
  const bool by_weights = std::isfinite(bars.Hc_best.value);
  const steady::Estimate Hc = by_weights ? bars.Hc_best : steady::Estimate{outcome.Hc, bars.Hc.total()};
  const steady::Estimate Hm = by_weights ? bars.Hm_best : steady::Estimate{outcome.Hm.value, bars.Hm.total()};
  const Place lowest = by_weights ? Place{Hm.value, bars.Hm_fitted_X, bars.Hm_fitted_Y} : outcome.Hm;
  const bool governs = domain > std::min(Hc.error, Hm.error);
  // in: id and id_in_SI: the names of the film without and in SI.
  const auto film = [&](const char* id, const char* id_in_SI, double H, double H_moes, const Place& at, double error) {
    const std::string errors = bar(error) + (governs ? " (domain " + percent(domain) + ")" : "");
    const std::string own = fmt::format(" = {:.5f}{}, Moes {:.4f}, at ({:.3f}, {:.3f}) a{}\n", H, si ? "" : errors,
                                        H_moes, at.X, at.Y, mark);
    const std::string& label = numbers::number_of(si ? id_in_SI : id).label;
    if (!si) return label + own;
    return label + " = " + film_text(H, *si) + errors + ", at " + place_text(at.X, at.Y, *si) + "; " + symbol_of(id) +
           own;
  };
  // The values at the nodes, as in the stored fields; printed only if they differ from the best estimates.
  const auto beside = [&](const char* id, const char* id_in_SI, double H, double shown, double error) {
    if (H == shown) return std::string();
    const std::string own = symbol_of(id) + fmt::format(" = {:.5f}", H);
    return "             on this mesh " +
           (si ? symbol_of(id_in_SI) + " = " + film_text(H, *si) + bar(error) + "; " + own : own + bar(error)) + "\n";
  };
  const double moes = outcome.Hc_moes / outcome.Hc;
  std::string text = film(id::Hc, id::hc, Hc.value, moes * Hc.value, {}, Hc.error);
  text += beside(id::Hc, id::hc, outcome.Hc, Hc.value, bars.Hc.total());
  text += film(id::Hm, id::hm, Hm.value, moes * Hm.value, lowest, Hm.error);
  text += beside(id::Hm, id::hm, outcome.Hm.value, Hm.value, bars.Hm.total());
  const Place& at = outcome.P_max;
  text += fmt::format("{:<13}", symbol_of(id::p_max));
  if (si)
    text += pressure_in_GPa(at.value * si->p_h) + bar(bars.P_max) + ", at " + place_text(at.X, at.Y, *si) +
            fmt::format("; P = {:.5f}", at.value);
  else
    text += fmt::format("P = {:.5f}{}{}", at.value, bar(bars.P_max),
                        std::isfinite(input.physics.p_h) ? ", " + pressure(at.value * input.physics.p_h) : "");
  text += fmt::format(", at ({:.3f}, {:.3f}) a{}\n", at.X, at.Y, mark);
  if ((solution.levels.size() > 2 || bars.relief_unresolved > 0.0) && !bars.P_max_converging)
    text += bars.relief_unresolved > 0.0 ? "             the mesh does not resolve the rough surfaces, and the "
                                           "pressure of their asperities rises on finer meshes\n"
            : bars.spike_unseen
                ? "             a spike that this mesh does not resolve may be higher\n"
                : "             it still rises from grid to grid, as at a spike: the value depends on the mesh\n";
  return text;
}

std::string error_lines(const Case& input, const steady::Solution& solution) {
  const steady::ErrorBars& bars = solution.error_bars;
  const std::optional<SiScales> si = si_scales(input.physics);
  std::string text;
  if (std::isfinite(bars.Hc_extrapolated.value)) {
    const auto& [Hc, Hm] = std::pair(bars.Hc_extrapolated, bars.Hm_extrapolated);
    const char* where = " (mesh size zero, this domain)";
    text += "extrapolated ";
    const std::string H_c = symbol_of(id::Hc), H_m = symbol_of(id::Hm);
    text += si ? fmt::format("{} = {}{}, {} = {}{}{}; {} = {:.6f}, {} = {:.6f}\n", symbol_of(id::hc),
                             film_text(Hc.value, *si), bar(Hc.error), symbol_of(id::hm), film_text(Hm.value, *si),
                             bar(Hm.error), where, H_c, Hc.value, H_m, Hm.value)
               : fmt::format("{} = {:.6f}{}, {} = {:.6f}{}{}\n", H_c, Hc.value, bar(Hc.error), H_m, Hm.value,
                             bar(Hm.error), where);
  }
  if (std::isfinite(bars.Hm_fitted_value)) {
    const double X = unsigned_zero(bars.Hm_fitted_X), Y = unsigned_zero(bars.Hm_fitted_Y);
    const std::string error = bar(bars.Hm_fitted.total()) + " between the nodes, at ";
    text += "fitted       ";
    if (si)
      text += symbol_of(id::hm) + " = " + film_text(bars.Hm_fitted_value, *si) + error + place_text(X, Y, *si) + "; ";
    text += fmt::format("{} = {:.6f}{}({:.4f}, {:.4f}) a{}\n", symbol_of(id::Hm), bars.Hm_fitted_value,
                        si ? ", at " : error, X, Y, convergence_mark(solution.converged));
  }
  if (std::isfinite(bars.Hc.discretization))
    text +=
        fmt::format("errors       {}: mesh {}, cycles {}; {}: mesh {}, cycles {}; not included: domain about {}\n",
                    symbol_of(id::Hc), percent(bars.Hc.discretization), percent(bars.Hc.algebraic), symbol_of(id::Hm),
                    percent(bars.Hm.discretization), percent(bars.Hm.algebraic), percent(bars.domain));
  const steady::AccuracyReport& accuracy = solution.accuracy;
  if (std::isfinite(accuracy.asked))
    text += fmt::format("accuracy     {:.4g} % required for {} and {}: ", 100.0 * accuracy.asked, symbol_of(id::Hc),
                        symbol_of(id::Hm)) +
            (!accuracy.met               ? "not reached because of " + accuracy.stopped_by
             : accuracy.by_extrapolation ? "reached by the extrapolated or fitted values, not by the nodal ones"
                                         : "reached") +
            "\n";
  return text;
}

std::string verified_lines(const Case& input, const steady::Verification& checked) {
  const auto number = [](double value) { return known("{:.1e}", value); };
  if (std::isnan(checked.residual)) return {};
  const std::optional<SiScales> si = si_scales(input.physics);
  const std::string where =
      si ? place_text(checked.largest_residual_X, checked.largest_residual_Y, *si)
         : fmt::format("({:.3f}, {:.3f}) a", checked.largest_residual_X, checked.largest_residual_Y);
  return fmt::format(
      "verified     residual {}, largest {} at {}; load error {}; mass flow error {}\n"
      "             least P {}, complementarity error {}; algebraic error {} {}, {} {}\n",
      number(checked.residual), number(checked.largest_residual), where, number(checked.load_error),
      number(std::abs(checked.flow_imbalance)), known("{:.1g}", checked.least_P), number(checked.dry_violation),
      symbol_of(id::Hc), number(checked.algebraic_error_Hc), symbol_of(id::Hm), number(checked.algebraic_error_Hm));
}

}  // namespace ehl::program
