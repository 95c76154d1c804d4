// Film and pressure of a solved contact, their errors, and the course of the solution.
#include "case/numbers/records.hpp"

namespace ehl::program::numbers {
namespace {

const steady::ErrorBars& bars(Of s) { return s.computed.solution.error_bars; }
const Outcome& outcome(Of s) { return s.computed.outcome; }
steady::LevelRow last(Of s) { return solution(s).levels.empty() ? steady::LevelRow{} : solution(s).levels.back(); }

// The contact has oil; if not, it is dry.
bool with_oil(Of s) { return !s.input.dry; }
bool without_oil(Of s) { return s.input.dry.has_value(); }
bool has_p_h(Of s) { return with_oil(s) || in_SI(s); }
bool always(Of) { return true; }

constexpr char of_nodes[] = "minimum film of all nodes";
constexpr char where_highest[] = "position of the highest pressure";
constexpr char bar_on_domain[] = "estimated relative error on this domain: mesh and cycles";
constexpr char its_error[] = "its estimated relative error";

// Numbers of a film, where a record does not say that a dry contact has them, too.
std::vector<Number> of_films(std::vector<Number> list) {
  for (Number& one : list)
    if (!one.only_if) one.only_if = with_oil;
  return list;
}

}  // namespace

std::vector<Number> film_numbers() {
  // A run in time that ended early has not converged, although its steady start has.
  const auto why_not = [](Of s) {
    return s.computed.in_time ? why_incomplete(s.computed.in_time) : solution(s).failed_check;
  };
  return of_films(
      {number(id::converged, "-", "1: all checks passed, 0: not", only_if(always),
              [=](Of s) { return (solution(s).converged || s.computed.in_time) && why_not(s).empty(); }),
       number(id::failed_check, "", "empty when converged", only_if(always), why_not),
       number(id::title, "", "title of the case", only_if(always), not_in_file, [](Of s) { return s.input.title; }),
       number(id::Hc, "a^2/R", "film at (0,0)", bar(id::error_Hc), label("central film H_c"), column(206),
              on_page(2, "central film, on this mesh"), [](Of s) { return outcome(s).Hc; }),
       number(id::Hm, "a^2/R", of_nodes, bar(id::error_Hm), label("minimum film H_m"), column(207),
              on_page(4, "minimum film, of the nodes"), [](Of s) { return outcome(s).Hm.value; }),
       number(id::Hm_x, "a", "position of the minimum film", json("Hm_X"), [](Of s) { return outcome(s).Hm.X; }),
       number(id::Hm_y, "a", "position of the minimum film", json("Hm_Y"), [](Of s) { return outcome(s).Hm.Y; }),
       number(id::error_Hc, "-", bar_on_domain, column(209), [](Of s) { return bars(s).Hc.total(); }),
       number(id::error_Hm, "-", bar_on_domain, column(210), [](Of s) { return bars(s).Hm.total(); }),
       number(id::Hc_best, "a^2/R", "Hc with the narrowest bar: extrapolated, or of the finest grid",
              bar(id::error_Hc_best), label("central film h_c"), column(211), on_page(1),
              [](Of s) { return bars(s).Hc_best.value; }),
       number(id::error_Hc_best, "-", its_error, column(212), [](Of s) { return bars(s).Hc_best.error; }),
       number(id::Hm_best, "a^2/R", "the same of Hm_fitted", bar(id::error_Hm_best), label("minimum film h_m"),
              column(213), on_page(3), [](Of s) { return bars(s).Hm_best.value; }),
       number(id::error_Hm_best, "-", its_error, column(214), [](Of s) { return bars(s).Hm_best.error; }),
       number("Hc_extrapolated", "a^2/R", "Hc extrapolated to mesh size zero", bar("error_Hc_extrapolated"),
              [](Of s) { return bars(s).Hc_extrapolated.value; }),
       number("error_Hc_extrapolated", "-", its_error, [](Of s) { return bars(s).Hc_extrapolated.error; }),
       number("Hm_extrapolated", "a^2/R", "Hm_fitted extrapolated to mesh size zero", bar("error_Hm_extrapolated"),
              [](Of s) { return bars(s).Hm_extrapolated.value; }),
       number("error_Hm_extrapolated", "-", its_error, [](Of s) { return bars(s).Hm_extrapolated.error; }),
       number(id::Hm_fitted, "a^2/R", "minimum film between the nodes", bar("error_Hm_fitted"),
              [](Of s) { return bars(s).Hm_fitted_value; }),
       number("Hm_fitted_x", "a", "its position", json("Hm_fitted_X"), [](Of s) { return bars(s).Hm_fitted_X; }),
       number("Hm_fitted_y", "a", "its position", json("Hm_fitted_Y"), [](Of s) { return bars(s).Hm_fitted_Y; }),
       number(id::P_max_converging, "-", "0: P_max grows with the mesh, or a spike is not seen yet",
              [](Of s) { return bars(s).P_max_converging; }),
       number(id::error_P_max, "-", "estimated relative error of P_max; NaN where it does not converge",
              [](Of s) { return bars(s).P_max; }),
       number("error_Hm_fitted", "-", "its estimated relative error on this domain",
              [](Of s) { return bars(s).Hm_fitted.total(); }),
       number(id::domain_error, "-", "estimated relative change of Hc and Hm on a domain without end",
              json("error_parts/domain"), [](Of s) { return bars(s).domain; }),
       number("Hc_moes", "-", "(h/R)(2U)^(-1/2) at the centre", bar(id::error_Hc), label("central film in Moes units"),
              on_page(6, "", "h/R (2U)^{-1/2}"), [](Of s) { return outcome(s).Hc_moes; }),
       number("Hm_moes", "-", "(h/R)(2U)^(-1/2), smallest", bar(id::error_Hm), label("minimum film in Moes units"),
              on_page(7), [](Of s) { return outcome(s).Hm_moes; }),
       number(id::hc, "m", "film at (0,0)", json("hc_m"), bar(id::error_Hc), label("central film h_c"),
              in_si(101, "h_c", "nm"), [](Of s) { return outcome(s).hc; }),
       number("hc_error", "m", "its error bar, mesh and cycles", only_column, in_si(102, "h_c_error", "nm"),
              [](Of s) { return outcome(s).hc * bars(s).Hc.total(); }),
       number(id::hm, "m", of_nodes, json("hm_m"), bar(id::error_Hm), label("minimum film h_m"),
              in_si(103, "h_m", "nm"), [](Of s) { return outcome(s).hm; }),
       number("hm_error", "m", "its error bar, mesh and cycles", only_column, in_si(104, "h_m_error", "nm"),
              [](Of s) { return outcome(s).hm * bars(s).Hm.total(); }),
       number(id::P_max, "p_h", "highest pressure of all nodes", only_if(always), bar(id::error_P_max),
              label("highest pressure p_{max}"), column(208), on_page(5), sweep_page(OfSweep::in_table),
              [](Of s) { return outcome(s).P_max.value; }),
       number("P_max_x", "a", where_highest, only_if(always), json("P_max_X"), [](Of s) { return outcome(s).P_max.X; }),
       number("P_max_y", "a", where_highest, only_if(always), json("P_max_Y"), [](Of s) { return outcome(s).P_max.Y; }),
       number(id::p_max, "Pa", "highest pressure of all nodes", only_if(has_p_h), json("p_max_Pa"),
              bar(id::error_P_max), label("highest pressure p_{max}"), in_si(105, "p_max", "GPa"),
              sweep_page(OfSweep::in_table), [](Of s) { return outcome(s).P_max.value * s.input.physics.p_h; }),
       number(id::H00, "a^2/R", "minus the mutual approach", only_if(always), [](Of s) { return solution(s).H00; }),
       number(id::area, "a^2", "area of the nodes in contact", only_if(without_oil), label("area of contact"),
              on_page(20), [](Of s) { return s.computed.dry->rows.back().area; }),
       number(id::gap_error, "a^2/R", "largest gap in the contact or overlap outside", only_if(without_oil),
              label("largest gap in the contact"), on_page(21),
              [](Of s) { return s.computed.dry->rows.back().error; })});
}

std::vector<Number> course_numbers() {
  return of_films(
      {number("attempts", "", "number of strategies tried", only_column, column(4, 0),
              [](Of s) { return static_cast<int>(solution(s).attempts.size()); }),
       number(id::residual, "-", "relative residual of the Reynolds equation", column(215),
              [](Of s) { return last(s).residual; }),
       number(id::load_error, "-", "relative error of the load", only_if(always), column(216),
              [](Of s) { return s.computed.dry ? s.computed.dry->load_error : last(s).load_error; }),
       number(id::mesh_error_Hc, "-", "the part of error_Hc that the mesh makes", not_json,
              [](Of s) { return bars(s).Hc.discretization; }),
       number(id::mesh_error_Hm, "-", "the part of error_Hm that the mesh makes", not_json,
              [](Of s) { return bars(s).Hm.discretization; }),
       number("cycle_factor", "-", "residual left by a cycle, mean of those on the finest grid", column(217),
              [](Of s) { return solution(s).cycle_factor; }),
       number(id::cycles, "-", "cycles on the finest grid", only_column, column(218, 0),
              [](Of s) { return last(s).cycles; }),
       number(id::work_units, "-", "in residual and deformation evaluations on the finest grid", only_column,
              column(219), [](Of s) { return last(s).work_units; }),
       number("path", "", "the method as a code", only_column, column(220, "none"),
              [](Of s) { return solution(s).path; }),
       number(id::seconds, "s", "time of the solution", only_if(always), [](Of s) { return solution(s).seconds; }),
       number(id::method, "", "the strategy that led to the solution", column(3, "none"),
              [](Of s) { return solution(s).method; }),
       number(id::warnings, "", "one per line"),
       number("regime", "", "regime of lubrication", [](Of s) { return outcome(s).regime; }),
       number(id::deformation, "", "how the elastic deformation was evaluated", only_if(always), not_json,
              [](Of s) { return solution(s).deformation; })});
}

std::vector<Number> roughness_numbers() {
  const auto rough = [](Of s) -> const Roughness& { return *s.computed.outcome.roughness; };
  return {number("Sq", "a^2/R", "roughness of both surfaces together", [=](Of s) { return rough(s).Sq; }),
          number(id::Sq_si, "m", "roughness of both surfaces together", only_if(in_SI), not_in_file,
                 in_si(106, "Sq", "nm"), [=](Of s) { return rough(s).Sq * s.input.physics.si->hertz.h_scale; }),
          number(id::lambda_ratio, "-", "minimum film of smooth surfaces over Sq", label("lambda ratio h_m/S_q"),
                 column_only_si(107), on_page(8), sweep_page(OfSweep::as_curve),
                 [=](Of s) { return rough(s).lambda_ratio(); })};
}

}  // namespace ehl::program::numbers
