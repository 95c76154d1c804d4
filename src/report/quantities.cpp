#include "report/quantities.hpp"

#include <cmath>

namespace ehl::program {
namespace {

using results::not_in_json;

constexpr const char* not_in_file = "";

}  // namespace

std::vector<Quantity> film_quantities(const Case& input, const steady::Solution& solution, const Outcome& outcome) {
  const steady::ErrorBars& bars = solution.error_bars;
  const steady::LevelRow last = solution.levels.empty() ? steady::LevelRow{} : solution.levels.back();
  std::vector<Quantity> list{
      {"converged", solution.converged, "-", "1: all checks passed, 0: not"},
      {"failed_check", solution.failed_check, "", "empty when converged"},
      {not_in_file, input.title, "", "of the case", "title"},
      {"Hc", outcome.Hc, "a^2/R", "film at (0,0)", "", "error_Hc"},
      {"Hm", outcome.Hm.value, "a^2/R", "smallest film of all nodes", "", "error_Hm"},
      {"Hm_x", outcome.Hm.X, "a", "where the smallest film is", "Hm_X"},
      {"Hm_y", outcome.Hm.Y, "a", "where the smallest film is", "Hm_Y"},
      {"error_Hc", bars.Hc.total(), "-", "estimated relative error on this domain: mesh and cycles"},
      {"error_Hm", bars.Hm.total(), "-", "estimated relative error on this domain: mesh and cycles"},
      {"Hc_best", bars.Hc_best.value, "a^2/R", "Hc with the narrowest bar: extrapolated, or of the finest grid", "",
       "error_Hc_best"},
      {"error_Hc_best", bars.Hc_best.error, "-", "its estimated relative error"},
      {"Hm_best", bars.Hm_best.value, "a^2/R", "the same of Hm_fitted", "", "error_Hm_best"},
      {"error_Hm_best", bars.Hm_best.error, "-", "its estimated relative error"},
      {"Hc_extrapolated", bars.Hc_extrapolated.value, "a^2/R", "Hc extrapolated to mesh size zero", "",
       "error_Hc_extrapolated"},
      {"error_Hc_extrapolated", bars.Hc_extrapolated.error, "-", "its estimated relative error"},
      {"Hm_extrapolated", bars.Hm_extrapolated.value, "a^2/R", "Hm_fitted extrapolated to mesh size zero", "",
       "error_Hm_extrapolated"},
      {"error_Hm_extrapolated", bars.Hm_extrapolated.error, "-", "its estimated relative error"},
      {"Hm_fitted", bars.Hm_fitted_value, "a^2/R", "smallest film between the nodes", "", "error_Hm_fitted"},
      {"Hm_fitted_x", bars.Hm_fitted_X, "a", "where it is", "Hm_fitted_X"},
      {"Hm_fitted_y", bars.Hm_fitted_Y, "a", "where it is", "Hm_fitted_Y"},
      {"P_max_converging", bars.P_max_converging, "-", "0: P_max grows with the mesh, or a spike is not seen yet"},
      {"error_P_max", bars.P_max, "-", "estimated relative error of P_max; NaN where it does not converge"},
      {"error_Hm_fitted", bars.Hm_fitted.total(), "-", "its estimated relative error on this domain"},
      {"domain_error", bars.domain, "-", "estimated relative change of Hc and Hm on a domain without end",
       "error_parts/domain"},
      {"Hc_moes", outcome.Hc_moes, "-", "(h/R)(2U)^(-1/2) at the centre", "", "error_Hc"},
      {"Hm_moes", outcome.Hm_moes, "-", "(h/R)(2U)^(-1/2), smallest", "", "error_Hm"},
      {"hc", outcome.hc, "m", "film at (0,0)", "hc_m", "error_Hc"},
      {"hm", outcome.hm, "m", "smallest film", "hm_m", "error_Hm"},
      {"P_max", outcome.P_max.value, "p_h", "highest pressure of all nodes", "", "error_P_max"},
      {"P_max_x", outcome.P_max.X, "a", "where the highest pressure is", "P_max_X"},
      {"P_max_y", outcome.P_max.Y, "a", "where the highest pressure is", "P_max_Y"},
      {"p_max", outcome.P_max.value * input.physics.p_h, "Pa", "highest pressure of all nodes", "p_max_Pa",
       "error_P_max"},
      {"H00", solution.H00, "a^2/R", "mutual approach"},
      {"residual", last.residual, "-", "relative residual of the Reynolds equation"},
      {"load_error", last.load_error, "-", "|integral of P - load| over the load"},
      {"mesh_error_Hc", bars.Hc.discretization, "-", "the part of error_Hc that the mesh makes", not_in_json},
      {"mesh_error_Hm", bars.Hm.discretization, "-", "the part of error_Hm that the mesh makes", not_in_json},
      {"cycle_factor", solution.cycle_factor, "-", "residual left by a cycle, mean of those on the finest grid"},
      {"seconds", solution.seconds, "s", "time of the solution"},
      {"method", solution.method, "", "the way that led to the solution"},
      {"regime", outcome.regime, "", "regime of lubrication"},
      {"deformation", solution.deformation, "", "how the elastic deformation was evaluated", not_in_json},
  };
  if (const std::optional<steady::Starvation>& found = solution.starvation) {
    list.push_back({not_in_file, found->factor, "-", "film over that of the flooded contact", "starvation_factor"});
    list.push_back({not_in_file, found->imbalance, "-", "of oil, relative", "mass_imbalance"});
  }
  if (const std::optional<Roughness>& rough = outcome.roughness) {
    list.push_back({"Sq", rough->Sq, "a^2/R", "roughness of both surfaces together"});
    if (input.physics.si)
      list.push_back({not_in_file, rough->Sq * input.physics.si->hertz.h_scale, "m", "the same", "Sq_m"});
    list.push_back({"lambda_ratio", rough->lambda_ratio(), "-", "smallest film of smooth surfaces over Sq"});
  }
  return list;
}

std::vector<Quantity> verification_quantities(const steady::Verification& checked, const contact::Ellipse& shape) {
  const bool line = contact::line(shape) && !contact::roller(shape);
  const bool round = contact::circular(shape);
  std::vector<Quantity> list{
      {not_in_file, checked.residual, "-", "relative residual of the Reynolds equation", "residual"},
      {"largest_residual", checked.largest_residual, "-", "at one node, relative to the wedge term like the residual"},
      {"largest_residual_x", checked.largest_residual_X, "a", "where it is", "largest_residual_X"},
      {"largest_residual_y", checked.largest_residual_Y, "a", "where it is", "largest_residual_Y"},
      {"least_P", checked.least_P, "p_h", "lowest pressure of all nodes"},
      {"dry_violation", checked.dry_violation, "-", "largest residual of a cavitated node that wants pressure"},
      {not_in_file, checked.load_error, "-", "relative error of the load", "load_error"},
      {"change_Hc", checked.change_Hc, "-", "relative change of Hc in the last cycle"},
      {"change_Hm", checked.change_Hm, "-", "relative change of Hm in the last cycle"},
      {"algebraic_error_Hc", checked.algebraic_error_Hc, "-", "what further cycles would change, foretold"},
      {"algebraic_error_Hm", checked.algebraic_error_Hm, "-", "what further cycles would change, foretold"},
      {not_in_file, checked.Hm, "a^2/R", "smallest film of all nodes", "Hm"},
      {not_in_file, checked.Hm_X, "a", "where it is", "Hm_X"},
      {not_in_file, checked.Hm_Y, "a", "where it is", "Hm_Y"},
      {"flow_through", checked.flow_through, line ? "rho0 u_m a^2/R" : "rho0 u_m a^3/R",
       line    ? "mass flow through the contact at x = 0, per length along y"
       : round ? "mass flow through the contact, |y| <= 1 at x = 0"
               : "mass flow through the contact at x = 0, as wide as it is"},
      {"flow_imbalance", checked.flow_imbalance, "-",
       line    ? "mass flow out of |x| <= 1.5 less in, over flow_through"
       : round ? "mass flow out of |x|, |y| <= 1.5 less in, over flow_through"
               : "mass flow out of 1.5 times the contact's reach less in, over flow_through"},
      {"flow_imbalance_whole", checked.flow_imbalance_whole, "-", "the same of all of the pressurised region"}};
  if (std::isfinite(checked.least_content))
    list.push_back({"least_content", checked.least_content, "a^2/R", "lowest oil content of all nodes"});
  return list;
}

std::vector<Quantity> machine_quantities(const machines::Contact& machine) {
  std::vector<Quantity> list;
  for (const machines::Number& one : machine.numbers)
    list.push_back(
        {machine.section + "_" + one.name, one.value, one.unit, one.formula, machine.section + "/" + one.name});
  return list;
}

std::vector<Quantity> scale_quantities(const Case& input) {
  const Physics& physics = input.physics;
  const contact::Groups& g = physics.groups;
  std::vector<Quantity> list{{"M", g.M, "-", "Moes load number"},
                             {"L", g.L, "-", "Moes material number"},
                             {"W", g.W, "-", "Hamrock-Dowson load number"},
                             {"U", g.U, "-", "Hamrock-Dowson speed number"},
                             {"G", g.G, "-", "Hamrock-Dowson material number"},
                             {"lambda", g.lambda, "-", "6 eta0 u_s R^2/(a^3 p_h)"},
                             {"alpha_bar", g.alpha_bar, "-", "alpha p_h"},
                             {"p_h", physics.p_h, "Pa", "Hertz pressure, the scale of P", "p_h_Pa"},
                             {"H_moes", contact::H_to_moes_units(1.0, g.M, g.shape), "-", "film in Moes units over H"}};
  const auto append = [&](const std::vector<Quantity>& more) { list.insert(list.end(), more.begin(), more.end()); };
  if (input.machine) append(machine_quantities(*input.machine));
  const bool line = contact::line(g.shape);
  const bool elliptic = !contact::circular(g.shape) && !line;
  if (elliptic)
    append({{"radius_ratio", g.shape.radius_ratio, "-", "R_x/R_y"},
            {"angle", g.shape.angle, "degrees", "from the direction of R_x to the entrainment"},
            {"kappa", g.shape.kappa, "-", "b/a, the semi-axes along R_y and R_x"}});
  if (contact::roller(g.shape)) append({{"kappa", g.shape.kappa, "-", "half of the roller's length over a"}});
  if (!physics.si) return list;
  const contact::SiContact& c = physics.si->contact;
  append({{"a", physics.si->hertz.a, "m", "Hertz radius, the scale of X and Y", "a_m"},
          {"h", physics.si->hertz.h_scale, "m", "a^2/R, the scale of H", not_in_json},
          {"load", c.load, line ? "N/m" : "N", line ? "normal load per length" : "normal load", not_in_json},
          {"R", c.radius, "m", "reduced radius", "R_m"},
          {"E_prime", c.E_prime, "Pa", "reduced modulus", not_in_json},
          {"u1", physics.si->u1, "m/s", "speed of surface 1", not_in_json},
          {"u2", physics.si->u2, "m/s", "speed of surface 2", not_in_json},
          {"u_s", c.u_s, "m/s", "u1 + u2", not_in_json},
          {"eta0", c.eta0, "Pa s", "viscosity at ambient pressure", not_in_json}});
  if (physics.ambient)
    append({{"temperature", physics.ambient->T, "C", "temperature of oil and bodies"},
            {"rho0", physics.ambient->rho, "kg/m^3", "density of the oil at ambient pressure"}});
  if (elliptic)
    append({{"b", physics.si->hertz.b, "m", "semi-axis along R_y", not_in_json},
            {"R_y", c.radius / c.shape.radius_ratio, "m", "reduced radius across R_x", not_in_json}});
  return list;
}

std::vector<Column<steady::LevelRow>> level_columns() {
  using Row = steady::LevelRow;
  return {{"level", "-", "grid level", &Row::level},
          {"nx", "-", "cells along x", &Row::nx},
          {"ny", "-", "cells along y", &Row::ny},
          {"Hc", "a^2/R", "film at (0,0)", &Row::Hc},
          {"Hm", "a^2/R", "smallest film of all nodes", &Row::Hm},
          {"mesh_error_Hc", "-", "estimated relative discretization error", &Row::error_Hc},
          {"mesh_error_Hm", "-", "estimated relative discretization error", &Row::error_Hm},
          {"Hm_fitted", "a^2/R", "smallest film between the nodes", &Row::Hm_fitted},
          {"P_max", "p_h", "highest pressure of all nodes", &Row::P_max},
          {"order_Hc", "-", "observed order of convergence", &Row::order_Hc},
          {"residual", "-", "relative residual of the Reynolds equation", &Row::residual},
          {"load_error", "-", "relative error of the load", &Row::load_error},
          {"cycles", "-", "cycles on the level", &Row::cycles},
          {"work_units", "-", "in residual and deformation evaluations on the level", &Row::work_units},
          {"seconds", "s", "time on the level", &Row::seconds}};
}

std::vector<Column<steady::CycleRow>> cycle_columns() {
  using Row = steady::CycleRow;
  return {{"level", "-", "grid level", &Row::level},
          {"cycle", "-", "cycle on the level", &Row::cycle},
          {"residual", "-", "relative residual of the Reynolds equation", &Row::residual},
          {"load_error", "-", "relative error of the load", &Row::load_error},
          {"Hc", "a^2/R", "film at (0,0)", &Row::Hc},
          {"Hm", "a^2/R", "smallest film of all nodes", &Row::Hm}};
}

std::vector<Column<steady::ContinuationStep>> continuation_columns() {
  using Row = steady::ContinuationStep;
  return {{"M", "-", "Moes load number", &Row::M},
          {"load_ratio", "-", "load over that of the case", &Row::load_ratio},
          {"Hc", "a^2/R", "film at (0,0); NaN where the first cycle diverged", &Row::Hc},
          {"Hm", "a^2/R", "smallest film", &Row::Hm},
          {"residual", "-", "relative residual of the Reynolds equation", &Row::residual},
          {"cycles", "-", "cycles for this load", &Row::cycles},
          {"converged", "-", "1: solved; 0: rejected, a shorter step follows", &Row::converged}};
}

}  // namespace ehl::program
